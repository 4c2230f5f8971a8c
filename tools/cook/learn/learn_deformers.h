// Multi-weight enveloping and pose space out of what a better deformer does in the character's own poses.
#pragma once

#include "cook/geometry/owned_streams.h"
#include "cook/scene/cook_options.h"
#include "cook/skin/deform_source.h"

namespace marrow::cook {

// The joint whose frame multi-weights are meant in: of those that vertices follow the nearest to the skeleton's root.
std::uint32_t multi_weight_root(const DeformSource& source);

struct LearntDeformers {
  BoundDeformers deformers;
  DeformerReport multi_weights, pose_space;
};
// Fits what `options` ask for to the influences that the file will keep, once animation space has been learnt. Notes
// each that is not shipped, as it does not beat SSD in poses left out. grid: of positions.
LearntDeformers learn_deformers(const RawScene& scene, const RawMesh& mesh, const RawSkin& skin,
                                const BuiltScene& built, const MeshOptions& options, const LearnOptions& wanted,
                                MeshGrid grid, const SkinBinding& binding, Notes& notes);

}  // namespace marrow::cook
