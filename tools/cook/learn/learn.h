// Animation space out of what a better deformer does in the character's own poses.
#pragma once

#include <string>
#include <vector>

#include "cook/learn/examples.h"
#include "cook/learn/truths.h"
#include "cook/scene/cook_options.h"
#include "deform/fit/fit.h"

namespace marrow::cook {

// How many moments of clips tell whether something jumps.
inline constexpr std::size_t kFramesInARow = 64;

// DeformSource::shown of a mesh: where examples are the truth they are read; else none.
std::vector<ShownPose> find_examples(const LearnOptions& options, const Shown& shown);
// The poses to learn from: moments of clips, or examples, which `source` must have then.
Trainees find_trainees(const DeformSource& source, const BuiltScene& built, const LearnOptions& options);

// Coordinates, and how good they are by cross-validation.
struct Learnt {
  deform::Coordinates coordinates;  // over the mesh's joints and, behind them, the helpers
  // Over the same: what linear blend skinning makes of them is SSD (deform::on_joints()).
  std::vector<std::vector<deform::Influence>> weights;
  std::vector<deform::Helper> helpers;
  deform::FitQuality quality;
  double rms_m = 0;  // what is left, over shipped poses
};
// Without a better result than SSD's, SSD's. poses: of the joints; helpers are added here. The lift takes
// of poses how alike joints turn, and nothing else.
Learnt learn(const DeformSource& source, std::vector<deform::TrainingPose> poses, const LearnOptions& options,
             const deform::Progress& progress = {});

// How finely files keep what a mesh of this size has learnt: to a half of what is left of the error, of a body to a
// third, as more would fold small triangles; and never finer than a 16384th of the size.
double residual_step_m(const Learnt& learnt, double size_m, const LearnOptions& options);

struct LearntBinding {
  SkinBinding binding;  // with residuals and helpers
  LearnReport report;
};
// binding: of the mesh to the skin. Notes a fit that is not shipped.
LearntBinding learn_binding(const RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                            const LearnOptions& options, SkinBinding binding, Notes& notes);

}  // namespace marrow::cook
