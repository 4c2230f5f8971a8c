// Blocks of memory on boundaries of 16 bytes, as load() and whatever lays things out in the caller's memory want them.
//
// block_in() finds a block of at least `size` bytes in any memory of block_bytes(size) bytes.
#pragma once

#include <cstdint>

#include "marrow/span.h"

namespace marrow {

// Bytes: where blocks begin at multiples of.
inline constexpr std::size_t kBlockBoundary = 16;

// How many bytes of any alignment hold a block of `bytes`.
constexpr std::size_t block_bytes(std::size_t bytes) {
  return bytes + kBlockBoundary - 1;
}

// Whether a block may begin there.
inline bool is_on_boundary(const void* first) {
  return reinterpret_cast<std::uintptr_t>(first) % kBlockBoundary == 0;
}

// What lies behind the first boundary in `memory`; empty if there is none.
inline Span<std::byte> block_in(Span<std::byte> memory) {
  const std::size_t before = (0 - reinterpret_cast<std::uintptr_t>(memory.data)) % kBlockBoundary;
  if (before >= memory.size) return {};
  return {memory.data + before, memory.size - before};
}

}  // namespace marrow
