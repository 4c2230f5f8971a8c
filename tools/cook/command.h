// `marrow cook`: glTF in, a cooked file out.
#pragma once

#include <string>

#include "cook/build.h"

namespace marrow::tools {

struct CookArguments {
  std::string in, out, report;
  bool json = false;
  cook::CookOptions options;
};

// Throws Failure; then neither the output nor the report is left behind.
void run_cook(const CookArguments& arguments);

}  // namespace marrow::tools
