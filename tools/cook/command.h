// `marrow cook`: glTF in, a cooked file out.
#pragma once

#include <string>
#include <vector>

#include "cook/build.h"

namespace marrow::tools {

struct CookArguments {
  std::string in, out, report;
  bool json = false;
  std::vector<std::string> clip_error;
  std::string clip_codec = "segments";
  std::vector<std::string> additive;
  std::string mesh_codec = "draco";
  std::string position_error;
  std::string skeleton;       // a character's file
  std::string images = "reference";
  cook::CookOptions options;  // but for what the texts say
};

// Throws Failure; then neither the output nor the report is left behind.
void run_cook(const CookArguments& arguments);

}  // namespace marrow::tools
