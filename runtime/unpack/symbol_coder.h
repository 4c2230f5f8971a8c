// Entropy coding of bits and small numbers: adaptive models, and range asymmetric numeral systems (rANS).
// Duda, "Asymmetric numeral systems: entropy coding combining speed of Huffman coding with compression rate of
// arithmetic coding", arXiv:1311.2540, 2013. What is decoded first was encoded last.
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

// An adaptive model of a bit. The chance of a 1 is the mean of two estimates that adapt at different speeds. Both adapt
// faster while they have seen few bits.
class BitModel {
 public:
  static constexpr std::uint32_t kBits = 16;
  std::uint32_t chance() const {
    return static_cast<std::uint32_t>((1 << 16) + fast_ + slow_) >> 1;
  }  // of 2^16; never 0 or 2^16
  void learn(bool bit);

 private:
  std::int16_t fast_ = 0, slow_ = 0, seen_ = 0;  // chances less a half, so that all is 0 at first
};

// A symbol's share of 2^bits, or a bit's.
struct SymbolShare {
  std::uint32_t start, size;  // size is not 0
};

// An adaptive model of 16 symbols. After each symbol all shares move towards it; no share ever reaches 0.
class SymbolModel {
 public:
  static constexpr std::uint32_t kCount = 16, kBits = 14;
  static constexpr std::uint32_t kWeights = 256;

  // weights: of each symbol, none 0, together kWeights. is_guess: they are worth as much as a few symbols seen.
  void begin(const std::uint8_t (&weights)[kCount], bool is_guess);
  SymbolShare share(std::uint32_t symbol) const {
    const std::int32_t start = starts_[symbol];
    return {static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(starts_[symbol + 1] - start)};
  }
  // place: below 2^kBits
  std::uint32_t find(std::uint32_t place) const;
  void learn(std::uint32_t symbol);

 private:
  std::int16_t starts_[kCount + 1];  // the first is 0, the last 2^kBits
  std::int16_t seen_;
};
// Of lengths of numbers: those close to `size` are likely.
void begin_near(std::uint32_t size, SymbolModel& model);
// All symbols alike.
void begin_evenly(SymbolModel* models, std::size_t count);

// Past the end everything reads as zero. Unnamed parameters are what an encoder would write; the decoder ignores them.
class SymbolDecoder {
 public:
  static constexpr bool kEncodes = false;
  static constexpr std::uint32_t kMostRawBits = 16;

  explicit SymbolDecoder(Span<const std::byte> bytes);
  // Does not refill the state: raw_bits() must be called next, with a count of 0 if there are none.
  std::uint32_t symbol(SymbolModel& model, std::uint32_t);
  std::uint32_t raw_bits(std::uint32_t count, std::uint32_t) {
    const auto out = static_cast<std::uint32_t>(state_) & ((1u << count) - 1);
    state_ >>= count;
    refill();
    return out;
  }
  bool bit(BitModel& model, bool);
  bool even_bit(bool) { return raw_bits(1, 0) != 0; }
  // Whether these are the bytes that an encoder writes for what was decoded.
  bool at_end() const { return state_ == kLeastState && left_ == 0 && !failed_; }

  // States are from here to 2^32 times that.
  static constexpr std::uint64_t kLeastState = std::uint64_t{1} << 32;

 private:
  void refill() {
    if (state_ < kLeastState) state_ = state_ << 32 | next();
  }
  std::uint32_t next();

  const std::byte* at_;
  std::size_t left_;
  std::uint64_t state_ = 0;
  bool failed_ = false;
};

}  // namespace marrow
