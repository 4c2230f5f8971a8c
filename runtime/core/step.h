// How much one step of work does that is long as a whole: it is counted by what is done.
#pragma once

#include <algorithm>
#include <cstdint>

#include "marrow/span.h"

namespace marrow {

// Numbers that are decoded one after the other, some 10 to 50 ns each; and bytes that are copied, cleared or summed up.
inline constexpr std::uint32_t kStepNumbers = 1 << 17, kStepBytes = 4 << 20;

// Where a step ends that begins at `at` and takes `most` of `count`.
constexpr std::uint32_t step_end(std::uint32_t at, std::uint32_t count, std::uint32_t most = kStepNumbers) {
  return count - at < most ? count : at + most;
}

// Uses up what some work is worth.
constexpr void use_up(std::uint64_t work, std::uint32_t& left) {
  left = work < left ? left - static_cast<std::uint32_t>(work) : 0;
}

// How far numbers are sorted.
struct Sorting {
  std::uint32_t heaped = 0, placed = 0;
};

// Goes on; true when done. less: of no two the same both ways, so that what comes of it does not depend on how many
// there are. More than `at_once` are sorted as a heap, in steps.
template <class Less>
bool sort_some(Span<std::uint32_t> numbers, Sorting& sorting, std::uint32_t at_once, const Less& less) {
  const auto count = static_cast<std::uint32_t>(numbers.size);
  std::uint32_t* const first = numbers.data;
  if (count <= at_once) {
    std::sort(first, first + count, less);
    return true;
  }
  const auto sift = [&](std::uint32_t at, std::uint32_t end) {
    const std::uint32_t moved = first[at];
    for (std::uint32_t child = 2 * at + 1; child < end; child = 2 * at + 1) {
      if (child + 1 < end && less(first[child], first[child + 1])) ++child;
      if (!less(moved, first[child])) break;
      first[at] = first[child];
      at = child;
    }
    first[at] = moved;
  };
  std::uint32_t left = at_once / 4;
  for (; sorting.heaped < count / 2 && left > 0; --left) sift(count / 2 - ++sorting.heaped, count);
  for (; sorting.placed + 1 < count && left > 0; --left) {
    const std::uint32_t last = count - ++sorting.placed;
    std::swap(first[0], first[last]);
    sift(0, last);
  }
  return sorting.placed + 1 >= count;
}

}  // namespace marrow
