#include "cook/geometry/rows.h"

#include <cstring>

namespace marrow::cook {

Rows::Rows(const OwnedStreams& s) {
  for (const Stream& stream : s.streams) bytes_ += stream.components * sizeof(std::int32_t);
  all_.resize(bytes_ * s.mesh.vertex_count);
  std::size_t at = 0;
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const std::size_t width = s.streams[i].components * sizeof(std::int32_t);
    for (std::size_t v = 0; v < s.mesh.vertex_count; ++v)
      std::memcpy(&all_[v * bytes_ + at], &s.values[i][v * s.streams[i].components], width);
    at += width;
  }
}

Places places_of(const Rows& rows, const Rows& whole, std::uint32_t count) {
  Places out;
  for (std::uint32_t v = 0; v < count; ++v) {
    const auto [at, is_new] = out.try_emplace(rows.of(v), v);
    if (!is_new && whole.of(v) != whole.of(at->second)) return {};
  }
  return out;
}

}  // namespace marrow::cook
