// Some of many, evenly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace marrow::tools {

// At most `most` of them, from the first on, equally far apart, in their order.
template <class T>
std::vector<T> evenly(const std::vector<T>& all, std::size_t most) {
  std::vector<T> out;
  const std::size_t count = std::min(all.size(), most);
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(all[i * all.size() / count]);
  return out;
}

}  // namespace marrow::tools
