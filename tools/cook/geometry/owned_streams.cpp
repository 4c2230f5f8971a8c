#include "cook/geometry/owned_streams.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <span>

#include <meshoptimizer.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace marrow::cook {
namespace {

// A vertex cache that forgets what came first.
class Cache {
 public:
  explicit Cache(std::size_t vertex_count) : loaded_(vertex_count, 0) {}
  void clear() { loads_ += kSize + 1; }
  // How many of a triangle's vertices are not in it, and now are.
  std::uint32_t misses(const std::uint32_t* corners) {
    std::uint32_t count = 0;
    for (int c = 0; c < 3; ++c) {
      if (loads_ - loaded_[corners[c]] <= kSize) continue;
      loaded_[corners[c]] = loads_++;
      ++count;
    }
    return count;
  }

 private:
  static constexpr std::uint64_t kSize = 16;
  std::uint64_t loads_ = kSize + 1;
  std::vector<std::uint64_t> loaded_;  // when, counted in loads
};

// First triangles of parts, and behind them the number of triangles.
using Cuts = std::vector<std::size_t>;

// Where none of a triangle's vertices was there, a cut costs nothing.
Cuts free_cuts(std::span<const std::uint32_t> indices, Cache& cache) {
  const std::size_t triangles = indices.size() / 3;
  Cuts cuts;
  for (std::size_t t = 0; t < triangles; ++t)
    if (cache.misses(&indices[3 * t]) == 3 || t == 0) cuts.push_back(t);
  cuts.push_back(triangles);
  return cuts;
}

// Cuts the part from `first` to `end` wherever it has loaded few enough vertices a triangle. What is left at the end
// stays with the last.
void cut_further(std::span<const std::uint32_t> indices, std::size_t first, std::size_t end, float most_misses,
                 Cache& cache, Cuts& cuts) {
  cache.clear();
  std::uint32_t all = 0;
  for (std::size_t t = first; t < end; ++t) all += cache.misses(&indices[3 * t]);
  const float most = most_misses * (static_cast<float>(all) / static_cast<float>(end - first));
  cache.clear();
  cuts.push_back(first);
  std::uint32_t misses = 0, triangles = 0;
  for (std::size_t t = first; t < end; ++t) {
    misses += cache.misses(&indices[3 * t]);
    ++triangles;
    if (static_cast<float>(misses) / static_cast<float>(triangles) > most) continue;
    cuts.push_back(t + 1);
    cache.clear();
    misses = triangles = 0;
  }
  if (cuts.back() != first) cuts.pop_back();
}

struct Surface {
  std::span<const std::uint32_t> indices;
  std::span<const float> positions;
  glm::vec3 corner(std::size_t i) const {
    const float* const p = &positions[std::size_t{3} * indices[i]];
    return {p[0], p[1], p[2]};
  }
};

glm::vec3 middle_of_corners(const Surface& surface) {
  glm::vec3 sum(0);
  for (std::size_t i = 0; i < surface.indices.size(); ++i) sum += surface.corner(i);
  return sum / static_cast<float>(surface.indices.size());
}

// How far the part lies on the side that it faces.
float outwardness(const Surface& surface, std::size_t first, std::size_t end, const glm::vec3& middle) {
  glm::vec3 centre(0), normal(0);
  float area = 0;
  for (std::size_t t = first; t < end; ++t) {
    const glm::vec3 a = surface.corner(3 * t), b = surface.corner(3 * t + 1), c = surface.corner(3 * t + 2);
    const glm::vec3 across = glm::cross(b - a, c - a);
    const float size = glm::length(across);
    centre += (a + b + c) * (size / 3);
    normal += across;
    area += size;
  }
  const float length = glm::length(normal);
  centre *= area > 0 ? 1 / area : 0.0f;
  normal *= length > 0 ? 1 / length : 0.0f;
  return glm::dot(centre - middle, normal);
}

// As whole numbers, so that parts that are much alike stay in the order that the cache likes.
std::vector<int> in_steps(const std::vector<float>& values) {
  constexpr float kMost = 2047;
  float largest = 1e-3f;
  for (const float v : values) largest = std::max(largest, std::abs(v));
  std::vector<int> out;
  for (const float v : values) out.push_back(static_cast<int>((0.5f - 0.5f * (v / largest)) * kMost + 0.5f));
  return out;
}

// The triangles of a mesh that is in order for the vertex cache, cut into parts, of which those that face away from the
// middle come first: what lies behind them need not be drawn. Sander, Nehab, Barczak, "Fast triangle reordering for
// vertex locality and reduced overdraw", 2007, as meshoptimizer 0.18 does it; its library for AArch64 contracts
// products, so that the order would be another there.
//
// positions: three floats a vertex. most_misses: how many more vertices than without cuts a part may load, as 1.05.
std::vector<std::uint32_t> outer_parts_first(std::span<const std::uint32_t> indices, std::span<const float> positions,
                                             float most_misses) {
  Cache cache(positions.size() / 3);
  const Cuts free = free_cuts(indices, cache);
  Cuts cuts;
  for (std::size_t i = 0; i + 1 < free.size(); ++i)
    cut_further(indices, free[i], free[i + 1], most_misses, cache, cuts);
  cuts.push_back(indices.size() / 3);

  const Surface surface{indices, positions};
  const glm::vec3 middle = middle_of_corners(surface);
  std::vector<float> outward;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    outward.push_back(outwardness(surface, cuts[i], cuts[i + 1], middle));
  const std::vector<int> inward = in_steps(outward);
  std::vector<std::size_t> order(outward.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return inward[a] < inward[b]; });

