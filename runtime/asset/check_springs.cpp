// Rules of SPRI sections that are code.
#include "asset/checker.h"
#include "asset/spring_rules.h"

namespace marrow {
namespace {

// Within kLongestSpringBone generations. joint: below the skeleton's count, and not `above` itself.
bool is_below(const std::uint16_t* parents, std::uint32_t joint, std::uint32_t above) {
  for (std::uint32_t n = 0; n < format::kLongestSpringBone && joint > above; ++n) {  // a parent has the lower number
    joint = parents[joint];
    if (joint == above) return true;
    if (joint == kNoParent) return false;
  }
  return false;
}

}  // namespace

bool Checker::chain_joints() {
  const auto& chain = record<format::SpringRecord>();
  const auto* const joints = array<SpringJoint>(MARROW_PLACE(SpringLayout, joints)) + so_far_.next_joint;
  so_far_.next_joint += chain.joint_count;
  const auto& skeleton = *static_cast<const format::SkeletonHeader*>(base(From::owner));
  const auto* const parents = at<std::uint16_t>(base(From::owner), format::layout(skeleton).parents);
  for (const SpringJoint* j = joints; j != joints + chain.joint_count; ++j) {
    if (j->joint >= skeleton.joint_count) return fail(j, "a joint outside the skeleton");
    if (j != joints && !is_below(parents, j->joint, j[-1].joint))
      return fail(j, "each joint of a chain is below the one before it, by 255 generations at most");
    if (!good_settings(*j)) return fail(j, "a setting out of its range");
  }
  return true;
}

}  // namespace marrow
