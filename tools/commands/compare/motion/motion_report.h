// The range of motion as JSON and as lines of text.
#pragma once

#include <nlohmann/json.hpp>

#include "commands/compare/motion/motion_study.h"

namespace marrow::tools {

// docs/deformers.md has the fields.
nlohmann::ordered_json motion_report(const Study& study, const DeformerComparison& comparison,
                                     const MotionStudy& motion);

// A table of deformers, each with the joint where it is worst.
void print_motion(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion);

}  // namespace marrow::tools