  std::vector<std::uint32_t> out;
  for (const std::size_t i : order) out.insert(out.end(), &indices[3 * cuts[i]], indices.data() + 3 * cuts[i + 1]);
  return out;
}

// A number for each vertex that a triangle uses, the same for those that agree in all of the streams that `counts`
// says; kNoSlot for the others.
std::vector<std::uint32_t> equal_vertices(const OwnedStreams& s, bool (*counts)(StreamKind), std::size_t& distinct) {
  const Rows rows(s, counts);
  std::unordered_map<std::string_view, std::uint32_t> numbers;
  std::vector<std::uint32_t> out(s.mesh.vertex_count, kNoSlot);
  for (const std::uint32_t v : s.indices)
    if (out[v] == kNoSlot)
      out[v] = numbers.try_emplace(rows.of(v), static_cast<std::uint32_t>(numbers.size())).first->second;
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

void weld(OwnedStreams& s, bool keep_map) {
  std::size_t distinct = 0;
  const std::vector<std::uint32_t> place = equal_vertices(s, moves, distinct);
  const std::vector<std::uint32_t> same = equal_vertices(s, nullptr, distinct);
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
  for (std::size_t i = 0; i < s.streams.size(); ++i)
    s.values[i] = numbers_of(s.streams[i], s.values[i], count, [&](std::size_t v) { return first[v]; });
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

Rows::Rows(const OwnedStreams& s, bool (*counts)(StreamKind)) {
  const auto width_of = [&](const Stream& stream) {
    return counts == nullptr || counts(stream.kind) ? stream.components * sizeof(std::int32_t) : 0;
  };
  for (const Stream& stream : s.streams) bytes_ += width_of(stream);
  all_.resize(bytes_ * s.mesh.vertex_count);
  std::size_t at = 0;
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const std::size_t width = width_of(s.streams[i]);
    for (std::size_t v = 0; v < s.mesh.vertex_count && width > 0; ++v)
      std::memcpy(&all_[v * bytes_ + at], &s.values[i][v * s.streams[i].components], width);
    at += width;
  }
}

RowPlaces places_of(const Rows& rows, const Rows& whole, std::uint32_t count) {
  RowPlaces out;
  for (std::uint32_t v = 0; v < count; ++v) {
    const auto [at, is_new] = out.try_emplace(rows.of(v), v);
    if (!is_new && whole.of(v) != whole.of(at->second)) return {};
  }
  return out;
}
}  // namespace marrow::cook
