// Bytes on a 16-byte boundary, as load() wants them.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace marrow::tools {

class AlignedBytes {
 public:
  AlignedBytes() = default;
  explicit AlignedBytes(std::size_t size) : chunks_((size + 15) / 16), size_(size) {}
  explicit AlignedBytes(std::span<const std::byte> bytes) : AlignedBytes(bytes.size()) {
    if (size_ > 0) std::memcpy(data(), bytes.data(), size_);
  }
  std::byte* data() { return reinterpret_cast<std::byte*>(chunks_.data()); }
  const std::byte* data() const { return reinterpret_cast<const std::byte*>(chunks_.data()); }
  std::size_t size() const { return size_; }
  // Forgets what lies behind; size: at most size().
  void truncate(std::size_t size) {
    chunks_.resize((size + 15) / 16);
    size_ = size;
  }

 private:
  struct alignas(16) Chunk {
    std::byte bytes[16];
  };
  std::vector<Chunk> chunks_;
  std::size_t size_ = 0;
};

}  // namespace marrow::tools
