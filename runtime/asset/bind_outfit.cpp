// Whether an outfit fits a body: both skeletons are walked once, side by side, as both are breadth-first.
#include <cstring>

#include "asset/misfits.h"
#include "core/check.h"
#include "marrow/outfit.h"

namespace marrow {
namespace {

// Called once it is known that something is in the way. reached: how many joints of the body were found in order.
void list(const Joints& outfit, const Joints& body, std::uint32_t reached, Misfits& out) {
  for (std::uint32_t j = 0; j < body.count; ++j) {
    const std::uint32_t found = outfit.find(body.name(j), j);
    if (found == outfit.count) {
      out.add(Misfit::extra, j);
    } else if (std::strcmp(body.parent_name(j), outfit.parent_name(found)) != 0) {
      out.add(Misfit::other_parent, found);
    }
  }
  for (std::uint32_t j = 0; j < outfit.count && outfit.parents[j] == kNoJoint; ++j)
    if (body.find(outfit.name(j), j) == body.count) out.add(Misfit::missing, j);
  if (out.count() > 0) return;
  const std::uint32_t first = reached < body.count ? outfit.find(body.name(reached), reached) : 0;
  out.add(Misfit::other_place, first);
}

}  // namespace

Status bind_outfit(const File& outfit, std::uint32_t skeleton, const File& body, std::uint32_t body_skeleton,
                   Span<std::uint16_t> body_joints, Span<JointMisfit> misfits, std::size_t* misfit_count) {
  if (misfit_count != nullptr) *misfit_count = 0;
  MARROW_REQUIRE(skeleton < outfit.skeleton_count());
  MARROW_REQUIRE(body_skeleton < body.skeleton_count());
  const Skeleton own = outfit.skeleton(skeleton), there = body.skeleton(body_skeleton);
  MARROW_REQUIRE(holds(body_joints, own.joint_count));
  MARROW_REQUIRE(holds(misfits, misfits.size));
  const Joints worn{outfit, own.names, own.parents, own.joint_count};
  const Joints wearer{body, there.names, there.parents, there.joint_count};
  std::uint32_t next = 0;
  bool loose = false;  // a root that is none of the body's
  for (std::uint32_t j = 0; j < own.joint_count; ++j) {
    const bool root = j < own.root_count;
    const std::uint16_t above = root ? kNoJoint : body_joints[own.parents[j]];
    const bool hangs_alike = next < there.joint_count && there.parents[next] == above && (root || above != kNoJoint);
    const bool same = hangs_alike && std::strcmp(worn.name(j), wearer.name(next)) == 0;
    body_joints[j] = same ? static_cast<std::uint16_t>(next++) : kNoJoint;
    loose = loose || (root && !same);
  }
  if (next == there.joint_count && !loose) return Status::ok;
  Misfits found(misfits);
  if (misfit_count != nullptr || !misfits.empty()) list(worn, wearer, next, found);
  if (misfit_count != nullptr) *misfit_count = found.count();
  return Status::mismatch;
}

}  // namespace marrow
