#include "pose/sample_coded.h"

#include <cstring>

#include "asset/format.h"
#include "core/fixed.h"
#include "core/opaque.h"
#include "math/keys.h"
#include "math/slerp.h"
#include "math/vector.h"
#include "pose/sample_each.h"

namespace marrow {
namespace {

constexpr std::uint32_t kHeaderBytes = sizeof(format::TrackHeader), kConstantBytes = sizeof(format::Constant);

struct Tables {
  // What a width code means, as vectors: no instruction shifts or masks by a number from memory. Looked up by the code
  // times 16, which is where the code stands in a header or how far an entry is from the first.
  alignas(16) std::uint64_t mask[16][2];
  alignas(16) std::uint64_t shift[16][2];
  std::uint64_t bits_times_16[16][2];
  // By sets of lanes: the set as a vector, and where its lanes' headers and constants stand. A lane that is not in the
  // set shares another's.
  alignas(16) std::uint32_t lanes[16][4];
  std::uint8_t header[16][4], constant[16][4];
  std::uint8_t header_bytes[16], constant_bytes[16];
  // Operands from memory.
  alignas(16) float one[4], two[4], series_limit[4];
  alignas(16) std::uint32_t codes[4], high[4];
};
constexpr Tables make_tables() {
  Tables t{};
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
constexpr Tables kTables = make_tables();

// One address for all tables, and numbers that stay where instructions can take them from.
inline const Tables& tables() {
  return *opaque(&kTables);
}

inline const std::uint64_t* at(const std::uint64_t (&table)[16][2], std::uint64_t code_times_16) {
  return reinterpret_cast<const std::uint64_t*>(reinterpret_cast<const std::byte*>(table) + code_times_16);
}

// Two neighbouring frames of four sub-tracks, one lane each, (a or b + least) · step: in registers as in a FramePair.
struct Unpacked {
  f32x4 a[3], b[3], rest[4];  // the least, and the step
};
[[maybe_unused]] inline f32x4 lanes_of(f32x4 number) {
  return number;
}
[[maybe_unused]] inline f32x4 lanes_of(const float (&number)[4]) {
  return load_aligned(number);
}

// Of codes times 65536.
inline f32x4 step_sizes(i32x4 codes) {
  return bits_as_float(shift_left<format::kStepShift - 16>(codes) +
                       splat_int(static_cast<std::int32_t>(format::kFirstStep)));
}

// Passes over as many tracks as there are bits in `lanes`.
[[maybe_unused]] void skip(TrackCursor& cursor, std::uint32_t lanes) {
  const auto& bits = kTables.bits_times_16;
  for (; lanes != 0; lanes &= lanes - 1) {
    std::uint32_t codes;
    std::memcpy(&codes, cursor.header, 4);
    cursor.bit_times_16 += *at(bits, codes & 0xF0u) + *at(bits, codes >> 4 & 0xF0u) + *at(bits, codes >> 8 & 0xF0u);
    cursor.header += kHeaderBytes;
  }
}

// The numbers of four lanes, four int16 each, times 65536; ab and cd hold two lanes each.
inline void widen(const Tables& t, i32x4 ab, i32x4 cd, i32x4 (&out)[4]) {
  const i32x4 xy = even(ab, cd), zw = odd(ab, cd);
  const i32x4 high = load_aligned(t.high);
  out[0] = shift_left<16>(xy);
  out[1] = xy & high;
  out[2] = shift_left<16>(zw);
  out[3] = zw & high;
}

// The first bytes of four headers, each code with its upper neighbour out of the way: times 16.
struct Codes {
  alignas(16) std::byte upper[16];  // x in byte 0, z in byte 1 of each word
  alignas(16) std::byte lower[16];  // y in byte 1
};

// Both frames' integers of a track.
struct Fields {
  u64x2 x, y, z;
};

// The next track's; moves `record` to the byte where its bits begin, and `bit_times_16` from there behind them.
inline void next_fields(const std::byte*& record, std::uint64_t& bit_times_16, std::size_t frame_bytes, const Tables& t,
                        const Codes& codes, std::uint32_t lane, Fields& out) {
  const auto x = static_cast<std::uint64_t>(codes.upper[4 * lane]),
             y = static_cast<std::uint64_t>(codes.lower[4 * lane + 1]),
             z = static_cast<std::uint64_t>(codes.upper[4 * lane + 1]);
  record += bit_times_16 / 128;
  bit_times_16 %= 128;
  const u64x2 w = shift_right(load_pair(record, record + frame_bytes), at(t.shift, bit_times_16));
  // In this order each sum takes an operand from memory.
  bit_times_16 = opaque(bit_times_16 + *at(t.bits_times_16, x));
  bit_times_16 = opaque(bit_times_16 + *at(t.bits_times_16, y));
  bit_times_16 += *at(t.bits_times_16, z);
  const u64x2 v = shift_right(w, at(t.shift, x));
  out.x = w & load_aligned(at(t.mask, x));
  out.y = v & load_aligned(at(t.mask, y));
  out.z = shift_right(v, at(t.shift, y)) & load_aligned(at(t.mask, z));
}

// Two lanes' fields side by side: of the first frame and of the second, in turn.
struct TwoLanes {
  i32x4 c[3];
};

// The next tracks, one for each lane in `lanes`. What a lane without a track gets is the same in both frames.
[[gnu::always_inline, maybe_unused]] inline void unpack(TrackCursor& cursor, const Tables& t, std::uint32_t lanes,
                                                        Unpacked& out) {
  const std::uint8_t(&offsets)[4] = t.header[lanes];
  const std::byte *const h0 = cursor.header + offsets[0], *const h1 = cursor.header + offsets[1],
                         *const h2 = cursor.header + offsets[2], *const h3 = cursor.header + offsets[3];
  cursor.header += t.header_bytes[lanes];
  const auto load_two = [](const std::byte* a, const std::byte* b) { return words(load_pair(a, b)); };
  const i32x4 heads = even(load_two(h0, h1), load_two(h2, h3));
  Codes codes;
  store(codes.upper, heads & load_aligned(t.codes));
  store(codes.lower, shift_left<4>(heads) & load_aligned(t.codes));
  // 2^(shift - 16): the shift of the minima, put where a float has its exponent.
  const f32x4 power = bits_as_float(shift_left<23>(heads & splat_int(15)) + splat_int((127 - 16) << 23));
  i32x4 least[4];
  widen(t, load_two(h0 + 3, h1 + 3), load_two(h2 + 3, h3 + 3), least);
  for (int c = 0; c < 3; ++c) out.rest[c] = to_float(least[c]) * power;
  out.rest[3] = step_sizes(heads & splat_int(0xFF0000));

  const std::byte* record = cursor.record;
  std::uint64_t bit = cursor.bit_times_16;
  const std::size_t frame_bytes = cursor.frame_bytes;
  const auto two = [&](std::uint32_t first) {
    const u64x2 zero = load_aligned(kTables.mask[0]);
    Fields f = {zero, zero, zero}, g = f;
    if ((lanes >> first & 1u) != 0) [[likely]]
      next_fields(record, bit, frame_bytes, t, codes, first, f);
    if ((lanes >> (first + 1) & 1u) != 0) [[likely]]
      next_fields(record, bit, frame_bytes, t, codes, first + 1, g);
    return TwoLanes{{even(words(f.x), words(g.x)), even(words(f.y), words(g.y)), even(words(f.z), words(g.z))}};
  };
  const TwoLanes ab = two(0), cd = two(2);
  cursor.record = record;
  cursor.bit_times_16 = bit;
  for (int c = 0; c < 3; ++c) {
    out.a[c] = to_float(even(ab.c[c], cd.c[c]));
    out.b[c] = to_float(odd(ab.c[c], cd.c[c]));
  }
}

[[maybe_unused]] inline void load_kept(const FramePair& from, Unpacked& out) {
  for (int c = 0; c < 3; ++c) {
    out.a[c] = load_aligned(from.a[c]);
    out.b[c] = load_aligned(from.b[c]);
  }
  for (int i = 0; i < 4; ++i) out.rest[i] = load_aligned(from.rest[i]);
}
[[maybe_unused]] inline void keep(const Unpacked& four, FramePair& to) {
  for (int c = 0; c < 3; ++c) {
    store(to.a[c], four.a[c]);
    store(to.b[c], four.b[c]);
  }
  for (int i = 0; i < 4; ++i) store(to.rest[i], four.rest[i]);
}

// Writes the lanes in `lanes` of N components.
template <std::size_t N>
inline void store_lanes(const Tables& t, const f32x4 (&value)[N], std::uint32_t lanes, float (&to)[N][4]) {
  if (lanes == 15) {
    for (std::size_t i = 0; i < N; ++i) store(to[i], value[i]);
    return;
  }
  const mask4 mask = load_mask(t.lanes[lanes]);
  for (std::size_t i = 0; i < N; ++i) store(to[i], mask, value[i]);
}

// The quaternion of modified Rodrigues parameters m is (factor · m, factor - 1) with factor = 2 / (1 + m²).
struct Rodrigues {
  Vector<f32x4> m;
  f32x4 factor;
};

// n: a or b of `four`, an Unpacked or a FramePair.
template <class Numbers, class Four>
inline Rodrigues rodrigues(const Tables& t, const Numbers& n, const Four& four) {
  const f32x4 step = lanes_of(four.rest[3]);
  const Vector<f32x4> m = {(lanes_of(n[0]) + lanes_of(four.rest[0])) * step,
                           (lanes_of(n[1]) + lanes_of(four.rest[1])) * step,
                           (lanes_of(n[2]) + lanes_of(four.rest[2])) * step};
  return {m, load_aligned(t.two) / (dot(m, m) + load_aligned(t.one))};
}

// Two rotations a lane, ready to be blended.
struct Rotations {
  Vector<f32x4> a, b;
  f32x4 factor_a, factor_b, chord_squared;
};

template <class Four>
inline Rotations rotations(const Tables& t, const Four& four) {
  const Rodrigues a = rodrigues(t, four.a, four), b = rodrigues(t, four.b, four);
  // The squared chord between the quaternions, without a difference of large numbers.
  const Vector<f32x4> d = a.m - b.m;
  return {a.m, b.m, a.factor, b.factor, dot(d, d) * (a.factor * b.factor)};
}

inline Vector<f32x4> load3(const float (&from)[3][4]) {
  return {load_aligned(from[0]), load_aligned(from[1]), load_aligned(from[2])};
}
inline void store3(const Vector<f32x4>& v, float (&to)[3][4]) {
  store(to[0], v.x);
  store(to[1], v.y);
  store(to[2], v.z);
}

[[maybe_unused]] inline Rotations kept_rotations(const FramePair& from) {
  return {load3(from.a), load3(from.b), load_aligned(from.rest[0]), load_aligned(from.rest[1]),
          load_aligned(from.rest[2])};
}
[[maybe_unused]] inline void keep(const Rotations& r, FramePair& to) {
  store3(r.a, to.a);
  store3(r.b, to.b);
  store(to.rest[0], r.factor_a);
  store(to.rest[1], r.factor_b);
  store(to.rest[2], r.chord_squared);
}

// The blend of two frames, the same for every joint.
struct FrameBlend {
  f32x4 u;
  SlerpSeries a, b;
  explicit FrameBlend(float between) : u(splat(between)), a(slerp_series(1.0f - between)), b(slerp_series(between)) {}
};

// Rotations, into the lanes in `lanes`.
inline void rotate_rest(const Tables& t, const Rotations& two, const FrameBlend& blend, const float (&rest)[4][4],
                        std::uint32_t lanes, float (&rotation)[4][4]) {
  const f32x4 chord_squared = two.chord_squared;
  f32x4 wa, wb;
  if (any(load_aligned(t.series_limit) < chord_squared)) [[unlikely]] {
    // Beyond half a turn, -b is as good as b, and nearer.
    const mask4 far = splat(2.0f) < chord_squared;
    const auto [exact_a, exact_b] = slerp_weights(select(far, splat(4.0f) - chord_squared, chord_squared), blend.u);
    wa = exact_a;
    wb = select(far, splat(0.0f) - exact_b, exact_b);
  } else {
    wa = slerp_weight(blend.a, chord_squared);
    wb = slerp_weight(blend.b, chord_squared);
  }
  const f32x4 fa = wa * two.factor_a, fb = wb * two.factor_b;
  const Vector<f32x4> v = two.a * fa + two.b * fb;
  const f32x4 x = v.x, y = v.y, z = v.z, w = (fa + fb) - (wa + wb);
  const f32x4 rx = load_aligned(rest[0]), ry = load_aligned(rest[1]), rz = load_aligned(rest[2]),
              rw = load_aligned(rest[3]);
  store_lanes(t,
              {rw * x + rx * w + (ry * z - rz * y), rw * y + ry * w + (rz * x - rx * z),
               rw * z + rz * w + (rx * y - ry * x), rw * w - (rx * x + ry * y + rz * z)},
              lanes, rotation);
}

// Translations or scales.
template <class Four>
inline void add_to_rest(const Tables& t, const Four& four, f32x4 u, const float (&rest)[3][4], std::uint32_t lanes,
                        float (&vector)[3][4]) {
  f32x4 out[3];
  for (int c = 0; c < 3; ++c)
    out[c] = load_aligned(rest[c]) +
             (lanes_of(four.a[c]) + (lanes_of(four.b[c]) - lanes_of(four.a[c])) * u + lanes_of(four.rest[c])) *
                 lanes_of(four.rest[3]);
  store_lanes(t, out, lanes, vector);
}

[[gnu::noinline, maybe_unused]] void blend_kept(const FramePair& two, std::uint32_t kind, const FrameBlend& blend,
                                                const SoaTransform& rest, std::uint32_t lanes, SoaTransform& out) {
  const Tables& t = tables();
  if (kind == 0) return rotate_rest(t, rotations(t, two), blend, rest.rotation, lanes, out.rotation);
  add_to_rest(t, two, blend.u, kind == 2 ? rest.scale : rest.translation, lanes,
              kind == 2 ? out.scale : out.translation);
}

// What moves, group after group. One loop for all kinds, since they are unpacked alike.
struct Moving {
  const Skeleton& skeleton;
  const CodedTracks& coded;
  const SampleOptions& options;
  FrameBlend blend;
  FramePair *kept, *kept_end;  // one a kind and group; null: none is kept
  bool is_kept;                // by an earlier call
};

void set_moving(const Moving& m, TrackCursor cursor, SoaTransform* out) {
  const Tables& t = tables();
  const GroupMasks* masks = m.coded.masks;
  const SoaTransform* rest = m.skeleton.rest;
  SoaTransform* const end = out + m.skeleton.soa_size();
  FramePair* pair = m.kept;
  for (std::size_t g = 0; out != end; ++g, ++out, ++rest, ++masks) {
    std::uint32_t moving = masks->moving;
    if (moving == 0) continue;
    const std::uint32_t wanted = wanted_lanes(m.options, g);
    for (std::uint32_t kind = 0; moving != 0; ++kind, moving >>= 4) {
      const std::uint32_t tracks = moving & 15u, lanes = tracks & wanted;
      if (tracks == 0) continue;
      if (!kSmall && lanes == 0) {
        skip(cursor, tracks);
        continue;
      }
      // Only if a clip passes for another one by its id, as a file might that was made for that.
      if (pair != nullptr && pair == m.kept_end) [[unlikely]]
        return;
      if constexpr (kSmall) {
        FramePair one;
        FramePair& two = pair != nullptr ? *pair : one;
        if (!m.is_kept) unpack_each(cursor, tracks, two);
        blend_kept(two, kind, m.blend, *rest, lanes, *out);
      } else {
        Unpacked four;
        if (!m.is_kept) unpack(cursor, t, tracks, four);
        if (kind == 0) {
          const Rotations two = m.is_kept ? kept_rotations(*pair) : rotations(t, four);
          if (!m.is_kept && pair != nullptr) keep(two, *pair);
          rotate_rest(t, two, m.blend, rest->rotation, lanes, out->rotation);
        } else {
          if (m.is_kept) {
            load_kept(*pair, four);
          } else if (pair != nullptr) {
            keep(four, *pair);
          }
          const bool scales = kind == 2;
          add_to_rest(t, four, m.blend.u, scales ? rest->scale : rest->translation, lanes,
                      scales ? out->scale : out->translation);
        }
      }
      if (pair != nullptr) ++pair;
    }
  }
}

// Of the next constants, one for each lane in `lanes`, those of the lanes `first` and `first` + 1.
inline i32x4 two_constants(const Tables& t, const std::byte* next, std::uint32_t lanes, std::uint32_t first) {
  const std::uint8_t(&offset)[4] = t.constant[lanes];
  return words(load_pair(next + offset[first], next + offset[first + 1]));
}

// From constants of two lanes each: quaternions times any factor.
inline void set_rotations(const Tables& t, i32x4 ab, i32x4 cd, std::uint32_t lanes, float (&rotation)[4][4]) {
  i32x4 v[4];
  widen(t, ab, cd, v);
  const f32x4 x = to_float(v[0]), y = to_float(v[1]), z = to_float(v[2]), w = to_float(v[3]);
  const f32x4 inverse = load_aligned(t.one) / sqrt(x * x + y * y + z * z + w * w);
  store_lanes(t, {x * inverse, y * inverse, z * inverse, w * inverse}, lanes, rotation);
}

// Differences from the rest pose, and their steps.
inline void set_vectors(const Tables& t, i32x4 ab, i32x4 cd, const float (&rest)[3][4], std::uint32_t lanes,
                        float (&vector)[3][4]) {
  i32x4 v[4];
  widen(t, ab, cd, v);
  const f32x4 step = splat(1.0f / 65536) * step_sizes(v[3]);
  store_lanes(t,
              {load_aligned(rest[0]) + to_float(v[0]) * step, load_aligned(rest[1]) + to_float(v[1]) * step,
               load_aligned(rest[2]) + to_float(v[2]) * step},
              lanes, vector);
}

// What does not move: the rest pose, over it the constants.
void set_still(const Skeleton& skeleton, const CodedTracks& coded, const SampleOptions& options, SoaTransform* out) {
  const Tables& t = tables();
  const std::byte* next = coded.constants;
  const GroupMasks* masks = coded.masks;
  const SoaTransform* rest = skeleton.rest;
  SoaTransform* const end = out + skeleton.soa_size();
  for (std::size_t g = 0; out != end; ++g, ++out, ++rest, ++masks) {
    const std::uint32_t constant = masks->constant, wanted = wanted_lanes(options, g);
    // Lanes that move will be written over.
    const bool rotations_follow = wanted == 15 && (~(masks->moving | constant) & 15u) == 0;
    if (rotations_follow) {
      copy(rest->translation, out->translation);
      copy(rest->scale, out->scale);
    } else {
      copy_lanes(*rest, wanted, *out);
    }
    if (const std::uint32_t lanes = constant & 15u; lanes == 15) {
      set_rotations(t, load_words(next), load_words(next + 2 * kConstantBytes), wanted, out->rotation);
      next += 4 * kConstantBytes;
    } else if (lanes != 0) {
      set_rotations(t, two_constants(t, next, lanes, 0), two_constants(t, next, lanes, 2),
                    rotations_follow ? 15 : lanes & wanted, out->rotation);
      next += t.constant_bytes[lanes];
    }
    if ((constant & 0xFF0u) == 0) continue;
    for (std::uint32_t shift = 4; shift <= 8; shift += 4) {
      const std::uint32_t lanes = constant >> shift & 15u;
      if (lanes == 0) continue;
      set_vectors(t, two_constants(t, next, lanes, 0), two_constants(t, next, lanes, 2),
                  shift == 4 ? rest->translation : rest->scale, lanes & wanted,
                  shift == 4 ? out->translation : out->scale);
      next += t.constant_bytes[lanes];
    }
  }
}

// A frame, the last but one at most, and how far it is on the way to the next.
struct Place {
  std::uint32_t frame;
  float between;
};

Place find(const CodedTracks& coded, float time_s) {
  const std::uint32_t last = coded.frame_count - 1;
  if (coded.times_s != nullptr) {
    const Moment m = find_moment(coded.times_s, coded.frame_count, time_s);
    return {static_cast<std::uint32_t>(m.key), m.u};
  }
  const float position = (time_s - coded.start_s) * coded.frames_per_s;
  if (position >= static_cast<float>(last)) return {last - 1, 1.0f};
  if (!(position > 0.0f)) return {0, 0.0f};
  const auto frame = static_cast<std::uint32_t>(position);
  return {frame, position - static_cast<float>(frame)};
}

}  // namespace

void copy_some_lanes(const SoaTransform& from, std::uint32_t lanes, SoaTransform& to) {
  if (lanes == 15) {
    to = from;
    return;
  }
  constexpr std::size_t kNumbers = sizeof from / sizeof(float);
  const auto* const source = reinterpret_cast<const float*>(&from);
  auto* const target = reinterpret_cast<float*>(&to);
  for (std::size_t i = 0; i < kNumbers; ++i)
    if ((lanes >> i % 4 & 1u) != 0) target[i] = source[i];
}

std::size_t frame_pairs(const CodedTracks& coded, std::size_t groups) {
  std::size_t out = 0;
  for (std::size_t g = 0; g < groups; ++g)
    for (std::uint32_t moving = coded.masks[g].moving; moving != 0; moving >>= 4) out += (moving & 15u) != 0;
  return out;
}

void sample_coded(const Skeleton& skeleton, const CodedTracks& coded, float time_s, const SampleOptions& options,
                  SoaTransform* out, bool is_still, SampleCache* cache) {
  if (!is_still) (kSmall ? set_still_each : set_still)(skeleton, coded, options, out);
  const Place place = find(coded, time_s);
  const std::uint32_t segment = place.frame / coded.segment_intervals;
  const TrackCursor cursor(coded.payload + coded.segment_offsets[segment], coded.track_count,
                           place.frame - segment * coded.segment_intervals);
  Span<FramePair> kept;
  if (cache != nullptr && cache->room)
    kept = {reinterpret_cast<FramePair*>(cache->memory.data), cache->memory.size / sizeof(FramePair)};
  set_moving({skeleton, coded, options, FrameBlend(place.between), kept.begin(), kept.end(),
              !kept.empty() && cache->frame == place.frame},
             cursor, out);
  if (cache != nullptr) cache->frame = place.frame;
}

}  // namespace marrow
