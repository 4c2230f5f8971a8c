#include "cook/geometry/owned_streams.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <unordered_map>

#include <meshoptimizer.h>

#include "cook/geometry/order_parts.h"

namespace marrow::cook {

Stream& OwnedStreams::add(StreamKind kind, std::uint32_t components, std::uint32_t bits) {
  Stream& s = streams.emplace_back();
  s.kind = kind;
  s.components = static_cast<std::uint8_t>(components);
  s.bits = static_cast<std::uint8_t>(bits);
  values.emplace_back().reserve(std::size_t{mesh.vertex_count} * components);
  return s;
}

MeshStreams OwnedStreams::view() {
  MeshStreams out = mesh;
  out.indices = indices.data();
  out.triangle_count = static_cast<std::uint32_t>(indices.size() / 3);
  out.source_map = source_map.data();
  out.source_vertex_count = static_cast<std::uint32_t>(source_map.size());
  for (std::size_t i = 0; i < streams.size(); ++i) streams[i].values = values[i].data();
  out.streams = streams.data();
  out.stream_count = static_cast<std::uint32_t>(streams.size());
  out.rotations = rotations.data();
  out.parents = parents.data();
  out.apart.bits = {residual_bits.data(), residual_bits.size()};
  return out;
}

const Stream* OwnedStreams::find(StreamKind kind) const {
  for (const Stream& s : streams) {
    if (s.kind == kind) return &s;
    if (is_past(kind, s.kind)) break;
  }
  return nullptr;
}

std::vector<std::int32_t>* OwnedStreams::values_of(StreamKind kind) {
  const Stream* const s = find(kind);
  return s == nullptr ? nullptr : &values[static_cast<std::size_t>(s - streams.data())];
}

namespace {

// A number for each vertex that a triangle uses, the same for those that agree in all of the streams that `counts`
// says; kNoSlot for the others.
template <class Counts>
std::vector<std::uint32_t> equal_vertices(const OwnedStreams& s, const Counts& counts, std::size_t& distinct) {
  std::size_t width = 0;
  for (const Stream& stream : s.streams) width += counts(stream.kind) ? std::size_t{stream.components} : 0u;
  std::vector<std::int32_t> rows;
  rows.reserve(width * s.mesh.vertex_count);
  for (std::size_t v = 0; v < s.mesh.vertex_count; ++v) {
    for (std::size_t i = 0; i < s.streams.size(); ++i) {
      if (!counts(s.streams[i].kind)) continue;
      const auto from = s.values[i].begin() + static_cast<std::ptrdiff_t>(v * s.streams[i].components);
      rows.insert(rows.end(), from, from + s.streams[i].components);
    }
  }
  const std::size_t bytes = width * sizeof(std::int32_t);
  std::unordered_map<std::string_view, std::uint32_t> numbers;
  std::vector<std::uint32_t> out(s.mesh.vertex_count, kNoSlot);
  for (const std::uint32_t v : s.indices) {
    if (out[v] != kNoSlot) continue;
    const std::string_view row(reinterpret_cast<const char*>(rows.data()) + v * bytes, bytes);
    out[v] = numbers.try_emplace(row, static_cast<std::uint32_t>(numbers.size())).first->second;
  }
  distinct = numbers.size();
  return out;
}

bool moves(StreamKind kind) {
  return kind == StreamKind::position || kind == StreamKind::joints || kind == StreamKind::weights ||
         kind == StreamKind::residual || is_centred(kind);
}

// The triangles that have an area; and of the others, if `every_vertex` is wanted, those with a corner that no kept
// triangle has: then `collapsed` is set. place, same: each vertex's numbers; `distinct`: how many of `same` there are.
std::vector<std::uint32_t> triangles_to_keep(const OwnedStreams& s, const std::vector<std::uint32_t>& place,
                                             const std::vector<std::uint32_t>& same, std::size_t distinct,
                                             bool every_vertex, bool& collapsed) {
  std::vector<std::uint32_t> kept;
  std::vector<bool> is_taken(distinct, false);
  const auto keep = [&](const std::uint32_t* t) {
    kept.insert(kept.end(), t, t + 3);
    for (int corner = 0; corner < 3; ++corner) is_taken[same[t[corner]]] = true;
  };
  for (std::size_t i = 0; i + 2 < s.indices.size(); i += 3) {
    const std::uint32_t* const t = &s.indices[i];
    if (place[t[0]] != place[t[1]] && place[t[1]] != place[t[2]] && place[t[2]] != place[t[0]]) keep(t);
  }
  const std::size_t whole = kept.size();
  for (std::size_t i = 0; every_vertex && i + 2 < s.indices.size(); i += 3) {
    const std::uint32_t* const t = &s.indices[i];
    if (!is_taken[same[t[0]]] || !is_taken[same[t[1]]] || !is_taken[same[t[2]]]) keep(t);
  }
  collapsed = kept.size() > whole;
  if (kept.empty()) keep(s.indices.data());  // a mesh is never empty
  return kept;
}

}  // namespace

void weld(OwnedStreams& s, bool keep_map) {
  std::size_t distinct = 0;
  const std::vector<std::uint32_t> place = equal_vertices(s, moves, distinct);
  const std::vector<std::uint32_t> same = equal_vertices(
      s, [](StreamKind) { return true; }, distinct);
  std::vector<std::uint32_t> kept = triangles_to_keep(s, place, same, distinct, keep_map, s.has_collapsed);
  // Numbered anew by first use.
  std::vector<std::uint32_t> number(distinct, kNoSlot), first(distinct);
  std::uint32_t count = 0;
  for (std::uint32_t& index : kept) {
    std::uint32_t& n = number[same[index]];
    if (n == kNoSlot) {
      first[count] = index;
      n = count++;
    }
    index = n;
  }
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const std::size_t components = s.streams[i].components;
    std::vector<std::int32_t> values;
    values.reserve(count * components);
    for (std::uint32_t v = 0; v < count; ++v) {
      const auto from = s.values[i].begin() + static_cast<std::ptrdiff_t>(first[v] * components);
      values.insert(values.end(), from, from + static_cast<std::ptrdiff_t>(components));
    }
    s.values[i] = std::move(values);
  }
  if (keep_map) {
    s.source_map.clear();
    for (const std::uint32_t n : same) s.source_map.push_back(n == kNoSlot ? kNoSlot : number[n]);
  }
  s.indices = std::move(kept);
  s.mesh.vertex_count = count;
  s.mesh.triangle_count = static_cast<std::uint32_t>(s.indices.size() / 3);
}

