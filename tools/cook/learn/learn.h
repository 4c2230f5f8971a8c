// Animation space out of what a better deformer does in the character's own poses.
#pragma once

#include <string>

#include "cook/learn/examples.h"
#include "deform/deformers.h"

namespace marrow::cook {

enum class AnimationSpace { lift, smooth, fit };
enum class Truth { dual_quaternions, centres_of_rotation, delta_mush, examples };

struct LearnOptions {
  AnimationSpace animation_space = AnimationSpace::lift;
  Truth truth = Truth::centres_of_rotation;
  deform::DeltaMushOptions delta_mush;
  std::string examples_file;
  int half_joints = 0;  // between a joint and its parent, 0 … 2
  int influences = 0;   // that a vertex may have, the weights' own aside; 0: 4, with half-joints 5
  bool keep_bind_pose = false;
  bool multi_weights = false;
  int pose_examples = 0;      // of pose space, at most; 0: none
  deform::Progress progress;  // of each fit
};

const char* name_of(Truth truth);
// Refers to `source`.
deform::Deformer make_truth(const DeformSource& source, const LearnOptions& options);

// The poses to learn from. Where examples are the truth they are read into `source`.
Trainees find_trainees(RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                       const LearnOptions& options, DeformSource& source);

// Coordinates, and how good they are by cross-validation.
struct Learnt {
  deform::Coordinates coordinates;  // over the mesh's joints and, behind them, the half-joints
  std::vector<deform::HalfJoint> half_joints;
  deform::FitQuality quality;
  double rms_m = 0;  // what is left, over shipped poses
};
// Without a better result than SSD's, SSD's. poses: of the joints; half-joints are added here.
Learnt learn(const DeformSource& source, std::vector<deform::TrainingPose> poses, const LearnOptions& options);

// Writes residuals and half-joints of `binding`. Adds a warning where the fit is not shipped.
LearnReport learn_binding(RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                          const LearnOptions& options, SkinBinding& binding);

}  // namespace marrow::cook
