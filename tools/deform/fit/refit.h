// Better weights for linear blend skinning.
#pragma once

#include <vector>

#include "deform/fit/fit.h"

namespace marrow::deform {

// The mesh with the weights, each vertex's own joints, that are nearest to the truth in the least-squares sense; they
// sum to 1 and may be negative. ridge: how strongly the old weights hold, as a share of how far the joints move the
// vertex.
SkinnedMesh refit_weights(const SkinnedMesh& mesh, const std::vector<TrainingPose>& poses, const Deformer& truth,
                          double ridge = 1e-3);

}  // namespace marrow::deform
