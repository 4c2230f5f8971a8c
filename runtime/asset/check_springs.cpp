// Rules of SPRI sections.
#include "asset/checker.h"
#include "asset/spring_rules.h"

namespace marrow {

using format::layout;

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

bool Checker::spring_chain(const format::SpringHeader& h, const format::SpringRecord& chain,
                           const SpringJoint* joints) {
  if (!good_point(chain.tip)) return fail(&chain, "a tip that is not finite, or beyond 1e6");
  if (chain.reserved != 0) return fail(&chain, "reserved must be 0");
  if (h.collider_count < kMaxSpringColliders && chain.colliders >> h.collider_count != 0)
    return fail(&chain, "a collider that is not there");
  if (chain.joint_count == 1 && !(chain.tip[0] != 0 || chain.tip[1] != 0 || chain.tip[2] != 0))
    return fail(&chain, "a chain without a bone");
  const File::Section& of = nth(format::kSkeletons, h.skeleton);
  const auto& skeleton = *at<format::SkeletonHeader>(of, 0);
  const auto* parents = at<std::uint16_t>(of, layout(skeleton).parents);
  for (const SpringJoint* j = joints; j != joints + chain.joint_count; ++j) {
    if (j->joint >= skeleton.joint_count) return fail(j, "a joint outside the skeleton");
    if (j != joints && !is_below(parents, j->joint, j[-1].joint))
      return fail(j, "each joint of a chain is below the one before it, by 255 generations at most");
    if (!good_settings(*j)) return fail(j, "a setting out of its range");
  }
  return true;
}

bool Checker::springs(const File::Section& s) {
  const auto* h = header<format::SpringHeader>(s);
  if (h == nullptr) return false;
  const auto* skeleton = only_of_skeleton(s, "one section of springs a skeleton, in their order");
  if (skeleton == nullptr) return false;
  const std::uint32_t joint_count = skeleton->joint_count;
  if (h->chain_count == 0) return fail(&h->chain_count, "a section of springs without a chain");
  if (h->joint_count > joint_count) return fail(&h->joint_count, "more joints than the skeleton has");
  if (h->collider_count > kMaxSpringColliders) return fail(&h->collider_count, "at most 64 colliders");
  const format::SpringLayout l = layout(*h);
  const auto* chains = at<format::SpringRecord>(h, l.chains);
  const auto* joints = at<SpringJoint>(h, l.joints);
  std::uint32_t next = 0;
  for (std::uint32_t c = 0; c < h->chain_count; ++c) {
    if (chains[c].first_joint != next || chains[c].joint_count == 0 || chains[c].joint_count > h->joint_count - next)
      return fail(chains + c, "chains share out the joints, one after the other");
    if (!spring_chain(*h, chains[c], joints + next)) return false;
    next += chains[c].joint_count;
  }
  if (next != h->joint_count) return fail(&h->joint_count, "joints of no chain");
  const auto* colliders = at<SpringCollider>(h, l.colliders);
  for (std::uint32_t i = 0; i < h->collider_count; ++i) {
    if (colliders[i].joint >= joint_count) return fail(colliders + i, "a joint outside the skeleton");
    if (colliders[i].reserved != 0) return fail(colliders + i, "reserved must be 0");
    if (!good_collider(colliders[i])) return fail(colliders + i, "a collider that is not finite, or beyond 1e6");
  }
  return true;
}

}  // namespace marrow
