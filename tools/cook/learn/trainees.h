// The poses that a fit is trained on.
#pragma once

#include "cook/skin/deform_source.h"
#include "deform/fit/fit.h"
#include "deform/motion/range_of_motion.h"

namespace marrow::cook {

// How clips are sampled for a fit, and how many poses are made up.
inline constexpr double kTrainedRate_hz = 30;
inline constexpr std::size_t kMostTrained = 320;
inline constexpr std::size_t kMadeUp = 100;
// Wide poses: how many, and how far joints turn.
inline constexpr std::size_t kWide = 100;
inline constexpr double kWide_rad = 2.6179938779914944;  // 150°

// Rest, moments of clips, and poses that those clips could have had. Poses of one clip are of one fold; with one or two
// clips those of a quarter of a clip are.
// shipped: in the order of clip_poses(); empty: of no clip, then what is made up counts as shipped.
// wide: wide poses as well, which never count as shipped.
struct Trainees {
  std::vector<deform::TrainingPose> poses;
  std::size_t made_up = 0;
};
Trainees trainees(const DeformSource& source, const BuiltScene& built, const std::vector<SampledPose>& shipped,
                  bool wide = false);

// Poses in which the surface is known, and rest; nothing is made up, since nobody knows how it should look. In
// ascending order of clips.
Trainees trainees(const DeformSource& source, const std::vector<ShownPose>& shown);

// Poses of one joint at a time, so that a fit knows what each joint does without the others. Each joint turned as in
// `motion`, which fits are judged by, to two angles that are not in it: 0.4 and 0.85 of the farthest. At most `most`
// poses, evenly; none counts as shipped. folds: how many cross-validation has.
std::vector<deform::TrainingPose> single_joints(const std::vector<deform::MotionPose>& motion, std::size_t most,
                                                std::uint32_t folds);

// Poses in which the character is less than half or more than twice as large as in the bind pose are brought to the
// size of that, so that they count as much as those of single joints: roots often scale centimetres to metres.
void bring_to_bind_size(std::vector<deform::TrainingPose>& poses);

}  // namespace marrow::cook
