// The joints that are worst in their range of motion, from near by.
#pragma once

#include "commands/compare/motion/motion_study.h"
#include "commands/compare/pictures.h"

namespace marrow::tools {

// Of the poses in which the truth does not fold the one in which the last of `deformers` is farthest from it, and the
// twist in which that has the narrowest ring. deformers: indices into the comparison's rows.
std::vector<PictureRow> draw_worst_joints(const Study& study, const DeformerComparison& comparison,
                                          const MotionStudy& motion, const deform::Deformer& truth,
                                          const std::vector<std::size_t>& deformers);

}  // namespace marrow::tools
