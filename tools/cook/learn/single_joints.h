// Poses of one joint at a time to learn from, so that a fit knows what each joint does without the others.
#pragma once

#include <vector>

#include "deform/fit/fit.h"
#include "deform/motion/range_of_motion.h"

namespace marrow::cook {

// Each joint turned as in `motion`, which fits are judged by, to two angles that are not in it: 0.4 and 0.85 of the
// farthest. At most `most` poses, evenly; none counts as shipped.
// beside: what is learnt too. The character is as large as there, in the root mean square, and they are of its folds.
std::vector<deform::TrainingPose> single_joints(const std::vector<deform::MotionPose>& motion, std::size_t most,
                                                const std::vector<deform::TrainingPose>& beside);

}  // namespace marrow::cook
