// Makes spring bones: from chains to groups of four.
#include <cmath>
#include <cstring>

#include "asset/spring_rules.h"
#include "core/check.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "math/finite.h"
#include "pose/hierarchy.h"
#include "springs/spring_state.h"

namespace marrow {
namespace {

constexpr float kTwoPi = 6.28318531f;

std::size_t bone_count(const SpringChain& chain) {
  const std::size_t joints = chain.joints.size;
  return joints == 0 ? 0 : has_tip(chain) ? joints : joints - 1;
}
std::size_t groups_of(Span<const SpringChain> chains) {
  std::size_t bones = 0;
  for (const SpringChain& chain : chains) bones += bone_count(chain);
  return (bones + 3) / 4;
}

BadCall check_chains(const Skeleton& skeleton, Span<const SpringChain> chains) {
  MARROW_CHECK(holds(chains) && chains.size <= skeleton.joint_count);
  std::size_t joints = 0;
  for (const SpringChain& chain : chains) {
    MARROW_CHECK(holds(chain.joints) && bone_count(chain) > 0);
    joints += chain.joints.size;
    MARROW_CHECK(joints <= skeleton.joint_count);
    MARROW_CHECK(good_point(chain.tip));
    for (std::size_t i = 0; i < chain.joints.size; ++i) {
      const SpringJoint& j = chain.joints[i];
      MARROW_CHECK(j.joint < skeleton.joint_count);
      MARROW_CHECK(i == 0 ||
                   (j.joint != chain.joints[i - 1].joint && hangs_below(skeleton, j.joint, chain.joints[i - 1].joint)));
      MARROW_CHECK(good_settings(j));
    }
  }
  return {};
}

void set_bone(const SpringJoint& from, SpringGroup& to, std::size_t lane) {
  const float omega = kTwoPi * from.frequency_hz;
  to.stiffness[lane] = omega * omega;
  to.damping[lane] = 2.0f * from.damping_ratio * omega;
  to.drag[lane] = from.drag;
  to.gravity[lane] = from.gravity;
  to.radius_m[lane] = from.radius_m;
  to.weight[lane] = from.weight;
  to.most_pull[lane] = from.most_pull != 0 ? static_cast<float>(from.most_pull) : kAnyPull;
}

// Calls f(bone, its chain's number, its joint, its end or null) for every bone.
template <class F>
void for_each_bone(Span<const SpringChain> chains, F f) {
  std::size_t bone = 0;
  for (std::size_t c = 0; c < chains.size; ++c) {
    const SpringChain& chain = chains[c];
    for (std::size_t i = 0, count = bone_count(chain); i < count; ++i, ++bone)
      f(bone, c, chain.joints[i], i + 1 < chain.joints.size ? &chain.joints[i + 1] : nullptr);
  }
}

void set_roots(Span<const SpringChain> chains, SpringRoot* roots) {
  for (std::size_t c = 0; c < chains.size; ++c) {
    roots[c].first = chains[c].joints[0].joint;
    roots[c].shown = 0;
    roots[c].colliders = chains[c].colliders;
    for (int i = 0; i < 3; ++i) roots[c].tip[i] = chains[c].tip[i];
  }
  for_each_bone(chains, [&](std::size_t, std::size_t c, const SpringJoint& j, const SpringJoint*) {
    if (j.weight > 0.0f) roots[c].shown = 1;
  });
}

// Whether springs change the joint's matrix.
bool among(const Springs& springs, std::uint32_t joint) {
  std::uint32_t low = 0, high = springs.below_count;
  while (low < high) {
    const std::uint32_t middle = (low + high) / 2;
    if (springs.below[middle].end <= joint) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < springs.below_count && springs.below[low].first <= joint;
}

// Finds every joint in or below a chain that shows something.
void find_below(const Skeleton& skeleton, Springs& springs) {
  springs.below_count = 0;
  for (std::uint32_t joint = 0; joint < skeleton.joint_count; ++joint) {
    bool in = joint >= skeleton.root_count && among(springs, skeleton.parents[joint]);
    for (std::uint32_t r = 0; r < springs.root_count && !in; ++r)
      in = springs.roots[r].shown != 0 && springs.roots[r].first == joint;
    if (!in) continue;
    const auto number = static_cast<std::uint16_t>(joint);
    if (springs.below_count == 0 || springs.below[springs.below_count - 1].end != number)
      springs.below[springs.below_count++] = {number, number};
    ++springs.below[springs.below_count - 1].end;
  }
}

}  // namespace

std::size_t springs_bytes(const Skeleton& skeleton, Span<const SpringChain> chains) {
  if (!holds(chains, 1)) return 0;
  const std::size_t ranges = (static_cast<std::size_t>(skeleton.joint_count) + 1) / 2;
  return groups_of(chains) * sizeof(SpringGroup) + chains.size * sizeof(SpringRoot) + ranges * sizeof(JointRange);
}

Status make_springs(const Skeleton& skeleton, Span<const SpringChain> chains, Span<std::byte> memory, Springs& out) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_chains(skeleton, chains));
  const std::size_t bytes = springs_bytes(skeleton, chains), groups = groups_of(chains);
  MARROW_REQUIRE(holds(memory, bytes));
  if (bytes > 0) MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  if (bytes > 0) std::memset(memory.data, 0, bytes);
  out.groups = reinterpret_cast<SpringGroup*>(memory.data);
  out.roots = reinterpret_cast<SpringRoot*>(memory.data + groups * sizeof(SpringGroup));
  out.below = reinterpret_cast<JointRange*>(out.roots + chains.size);
  out.group_count = static_cast<std::uint32_t>(groups);
  out.root_count = static_cast<std::uint32_t>(chains.size);
  out.joint_count = skeleton.joint_count;
  out.saved_s = 0;
  for (std::size_t i = 0; i < 4 * groups; ++i) out.groups[i / 4].joint[i % 4] = kNoBone;
  for_each_bone(chains, [&](std::size_t bone, std::size_t c, const SpringJoint& j, const SpringJoint* end) {
    SpringGroup& group = out.groups[bone / 4];
    const std::size_t lane = bone % 4;
    set_bone(j, group, lane);
    group.joint[lane] = j.joint;
    group.end[lane] = end != nullptr ? end->joint : kNoBone;
    group.root[lane] = static_cast<std::uint16_t>(c);
  });
  set_roots(chains, out.roots);
  find_below(skeleton, out);
  return Status::ok;
}

