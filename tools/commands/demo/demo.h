// `marrow demo`: from artists' files to cooked ones, a contact sheet each and a table.
#pragma once

#include <string>
#include <vector>

namespace marrow::tools {

struct DemoArguments {
  std::vector<std::string> inputs;
  std::string clip, directory;
};

// Throws Failure.
void run_demo(const DemoArguments& arguments);

}  // namespace marrow::tools
