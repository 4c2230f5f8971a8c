// A block of bytes on a 16-byte boundary and exactly as long as asked, so that a sanitizer sees the first byte past it.
#pragma once

#include <cstddef>
#include <cstring>
#include <new>

namespace marrow::test {

class AlignedBlock {
 public:
  explicit AlignedBlock(std::size_t size)
      : data_(static_cast<std::byte*>(::operator new (size, std::align_val_t{16}))), size_(size) {}
  AlignedBlock(const void* bytes, std::size_t size) : AlignedBlock(size) {
    if (size > 0) std::memcpy(data_, bytes, size);
  }
  AlignedBlock(const AlignedBlock&) = delete;
  AlignedBlock& operator=(const AlignedBlock&) = delete;
  ~AlignedBlock() { ::operator delete (data_, std::align_val_t{16}); }

  std::byte* data() { return data_; }
  const std::byte* data() const { return data_; }
  std::size_t size() const { return size_; }

 private:
  std::byte* data_;
  std::size_t size_;
};

}  // namespace marrow::test
