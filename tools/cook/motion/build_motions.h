// What clips do beside their poses, as MOTN sections have it: events, steps, speed, and the root's motion.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

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
