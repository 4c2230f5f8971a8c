// What clips do beside their poses, as MOTN sections have it: events, steps, speed, and the root's motion.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "cook/motion/find_contacts.h"
#include "cook/motion/trace_clip.h"
#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// The mean velocity over the ground, level, model space. Of a clip that turns as it goes, its length is that of the arc
// and its direction that of the arc's chord.
glm::dvec3 velocity_of(const ClipTrace& trace, const Contacts& contacts);

struct RootTrack {
  std::vector<RootKey> keys;     // M(t) as ClipMotion::root has it; empty: it does not move
  std::vector<RootKey> in_pose;  // what of it the clip's poses have: all, but for clips that walk on the spot
};

// From the hips, and for clips that walk on the spot from their contacts. What it leaves out stays in the pose, so both
// together are the clip. A loop goes evenly from its start to its end, along a line or round an arc: then clips may be
// blended at changing weights without the sway of their hips turning the character. Other clips follow the hips within
// a thirtieth of a leg and five degrees; their last key is exact.
RootTrack find_root(const ClipTrace& trace, const Contacts& contacts, RootMotion how);

// Whether take_out_root() can do its work: the scale above each root is the same along all axes, and no root jumps.
bool can_take_out_root(const BuiltClip& clip, const BuiltSkeleton& skeleton);
// Takes M(t) out of a clip: its roots' channels become those of M⁻¹ · pose. clip: as it is. channels: the same.
void take_out_root(const std::vector<RootKey>& root, const BuiltClip& clip, const BuiltSkeleton& skeleton,
                   RawClip& channels);

// Of each of the built clips, which have their keys as the source has them. built: skeletons with roles, and clips.
// meshes: of all skeletons, without levels of detail. Additive clips have events alone. Notes what of the source's
// events is wrong, and roots that cannot be taken out of their clips. Throws tools::Failure (usage) at rules that fit
// no clip or lie outside it.
std::vector<BuiltMotion> build_motions(const RawScene& scene, const BuiltScene& built, const std::vector<Mesh>& meshes,
                                       const MotionOptions& options, Notes& notes);

// The same, into the clips of `built`.
void measure_motions(const RawScene& scene, const std::vector<Mesh>& meshes, const MotionOptions& options,
                     BuiltScene& built, Notes& notes);

}  // namespace marrow::cook
