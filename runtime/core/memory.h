// The caller's memory, handed out piece by piece, each on a boundary of 16 bytes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/span.h"

namespace marrow {

// Without any memory it only counts.
struct Memory {
  std::byte* first = nullptr;
  std::size_t used = 0;
  std::size_t most = SIZE_MAX;  // bytes there are; of no account where a public function has asked for enough
  bool failed = false;          // a piece was to be more than there was

  // What is used, and what aligns the next piece.
  std::size_t whole() const { return (used + 15) / 16 * 16; }
  // count: at most 2³⁶. Empty if that is more than there is, or without any memory.
  template <class T>
  Span<T> take(std::uint64_t count) {
    static_assert(alignof(T) <= 16);
    const std::size_t at = whole();
    const std::uint64_t bytes = count * sizeof(T);
    if (at > most || bytes > most - at) {
      failed = true;
      return {};
    }
    used = at + static_cast<std::size_t>(bytes);
    if (first == nullptr) return {};
    return {reinterpret_cast<T*>(first + at), static_cast<std::size_t>(count)};
  }
};

}  // namespace marrow
