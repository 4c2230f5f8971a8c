// Deformers over the range of motion: each joint alone, as far as it turns, whatever the clips do. And clips between
// the frames of a rate.
#pragma once

#include <vector>

#include "compare/measure.h"
#include "compare/study.h"
#include "deform/motion/between_frames.h"
#include "deform/motion/motion_errors.h"

namespace marrow::tools {

// Of a deformer, over poses in which the truth does not fold; rings in the others too. See deform::MotionFigures.
struct MotionRow {
  std::size_t worse = 0;                    // poses in which it is farther from the truth than SSD
  std::size_t worse_folding = 0;            // the same, of those in which the truth folds
  double of_ssd = 1;                        // RMS over poses, over SSD's
  double worst_of_ssd = 0;                  // in the pose where that is most
  std::optional<double> ring_over_bind;     // of twists, the narrowest
  std::optional<double> ring_over_truth;    // of twists, the narrowest beside the truth's
  std::optional<double> volume_over_truth;  // the one farthest from 1
  std::size_t flipped = 0;                  // triangles, the most in a pose
  double mean_flipped = 0;                  // the mean of all poses, those in which the truth folds too
  // Where those are worst: the pose of worst_of_ssd, and the joint of the narrowest ring beside the truth's; kNowhere:
  // in no pose.
  static constexpr std::size_t kNowhere = ~std::size_t{0};
  std::size_t worst_pose = kNowhere, narrowest_pose = kNowhere;  // of Study::motion
};

struct MotionJoint {
  std::uint32_t joint = 0;
  std::size_t poses = 0, folding = 0;
  std::vector<MotionRow> of;  // each deformer of the comparison
};

struct MotionStudy {
  std::size_t poses = 0;                     // in which the truth does not fold
  std::vector<std::size_t> folding;          // those in which it does
  std::vector<MotionRow> of;                 // each deformer, over all joints
  std::optional<double> truth_ring;          // the truth's MotionRow::ring_over_bind
  std::vector<MotionJoint> joints;           // that have poses
  std::vector<deform::MotionErrors> errors;  // of each pose
};

// Of what the first round has trained. Empty where the truth is finite in none of the poses, as of examples.
MotionStudy study_motion(const Study& study, const DeformerComparison& comparison, const deform::Deformer& truth);

// "forearm.L, twist by 170°"
std::string title_of(const Study& study, const deform::MotionPose& pose);

// "Poses of the range of motion worse than linear blend skinning's: as_fit 3 of 150, …": without those that are SSD.
std::string summary(const DeformerComparison& comparison, const MotionStudy& motion);

// How far clips are off that are played from so many frames a second.
inline constexpr double kLeastFrames_hz = 1, kMostFrames_hz = 240;

// Of all clips of the mesh's skeleton. Lengths in metres: where SSD puts vertices, from where it puts them in the
// source's pose at that moment.
struct FramesRow {
  double hz = 0;
  deform::BetweenFrames kind = deform::BetweenFrames::linear;
  std::size_t frames = 0;
  double rms = 0, most = 0;
};

// For each rate a row a kind. Frames are evenly apart, both ends of a clip among them, at least `hz` a second. Looked
// at is a quarter, a half and three quarters of the way between two; of long clips some of the intervals, evenly. None
// if no clip moves the skeleton. On all cores; the same result on every run.
std::vector<FramesRow> study_frames(const Study& study, const std::vector<double>& rates_hz);

}  // namespace marrow::tools
