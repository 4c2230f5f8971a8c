// What the header of a coded track says of its integers.
#pragma once

#include <bit>

#include "asset/format.h"

namespace marrow {

// Of a track in a segment: the fewest bits that hold its integers.
struct TrackFit {
  std::uint32_t shift = 0;
  std::int32_t least[3] = {};  // before the shift
  std::uint32_t width_codes[3] = {};
  std::uint32_t bits = 0;  // of all three components, at most 57
};

// low, high: of each component over all frames. False if the format has no room for them.
inline bool fit_track(const std::int32_t (&low)[3], const std::int32_t (&high)[3], TrackFit& out) {
  constexpr std::uint32_t kMostShift = 15, kMostCode = 15;
  constexpr std::int32_t kMostLeast = 32767;
  out = {};
  for (const std::int32_t x : low)
    while (x >> out.shift < -kMostLeast - 1 || x >> out.shift > kMostLeast) ++out.shift;
  if (out.shift > kMostShift) return false;
  for (int c = 0; c < 3; ++c) {
    out.least[c] = low[c] >> out.shift;
    const std::int64_t range = std::int64_t{high[c]} - out.least[c] * (std::int64_t{1} << out.shift);
    if (range >> format::component_bits(kMostCode) != 0) return false;
    const auto bits = static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(range)));
    out.width_codes[c] = bits < kMostCode ? bits : kMostCode;
    out.bits += format::component_bits(out.width_codes[c]);
  }
  return true;
}

}  // namespace marrow
