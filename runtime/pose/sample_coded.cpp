#include "pose/sample_coded.h"

#include <cstring>

#include "asset/format.h"
#include "math/f32x4.h"
#include "math/slerp.h"

namespace marrow {
namespace {

// What a width code means, as vectors: no instruction shifts or masks by a number from memory. Looked up by the code
// times 16, which is where the code stands in a header or how far an entry is from the first.
struct Widths {
  alignas(16) std::uint64_t mask[16][2];
  alignas(16) std::uint64_t shift[16][2];
  std::uint64_t bits_times_16[16][2];
};
constexpr Widths make_widths() {
  Widths w{};
  for (std::uint32_t code = 0; code < 16; ++code)
    for (int i = 0; i < 2; ++i) {
      w.shift[code][i] = shift_count(format::component_bits(code));
      w.bits_times_16[code][i] = 16 * format::component_bits(code);
      w.mask[code][i] = (std::uint64_t{1} << format::component_bits(code)) - 1;
    }
  return w;
}
constexpr Widths kWidths = make_widths();

inline const std::uint64_t* at(const std::uint64_t (&table)[16][2], std::uint64_t code_times_16) {
  return reinterpret_cast<const std::uint64_t*>(reinterpret_cast<const std::byte*>(table) + code_times_16);
}

// Sets of lanes as vectors: 1 for a lane in the set.
struct Lanes {
  alignas(16) float in[16][4];
};
constexpr Lanes make_lanes() {
  Lanes l{};
  for (std::uint32_t set = 0; set < 16; ++set)
    for (std::uint32_t lane = 0; lane < 4; ++lane) l.in[set][lane] = static_cast<float>(set >> lane & 1u);
  return l;
}
constexpr Lanes kLanes = make_lanes();

constexpr std::uint8_t kBitCount[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

// Stands in for a lane without a track: every component 0, or the identity.
constexpr std::byte kNoTrack[16] = {};
constexpr format::Constant kNoConstant = {{0, 0, 0, 32767}};

// Two neighbouring frames of four sub-tracks, one lane each: (a or b + least) · step.
struct Unpacked {
  f32x4 a[3], b[3], least[3], step;
};

// Of codes times 65536.
inline f32x4 step_sizes(i32x4 codes) {
  return bits_as_float(shift_left<format::kStepShift - 16>(codes) +
                       splat_int(static_cast<std::int32_t>(format::kFirstStep)));
}

// Stands at a track's header and at its integers in two neighbouring frames.
struct Cursor {
  const std::byte* header;
  const std::byte *a, *b;          // records of the frames
  std::uint64_t bit_times_16 = 0;  // into both

  Cursor(const std::byte* segment, std::uint32_t track_count, std::uint32_t frame) {
    std::uint32_t frame_bytes;
    std::memcpy(&frame_bytes, segment, 4);
    header = segment + 4;
    a = header + std::size_t{track_count} * sizeof(format::TrackHeader) + std::size_t{frame_bytes} * frame;
    b = a + frame_bytes;
  }
};

// Widths of x, y, z times 16.
struct Codes {
  std::uint64_t x, y, z;
  explicit Codes(const std::byte* header) {
    std::uint32_t word;
    std::memcpy(&word, header, 4);
    x = word & 0xF0u;
    y = word >> 4 & 0xF0u;
    z = word >> 8 & 0xF0u;
  }
  std::uint64_t bits_times_16() const {
    return *at(kWidths.bits_times_16, x) + *at(kWidths.bits_times_16, y) + *at(kWidths.bits_times_16, z);
  }
};

// Passes over as many tracks as there are bits in `lanes`.
void skip(Cursor& cursor, std::uint32_t lanes) {
  for (; lanes != 0; lanes &= lanes - 1) {
    cursor.bit_times_16 += Codes(cursor.header).bits_times_16();
    cursor.header += sizeof(format::TrackHeader);
  }
}

// The next tracks, one for each lane in `lanes`.
__attribute__((always_inline)) inline void unpack(Cursor& cursor, std::uint32_t lanes, Unpacked& out) {
  u64x2 x[4], y[4], z[4];  // both frames' integers
  const std::byte* headers[4];
  const std::byte* header = cursor.header;
  const std::byte *const a = cursor.a, *const b = cursor.b;
  std::uint64_t bit = cursor.bit_times_16;
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    if ((lanes >> lane & 1u) == 0) {
      headers[lane] = kNoTrack;
      const u64x2 zero = load_aligned(kWidths.mask[0]);
      store(x[lane], zero);
      store(y[lane], zero);
      store(z[lane], zero);
      continue;
    }
    const Codes codes(header);
    u64x2 w = shift_right(load_pair(a + bit / 128, b + bit / 128), load_aligned(at(kWidths.shift, bit % 128)));
    bit += codes.bits_times_16();
    store(x[lane], w & load_aligned(at(kWidths.mask, codes.x)));
    w = shift_right(w, load_aligned(at(kWidths.shift, codes.x)));
    store(y[lane], w & load_aligned(at(kWidths.mask, codes.y)));
    w = shift_right(w, load_aligned(at(kWidths.shift, codes.y)));
    store(z[lane], w & load_aligned(at(kWidths.mask, codes.z)));
    headers[lane] = header;
    header += sizeof(format::TrackHeader);
  }
  cursor.header = header;
  cursor.bit_times_16 = bit;
  const i32x4 words = gather_words(headers);
  // 2^(shift - 16): the shift of the minima, put where a float has its exponent.
  const f32x4 power = bits_as_float(shift_left<23>(words & splat_int(15)) + splat_int((127 - 16) << 23));
  i32x4 least[4];
  gather_int16({headers[0] + 3, headers[1] + 3, headers[2] + 3, headers[3] + 3}, least);
  const auto finish = [&](const u64x2(&fields)[4], int c) {
    i32x4 first, second;
    low_words(fields, first, second);
    out.a[c] = to_float(first);
    out.b[c] = to_float(second);
    out.least[c] = to_float(least[c]) * power;
  };
  finish(x, 0);
  finish(y, 1);
  finish(z, 2);
  out.step = step_sizes(words & splat_int(0xFF0000));
}

// Writes the lanes in `lanes` of N components.
template <std::size_t N>
inline void store_lanes(const f32x4 (&value)[N], std::uint32_t lanes, float (&to)[N][4]) {
  if (lanes == 15) {
    for (std::size_t i = 0; i < N; ++i) store(to[i], value[i]);
    return;
  }
  const mask4 mask = splat(0.0f) < load_aligned(kLanes.in[lanes]);
  for (std::size_t i = 0; i < N; ++i) store(to[i], select(mask, value[i], load_aligned(to[i])));
}

// The quaternion of modified Rodrigues parameters m is (factor · m, factor - 1) with factor = 2 / (1 + m²).
struct Rodrigues {
  f32x4 x, y, z, factor;
};

inline Rodrigues rodrigues(const f32x4 (&n)[3], const Unpacked& four) {
  const f32x4 x = (n[0] + four.least[0]) * four.step, y = (n[1] + four.least[1]) * four.step,
              z = (n[2] + four.least[2]) * four.step;
  return {x, y, z, splat(2.0f) / (splat(1.0f) + dot3(x, y, z, x, y, z))};
}

// The blend of two frames, the same for every joint.
struct Blend {
  f32x4 u;
  SlerpSeries a, b;
  explicit Blend(float between) : u(splat(between)), a(slerp_series(1.0f - between)), b(slerp_series(between)) {}
};

// The next tracks, of rotations.
inline void rotate_rest(Cursor& cursor, std::uint32_t tracks, const Blend& blend, const float (&rest)[4][4],
                        std::uint32_t wanted, float (&rotation)[4][4]) {
  Unpacked four;
  unpack(cursor, tracks, four);
  const Rodrigues a = rodrigues(four.a, four), b = rodrigues(four.b, four);
  // The squared chord between the quaternions, without a difference of large numbers.
  const f32x4 dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
  const f32x4 chord_squared = dot3(dx, dy, dz, dx, dy, dz) * (a.factor * b.factor);
  f32x4 wa = slerp_weight(blend.a, chord_squared), wb = slerp_weight(blend.b, chord_squared);
  if (any(splat(kSlerpSeriesLimit) < chord_squared)) {
    // Beyond half a turn, -b is as good as b, and nearer.
    const mask4 far = splat(2.0f) < chord_squared;
    const auto [exact_a, exact_b] = slerp_weights(select(far, splat(4.0f) - chord_squared, chord_squared), blend.u);
    wa = exact_a;
    wb = select(far, splat(0.0f) - exact_b, exact_b);
  }
  const f32x4 fa = wa * a.factor, fb = wb * b.factor;
  const f32x4 x = fa * a.x + fb * b.x, y = fa * a.y + fb * b.y, z = fa * a.z + fb * b.z, w = (fa + fb) - (wa + wb);
  const f32x4 rx = load_aligned(rest[0]), ry = load_aligned(rest[1]), rz = load_aligned(rest[2]),
              rw = load_aligned(rest[3]);
  store_lanes({rw * x + rx * w + (ry * z - rz * y), rw * y + ry * w + (rz * x - rx * z),
               rw * z + rz * w + (rx * y - ry * x), rw * w - dot3(rx, ry, rz, x, y, z)},
              tracks & wanted, rotation);
}

// The next tracks, of translations or scales.
void add_to_rest(Cursor& cursor, std::uint32_t tracks, f32x4 u, const float (&rest)[3][4], std::uint32_t wanted,
                 float (&vector)[3][4]) {
  if ((tracks & wanted) == 0) return skip(cursor, tracks);
  Unpacked four;
  unpack(cursor, tracks, four);
  f32x4 out[3];
  for (int c = 0; c < 3; ++c)
    out[c] = load_aligned(rest[c]) + (four.a[c] + (four.b[c] - four.a[c]) * u + four.least[c]) * four.step;
  store_lanes(out, tracks & wanted, vector);
}

// The numbers of the next constants times 65536, one for each lane in `lanes`.
inline const std::byte* gather_constants(const std::byte* next, std::uint32_t lanes, i32x4 (&v)[4]) {
  constexpr std::size_t kSize = sizeof(format::Constant);
  if (lanes == 15) {
    load_int16(next, v);
    return next + 4 * kSize;
  }
  const std::byte* from[4];
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    const bool present = (lanes >> lane & 1u) != 0;
    from[lane] = present ? next : reinterpret_cast<const std::byte*>(&kNoConstant);
    next += present ? kSize : 0;
  }
  gather_int16(from, v);
  return next;
}

inline const std::byte* set_rotation(const std::byte* next, std::uint32_t constant, std::uint32_t lanes,
                                     float (&rotation)[4][4]) {
  i32x4 v[4];
  next = gather_constants(next, constant, v);
  const f32x4 x = to_float(v[0]), y = to_float(v[1]), z = to_float(v[2]), w = to_float(v[3]);
  const f32x4 inverse = splat(1.0f) / sqrt(dot3(x, y, z, x, y, z) + w * w);
  store_lanes({x * inverse, y * inverse, z * inverse, w * inverse}, lanes, rotation);
  return next;
}

const std::byte* set_vector(const std::byte* next, std::uint32_t constant, const float (&rest)[3][4],
                            std::uint32_t lanes, float (&vector)[3][4]) {
  i32x4 v[4];
  next = gather_constants(next, constant, v);
  const f32x4 step = splat(1.0f / 65536) * step_sizes(v[3]);
  store_lanes({load_aligned(rest[0]) + to_float(v[0]) * step, load_aligned(rest[1]) + to_float(v[1]) * step,
               load_aligned(rest[2]) + to_float(v[2]) * step},
              lanes, vector);
  return next;
}

inline const std::byte* set_constants(const std::byte* next, std::uint32_t constant, const SoaTransform& rest,
                                      std::uint32_t wanted, SoaTransform& out) {
  const std::uint32_t r = constant & 15u, t = constant >> 4 & 15u, s = constant >> 8;
  if (r != 0) next = set_rotation(next, r, r & wanted, out.rotation);
  if (t != 0) next = set_vector(next, t, rest.translation, t & wanted, out.translation);
  if (s != 0) next = set_vector(next, s, rest.scale, s & wanted, out.scale);
  return next;
}

// A frame, the last but one at most, and how far it is on the way to the next.
struct Place {
  std::uint32_t frame;
  float between;
};

Place find(const CodedTracks& coded, float time_s) {
  const std::uint32_t last = coded.frame_count - 1;
  const float position = (time_s - coded.start_s) * coded.frames_per_s;
  if (position >= static_cast<float>(last)) return {last - 1, 1.0f};
  if (!(position > 0.0f)) return {0, 0.0f};
  const auto frame = static_cast<std::uint32_t>(position);
  return {frame, position - static_cast<float>(frame)};
}

}  // namespace

