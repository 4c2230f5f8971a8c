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
    return values == nullptr || std::equal(of(a), of(a) + most, of(b));
  }
};

JointLists joint_lists(const MeshStreams& mesh) {
  const Stream* const joints = mesh.find(StreamKind::joints);
  return joints == nullptr ? JointLists{} : JointLists{joints->values, joints->components};
}

}  // namespace

std::uint32_t influence_count(const MeshStreams& mesh, std::uint32_t vertex) {
  return joint_lists(mesh).count(vertex);
}

bool arrange(const MeshStreams& mesh, Memory& scratch, Arrangement& out) {
  const std::uint32_t count = mesh.vertex_count;
  out.order = scratch.take<std::uint32_t>(count).data;
  out.slot_of_vertex = scratch.take<std::uint32_t>(count).data;
  std::uint32_t* const first_use = scratch.take<std::uint32_t>(count).data;
  std::uint64_t* const keys = scratch.take<std::uint64_t>(count).data;
  if (scratch.failed) return false;
  const JointLists joints = joint_lists(mesh);
  for (std::uint32_t v = 0; v < count; ++v) {
    out.order[v] = v;
    first_use[v] = UINT32_MAX;
    keys[v] = joints.key(v);
  }
  for (std::uint32_t i = 3 * mesh.triangle_count; i-- > 0;) first_use[mesh.indices[i]] = i;

  std::sort(out.order, out.order + count, [&](std::uint32_t a, std::uint32_t b) {
    if (keys[a] != keys[b]) return keys[a] < keys[b];
    if (const std::int32_t rest = joints.compare_rest(a, b)) return rest < 0;
    return first_use[a] != first_use[b] ? first_use[a] < first_use[b] : a < b;
  });

  std::uint32_t slot = 0, run_first = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i == 0 || !joints.same(out.order[i], out.order[i - 1])) {
      slot = (slot + 3) / 4 * 4;
      run_first = slot;
      ++out.run_count;
      out.set_count += joints.count(out.order[i]);
    }
    if ((slot - run_first) % 4 == 0) out.influence_blocks += joints.count(out.order[i]);
    out.slot_of_vertex[out.order[i]] = slot++;
  }
  out.block_count = (slot + 3) / 4;
  return true;
}

}  // namespace marrow
