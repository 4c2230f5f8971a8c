// What a vertex follows.
#pragma once

#include <cstdint>

#include "marrow/file.h"

namespace marrow {

// Palette entries, ascending.
struct EntrySet {
  std::int32_t joints[kMaxInfluences] = {};
  std::uint32_t count = 0;

  bool has(std::int32_t joint) const {
    for (std::uint32_t i = 0; i < count; ++i)
      if (joints[i] == joint) return true;
    return false;
  }
  void add(std::int32_t joint) {
    std::uint32_t at = count++;
    for (; at > 0 && joints[at - 1] > joint; --at) joints[at] = joints[at - 1];
    joints[at] = joint;
  }
};

// As streams hold it: `influences` numbers, of which the last repeats.
inline EntrySet read_set(const std::int32_t* joints, std::uint32_t influences) {
  EntrySet out;
  do out.joints[out.count] = joints[out.count];
  while (++out.count < influences && joints[out.count] != joints[out.count - 1]);
  return out;
}
inline void write_set(const EntrySet& set, std::uint32_t influences, std::int32_t* joints) {
  for (std::uint32_t j = 0; j < influences; ++j) joints[j] = set.joints[j < set.count ? j : set.count - 1];
}

}  // namespace marrow