bool meets_too_often(const OwnedStreams& s, Meeting in) {
  constexpr std::uint64_t kMostACorner = 64, kFew = 20'000'000;
  std::vector<std::uint64_t> corners(s.mesh.vertex_count, 0);
  if (in == Meeting::vertex) {
    for (const std::uint32_t vertex : s.indices) ++corners[vertex];
  } else {
    std::size_t distinct = 0;
    const std::vector<std::uint32_t> place = equal_vertices(
        s, [](StreamKind kind) { return kind == StreamKind::position; }, distinct);
    for (const std::uint32_t vertex : s.indices) ++corners[place[vertex]];
  }
  std::uint64_t pairs = 0;
  for (const std::uint64_t n : corners) pairs += n * n;
  return pairs > kFew && pairs > kMostACorner * s.indices.size();
}

void optimise_order(OwnedStreams& s) {
  constexpr unsigned kCacheSize = 16;
  constexpr float kCacheMissesForOverdraw = 1.05f;  // of what the cache alone would miss
  const std::uint32_t count = s.mesh.vertex_count;
  std::vector<std::uint32_t> ordered(s.indices.size());
  if (meets_too_often(s, Meeting::vertex)) {  // what is better looks at all triangles of a vertex for each of them
    meshopt_optimizeVertexCacheFifo(ordered.data(), s.indices.data(), s.indices.size(), count, kCacheSize);
  } else {
    meshopt_optimizeVertexCache(ordered.data(), s.indices.data(), s.indices.size(), count);
  }
  const Stream& position = *s.find(StreamKind::position);
  std::vector<float> positions;
  for (const std::int32_t v : *s.values_of(StreamKind::position))
    positions.push_back(position.bits == 0 ? std::bit_cast<float>(v) : static_cast<float>(v));
  s.indices = outer_parts_first(ordered, positions, kCacheMissesForOverdraw);
}

}  // namespace marrow::cook
