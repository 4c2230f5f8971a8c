// Animation-space coordinates out of examples: constrained, ridge-regularised least squares.
#pragma once

#include <vector>

#include "deform/animation_space.h"
#include "deform/fit/progress.h"
#include "deform/helpers/closed_form.h"

namespace marrow::deform {

struct TrainingPose {
  Pose pose;
  std::uint32_t fold = 0;  // poses that cross-validation leaves out together: those of one clip
  bool shipped = true;     // of a clip, not made up
  bool learnt = true;      // false: of a range of motion, which fits are judged by and never learn
};

struct FitOptions {
  bool keep_bind_pose = false;
  // Tried by cross-validation, beside keeping the prior; with one fold the first is taken.
  std::vector<double> ridges = {1e-3, 1e-7, 1e-6, 1e-5, 1e-4, 1e-2, 1e-1};
  // Where not null, a vertex follows only the `most_joints` of its candidates that matter most, more where fewer cannot
  // make up its weights. is_lift: the candidates are the lift of these.
  const ClosedForm* weights = nullptr;
  bool is_lift = true;
  std::size_t most_joints = 4;
  double unseen = 0;                   // and none whose loss costs less: the mean square over poses, in diagonals
  const Surface* even_over = nullptr;  // where not null, what is missed of the truth goes over smoothly
  double most_worse = 0.02;  // share of shipped poses that may be worse than the reference, where that can be had
  Progress progress = {};    // of poses, then of sets of joints
};

// By cross-validation, over shipped poses; by training where there is one fold.
struct FitQuality {
  double share = 1;        // RMS error over the reference's
  double worse_share = 0;  // of poses that are worse than the reference
};

struct Fit {
  Coordinates coordinates;
  FitQuality quality;
  double rms = 0;  // of what is left in shipped poses left out, in diagonals
};

// candidates: the prior, what the ridge pulls to; its joints are those that a vertex may follow. reference: what the
// fit must be better than.
//
// Poses count w = (1 / (e² + ε))ᵖ, e the reference's RMS error there, so that those in which it is nearly right are not
// sacrificed to a few extreme ones: of several ε and p the one with the least error that keeps `most_worse`. Everything
// is in diagonals of the bind pose, so the ridge does not depend on the unit.
//
// Of poses that are not learnt each group takes the error of what all others give, beside what cross-validation gives
// of the others, both as shares of the reference's. Where a pose of them becomes worse than the reference, the groups
// that are most to blame keep the prior.
//
// Poses in which the truth is not finite, as a joint has collapsed, say, are left out; without any the prior stays.
//
// One normal matrix and one factorisation a distinct set of joints, fold, ridge and p, however many vertices share it.
// On all cores; the same result on every run. Memory: 16 bytes · vertices · poses.
Fit fit_coordinates(const Coordinates& candidates, double diagonal_m, std::vector<TrainingPose> poses,
                    const Deformer& truth, const Deformer& reference, const FitOptions& options);

}  // namespace marrow::deform
