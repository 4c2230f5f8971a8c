// Poses of one joint at a time to learn from, so that a fit knows what each joint does without the others.
#pragma once

#include <vector>

#include "deform/fit/fit.h"
#include "deform/motion/range_of_motion.h"

namespace marrow::cook {

// Each joint turned as in `motion`, which fits are judged by, to two angles that are not in it: 0.4 and 0.85 of the
// farthest. At most `most` poses, evenly; none counts as shipped. folds: how many cross-validation has.
std::vector<deform::TrainingPose> single_joints(const std::vector<deform::MotionPose>& motion, std::size_t most,
                                                std::uint32_t folds);

// Poses in which the character is less than half or more than twice as large as in the bind pose are brought to the
// size of that, so that they count as much as those of single joints: roots often scale centimetres to metres.
void bring_to_bind_size(std::vector<deform::TrainingPose>& poses);

}  // namespace marrow::cook
