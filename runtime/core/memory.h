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
  // Null if that is more than there is, or without any memory.
  std::byte* take_bytes(std::uint64_t bytes) {
    const std::size_t at = whole();
    if (at > most || bytes > most - at) {
      failed = true;
      return nullptr;
    }
    used = at + static_cast<std::size_t>(bytes);
    return first == nullptr ? nullptr : first + at;
  }
  // count: at most 2³⁶. Empty where there are no bytes for it.
  template <class T>
  Span<T> take(std::uint64_t count) {
    static_assert(alignof(T) <= 16);
    std::byte* const bytes = take_bytes(count * sizeof(T));
    return {reinterpret_cast<T*>(bytes), bytes == nullptr ? 0 : static_cast<std::size_t>(count)};
  }
};

}  // namespace marrow
