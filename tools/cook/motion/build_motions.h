// What clips do beside their poses: as MOTN sections have it.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

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
