// A block of bytes on a 16-byte boundary and exactly as long as asked, so that a sanitizer sees the first byte past it.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace marrow::test {

class AlignedBlock {
 public:
  explicit AlignedBlock(std::size_t size) : size_(size) {
    void* memory = nullptr;
    if (posix_memalign(&memory, 16, size == 0 ? 1 : size) != 0) std::abort();
    data_ = static_cast<std::byte*>(memory);
  }
  AlignedBlock(const void* bytes, std::size_t size) : AlignedBlock(size) {
    if (size > 0) std::memcpy(data_, bytes, size);
  }
  AlignedBlock(const AlignedBlock&) = delete;
  AlignedBlock& operator=(const AlignedBlock&) = delete;
  ~AlignedBlock() { std::free(data_); }

  std::byte* data() { return data_; }
  const std::byte* data() const { return data_; }
  std::size_t size() const { return size_; }

 private:
  std::byte* data_ = nullptr;
  std::size_t size_;
};

}  // namespace marrow::test
