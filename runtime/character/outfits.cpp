// Which skeleton of a body each skeleton of an outfit follows, and all of them in the body's pose.
#include <cstring>

#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "marrow/character.h"
#include "marrow/outfit.h"

namespace marrow {
namespace {

struct OutfitPieces {
  Span<OutfitSkeleton> skeletons;
  Span<std::uint16_t> joints;  // skeleton after skeleton
};

OutfitPieces lay_out(const File& outfit, Memory& memory) {
  std::uint64_t joints = 0;
  for (std::uint32_t s = 0; s < outfit.skeleton_count(); ++s) joints += outfit.skeleton(s).joint_count;
  OutfitPieces out;
  out.skeletons = memory.take<OutfitSkeleton>(outfit.skeleton_count());
  out.joints = memory.take<std::uint16_t>(joints);
  return out;
}

// The skeleton of the body with this one's name if it fits that, else the first that it fits; skeleton_count(): none.
std::uint32_t wearer_of(const File& body, const File& outfit, std::uint32_t skeleton, Span<std::uint16_t> joints) {
  const std::uint32_t count = body.skeleton_count();
  const std::uint32_t named = body.find_skeleton(outfit.skeleton(skeleton).name);
  if (named < count && bind_outfit(outfit, skeleton, body, named, joints) == Status::ok) return named;
  for (std::uint32_t s = 0; s < count; ++s)
    if (s != named && bind_outfit(outfit, skeleton, body, s, joints) == Status::ok) return s;
  return count;
}

BadCall check_outfit(const Outfit& outfit, const Character& body, const Character& worn) {
  MARROW_CHECK(outfit.skeletons.size == worn.skeletons.size);
  for (std::size_t s = 0; s < worn.skeletons.size; ++s) {
    const OutfitSkeleton& follows = outfit.skeletons[s];
    const Skeleton& own = worn.skeletons[s].pose.skeleton;
    MARROW_CHECK(follows.body_skeleton < body.skeletons.size);
    MARROW_CHECK(holds(follows.body_joints, own.joint_count));
    const std::size_t joints = body.skeletons[follows.body_skeleton].pose.model_from_joint.size;
    for (std::uint32_t j = 0; j < own.joint_count; ++j)
      MARROW_CHECK(follows.body_joints[j] == kNoJoint ? j >= own.root_count : follows.body_joints[j] < joints);
  }
  return {};
}

}  // namespace

std::size_t outfit_bytes(const File& outfit) {
  Memory counted;
  lay_out(outfit, counted);
  return counted.whole();
}

Status make_outfit(const File& body, const File& outfit, Span<std::byte> memory, Outfit& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(memory, outfit_bytes(outfit)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  if (outfit.skeleton_count() == 0) return Status::mismatch;
  Memory taken{memory.data};
  const OutfitPieces pieces = lay_out(outfit, taken);
  std::size_t first = 0;
  for (std::uint32_t s = 0; s < outfit.skeleton_count(); ++s) {
    const Span<std::uint16_t> joints(pieces.joints.data + first, outfit.skeleton(s).joint_count);
    const std::uint32_t wearer = wearer_of(body, outfit, s, joints);
    if (wearer == body.skeleton_count()) return Status::mismatch;
    pieces.skeletons[s] = {wearer, joints};
    first += joints.size;
  }
  out = {pieces.skeletons};
  return Status::ok;
}

Status follow_body(const Outfit& outfit, const Character& body, Character& worn) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_outfit(outfit, body, worn));
  for (std::size_t s = 0; s < worn.skeletons.size; ++s) {
    const OutfitSkeleton& follows = outfit.skeletons[s];
    const Pose &own = worn.skeletons[s].pose, &on = body.skeletons[follows.body_skeleton].pose;
    const Status status =
        follow_body(own.skeleton, follows.body_joints, on.model_from_joint, own.local, own.model_from_joint);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

}  // namespace marrow
