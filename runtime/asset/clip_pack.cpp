#include "marrow/clip_pack.h"

#include <cstring>

#include "asset/misfits.h"
#include "asset/skeleton_hash.h"
#include "core/check.h"
#include "core/zone.h"

namespace marrow {
namespace {

void list(const Joints& wanted, const std::uint32_t* rest_hashes, const Joints& there, const SoaTransform* rest,
          Misfits& out) {
  for (std::uint32_t j = 0; j < wanted.count; ++j) {
    const std::uint32_t found = there.find(wanted.name(j), j);
    if (found == there.count) {
      out.add(Misfit::missing, j);
    } else if ((wanted.parents[j] == kNoJoint) != (there.parents[found] == kNoJoint) ||
               std::strcmp(wanted.parent_name(j), there.parent_name(found)) != 0) {
      out.add(Misfit::other_parent, j);
    } else if (rest_hashes[j] != rest_hash(rest, found)) {
      out.add(Misfit::other_rest, j);
    }
  }
  for (std::uint32_t j = 0; j < there.count; ++j)
    if (wanted.find(there.name(j), j) == wanted.count) out.add(Misfit::extra, j);
  if (out.count() > 0) return;
  for (std::uint32_t j = 0; j < wanted.count; ++j)
    if (there.find(wanted.name(j), j) != j) out.add(Misfit::other_place, j);
}

}  // namespace

std::uint64_t skeleton_hash(const File& file, std::uint32_t index) {
  const Skeleton skeleton = file.skeleton(index);
  Fnv64 hash;
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j)
    add_joint(hash, file.text(skeleton.names[j]), skeleton.parents[j], skeleton.rest, j);
  return hash.value();
}

Status bind_clips(const File& pack, std::uint32_t reference, const File& character, std::uint32_t skeleton,
                  Span<JointMisfit> misfits, std::size_t* misfit_count) {
  MARROW_ZONE;
  if (misfit_count != nullptr) *misfit_count = 0;
  MARROW_REQUIRE(reference < pack.reference_count());
  MARROW_REQUIRE(skeleton < character.skeleton_count());
  MARROW_REQUIRE(holds(misfits, misfits.size));
  const SkeletonReference wanted = pack.reference(reference);
  const Skeleton there = character.skeleton(skeleton);
  if (wanted.joint_count == there.joint_count && wanted.hash == skeleton_hash(character, skeleton)) return Status::ok;
  Misfits found(misfits);
  if (misfit_count != nullptr || !misfits.empty())
    list({pack, wanted.names, wanted.parents, wanted.joint_count}, wanted.rest_hashes,
         {character, there.names, there.parents, there.joint_count}, there.rest, found);
  if (misfit_count != nullptr) *misfit_count = found.count();
  return Status::mismatch;
}

}  // namespace marrow
