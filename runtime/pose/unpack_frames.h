// Tracks of a group of four joints in two neighbouring frames: from bits to numbers.
#pragma once

#include <cstring>

#include "asset/format.h"
#include "pose/coded_lanes.h"
#include "pose/sample_coded.h"

namespace marrow {

// Stands at a track's header and at its integers in two neighbouring frames.
struct TrackCursor {
  const std::byte* header;
  std::size_t frame_bytes;
  const std::byte* record;         // in the first frame
  std::uint64_t bit_times_16 = 0;  // from there

  TrackCursor(const std::byte* segment, std::uint32_t track_count, std::uint32_t frame) {
    std::uint32_t bytes;
    std::memcpy(&bytes, segment, 4);
    header = segment + 4;
    frame_bytes = bytes;
    record = header + std::size_t{track_count} * sizeof(format::TrackHeader) + frame_bytes * frame;
  }
};

// Passes over as many tracks as there are bits in `lanes`.
inline void skip(TrackCursor& cursor, std::uint32_t lanes) {
  const auto& bits = kLaneTables.bits_times_16;
  for (; lanes != 0; lanes &= lanes - 1) {
    std::uint32_t codes;
    std::memcpy(&codes, cursor.header, 4);
    cursor.bit_times_16 +=
        *by_code(bits, codes & 0xF0u) + *by_code(bits, codes >> 4 & 0xF0u) + *by_code(bits, codes >> 8 & 0xF0u);
    cursor.header += kHeaderBytes;
  }
}

// A FramePair of integers in registers, the earlier frame first.
struct Unpacked {
  f32x4 frame[2][3], other[3], step;
};
inline f32x4 lanes_of(f32x4 number) {
  return number;
}
inline f32x4 lanes_of(const float (&number)[4]) {
  return load_aligned(number);
}
inline void load_frame(const float (&from)[3][4], f32x4 (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = load_aligned(from[i]);
}
inline void store_frame(const f32x4 (&from)[3], float (&to)[3][4]) {
  for (int i = 0; i < 3; ++i) store(to[i], from[i]);
}
// A frame of a pair. opaque() makes the compiler use one base address for all its numbers.
template <class Pair>
inline auto& numbers_of(Pair& two, std::uint32_t frame) {
  return *opaque(&two.frame[frame]);
}

// The width codes of four headers, unpacked from nibbles to bytes: each byte is 16 · code.
struct WidthCodes {
  alignas(16) std::byte upper[16];  // x in byte 0, z in byte 1 of each word
  alignas(16) std::byte lower[16];  // y in byte 1
};

// A track's integers, in both frames or in the later one alone.
struct TrackFields {
  u64x2 x, y, z;
};

// Reads the next track's fields. Moves `record` to the byte where they begin, and `bit_times_16` to their end, counted
// from there.
template <bool kLater>
inline void next_fields(const std::byte*& record, std::uint64_t& bit_times_16, std::size_t frame_bytes,
                        const LaneTables& t, const WidthCodes& codes, std::uint32_t lane, TrackFields& out) {
  const auto x = static_cast<std::uint64_t>(codes.upper[4 * lane]),
             y = static_cast<std::uint64_t>(codes.lower[4 * lane + 1]),
             z = static_cast<std::uint64_t>(codes.upper[4 * lane + 1]);
  record += bit_times_16 / 128;
  bit_times_16 %= 128;
  const u64x2 bits = kLater ? load_one(record) : load_pair(record, record + frame_bytes);
  const u64x2 w = shift_right(bits, by_code(t.shift, bit_times_16));
  // opaque() fixes the order of the sums, so that each takes an operand from memory.
  bit_times_16 = opaque(bit_times_16 + *by_code(t.bits_times_16, x));
  bit_times_16 = opaque(bit_times_16 + *by_code(t.bits_times_16, y));
  bit_times_16 += *by_code(t.bits_times_16, z);
  const u64x2 v = shift_right(w, by_code(t.shift, x));
  out.x = w & load_aligned(by_code(t.mask, x));
  out.y = v & load_aligned(by_code(t.mask, y));
  out.z = shift_right(v, by_code(t.shift, y)) & load_aligned(by_code(t.mask, z));
}

// Two lanes' fields side by side.
struct TwoLanes {
  i32x4 c[3];
};

// Unpacks the next tracks, one for each lane in `lanes`, into registers. A lane without a track gets numbers that are
// the same in all frames. kLater: only the later frame; the cursor is at that frame.
template <bool kLater>
[[gnu::always_inline]] inline void unpack(TrackCursor& cursor, const LaneTables& t, std::uint32_t lanes,
                                          Unpacked& out) {
  const std::uint8_t(&offsets)[4] = t.header[lanes];
  const std::byte *const h0 = cursor.header + offsets[0], *const h1 = cursor.header + offsets[1],
                         *const h2 = cursor.header + offsets[2], *const h3 = cursor.header + offsets[3];
  cursor.header += t.header_bytes[lanes];
  const auto load_two = [](const std::byte* a, const std::byte* b) { return words(load_pair(a, b)); };
  const i32x4 heads = even(load_two(h0, h1), load_two(h2, h3));
  WidthCodes codes;
  store(codes.upper, heads & load_aligned(t.codes));
  store(codes.lower, shift_left<4>(heads) & load_aligned(t.codes));
  // 2^(shift - 16), from the shift of the minima: written as a float's exponent bits.
  const f32x4 power = bits_as_float(shift_left<23>(heads & splat_int(15)) + splat_int((127 - 16) << 23));
  i32x4 least[4];
  widen(t, load_two(h0 + 3, h1 + 3), load_two(h2 + 3, h3 + 3), least);
  for (int c = 0; c < 3; ++c) out.other[c] = to_float(least[c]) * power;
  out.step = step_sizes(heads & splat_int(0xFF0000));

  const std::byte* record = cursor.record;
  std::uint64_t bit = cursor.bit_times_16;
  const std::size_t frame_bytes = cursor.frame_bytes;
  const auto two = [&](std::uint32_t first) {
    const u64x2 zero = load_aligned(kLaneTables.mask[0]);
    TrackFields f = {zero, zero, zero}, g = f;
    if ((lanes >> first & 1u) != 0) [[likely]]
      next_fields<kLater>(record, bit, frame_bytes, t, codes, first, f);
    if ((lanes >> (first + 1) & 1u) != 0) [[likely]]
      next_fields<kLater>(record, bit, frame_bytes, t, codes, first + 1, g);
    const auto beside = [](u64x2 a, u64x2 b) { return kLater ? words(firsts(a, b)) : even(words(a), words(b)); };
    return TwoLanes{{beside(f.x, g.x), beside(f.y, g.y), beside(f.z, g.z)}};
  };
  const TwoLanes ab = two(0), cd = two(2);
  cursor.record = record;
  cursor.bit_times_16 = bit;
  for (int c = 0; c < 3; ++c) {
    if constexpr (!kLater) out.frame[0][c] = to_float(even(ab.c[c], cd.c[c]));
    out.frame[1][c] = to_float(kLater ? even(ab.c[c], cd.c[c]) : odd(ab.c[c], cd.c[c]));
  }
}

}  // namespace marrow
