// `marrow diff`: in what two cooked files differ, for people.
#pragma once

#include <string>

namespace marrow::tools {

// The exit code beside failure.h's for files that differ: 1 would be a mistake in usage.
inline constexpr int kFilesDiffer = 6;

struct DiffArguments {
  std::string a, b;
  std::string skeleton;  // the character of two clip packs; may be empty
  bool json = false;
};

// Whether both are the same byte by byte. Throws Failure.
bool run_diff(const DiffArguments& arguments);

}  // namespace marrow::tools
