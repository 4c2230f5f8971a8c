#include "pose/sample_coded.h"

#include <cstring>
#include <utility>

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
  // Operands from memory.
  alignas(16) float one[4], two[4], series_limit[4];
  alignas(16) std::uint32_t codes[4], high[4];
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

// A FramePair of integers in registers, the earlier frame first.
struct Unpacked {
  f32x4 frame[2][3], other[3], step;
};
[[maybe_unused]] inline f32x4 lanes_of(f32x4 number) {
  return number;
}
[[maybe_unused]] inline f32x4 lanes_of(const float (&number)[4]) {
  return load_aligned(number);
}
[[maybe_unused]] inline void load_frame(const float (&from)[3][4], f32x4 (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = load_aligned(from[i]);
}
[[maybe_unused]] inline void store_frame(const f32x4 (&from)[3], float (&to)[3][4]) {
  for (int i = 0; i < 3; ++i) store(to[i], from[i]);
}
// A frame of a pair, by one address for all its numbers.
template <class Pair>
inline auto& numbers_of(Pair& two, std::uint32_t frame) {
  return *opaque(&two.frame[frame]);
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

// A track's integers, in both frames or in the later one alone.
struct Fields {
  u64x2 x, y, z;
};

// The next track's; moves `record` to the byte where its bits begin, and `bit_times_16` from there behind them.
template <bool kLater>
inline void next_fields(const std::byte*& record, std::uint64_t& bit_times_16, std::size_t frame_bytes, const Tables& t,
                        const Codes& codes, std::uint32_t lane, Fields& out) {
  const auto x = static_cast<std::uint64_t>(codes.upper[4 * lane]),
             y = static_cast<std::uint64_t>(codes.lower[4 * lane + 1]),
             z = static_cast<std::uint64_t>(codes.upper[4 * lane + 1]);
  record += bit_times_16 / 128;
  bit_times_16 %= 128;
  const u64x2 bits = kLater ? load_one(record) : load_pair(record, record + frame_bytes);
  const u64x2 w = shift_right(bits, at(t.shift, bit_times_16));
  // In this order each sum takes an operand from memory.
  bit_times_16 = opaque(bit_times_16 + *at(t.bits_times_16, x));
  bit_times_16 = opaque(bit_times_16 + *at(t.bits_times_16, y));
  bit_times_16 += *at(t.bits_times_16, z);
  const u64x2 v = shift_right(w, at(t.shift, x));
  out.x = w & load_aligned(at(t.mask, x));
  out.y = v & load_aligned(at(t.mask, y));
  out.z = shift_right(v, at(t.shift, y)) & load_aligned(at(t.mask, z));
}

// Two lanes' fields side by side.
struct TwoLanes {
  i32x4 c[3];
};

// The next tracks, one for each lane in `lanes`. What a lane without a track gets is the same in all frames.
// kLater: of the later frame alone, at which the cursor stands.
template <bool kLater>
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
  for (int c = 0; c < 3; ++c) out.other[c] = to_float(least[c]) * power;
  out.step = step_sizes(heads & splat_int(0xFF0000));

  const std::byte* record = cursor.record;
  std::uint64_t bit = cursor.bit_times_16;
  const std::size_t frame_bytes = cursor.frame_bytes;
  const auto two = [&](std::uint32_t first) {
    const u64x2 zero = load_aligned(kTables.mask[0]);
    Fields f = {zero, zero, zero}, g = f;
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

// In place of a step, which is above 0: the two frames are alike.
constexpr float kAlike = -1.0f;
[[maybe_unused]] inline bool are_alike(const FramePair& two) {
  std::int32_t bits;
  std::memcpy(&bits, two.step, sizeof bits);
  return bits < 0;
}

// Whether it is to be written to the pose at once: it is alike, and was not. kFollows: what was kept is of the frame
// before, whose later one is the earlier now.
template <bool kFollows>
[[maybe_unused]] inline bool keep(const Unpacked& four, std::uint32_t first, FramePair& to) {
  const f32x4(&a)[3] = four.frame[0], (&b)[3] = four.frame[1];
  const f32x4 x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
  const bool alike = !any(splat(0.0f) < x * x + y * y + z * z);
  if (kFollows && alike && are_alike(to)) return false;
  if constexpr (!kFollows) store_frame(a, numbers_of(to, first));
  store_frame(b, numbers_of(to, 1 - first));
  if constexpr (!kFollows) store_frame(four.other, to.other);
  store(to.step, four.step);
  if (alike) to.step[0] = kAlike;
  return alike;
}

// Writes the lanes in `lanes` of `count` components.
template <class Count>
MARROW_CALLED_WHERE_SMALL inline void store_some(const Tables& t, const f32x4* value, Count count, std::uint32_t lanes,
                                                 float (*to)[4]) {
  if (lanes == 15) {
    for (std::size_t i = 0; i < count; ++i) store(to[i], value[i]);
    return;
  }
  const mask4 mask = load_mask(t.lanes[lanes]);
  for (std::size_t i = 0; i < count; ++i) store(to[i], mask, value[i]);
}
template <std::size_t N>
inline void store_lanes(const Tables& t, const f32x4 (&value)[N], std::uint32_t lanes, float (&to)[N][4]) {
  if constexpr (kSmall) {
    store_some(t, value, N, lanes, to);
  } else {
    store_some(t, value, Fixed<N>(), lanes, to);
  }
}

// Two rotations a lane, ready to be blended. The quaternion of modified Rodrigues parameters m is (factor · m,
// factor - 1) with factor = 2 / (1 + m²).
struct Rotations {
  f32x4 a[3], b[3], factor_a, factor_b, chord_squared;
  bool alike;  // all lanes are the same in both frames
};

// Of a frame of `four`, an Unpacked or a FramePair. Returns the factor.
template <class Four>
MARROW_CALLED_ONLY_WHERE_SMALL inline f32x4 rodrigues(const Tables& t, const Four& four, std::uint32_t frame,
                                                      f32x4 (&m)[3]) {
  const f32x4 step = lanes_of(four.step);
  for (int c = 0; c < 3; ++c) m[c] = (lanes_of(four.frame[frame][c]) + lanes_of(four.other[c])) * step;
  return load_aligned(t.two) / (m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + load_aligned(t.one));
}

// Of rotations whose `a` and `factor_a` are there.
template <class Four>
MARROW_CALLED_ONLY_WHERE_SMALL inline void later_rotations(const Tables& t, const Four& four, Rotations& out) {
  out.factor_b = rodrigues(t, four, 1, out.b);
  // The squared chord between the quaternions, without a difference of large numbers.
  const f32x4 x = out.a[0] - out.b[0], y = out.a[1] - out.b[1], z = out.a[2] - out.b[2];
  const f32x4 squared = x * x + y * y + z * z;
  out.chord_squared = squared * (out.factor_a * out.factor_b);
  out.alike = !any(splat(0.0f) < squared);
}

template <bool kFollows>
[[gnu::always_inline, maybe_unused]] inline bool keep(const Rotations& r, std::uint32_t first, FramePair& to) {
  if (kFollows && r.alike && are_alike(to)) return false;
  if constexpr (!kFollows) {
    store_frame(r.a, numbers_of(to, first));
    store(to.other[first], r.factor_a);
  }
  store_frame(r.b, numbers_of(to, 1 - first));
  store(to.other[1 - first], r.factor_b);
  store(to.other[2], r.chord_squared);
  to.step[0] = r.alike ? kAlike : 0.0f;
  return r.alike;
}

// The blend of two frames, a and b, the same for every joint.
struct FrameBlend {
  f32x4 u;
  SlerpSeries a, b;
  bool swapped = false;  // b is the earlier
  explicit FrameBlend(float between) : u(splat(between)), a(slerp_series(1.0f - between)), b(slerp_series(between)) {}
};

// Of a and b, whose squared chord this is.
[[gnu::always_inline]] inline SlerpWeights<f32x4> weights(const Tables& t, f32x4 chord_squared,
                                                          const FrameBlend& blend) {
  if (any(load_aligned(t.series_limit) < chord_squared)) [[unlikely]] {
    // Beyond half a turn, minus the later is as good as the later, and nearer.
    const mask4 far = splat(2.0f) < chord_squared;
    const auto [earlier, after] = slerp_weights(select(far, splat(4.0f) - chord_squared, chord_squared), blend.u);
    const f32x4 later = select(far, splat(0.0f) - after, after);
    if (!kSmall && blend.swapped) return {later, earlier};
    return {earlier, later};
  }
  return {slerp_weight(blend.a, chord_squared), slerp_weight(blend.b, chord_squared)};
}

// A blend of two equal ones would round as the time says.
MARROW_CALLED_ONLY_WHERE_SMALL inline SlerpWeights<f32x4> weights(const Tables& t, const Rotations& two,
                                                                  const FrameBlend& blend) {
  if (two.alike) return {load_aligned(t.one), splat(0.0f)};
  return weights(t, two.chord_squared, blend);
}

// Rotations, into the lanes in `lanes`.
[[gnu::always_inline]] inline void rotate_rest(const Tables& t, const Rotations& two, const SlerpWeights<f32x4>& weight,
                                               const float (&rest)[4][4], std::uint32_t lanes,
                                               float (&rotation)[4][4]) {
  const auto [wa, wb] = weight;
  const f32x4 fa = wa * two.factor_a, fb = wb * two.factor_b;
  const f32x4 x = two.a[0] * fa + two.b[0] * fb, y = two.a[1] * fa + two.b[1] * fb, z = two.a[2] * fa + two.b[2] * fb,
              w = (fa + fb) - (wa + wb);
  const f32x4 rx = load_aligned(rest[0]), ry = load_aligned(rest[1]), rz = load_aligned(rest[2]),
              rw = load_aligned(rest[3]);
  store_lanes(t,
              {rw * x + rx * w + (ry * z - rz * y), rw * y + ry * w + (rz * x - rx * z),
               rw * z + rz * w + (rx * y - ry * x), rw * w - (rx * x + ry * y + rz * z)},
              lanes, rotation);
}

// Translations or scales. first: which frame of `four` is the earlier.
template <class Four>
inline void add_to_rest(const Tables& t, const Four& four, std::uint32_t first, f32x4 u, const float (&rest)[3][4],
                        std::uint32_t lanes, float (&vector)[3][4]) {
  f32x4 out[3];
  for (int c = 0; c < 3; ++c) {
    const f32x4 a = lanes_of(four.frame[first][c]), b = lanes_of(four.frame[1 - first][c]);
    out[c] = load_aligned(rest[c]) + (a + (b - a) * u + lanes_of(four.other[c])) * lanes_of(four.step);
  }
  store_lanes(t, out, lanes, vector);
}

// What moves, group after group.
struct Moving {
  const Skeleton& skeleton;
  const CodedTracks& coded;
  const SampleOptions& options;
  const FrameBlend& blend;
  FramePair *kept, *kept_last;  // one a kind and group, and the last that there is memory for; null: none is kept
  std::uint32_t first;          // which of the two in a FramePair is the earlier
  bool is_kept;                 // by an earlier call
};

[[gnu::noinline, maybe_unused]] void blend_kept(const FrameBlend& blend, const FramePair& two, std::uint32_t kind,
                                                const SoaTransform& rest, std::uint32_t lanes, SoaTransform& out) {
  const Tables& t = tables();
  if (kind == 0) {
    Rotations r;
    r.factor_a = rodrigues(t, two, 0, r.a);
    later_rotations(t, two, r);
    return rotate_rest(t, r, weights(t, r, blend), rest.rotation, lanes, out.rotation);
  }
  add_to_rest(t, two, 0, blend.u, kind == 2 ? rest.scale : rest.translation, lanes,
              kind == 2 ? out.scale : out.translation);
}

// Which of two frames are unpacked into a cache's memory. The later alone, if what is kept there is of the frame
// before, of the same segment. Where code is small set_moving() does not ask.
enum class Keeps { none, both, later };

// Unpacks, and writes to the pose what is not kept, or is alike from now on; where code is small, all. One loop for all
// kinds, since they are unpacked alike.
template <Keeps kKeeps>
void set_moving(const Moving& m, TrackCursor& cursor, SoaTransform* out) {
  constexpr bool kFollows = kKeeps == Keeps::later;
  const Tables& t = tables();
  const GroupMasks* masks = m.coded.masks;
  const SoaTransform* rest = m.skeleton.rest;
  SoaTransform* const end = out + m.skeleton.soa_size();
  FramePair* pair = m.kept;
  for (std::size_t g = 0; out != end; ++g, ++out, ++rest, ++masks) {
    std::uint32_t moving = masks->moving;
    if (moving == 0) continue;
    const std::uint32_t wanted = kKeeps != Keeps::none ? 15u : wanted_lanes(m.options, g);
    for (std::uint32_t kind = 0; moving != 0; ++kind, moving >>= 4) {
      const std::uint32_t tracks = moving & 15u, lanes = tracks & wanted;
      if (tracks == 0) continue;
      if (!kSmall && lanes == 0) {
        skip(cursor, tracks);
        continue;
      }
      // Only if a clip passes for another one by its id, as a file might that was made for that.
      if (pair > m.kept_last) [[unlikely]]
        return;
      if constexpr (kSmall) {
        FramePair one;
        FramePair& two = pair != nullptr ? *pair : one;
        if (!m.is_kept) unpack_each(cursor, tracks, two);
        blend_kept(m.blend, two, kind, *rest, lanes, *out);
        if (pair != nullptr) ++pair;
      } else {
        Unpacked four;
        unpack<kFollows>(cursor, t, tracks, four);
        if (kind == 0) {
          Rotations two;
          if constexpr (kFollows) {
            load_frame(numbers_of(*pair, m.first), two.a);
            two.factor_a = load_aligned(pair->other[m.first]);
          } else {
            two.factor_a = rodrigues(t, four, 0, two.a);
          }
          later_rotations(t, four, two);
          if (kKeeps != Keeps::none && !keep<kFollows>(two, m.first, *pair++)) continue;
          rotate_rest(t, two, weights(t, two, m.blend), rest->rotation, lanes, out->rotation);
        } else {
          if constexpr (kFollows) load_frame(numbers_of(*pair, m.first), four.frame[0]);
          if (kKeeps != Keeps::none && !keep<kFollows>(four, m.first, *pair++)) continue;
          const bool scales = kind == 2;
          add_to_rest(t, four, 0, m.blend.u, scales ? rest->scale : rest->translation, lanes,
                      scales ? out->scale : out->translation);
        }
      }
    }
  }
}

// Of frames that are kept: all joints. What is alike in both stands there already. A loop of its own: processors do not
// see far enough ahead to unpack a group while they blend the one before.
[[maybe_unused]] void set_kept(const Moving& m, SoaTransform* out) {
  const Tables& t = tables();
  const GroupMasks* masks = m.coded.masks;
  const SoaTransform* rest = m.skeleton.rest;
  SoaTransform* const end = out + m.skeleton.soa_size();
  // Rotations of the even frame are `a`. Which is the earlier is a matter of weights alone, but for vectors.
  FrameBlend blend = m.blend;
  if (m.first != 0) {
    std::swap(blend.a, blend.b);
    blend.swapped = true;
  }
  const FramePair* pair = m.kept;
  for (; out != end; ++out, ++rest, ++masks) {
    const std::uint32_t moving = masks->moving;
    if (const std::uint32_t lanes = moving & 15u; lanes != 0) {
      if (pair > m.kept_last) [[unlikely]]
        return;
      const FramePair& two = *pair++;
      if (!are_alike(two)) {
        const SlerpWeights<f32x4> weight = weights(t, load_aligned(two.other[2]), blend);
        Rotations r;
        load_frame(two.frame[0], r.a);
        load_frame(two.frame[1], r.b);
        r.factor_a = load_aligned(two.other[0]);
        r.factor_b = load_aligned(two.other[1]);
        rotate_rest(t, r, weight, rest->rotation, lanes, out->rotation);
      }
    }
    if (moving <= 15) continue;
    for (std::uint32_t shift = 4; shift <= 8; shift += 4) {
      const std::uint32_t lanes = moving >> shift & 15u;
      if (lanes == 0) continue;
      if (pair > m.kept_last) [[unlikely]]
        return;
      const FramePair& two = *pair++;
      if (are_alike(two)) continue;
      const bool scales = shift == 8;
      add_to_rest(t, two, m.first, blend.u, scales ? rest->scale : rest->translation, lanes,
                  scales ? out->scale : out->translation);
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

// What does not move, four at a time: the rest pose, over it the constants.
[[maybe_unused]] void set_still_coded(const Skeleton& skeleton, const CodedTracks& coded, const SampleOptions& options,
                                      SoaTransform* out) {
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

void set_still(const Skeleton& skeleton, const CodedTracks& coded, const SampleOptions& options, SoaTransform* out) {
  if (kSmall) return set_still_each(skeleton, coded, options, out);
  if (coded.frame_count != 0) return set_still_coded(skeleton, coded, options, out);
  for (std::size_t g = 0; g < skeleton.soa_size(); ++g) copy_lanes(skeleton.rest[g], wanted_lanes(options, g), out[g]);
}

std::size_t frame_pairs(const CodedTracks& coded, std::size_t groups) {
  std::size_t out = 0;
  for (std::size_t g = 0; g < groups; ++g)
    for (std::uint32_t moving = coded.masks[g].moving; moving != 0; moving >>= 4) out += (moving & 15u) != 0;
  return out;
}

void sample_coded(const Skeleton& skeleton, const CodedTracks& coded, float time_s, const SampleOptions& options,
                  SoaTransform* out, SampleCache* cache) {
  const Place place = find(coded, time_s);
  FramePair *kept = nullptr, *last = nullptr;
  if (cache != nullptr && cache->room && cache->memory.size >= sizeof(FramePair)) {
    kept = reinterpret_cast<FramePair*>(cache->memory.data);
    last = reinterpret_cast<FramePair*>(cache->memory.end() - sizeof(FramePair));
  }
  const bool is_kept = kept != nullptr && cache->frame == place.frame;
  const std::uint32_t segment = place.frame / coded.segment_intervals;
  const std::uint32_t in_segment = place.frame - segment * coded.segment_intervals;
  const FrameBlend blend(place.between);
  const Moving moving = {skeleton, coded, options, blend, kept, last, place.frame % 2, is_kept};
  if (kSmall || !is_kept) {
    const bool follows = kept != nullptr && in_segment != 0 && cache->frame == place.frame - 1;
    const std::uint32_t from = !kSmall && follows ? in_segment + 1 : in_segment;
    TrackCursor cursor(coded.payload + coded.segment_offsets[segment], coded.track_count, from);
    if (kSmall || kept == nullptr) {
      set_moving<Keeps::none>(moving, cursor, out);
    } else if (follows) {
      set_moving<Keeps::later>(moving, cursor, out);
    } else {
      set_moving<Keeps::both>(moving, cursor, out);
    }
  }
  if (!kSmall && kept != nullptr) set_kept(moving, out);
  if (cache != nullptr) cache->frame = place.frame;
}

}  // namespace marrow
