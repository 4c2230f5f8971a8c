// `marrow info`: what cooked files hold.
#pragma once

#include <string>
#include <vector>

namespace marrow::tools {

struct InfoArguments {
  std::vector<std::string> in;
  std::string source;  // the glTF file that one was cooked from, to show its bytes beside; may be empty
  bool json = false;
  bool roles = false;   // those of joints alone
  bool motion = false;  // of clips alone
};

// Throws Failure.
void run_info(const InfoArguments& arguments);

}  // namespace marrow::tools
