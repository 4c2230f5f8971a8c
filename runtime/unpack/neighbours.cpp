#include "unpack/neighbours.h"

#include <algorithm>

namespace marrow {
namespace {

// Less than 0, 0 or more, by what two vertices have in the streams that say how they move.
std::int32_t compare(const Stream* const (&streams)[3], std::uint32_t a, std::uint32_t b) {
  for (const Stream* const s : streams) {
    const std::int32_t *const x = s->values + std::size_t{a} * s->components, *const y = s->values +
                                                                                         std::size_t{b} * s->components;
    for (std::uint32_t c = 0; c < s->components; ++c)
      if (x[c] != y[c]) return x[c] < y[c] ? -1 : 1;
  }
  return 0;
}

void find_leaders(const MeshStreams& mesh, std::uint32_t* order, std::uint32_t* leader) {
  const Stream* const streams[] = {mesh.find(StreamKind::position), mesh.find(StreamKind::joints),
                                   mesh.find(StreamKind::weights)};
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) order[v] = v;
  std::sort(order, order + mesh.vertex_count, [&](std::uint32_t a, std::uint32_t b) {
    const std::int32_t different = compare(streams, a, b);
    return different != 0 ? different < 0 : a < b;
  });
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    const bool same = i > 0 && compare(streams, order[i], order[i - 1]) == 0;
    leader[order[i]] = same ? leader[order[i - 1]] : order[i];
  }
}

// Calls f(corner, one of the other two) for all of each triangle whose corners are different leaders.
template <class F>
void for_each_side(const MeshStreams& mesh, const std::uint32_t* leader, const F& f) {
  for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const std::uint32_t* const i = mesh.indices + std::size_t{t} * 3;
    const std::uint32_t a = leader[i[0]], b = leader[i[1]], c = leader[i[2]];
    if (a == b || b == c || c == a) continue;
    f(a, b), f(a, c), f(b, c), f(b, a), f(c, a), f(c, b);
  }
}

}  // namespace

bool find_neighbours(const MeshStreams& mesh, Memory& memory, MeshNeighbours& out) {
  const std::uint32_t count = mesh.vertex_count;
  out.leader = memory.take<std::uint32_t>(count).data;
  out.first = memory.take<std::uint32_t>(count).data;
  out.count = memory.take<std::uint32_t>(count).data;
  out.scratch = memory.take<std::uint32_t>(count).data;
  out.scratch_2 = memory.take<std::uint32_t>(count).data;
  out.is_inside = memory.take<std::uint8_t>(count).data;
  out.all = memory.take<std::uint32_t>(std::uint64_t{mesh.triangle_count} * 6).data;
  if (memory.failed) return false;
  find_leaders(mesh, out.scratch, out.leader);
  for (std::uint32_t v = 0; v < count; ++v) out.count[v] = 0;
  for_each_side(mesh, out.leader, [&](std::uint32_t v, std::uint32_t) { ++out.count[v]; });
  for (std::uint32_t v = 0, sum = 0; v < count; ++v) {
    out.first[v] = sum;
    sum += out.count[v];
    out.count[v] = 0;
  }
  for_each_side(mesh, out.leader,
                [&](std::uint32_t v, std::uint32_t other) { out.all[out.first[v] + out.count[v]++] = other; });
  // Each once; how often one stood there is how many triangles the edge to it has.
  std::uint32_t *const seen_by = out.scratch, *const times = out.scratch_2;
  for (std::uint32_t v = 0; v < count; ++v) seen_by[v] = UINT32_MAX;
  for (std::uint32_t v = 0; v < count; ++v) {
    std::uint32_t* const row = out.all + out.first[v];
    std::uint32_t distinct = 0;
    for (std::uint32_t i = 0; i < out.count[v]; ++i) {
      const std::uint32_t other = row[i];
      if (seen_by[other] != v) {
        seen_by[other] = v;
        times[other] = 0;
        row[distinct++] = other;
      }
      ++times[other];
    }
    out.count[v] = distinct;
    bool inside = distinct > 0;
    for (std::uint32_t i = 0; i < distinct; ++i) inside = inside && times[row[i]] == 2;
    out.is_inside[v] = inside ? 1 : 0;
  }
  return true;
}

}  // namespace marrow
