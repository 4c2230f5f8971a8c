// `marrow pose`: a character at a moment, as numbers.
#pragma once

#include <string>

#include "commands/between.h"
#include "pose/choose.h"

namespace marrow::tools {

struct PoseArguments {
  std::string in, out;
  std::vector<std::string> outfits;
  Deformer deformer = Deformer::ssd;
  Choice choice;
  BetweenArguments between;
};

// Throws Failure.
void run_pose(const PoseArguments& arguments);

}  // namespace marrow::tools