Status set_springs(const Skeleton& skeleton, Span<const SpringChain> chains, Springs& springs) {
  MARROW_REQUIRE_GOOD(check_chains(skeleton, chains));
  MARROW_REQUIRE(skeleton.joint_count == springs.joint_count);
  MARROW_REQUIRE(chains.size == springs.root_count);
  MARROW_REQUIRE(groups_of(chains) == springs.group_count);
  bool same = true;
  std::size_t bones = 0;
  for_each_bone(chains, [&](std::size_t bone, std::size_t c, const SpringJoint& j, const SpringJoint* end) {
    const SpringGroup& group = springs.groups[bone / 4];
    const std::size_t lane = bone % 4;
    same = same && group.joint[lane] == j.joint && group.root[lane] == c &&
           group.end[lane] == (end != nullptr ? end->joint : kNoBone);
    ++bones;
  });
  for (; bones % 4 != 0; ++bones) same = same && springs.groups[bones / 4].joint[bones % 4] == kNoBone;
  MARROW_REQUIRE(same && "the joints that the springs were made for");
  for_each_bone(chains, [&](std::size_t bone, std::size_t, const SpringJoint& j, const SpringJoint*) {
    set_bone(j, springs.groups[bone / 4], bone % 4);
  });
  set_roots(chains, springs.roots);
  find_below(skeleton, springs);
  return Status::ok;
}

void reset_springs(Springs& springs) {
  for (std::uint32_t g = 0; g < springs.group_count; ++g) {
    std::memset(springs.groups[g].direction, 0, sizeof springs.groups[g].direction);
    std::memset(springs.groups[g].bent, 0, sizeof springs.groups[g].bent);
  }
  for (std::uint32_t r = 0; r < springs.root_count; ++r) {
    std::memset(springs.roots[r].velocity, 0, sizeof springs.roots[r].velocity);
    springs.roots[r].frames = 0;
  }
  springs.saved_s = 0;
}

}  // namespace marrow
