// Numbers of either sign as symbols: for what clips and bounds have of them.
#pragma once

#include "unpack/symbol_coder.h"

namespace marrow {

// 0, 1, -1, 2, -2 … as 0, 1, 2, 3, 4 …; the least there is comes last, as if above all others.
inline std::uint32_t folded(std::int32_t x) {
  const auto bits = static_cast<std::uint32_t>(x);
  return bits - 1 < 0x80000000u ? 2 * bits - 1 : 0 - 2 * bits;
}
inline std::int32_t unfolded(std::uint32_t x) {
  const std::uint32_t half = (x >> 1) + (x & 1);
  return static_cast<std::int32_t>((x & 1) != 0 ? half : 0 - half);
}
// Of what may be anything.
inline std::int32_t wrapped_sum(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
inline std::int32_t wrapped_difference(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

// The length of what it is when folded, and the bits behind the first. Coder: see ClipCodec.
template <class Coder>
std::int32_t code_signed(Coder& coder, SymbolModel& model, std::int32_t wanted) {
  constexpr std::uint32_t kLong = SymbolModel::kCount - 1, kMostLength = 32;
  const std::uint32_t bits = folded(wanted), size = Coder::kEncodes ? bit_length(bits) : 0;
  std::uint32_t length = coder.symbol(model, size < kLong ? size : kLong);
  length += length == kLong ? coder.raw_bits(5, size - kLong) : coder.raw_bits(0, 0);
  if (length < 2) return unfolded(length);
  std::uint32_t out = 1;
  for (std::uint32_t left = (length < kMostLength ? length : kMostLength) - 1; left > 0;) {
    const std::uint32_t some = left < SymbolDecoder::kMostRawBits ? left : SymbolDecoder::kMostRawBits - 1;
    left -= some;
    out = out << some | coder.raw_bits(some, bits >> left & ((1u << some) - 1));
  }
  return unfolded(out);
}

// In steps of another code, see format::step_size; of codes that are multiples of four, below 0 too. 0 of what is too
// far off to be a guess.
inline constexpr std::int32_t kMostRescaled = 1 << 30;
inline std::int32_t rescaled(std::int32_t number, std::int32_t from, std::int32_t to) {
  constexpr std::int32_t kMostOctaves = 24;
  const std::int32_t octaves = from / 4 - to / 4;
  if (octaves > kMostOctaves || octaves < -kMostOctaves) return 0;
  const std::int64_t up = std::int64_t{1} << (octaves > 0 ? octaves : 0);
  const std::int64_t down = (std::int64_t{1} << (octaves < 0 ? -octaves : 0)) * (4 + to % 4);
  const std::int64_t twice = std::int64_t{2} * number * (4 + from % 4) * up;
  const std::int64_t out = (twice + (twice < 0 ? -down : down)) / (2 * down);
  return out < -kMostRescaled || out > kMostRescaled ? 0 : static_cast<std::int32_t>(out);
}

}  // namespace marrow
