// What is asked of SPRI sections beyond their description.
#include "asset/checker.h"
#include "asset/spring_rules.h"

namespace marrow {
namespace {

// Within kLongestSpringBone generations. joint: below the skeleton's count, and not `above` itself.
bool is_near_below(const std::uint16_t* parents, std::uint32_t joint, std::uint32_t above) {
  for (std::uint32_t n = 0; n < format::kLongestSpringBone && joint > above; ++n) {  // a parent has the lower number
    joint = parents[joint];
    if (joint == above) return true;
    if (joint == kNoJoint) return false;
  }
  return false;
}

bool check_chain_joints(Checker& c, Span<const SpringJoint> joints) {
  const format::SkeletonHeader& skeleton = c.owner();
  const std::uint16_t* const parents = layout(skeleton).parents.in(&skeleton).data;
  for (const SpringJoint* j = joints.begin(); j != joints.end(); ++j) {
    if (j->joint >= skeleton.joint_count) return c.fail(j, "a joint outside the skeleton");
    if (j != joints.begin() && !is_near_below(parents, j->joint, j[-1].joint))
      return c.fail(j, "each joint of a chain is below the one before it, by 255 generations at most");
    if (!good_settings(*j)) return c.fail(j, "a setting out of its range");
  }
  return true;
}

}  // namespace

void check(Checker& c, const format::SpringHeader& h) {
  format::SpringLayout l;
  if (!check_fields(c, h, l)) return;
  std::uint32_t next = 0;
  for (const format::SpringRecord& chain : c.in(l.chains)) {
    if (chain.first_joint != next || chain.joint_count == 0 || chain.joint_count > h.joint_count - next)
      c.fail(&chain, "chains share out the joints, one after the other");
    else if (h.collider_count < kMaxSpringColliders && chain.colliders >> h.collider_count != 0)
      c.fail(&chain, "a collider that is not there");
    else if (chain.joint_count == 1 && chain.tip[0] == 0 && chain.tip[1] == 0 && chain.tip[2] == 0)
      c.fail(&chain, "a chain without a bone");
    if (!c.good() || !check_chain_joints(c, {c.in(l.joints).data + next, chain.joint_count})) return;
    next += chain.joint_count;
  }
  if (next != h.joint_count) c.fail(&h.joint_count, "joints of no chain");
}

}  // namespace marrow