void sample_coded(const Skeleton& skeleton, const CodedTracks& coded, float time_s, const SampleOptions& options,
                  SoaTransform* out) {
  const Place place = find(coded, time_s);
  const std::uint32_t segment = place.frame / coded.segment_intervals;
  Cursor cursor(coded.payload + coded.segment_offsets[segment], coded.track_count,
                place.frame - segment * coded.segment_intervals);
  const std::byte* constants = coded.constants;
  const Blend blend(place.between);
  const bool all = options.joints.empty(), still = !options.prefilled;
  const GroupMasks* masks = coded.masks;
  const SoaTransform* rest = skeleton.rest;
  SoaTransform* const end = out + skeleton.soa_size();
  for (std::size_t g = 0; out != end; ++g, ++out, ++rest, ++masks) {
    const std::uint32_t wanted = all ? 15u : wanted_lanes(options, g);
    const std::uint32_t moving = masks->moving;
    if (still) {
      copy_lanes(*rest, wanted, *out);
      if (masks->constant != 0) constants = set_constants(constants, masks->constant, *rest, wanted, *out);
    }
    if (moving == 0) continue;
    const std::uint32_t rotations = moving & 15u;
    if ((rotations & wanted) != 0) {
      rotate_rest(cursor, rotations, blend, rest->rotation, wanted, out->rotation);
    } else {
      skip(cursor, rotations);
    }
    if ((moving & 0xFF0u) == 0) continue;
    add_to_rest(cursor, moving >> 4 & 15u, blend.u, rest->translation, wanted, out->translation);
    add_to_rest(cursor, moving >> 8, blend.u, rest->scale, wanted, out->scale);
  }
}

}  // namespace marrow
