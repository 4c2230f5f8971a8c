// `marrow pose`: a character at a moment, as numbers.
#pragma once

#include <string>

namespace marrow::tools {

struct PoseArguments {
  std::string in, out, clip, deformer = "ssd";
  float time_s = 0;
};

// Throws Failure.
void run_pose(const PoseArguments& arguments);

}  // namespace marrow::tools
