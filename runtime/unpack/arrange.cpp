#include "unpack/arrange.h"

#include <algorithm>

namespace marrow {
namespace {

struct JointLists {
  const std::int32_t* values = nullptr;  // null: everything follows one joint
  std::uint32_t most = 1;

  const std::int32_t* of(std::uint32_t vertex) const { return values + std::size_t{vertex} * most; }
  std::uint32_t count(std::uint32_t vertex) const {
    if (values == nullptr) return 1;
    const std::int32_t* const joints = of(vertex);
    std::uint32_t n = 1;
    while (n < most && joints[n] != joints[n - 1]) ++n;
    return n;
  }
  // Number of joints and the first four of them: sorts as they do, up to what the rest of five or more decide.
  std::uint64_t key(std::uint32_t vertex) const {
    if (values == nullptr) return 0;
    const std::uint32_t n = count(vertex);
    std::uint64_t key = n;
    for (std::uint32_t i = 0; i < 4; ++i) key = key << 15 | (i < n ? static_cast<std::uint32_t>(of(vertex)[i]) : 0u);
    return key;
  }
  // Whose fifth and further joints are the lower: less than 0, 0 or more.
  std::int32_t compare_rest(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = 4; i < most; ++i)
      if (of(a)[i] != of(b)[i]) return of(a)[i] - of(b)[i];
    return 0;
  }
  bool same(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = 0; values != nullptr && i < most; ++i)
      if (of(a)[i] != of(b)[i]) return false;
    return true;
  }
};

JointLists joint_lists(const MeshStreams& mesh) {
  const Stream* const joints = mesh.find(StreamKind::joints);
  return joints == nullptr ? JointLists{} : JointLists{joints->values, joints->components};
}

// Stretches of vertices that follow the same joints.
struct Stretches {
  std::uint32_t count = 0;
  std::uint32_t* first;       // vertex
  std::uint32_t *high, *low;  // halves of its key
  std::uint32_t* of_vertex;

  Stretches(const JointLists& joints, std::uint32_t vertex_count, std::uint32_t* of, std::uint32_t* firsts,
            std::uint32_t* halves)
      : first(firsts), high(halves), low(halves + vertex_count), of_vertex(of) {
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
      if (v == 0 || !joints.same(v, v - 1)) {
        const std::uint64_t key = joints.key(v);
        high[count] = static_cast<std::uint32_t>(key >> 32);
        low[count] = static_cast<std::uint32_t>(key);
        first[count++] = v;
      }
      of_vertex[v] = count - 1;
    }
  }
  // Less than 0, 0 or more.
  std::int32_t compare(const JointLists& joints, std::uint32_t a, std::uint32_t b) const {
    if (high[a] != high[b]) return high[a] < high[b] ? -1 : 1;
    if (low[a] != low[b]) return low[a] < low[b] ? -1 : 1;
    return joints.compare_rest(first[a], first[b]);
  }
};

// Vertices in the order of their first use, each to where its run has come to. Those that no triangle uses come last.
// seen: a vertex, all 0.
void fill_runs(const MeshStreams& mesh, const std::uint32_t* stretch_of, const std::uint32_t* run_of,
               std::uint32_t* seen, std::uint32_t* run_ends, std::uint32_t* order) {
  const auto place = [&](std::uint32_t v) {
    if (seen[v] != 0) return;
    seen[v] = 1;
    order[run_ends[run_of[stretch_of[v]]]++] = v;
  };
  for (std::uint32_t i = 0; i < 3 * mesh.triangle_count; ++i) place(mesh.indices[i]);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) place(v);
}

// Slots of vertices, run by run.
void place_runs(const JointLists& joints, Arrangement& out) {
  std::uint32_t slot = 0, i = 0;
  for (std::uint32_t run = 0; run < out.run_count; ++run) {
    const std::uint32_t influences = joints.count(out.order[i]), blocks = (out.run_ends[run] - i + 3) / 4;
    out.set_count += influences;
    out.influence_blocks += blocks * influences;
    out.block_count += blocks;
    for (; i < out.run_ends[run]; ++i) out.slot_of_vertex[out.order[i]] = slot++;
    slot = 4 * out.block_count;
  }
}

}  // namespace

std::uint32_t influence_count(const MeshStreams& mesh, std::uint32_t vertex) {
  return joint_lists(mesh).count(vertex);
}

bool arrange(const MeshStreams& mesh, Memory& scratch, Arrangement& out) {
  const std::uint32_t count = mesh.vertex_count;
  std::uint32_t* const sorted = scratch.take<std::uint32_t>(count).data;
  std::uint32_t* const stretch_of = scratch.take<std::uint32_t>(count).data;
  std::uint32_t* const first = scratch.take<std::uint32_t>(count).data;
  std::uint32_t* const halves = scratch.take<std::uint32_t>(2 * std::uint64_t{count}).data;
  if (scratch.failed) return false;
  const JointLists joints = joint_lists(mesh);
  const Stretches stretches(joints, count, stretch_of, first, halves);
  for (std::uint32_t s = 0; s < stretches.count; ++s) sorted[s] = s;
  std::sort(sorted, sorted + stretches.count, [&](std::uint32_t a, std::uint32_t b) {
    const std::int32_t different = stretches.compare(joints, a, b);
    return different != 0 ? different < 0 : a < b;
  });

  std::uint32_t before = 0;
  // A stretch's run takes the place of a key that is compared no more, a run's first place that of what is sorted.
  std::uint32_t* const run_of = stretches.low;
  for (std::uint32_t s = 0, at = 0; s < stretches.count; ++s) {
    const std::uint32_t stretch = sorted[s], last = out.run_count - 1;
    if (s == 0 || stretches.compare(joints, before, stretch) != 0) sorted[out.run_count++] = at;
    if (s > 0) run_of[before] = last;
    before = stretch;
    at += (stretch + 1 < stretches.count ? first[stretch + 1] : count) - first[stretch];
  }
  run_of[before] = out.run_count - 1;

  out.run_ends = sorted;
  out.order = first;
  out.slot_of_vertex = stretches.high;
  for (std::uint32_t v = 0; v < count; ++v) out.slot_of_vertex[v] = 0;
  fill_runs(mesh, stretch_of, run_of, out.slot_of_vertex, out.run_ends, out.order);
  place_runs(joints, out);
  return true;
}

}  // namespace marrow
