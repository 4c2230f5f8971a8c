// `marrow diff`: in what two cooked files differ, for people.
#pragma once

#include <string>

namespace marrow::tools {

// The exit code beside failure.h's for files that differ: 1 would be a mistake in usage.
inline constexpr int kFilesDiffer = 6;

struct DiffArguments {
  std::string a, b;
  bool json = false;
  bool differs = false;  // the result: whether any byte differs
};

// Throws Failure.
void run_diff(DiffArguments& arguments);

}  // namespace marrow::tools
