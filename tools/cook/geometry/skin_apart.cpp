#include "cook/geometry/skin_apart.h"

#include <memory>

#include "common/failure.h"
#include "cook/geometry/rows.h"
#include "cook/geometry/symbol_encoder.h"
#include "draco/decode_skin.h"
#include "draco/skin_codec.h"

namespace marrow::cook {
namespace {

OwnedStreams without_skin(const OwnedStreams& streams) {
  OwnedStreams out = streams;
  for (std::size_t i = out.streams.size(); i-- > 0;) {
    if (!is_skin(out.streams[i].kind)) continue;
    out.streams.erase(out.streams.begin() + static_cast<std::ptrdiff_t>(i));
    out.values.erase(out.values.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return out;
}

}  // namespace

std::optional<SkinApart> SkinApart::take(OwnedStreams& streams) {
  if (!has_skin_for_bits(streams.view())) return {};
  OwnedStreams bare = without_skin(streams);
  if (places_of(Rows(bare), Rows(streams), streams.mesh.vertex_count).empty()) return {};
  SkinApart out;
  out.before_ = std::move(streams);
  streams = std::move(bare);
  return out;
}

std::vector<std::byte> SkinApart::give_back(OwnedStreams& streams) const {
  const Rows old_rows(without_skin(before_)), rows(streams);
  const Places places = places_of(old_rows, old_rows, before_.mesh.vertex_count);
  for (std::size_t i = 0; i < before_.streams.size(); ++i) {
    const Stream& stream = before_.streams[i];
    if (!is_skin(stream.kind)) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    streams.streams.insert(streams.streams.begin() + at, stream);
    std::vector<std::int32_t>& values = *streams.values.emplace(streams.values.begin() + at);
    for (std::size_t v = 0; v < streams.mesh.vertex_count; ++v) {
      const auto from = before_.values[i].begin() +
                        static_cast<std::ptrdiff_t>(std::size_t{places.at(rows.of(v))} * stream.components);
      values.insert(values.end(), from, from + stream.components);
    }
  }
  const MeshStreams mesh = streams.view();
  const SkinBefore before(mesh);
  const auto models = std::make_unique<SkinModels>();
  models->begin();
  SymbolEncoder encoder;
  SkinCodec<SymbolEncoder> codec(mesh, before, *models, encoder);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    if (!codec.code(v)) throw tools::Failure(tools::Exit::internal, "", "", "packed-geometry", "a skin that is none");
  return encoder.finish();
}

}  // namespace marrow::cook
