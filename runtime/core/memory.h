// The caller's memory, handed out piece by piece.
#pragma once

#include <cstddef>

#include "marrow/span.h"

namespace marrow {

// Without any memory it only counts.
struct Memory {
  std::byte* first = nullptr;
  std::size_t used = 0;

  // What is used, and what aligns the next piece.
  std::size_t whole() const { return (used + 15) / 16 * 16; }
  template <class T>
  Span<T> take(std::size_t count) {
    used = whole();
    T* const at = first != nullptr ? reinterpret_cast<T*>(first + used) : nullptr;
    used += count * sizeof(T);
    return {at, first != nullptr ? count : 0};
  }
};

}  // namespace marrow
