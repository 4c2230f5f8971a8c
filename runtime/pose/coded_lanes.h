// Coded tracks four at a time, a joint a lane: tables of what codes and sets of lanes mean, and how lanes are written.
#pragma once

#include "asset/format.h"
#include "core/opaque.h"
#include "math/f32x4.h"
#include "math/slerp.h"

namespace marrow {

inline constexpr std::uint32_t kHeaderBytes = sizeof(format::TrackHeader), kConstantBytes = sizeof(format::Constant);

struct LaneTables {
  // Operands from memory.
  alignas(16) float one[4], two[4], series_limit[4];
  alignas(16) std::uint32_t codes[4], high[4];
  // Masks and shift counts by width code, as vectors: no instruction shifts or masks by a scalar from memory. The index
  // is 16 · code: that is how a header holds the code, and it is the byte offset of the code's entry.
  alignas(16) std::uint64_t mask[16][2];
  alignas(16) std::uint64_t shift[16][2];
  std::uint64_t bits_times_16[16][2];
  // Indexed by a set of lanes, one bit each: the set as a vector mask, and the byte offsets of its lanes' headers and
  // constants. A lane outside the set has offset 0, the first track's.
  alignas(16) std::uint32_t lanes[16][4];
  std::uint8_t header[16][4], constant[16][4];
  std::uint8_t header_bytes[16], constant_bytes[16];
};
constexpr LaneTables make_lane_tables() {
  LaneTables t{};
  for (std::uint32_t n = 0; n < 16; ++n) {
    for (int i = 0; i < 2; ++i) {
      t.shift[n][i] = shift_count(format::component_bits(n));
      t.bits_times_16[n][i] = 16 * format::component_bits(n);
      t.mask[n][i] = (std::uint64_t{1} << format::component_bits(n)) - 1;
    }
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      if ((n >> lane & 1u) == 0) continue;
      t.lanes[n][lane] = ~0u;
      t.header[n][lane] = t.header_bytes[n];
      t.constant[n][lane] = t.constant_bytes[n];
      t.header_bytes[n] = static_cast<std::uint8_t>(t.header_bytes[n] + kHeaderBytes);
      t.constant_bytes[n] = static_cast<std::uint8_t>(t.constant_bytes[n] + kConstantBytes);
    }
  }
  for (int i = 0; i < 4; ++i) {
    t.one[i] = 1.0f;
    t.two[i] = 2.0f;
    t.series_limit[i] = kSlerpSeriesLimit;
    t.codes[i] = 0xF0F0F0F0u;
    t.high[i] = 0xFFFF0000u;
  }
  return t;
}
inline constexpr LaneTables kLaneTables = make_lane_tables();

// opaque() makes the compiler use one base address for all tables, and leave constants in memory as operands.
inline const LaneTables& lane_tables() {
  return *opaque(&kLaneTables);
}

inline const std::uint64_t* by_code(const std::uint64_t (&table)[16][2], std::uint64_t code_times_16) {
  return reinterpret_cast<const std::uint64_t*>(reinterpret_cast<const std::byte*>(table) + code_times_16);
}

// codes: step codes, each times 65536.
inline f32x4 step_sizes(i32x4 codes) {
  return bits_as_float(shift_left<format::kStepShift - 16>(codes) +
                       splat_int(static_cast<std::int32_t>(format::kFirstStep)));
}

// Splits four lanes of four int16 into out[component], each number times 65536. ab and cd hold two lanes each.
inline void widen(const LaneTables& t, i32x4 ab, i32x4 cd, i32x4 (&out)[4]) {
  const i32x4 xy = even(ab, cd), zw = odd(ab, cd);
  const i32x4 high = load_aligned(t.high);
  out[0] = shift_left<16>(xy);
  out[1] = xy & high;
  out[2] = shift_left<16>(zw);
  out[3] = zw & high;
}

// Writes the lanes in `lanes`.
template <std::size_t N>
inline void store_lanes(const LaneTables& t, const f32x4 (&value)[N], std::uint32_t lanes, float (&to)[N][4]) {
  if (lanes == 15) {
    for (std::size_t i = 0; i < N; ++i) store(to[i], value[i]);
    return;
  }
  const mask4 mask = load_mask(t.lanes[lanes]);
  for (std::size_t i = 0; i < N; ++i) store(to[i], mask, value[i]);
}

}  // namespace marrow
