// The range of motion as a part of the page.
#pragma once

#include "commands/compare/motion/motion_study.h"

namespace marrow::tools {

// What stands below the pictures of the worst joints: a table of deformers, one of joints for each of them, and the
// poses in which the truth folds.
std::string motion_tables(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion);

}  // namespace marrow::tools
