// Memory of the example: blocks on boundaries of 16 bytes, all given back at once. No C++ library is needed.
#pragma once

#include <marrow/block.h>

#include <cstdlib>

class Memory {
 public:
  Memory() = default;
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  ~Memory() { release(); }

  // At least this many bytes; none if there are none left, which every call of Marrow refuses.
  marrow::Span<std::byte> take(std::size_t bytes) {
    const std::size_t wanted = marrow::block_bytes(bytes);
    if (count_ == kMostBlocks) return {};
    void* const block = std::malloc(wanted);
    if (block == nullptr) return {};
    blocks_[count_++] = block;
    return marrow::block_in({static_cast<std::byte*>(block), wanted});
  }
  void release() {
    while (count_ > 0) std::free(blocks_[--count_]);
  }

 private:
  static constexpr int kMostBlocks = 64;
  void* blocks_[kMostBlocks] = {};
  int count_ = 0;
};
