// Reads bytes that nobody vouches for.
#pragma once

#include <cstring>

#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

// Past the end everything reads as zero and `failed` stays set.
class ByteReader {
 public:
  ByteReader(const std::byte* first, std::size_t bytes) : at_(first), left_(bytes) {}

  template <class T>
  T take() {
    T value{};
    if (left_ < sizeof(T)) {
      fail();
    } else {
      std::memcpy(&value, at_, sizeof(T));
      skip(sizeof(T));
    }
    return value;
  }

  // LEB128: seven bits a byte, lowest first.
  std::uint32_t take_varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 35; shift += 7) {
      const std::uint64_t byte = take<std::uint8_t>();
      value |= (byte & 0x7F) << shift;
      if (byte < 0x80) {
        if (value > 0xFFFFFFFFu) fail();
        return static_cast<std::uint32_t>(value);
      }
    }
    fail();
    return 0;
  }

  Span<const std::byte> take_bytes(std::size_t bytes) {
    if (bytes > left_) {
      fail();
      return {};
    }
    const Span<const std::byte> taken(at_, bytes);
    skip(bytes);
    return taken;
  }

  const std::byte* at() const { return at_; }
  std::size_t left() const { return left_; }
  bool failed() const { return failed_; }

 private:
  void skip(std::size_t bytes) {
    at_ += bytes;
    left_ -= bytes;
  }
  void fail() {
    left_ = 0;
    failed_ = true;
  }
  const std::byte* at_;
  std::size_t left_;
  bool failed_ = false;
};

}  // namespace marrow
