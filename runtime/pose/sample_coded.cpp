#include "pose/sample_coded.h"

#include <cstring>
#include <utility>

#include "core/opaque.h"
#include "math/keys.h"
#include "math/slerp.h"
#include "pose/coded_lanes.h"
#include "pose/sample_state.h"
#include "pose/unpack_frames.h"

namespace marrow {
namespace {

// Marks a pair whose two frames are alike: stored in FramePair::step[0], which is 0 or more otherwise.
constexpr float kAlike = -1.0f;
inline bool are_alike(const FramePair& two) {
  std::int32_t bits;
  std::memcpy(&bits, two.step, sizeof bits);
  return bits < 0;
}

// Stores a pair in the cache. Returns whether its frames have just become alike; then the caller calls write_alike().
// kFollows: the cache holds the preceding pair, whose later frame is now the earlier one, so only the new later frame
// is stored. first: which half of a FramePair holds the earlier frame.
template <bool kFollows>
inline bool keep(const Unpacked& four, std::uint32_t first, FramePair& to) {
  const f32x4(&a)[3] = four.frame[0], (&b)[3] = four.frame[1];
  const f32x4 x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
  const bool alike = !any(splat(0.0f) < x * x + y * y + z * z);
  if (kFollows && alike && are_alike(to)) return false;
  if constexpr (!kFollows) store_frame(a, numbers_of(to, first));
  store_frame(b, numbers_of(to, 1 - first));
  if constexpr (!kFollows) store_frame(four.other, to.other);
  store(to.step, four.step);
  return alike;
}

// Two rotations a lane, ready to be blended. The quaternion of modified Rodrigues parameters m is (factor · m,
// factor - 1) with factor = 2 / (1 + m²).
struct Rotations {
  f32x4 a[3], b[3], factor_a, factor_b, chord_squared;
  bool alike;  // all lanes are the same in both frames
};

// Sets m to the parameters of one frame of `four`. Returns the factor.
[[gnu::always_inline]] inline f32x4 rodrigues(const LaneTables& t, const Unpacked& four, std::uint32_t frame,
                                              f32x4 (&m)[3]) {
  for (int c = 0; c < 3; ++c) m[c] = (four.frame[frame][c] + four.other[c]) * four.step;
  return load_aligned(t.two) / (m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + load_aligned(t.one));
}

// Fills in the rest of `out`, whose `a` and `factor_a` are set.
[[gnu::always_inline]] inline void later_rotations(const LaneTables& t, const Unpacked& four, Rotations& out) {
  out.factor_b = rodrigues(t, four, 1, out.b);
  // The squared chord between the quaternions, without a difference of large numbers.
  const f32x4 x = out.a[0] - out.b[0], y = out.a[1] - out.b[1], z = out.a[2] - out.b[2];
  const f32x4 squared = x * x + y * y + z * z;
  out.chord_squared = squared * (out.factor_a * out.factor_b);
  out.alike = !any(splat(0.0f) < squared);
}

template <bool kFollows>
[[gnu::always_inline]] inline bool keep(const Rotations& r, std::uint32_t first, FramePair& to) {
  if (kFollows && r.alike && are_alike(to)) return false;
  if constexpr (!kFollows) {
    store_frame(r.a, numbers_of(to, first));
    store(to.other[first], r.factor_a);
  }
  store_frame(r.b, numbers_of(to, 1 - first));
  store(to.other[1 - first], r.factor_b);
  store(to.other[2], r.chord_squared);
  to.step[0] = 0.0f;
  return r.alike;
}

// The blend of two frames, a and b, the same for every joint.
struct FrameBlend {
  f32x4 u;
  SlerpSeries a, b;
  bool swapped = false;  // b is the earlier
  explicit FrameBlend(float between) : u(splat(between)), a(slerp_series(1.0f - between)), b(slerp_series(between)) {}
};

// The weights of the frames a and b. chord_squared: between their quaternions.
[[gnu::always_inline]] inline SlerpWeights<f32x4> weights(const LaneTables& t, f32x4 chord_squared,
                                                          const FrameBlend& blend) {
  if (any(load_aligned(t.series_limit) < chord_squared)) [[unlikely]] {
    // Beyond half a turn, the later quaternion negated is the same rotation, and nearer.
    const mask4 far = splat(2.0f) < chord_squared;
    const auto [earlier, after] = slerp_weights(select(far, splat(4.0f) - chord_squared, chord_squared), blend.u);
    const f32x4 later = select(far, splat(0.0f) - after, after);
    if (blend.swapped) return {later, earlier};
    return {earlier, later};
  }
  return {slerp_weight(blend.a, chord_squared), slerp_weight(blend.b, chord_squared)};
}

// Equal rotations get the weights 1 and 0: if they were blended, rounding would depend on the time.
[[gnu::always_inline]] inline SlerpWeights<f32x4> weights(const LaneTables& t, const Rotations& two,
                                                          const FrameBlend& blend) {
  if (two.alike) return {load_aligned(t.one), splat(0.0f)};
  return weights(t, two.chord_squared, blend);
}

// Writes rest · blended rotation into the lanes in `lanes`.
[[gnu::always_inline]] inline void rotate_rest(const LaneTables& t, const Rotations& two,
                                               const SlerpWeights<f32x4>& weight, const float (&rest)[4][4],
                                               std::uint32_t lanes, float (&rotation)[4][4]) {
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

// rotate_rest() for a pair from the cache. weight: of the even frame (a) and the odd frame (b), whichever of them is
// earlier.
inline void rotate_kept(const LaneTables& t, const FramePair& two, const SlerpWeights<f32x4>& weight,
                        const SoaTransform& rest, std::uint32_t lanes, SoaTransform& out) {
  Rotations r;
  load_frame(two.frame[0], r.a);
  load_frame(two.frame[1], r.b);
  r.factor_a = load_aligned(two.other[0]);
  r.factor_b = load_aligned(two.other[1]);
  rotate_rest(t, r, weight, rest.rotation, lanes, out.rotation);
}

// Writes rest + blended translations, or scales, into the lanes in `lanes`. first: which frame of `four` is the
// earlier.
template <class Four>
inline void add_to_rest(const LaneTables& t, const Four& four, std::uint32_t first, f32x4 u, const float (&rest)[3][4],
                        std::uint32_t lanes, float (&vector)[3][4]) {
  f32x4 out[3];
  for (int c = 0; c < 3; ++c) {
    const f32x4 a = lanes_of(four.frame[first][c]), b = lanes_of(four.frame[1 - first][c]);
    out[c] = load_aligned(rest[c]) + (a + (b - a) * u + lanes_of(four.other[c])) * lanes_of(four.step);
  }
  store_lanes(t, out, lanes, vector);
}

// Writes a pair whose frames are alike into the pose, once, and marks it: set_kept() passes it over from then on.
[[gnu::noinline]] void write_alike(FramePair& two, std::uint32_t kind, const SoaTransform& rest, std::uint32_t lanes,
                                   SoaTransform& out) {
  const LaneTables& t = lane_tables();
  if (kind == 0) {
    rotate_kept(t, two, {load_aligned(t.one), splat(0.0f)}, rest, lanes, out);
  } else {
    const bool scales = kind == 2;
    add_to_rest(t, two, 0, splat(0.0f), scales ? rest.scale : rest.translation, lanes,
                scales ? out.scale : out.translation);
  }
  two.step[0] = kAlike;
}

// The arguments of set_moving() and set_kept(): of a call of sample_coded().
struct Moving {
  const Skeleton& skeleton;
  const CodedTracks& coded;
  const SampleOptions& options;
  const FrameBlend& blend;
  FramePair *kept, *kept_last;  // the cache: one pair per kind and group, and the last that fits; null: none is kept
  std::uint32_t first;          // which of the two in a FramePair is the earlier
};

// Unpacks the moving tracks. With kFollows, only their later frame: the cache holds the frame before, of the same
// segment. With a cache the frames go there, and only pairs that have just become alike are written to the pose.
// Without one, the blended frames are written to the pose. One loop serves rotations, translations and scales (kinds 0,
// 1, 2), since they are unpacked in the same way.
template <bool kFollows>
void set_moving(const Moving& m, TrackCursor& cursor, SoaTransform* out) {
  const LaneTables& t = lane_tables();
  const GroupMasks* masks = m.coded.masks;
  const SoaTransform* rest = m.skeleton.rest;
  SoaTransform* const end = out + m.skeleton.soa_size();
  FramePair* pair = m.kept;
  for (std::size_t g = 0; out != end; ++g, ++out, ++rest, ++masks) {
    std::uint32_t moving = masks->moving;
    if (moving == 0) continue;
    const std::uint32_t wanted = kFollows ? 15u : wanted_lanes(m.options, g);
    for (std::uint32_t kind = 0; moving != 0; ++kind, moving >>= 4) {
      const std::uint32_t tracks = moving & 15u, lanes = tracks & wanted;
      if (tracks == 0) continue;
      if (lanes == 0) {
        skip(cursor, tracks);
        continue;
      }
      // Happens only if a clip has another clip's id, as in a hostile file.
      if (pair > m.kept_last) [[unlikely]]
        return;
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
        if (kFollows || pair != nullptr) {
          if (keep<kFollows>(two, m.first, *pair)) write_alike(*pair, kind, *rest, lanes, *out);
          ++pair;
        } else {
          rotate_rest(t, two, weights(t, two, m.blend), rest->rotation, lanes, out->rotation);
        }
      } else {
        if constexpr (kFollows) load_frame(numbers_of(*pair, m.first), four.frame[0]);
        if (kFollows || pair != nullptr) {
          if (keep<kFollows>(four, m.first, *pair)) write_alike(*pair, kind, *rest, lanes, *out);
          ++pair;
        } else {
          const bool scales = kind == 2;
          add_to_rest(t, four, 0, m.blend.u, scales ? rest->scale : rest->translation, lanes,
                      scales ? out->scale : out->translation);
        }
      }
    }
  }
}

// Blends the cached frames, for all joints. Pairs that are alike are in the pose already. A separate loop: processors
// do not look far enough ahead to unpack a group while they blend the one before.
void set_kept(const Moving& m, SoaTransform* out) {
  const LaneTables& t = lane_tables();
  const GroupMasks* masks = m.coded.masks;
  const SoaTransform* rest = m.skeleton.rest;
  SoaTransform* const end = out + m.skeleton.soa_size();
  // `a` is the even frame's rotation. If the even frame is the later one, swapping the weights is enough for rotations.
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
        rotate_kept(t, two, weight, *rest, lanes, *out);
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

// A frame, at most the last but one, and the fraction of the way to the next.
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
  if (cache != nullptr && state_of(*cache).room != 0 && cache->memory.size >= sizeof(FramePair)) {
    kept = reinterpret_cast<FramePair*>(cache->memory.data);
    last = reinterpret_cast<FramePair*>(cache->memory.end() - sizeof(FramePair));
  }
  const bool is_kept = kept != nullptr && state_of(*cache).frame == place.frame;
  const std::uint32_t segment = place.frame / coded.segment_intervals;
  const std::uint32_t in_segment = place.frame - segment * coded.segment_intervals;
  const FrameBlend blend(place.between);
  const Moving moving = {skeleton, coded, options, blend, kept, last, place.frame % 2};
  if (!is_kept) {
    const bool follows = kept != nullptr && in_segment != 0 && state_of(*cache).frame == place.frame - 1;
    const std::uint32_t from = follows ? in_segment + 1 : in_segment;
    TrackCursor cursor(coded.payload + coded.segment_offsets[segment], coded.track_count, from);
    if (follows) {
      set_moving<true>(moving, cursor, out);
    } else {
      set_moving<false>(moving, cursor, out);
    }
  }
  if (kept != nullptr) set_kept(moving, out);
  if (cache != nullptr) state_of(*cache).frame = place.frame;
}

}  // namespace marrow
