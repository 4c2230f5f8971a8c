// The joints that are worst in their range of motion, from near by.
#pragma once

#include "commands/compare/motion/motion_study.h"
#include "commands/compare/pictures.h"

namespace marrow::tools {

// The poses in which the last of `deformers` is farthest from the truth, of those in which that does not fold: at most
// `most`, no two of one joint. deformers: indices into the comparison's rows.
std::vector<PictureRow> draw_worst_joints(const Study& study, const DeformerComparison& comparison,
                                          const MotionStudy& motion, const deform::Deformer& truth,
                                          const std::vector<std::size_t>& deformers, std::size_t most);

}  // namespace marrow::tools
