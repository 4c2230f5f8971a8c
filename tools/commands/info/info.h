// `marrow info`: what a cooked file holds.
#pragma once

#include <string>

namespace marrow::tools {

struct InfoArguments {
  std::string in;
  std::string source;  // the glTF file it was cooked from, to show its bytes beside; may be empty
  bool json = false;
};

// Throws Failure.
void run_info(const InfoArguments& arguments);

}  // namespace marrow::tools
