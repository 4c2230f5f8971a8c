#include "cook/geometry/part_of_streams.h"

#include <algorithm>

namespace marrow::cook {
namespace {

template <class T>
T place_of(const std::vector<T>& ascending, T value) {
  return static_cast<T>(std::ranges::lower_bound(ascending, value) - ascending.begin());
}

// The first `kept` of the `width` numbers of each row.
void narrow(std::vector<std::int32_t>& values, std::size_t width, std::size_t kept) {
  std::size_t to = 0;
  for (std::size_t row = 0; row < values.size(); row += width)
    for (std::size_t i = 0; i < kept; ++i) values[to++] = values[row + i];
  values.resize(to);
}

template <class Drops>
void drop_streams(OwnedStreams& s, const Drops& drops) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    if (drops(s.streams[i], s.values[i])) continue;
    if (to != i) {
      s.streams[to] = s.streams[i];
      s.values[to] = std::move(s.values[i]);
    }
    ++to;
  }
  s.streams.resize(to);
  s.values.resize(to);
}

// As many influences as the part's vertices have at most.
void narrow_influences(OwnedStreams& s) {
  const std::size_t width = s.mesh.influences;
  std::size_t most = 1;
  std::vector<std::int32_t>* const joints = s.values_of(StreamKind::joints);
  for (std::size_t row = 0; joints != nullptr && row < joints->size(); row += width) {
    std::size_t count = 1;  // the last repeats
    while (count < width && (*joints)[row + count] > (*joints)[row + count - 1]) ++count;
    most = std::max(most, count);
  }
  s.mesh.influences = static_cast<std::uint32_t>(most);
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    Stream& stream = s.streams[i];
    if (stream.kind != StreamKind::joints && stream.kind != StreamKind::weights) continue;
    const std::size_t kept = stream.kind == StreamKind::joints ? most : most - 1;
    narrow(s.values[i], stream.components, kept);
    stream.components = static_cast<std::uint8_t>(kept);
  }
  drop_streams(s, [&](const Stream& stream, const std::vector<std::int32_t>&) {
    const bool of_influence = stream.kind == StreamKind::residual || stream.kind == StreamKind::multi_weight;
    return stream.components == 0 || (of_influence && stream.target >= most) ||
           (stream.kind == StreamKind::joints && s.mesh.joint_count < 2);
  });
}

// Of morph targets and examples that move nothing of the part. They remain targets, so that all parts have as many.
void drop_still(OwnedStreams& s) {
  drop_streams(s, [](const Stream& stream, const std::vector<std::int32_t>& values) {
    if (stream.kind != StreamKind::target && stream.kind != StreamKind::pose_delta) return false;
    const std::int32_t nothing = 1 << (stream.bits - 1);
    return std::ranges::all_of(values, [&](std::int32_t n) { return n == nothing; });
  });
}

void take_palette(const OwnedStreams& whole, const std::vector<std::uint16_t>& entries, OwnedStreams& out) {
  out.mesh.joint_count = static_cast<std::uint32_t>(entries.size());
  if ((whole.mesh.flags & format::kHasMwe) != 0)
    out.mesh.mwe_root = place_of(entries, static_cast<std::uint16_t>(whole.mesh.mwe_root));
  if (whole.mesh.example_count == 0) return;
  // An entry whose parent the part lacks has no weight in it; without a parent nothing turns.
  for (const std::uint16_t entry : entries) {
    const std::uint16_t parent = whole.parents[entry];
    out.parents.push_back(std::ranges::binary_search(entries, parent) ? place_of(entries, parent) : kNoJoint);
  }
  constexpr std::int16_t kIdentity[] = {0, 0, 0, 32767};
  for (std::size_t k = 0; k < whole.mesh.example_count; ++k)
    for (std::size_t j = 0; j < entries.size(); ++j) {
      const std::size_t at = (k * whole.mesh.joint_count + entries[j]) * 4;
      const std::int16_t* const from = out.parents[j] == kNoJoint ? kIdentity : &whole.rotations[at];
      out.rotations.insert(out.rotations.end(), from, from + 4);
    }
}

}  // namespace

OwnedStreams part_of_streams(const OwnedStreams& whole, const std::vector<std::uint32_t>& vertices,
                             const std::vector<std::uint32_t>& indices, const std::vector<std::uint16_t>& entries) {
  OwnedStreams out;
  out.mesh = whole.mesh;
  out.mesh.vertex_count = static_cast<std::uint32_t>(vertices.size());
  out.mesh.triangle_count = static_cast<std::uint32_t>(indices.size() / 3);
  for (const std::uint32_t v : indices) out.indices.push_back(place_of(vertices, v));
  out.streams = whole.streams;
  for (std::size_t i = 0; i < whole.streams.size(); ++i) {
    const std::size_t components = whole.streams[i].components;
    std::vector<std::int32_t>& values = out.values.emplace_back();
    for (const std::uint32_t v : vertices) {
      const auto from = whole.values[i].begin() + static_cast<std::ptrdiff_t>(v * components);
      values.insert(values.end(), from, from + static_cast<std::ptrdiff_t>(components));
    }
  }
  if (std::vector<std::int32_t>* const joints = out.values_of(StreamKind::joints))
    for (std::int32_t& joint : *joints) joint = place_of(entries, static_cast<std::uint16_t>(joint));
  take_palette(whole, entries, out);
  narrow_influences(out);
  drop_still(out);
  return out;
}

}  // namespace marrow::cook
