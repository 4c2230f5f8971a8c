// `marrow info`: what a cooked file holds.
#pragma once

#include <string>

namespace marrow::tools {

struct InfoArguments {
  std::string in;
  bool json = false;
};

// Throws Failure.
void run_info(const InfoArguments& arguments);

}  // namespace marrow::tools
