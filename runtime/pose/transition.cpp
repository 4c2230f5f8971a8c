#include "marrow/transition.h"

#include "core/check.h"
#include "marrow/blend.h"
#include "math/quaternion.h"
#include "pose/mask.h"

namespace marrow {
namespace {

constexpr float kPi = 3.14159265f;

constexpr float kShortest_s = 1e-6f, kLongest_s = 1e6f;

bool above_zero(float x) {
  return 0.0f < x && is_finite(x);
}

// The nine components by which four joints differ: translation, rotation vector, scale.
struct Offset {
  f32x4 at[9];
};

// What `from` is off `to`. turn: set to the rotational part, a unit quaternion. Of q and -q it is the one with w ≥ 0
// or, if `like` is given, the one in the hemisphere of `like`. `turn` and `like` may be the same.
Offset difference(const SoaTransform& from, const SoaTransform& to, const Quaternion<f32x4>* like,
                  Quaternion<f32x4>& turn) {
  const Quaternion<f32x4> either = load_rotations(from.rotation) * conjugate(load_rotations(to.rotation));
  turn = normalised(flip(either, like != nullptr ? dot(either, *like) : either.w));
  const Vector<f32x4> v = log_rotation(turn);
  Offset out;
  for (int i = 0; i < 3; ++i) {
    out.at[i] = load_aligned(from.translation[i]) - load_aligned(to.translation[i]);
    out.at[6 + i] = load_aligned(from.scale[i]) - load_aligned(to.scale[i]);
  }
  out.at[3] = v.x, out.at[4] = v.y, out.at[5] = v.z;
  return out;
}

// The fade is the quintic (1 - s)⁴ (x + (4 x + v) s). x is the offset's magnitude at the start, v its velocity times
// the fade's duration. For x ≥ 0 the fade stays ≥ 0 if v ≥ -5 x; otherwise it is shortened until that holds. A v > 0
// adds at most 0.082 v, at s = 1/5: so v of a turn is limited to 12 (π - x), which keeps the fade at or below π.
void set_fade(f32x4 start, f32x4 velocity, f32x4 slowest, bool is_turn, int i, InertialOffset& out) {
  const f32x4 zero = splat(0.0f), most = splat(1e9f);
  const f32x4 x = flip(start, start);  // |start|; the rest is mirrored with it
  f32x4 v = flip(velocity, start);
  // The rate is 1 / duration, or -v / (5 x) if that is more. An x of 0 has no sign to keep, so it is not shortened.
  const f32x4 sooner = (zero - v) / (splat(5.0f) * select(zero < x, x, most));
  f32x4 rate = select(slowest < sooner, sooner, slowest);
  rate = select(rate < most, rate, most);
  v = v / rate;
  if (is_turn) {
    const f32x4 room = splat(12.0f) * (splat(kPi) - x);
    v = select(room < v, select(zero < room, room, zero), v);
  }
  const f32x4 lowest = select(zero < x, zero - x, splat(-1e30f));
  const f32x4 slope = splat(4.0f) * x + v;
  store(out.start[i], start);
  store(out.slope[i], flip(select(slope < lowest, lowest, slope), start));
  store(out.rate[i], rate);
}

f32x4 fade(const InertialOffset& offset, int i, f32x4 time) {
  const f32x4 one = splat(1.0f);
  const f32x4 s = clamp_to_unit(load_aligned(offset.rate[i]) * time);
  const f32x4 left = one - s, left2 = left * left;
  return left2 * left2 * (load_aligned(offset.start[i]) + load_aligned(offset.slope[i]) * s);
}

}  // namespace

float fade_weight(Fade shape, float time_s, float duration_s) {
  if (!(0.0f < time_s)) return 0.0f;
  if (!(time_s < duration_s)) return 1.0f;
  const float u = time_s / duration_s, v = 1.0f - u;
  // The second half is the first one turned round, so that both ends are approached alike.
  switch (shape) {
    case Fade::linear:
      break;
    case Fade::smoothstep:
      return u < 0.5f ? u * u * (1.0f + 2.0f * v) : 1.0f - v * v * (1.0f + 2.0f * u);
    case Fade::smootherstep:
      return u < 0.5f ? u * u * u * (1.0f + v * (3.0f + 6.0f * v)) : 1.0f - v * v * v * (1.0f + u * (3.0f + 6.0f * u));
  }
  return u;
}

Status cross_fade(const Skeleton& skeleton, Span<const SoaTransform> from, Span<const SoaTransform> to, float weight,
                  Span<SoaTransform> out) {
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(within(weight, 0.0f, 1.0f));
  MARROW_REQUIRE(holds(from, groups));
  MARROW_REQUIRE(holds(to, groups));
  MARROW_REQUIRE(holds(out, groups));
  const BlendLayer layers[2] = {{from, 1.0f - weight, {}}, {to, weight, {}}};
  return blend(skeleton, {layers, 2}, out);
}

Status begin_inertia(const Skeleton& skeleton, const InertialStart& start, float duration_s, Inertia& inertia) {
  const std::size_t groups = skeleton.soa_size();
  const bool moving = !start.target_was.empty();
  MARROW_REQUIRE(holds(inertia.offsets, groups));
  MARROW_REQUIRE(holds(start.before, groups));
  MARROW_REQUIRE(holds(start.now, groups));
  MARROW_REQUIRE(holds(start.target, groups));
  MARROW_REQUIRE(!moving || holds(start.target_was, groups));
  MARROW_REQUIRE(above_zero(start.frame_s));
  MARROW_REQUIRE(above_zero(duration_s) && duration_s <= kLongest_s);
  const f32x4 frame = splat(start.frame_s > kShortest_s ? start.frame_s : kShortest_s),
              slowest = splat(1.0f / duration_s);
  for (std::size_t g = 0; g < groups; ++g) {
    Quaternion<f32x4> turn;
    const Offset now = difference(start.now[g], start.target[g], nullptr, turn);
    const Offset before = difference(start.before[g], (moving ? start.target_was : start.target)[g], &turn, turn);
    for (int i = 0; i < 9; ++i) {
      const bool is_turn = i >= 3 && i < 6;
      set_fade(now.at[i], (now.at[i] - before.at[i]) / frame, slowest, is_turn, i, inertia.offsets[g]);
    }
  }
  inertia.duration_s = duration_s;
  return Status::ok;
}

Status apply_inertia(const Skeleton& skeleton, const Inertia& inertia, float time_s, Span<SoaTransform> pose) {
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(holds(pose, groups));
  MARROW_REQUIRE(time_s == time_s);
  if (!(time_s < inertia.duration_s)) return Status::ok;
  MARROW_REQUIRE(holds(inertia.offsets, groups));
  const f32x4 time = splat(time_s > 0.0f ? time_s : 0.0f);
  for (std::size_t g = 0; g < groups; ++g) {
    SoaTransform& p = pose[g];
    f32x4 offset[9];
    for (int i = 0; i < 9; ++i) offset[i] = fade(inertia.offsets[g], i, time);
    for (int i = 0; i < 3; ++i) {
      store(p.translation[i], load_aligned(p.translation[i]) + offset[i]);
      store(p.scale[i], load_aligned(p.scale[i]) + offset[6 + i]);
    }
    const Quaternion<f32x4> turn = exp_rotation(vector_of(offset[3], offset[4], offset[5]));
    store_rotations(p.rotation, normalised(turn * load_rotations(p.rotation)));
  }
  return Status::ok;
}

}  // namespace marrow
