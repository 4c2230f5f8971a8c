// Each value once.
#pragma once

#include <algorithm>
#include <vector>

namespace marrow::tools {

// Sorts values and leaves out what repeats. (std::ranges::unique does not compile with Clang 14 on libstdc++ 12.)
template <class T>
void make_distinct(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace marrow::tools
