// What deformers are judged on: a mesh, its poses, and which of them may be learnt from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "cook/learn/learn.h"
#include "cook/skin/deform_source.h"
#include "deform/deformers.h"
#include "deform/motion/range_of_motion.h"

namespace marrow::tools {

struct HeldPose {
  deform::Pose pose;
  std::string clip;  // empty: of none
  double time_s = 0;
  std::optional<std::uint32_t> number;  // of a clip of the scene
};

// Learnt from `train`, judged by `held`.
struct Round {
  std::vector<deform::TrainingPose> train;
  std::vector<HeldPose> held;
};

struct Study {
  std::string name;        // of the mesh
  cook::RawScene scene;    // with nothing but the mesh
  cook::BuiltScene built;  // skeletons, and clips as the source has them; none of the cylinder
  cook::DeformSource source;
  deform::Pose rest;
  std::vector<Round> rounds;
  std::vector<std::string> joint_names;  // of the source's
  deform::RangeOfMotion motion;
  std::vector<std::string> left_out_of_motion;  // why and which, see cook::left_out_of_motion()
  bool wide_poses = false;                      // learnt from as well
};

// The mesh with the most vertices of those bound to a skin. frames: alternate frames of every clip are held out, and
// what is made up is learnt from; clips: each clip once, in at most eight rounds. Throws tools::Failure (invalid) if
// nothing is skinned, (usage) for clips to be held out where there are fewer than two.
// With the truth from examples their poses are the study's.
Study study_scene(cook::RawScene scene, Holdout holdout, const cook::LearnOptions& options);

// The cylinder that is commonly shown, 30 poses to learn from and 200 held out, five times.
Study study_cylinder();
// What smooths it as much as a character's default smooths that.
inline constexpr deform::DeltaMushOptions kCylinderDeltaMush{30, 1.0, deform::EdgeWeights::uniform};

// Leaves out poses in which the truth does not say where the mesh is, and notes which joint spoils them. Throws
// tools::Failure (invalid) if none is left to be held out.
void drop_unusable_poses(const cook::LearnOptions& options, Study& study, cook::Notes& notes);

}  // namespace marrow::tools
