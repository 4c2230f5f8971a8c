// Bits in fewer bits: adaptive binary arithmetic coding. Witten, Neal and Cleary, "Arithmetic coding for data
// compression", CACM 30(6), 1987, with a byte out as soon as both ends of the interval agree in it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/span.h"

namespace marrow {

// How many bits a number has without its leading zeros.
constexpr std::uint32_t bit_length(std::uint64_t x) {
  std::uint32_t bits = 0;
  for (; x != 0; x >>= 1) ++bits;
  return bits;
}

// How likely a bit is to be 1, by those before it: the mean of two that forget at different speeds, of which both learn
// faster while they have seen little.
class BitModel {
 public:
  std::uint32_t chance() const {
    return static_cast<std::uint32_t>((1 << 16) + fast_ + slow_) >> 1;
  }  // of 2^16; never 0 or 2^16
  void learn(bool bit);

 private:
  std::int16_t fast_ = 0, slow_ = 0, seen_ = 0;  // chances less a half, so that all is 0 at first
};

// The interval that encoder and decoder narrow alike.
class BitInterval {
 public:
  std::uint32_t low = 0, high = UINT32_MAX;
  // The last number of the part that stands for 1. chance: of 2^16, neither 0 nor 2^16.
  std::uint32_t middle(std::uint32_t chance) const {
    return low + static_cast<std::uint32_t>(std::uint64_t{high - low} * chance >> 16);
  }
  void take(bool bit, std::uint32_t middle) { (bit ? high : low) = bit ? middle : middle + 1; }
  bool agrees() const { return (low ^ high) >> 24 == 0; }
  void shift() {
    low <<= 8;
    high = high << 8 | 0xFF;
  }
};

inline constexpr std::uint32_t kEvenChance = 1 << 15;

// Past the end everything reads as zero.
class BitDecoder {
 public:
  static constexpr bool kEncodes = false;

  explicit BitDecoder(Span<const std::byte> bytes);
  // What is passed is what an encoder would write.
  bool bit(BitModel& model, bool);
  bool even_bit(bool) { return take(kEvenChance); }
  // Whether there are as many bytes as an encoder writes for these bits: four are read ahead, of which it writes one
  // where zeros do not do.
  bool at_end() const { return read_ == bytes_.size + 3 || read_ == bytes_.size + 4; }

 private:
  bool take(std::uint32_t chance);
  std::uint32_t next();

  Span<const std::byte> bytes_;
  std::size_t read_ = 0;
  BitInterval interval_;
  std::uint32_t code_ = 0;
};

}  // namespace marrow
