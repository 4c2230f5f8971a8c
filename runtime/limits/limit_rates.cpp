// Followers: rotations and points that follow a target with limited speed and acceleration.
#include "core/check.h"
#include "core/zone.h"
#include "limits/joint_limit.h"
#include "math/joint.h"

namespace marrow {
namespace {

constexpr float kStepsPerSecond = 960.0f, kLongestFrame_s = 0.25f;
constexpr float kShortestFrame_s = 1e-9f;  // any move of a target in this time still has a finite velocity
// A follower has arrived when its distance from the target, and the difference of their velocities, are at most these.
constexpr float kArrived = 1e-5f, kArrivedSpeed = 1e-3f;
enum FollowMode : std::uint32_t { kNotBegun, kUnderWay, kOnTarget };

// The speed after a step of h towards a target at distance d, such that braking by `brake` stops at the target:
// v² = 2 brake d - brake² / gain². Near the target it is v = gain d, since braking would end with a jump. The distance
// after the step is d - (now + v) h / 2.
float speed_on_curve(float d, float now, float brake, float gain, float h) {
  const float near = gain * (d - 0.5f * now * h) / (1.0f + 0.5f * gain * h);
  const float knee = brake / gain;  // the speed at which both agree
  if (near <= knee) return near;
  const float half = 0.5f * brake * h, under = half * half + 2.0f * brake * d - 2.0f * half * now - knee * knee;
  return sqrt(under > 0 ? under : 0.0f) - half;
}

struct Motion {
  f32x4 at, velocity;
};

f32x4 no_longer(f32x4 v, float most) {
  const float squared = squared3(v);
  return squared > most * most ? v * (most / sqrt(squared)) : v;
}

// Follows a target that moves evenly from `from` to the origin in `time_s`.
void follow_origin(Motion& m, f32x4 from, float time_s, const RateLimit& limit) {
  const int steps = static_cast<int>(time_s * kStepsPerSecond + 0.99f);
  const int count = steps > 0 ? steps : 1;
  const float h = time_s / static_cast<float>(count);
  const f32x4 target_velocity = from * (-1.0f / time_s);
  const float gain = limit.acceleration > 0 ? 120.0f : 1.0f / h;
  const float most = limit.speed > 0 ? limit.speed : 3e18f;
  for (int i = 0; i < count; ++i) {
    const f32x4 target = from * (static_cast<float>(count - i) / static_cast<float>(count));
    const f32x4 way = target - m.at;
    const float d = length3(way);
    const f32x4 direction = way * (d > 1e-12f ? 1.0f / d : 0.0f);
    if (limit.acceleration > 0) {
      const float now = dot3(m.velocity - target_velocity, direction);
      const float speed = speed_on_curve(d, now, 0.9f * limit.acceleration, gain, h);
      const f32x4 wanted = no_longer(target_velocity + direction * speed, most);
      const f32x4 next = m.velocity + no_longer(wanted - m.velocity, limit.acceleration * h);
      m.at = m.at + (m.velocity + next) * (0.5f * h);
      m.velocity = next;
    } else {
      m.velocity = no_longer(target_velocity + direction * (d * gain), most);
      m.at = m.at + m.velocity * h;
    }
  }
}

bool is_longer(f32x4 v, float most) {
  return squared3(v) > most * most;
}

// Moves a follower on by one frame. m: relative to the target's new place. from: the target's old place, likewise.
// Returns whether it is on the target in the end; its velocity is then the target's.
bool follow(Motion& m, f32x4 from, bool on_target, float time_s, float last_s, const RateLimit& limit) {
  const f32x4 target_velocity = from * (-1.0f / time_s);
  const float between_s = 0.5f * (time_s + last_s), gain = limit.acceleration * between_s;
  const bool has_speed = limit.speed > 0, has_acceleration = limit.acceleration > 0;
  const bool slow = !has_speed || !is_longer(target_velocity, limit.speed);
  const bool soft = !has_acceleration || !is_longer(target_velocity - m.velocity, gain);
  bool arrived = (on_target && slow && soft) || (!has_speed && !has_acceleration);
  if (!arrived) {
    follow_origin(m, from, time_s, limit);
    arrived = squared3(m.at) <= kArrived * kArrived &&
              (!has_acceleration || !is_longer(target_velocity - m.velocity, kArrivedSpeed));
    arrived = arrived || !all_finite(m.at) || !all_finite(m.velocity);  // lost
  }
  if (arrived) m.velocity = target_velocity;
  return arrived;
}

// Whether an earlier call can have stored these numbers. The farthest target in the shortest frame gives the greatest
// velocity.
bool is_sound(const float (&velocity)[3], float frame_s, std::uint32_t mode) {
  return all_within(velocity, 3, -1e25f, 1e25f) && within(frame_s, 0, kLongestFrame_s) && mode <= kOnTarget;
}
bool is_sound(const PointFollower& f) {
  return all_within(f.point, 3, -1e18f, 1e18f) && all_within(f.target, 3, -1e18f, 1e18f) &&
         is_sound(f.velocity, f.frame_s, f.mode);
}
bool is_rotation(const float (&q)[4]) {
  return has_direction(dot4(load(q), load(q)));
}
bool is_sound(const RotationFollower& f) {
  return is_rotation(f.rotation) && is_rotation(f.target) && is_sound(f.velocity, f.frame_s, f.mode);
}

float frame_time(float dt_s) {
  return greater(lesser(dt_s, kLongestFrame_s), kShortestFrame_s);
}

bool is_time(float dt_s) {
  return dt_s >= 0 && dt_s < kInfinity;
}
bool is_limit(const RateLimit& limit) {
  return limit.speed >= 0 && limit.speed < 1e18f && limit.acceleration >= 0 && limit.acceleration < 1e18f;
}

// J v, or with `inverse` J⁻¹ v, J being the left Jacobian of the exponential at p (Chirikjian, "Stochastic Models,
// Information Theory, and Lie Groups", 2011, 10.86): as a rotation vector p changes by v, its rotation turns by J v
// about the parent's axes.
f32x4 through_jacobian(f32x4 p, f32x4 v, bool inverse) {
  const f32x4 a = cross3(p, v), b = cross3(p, a);
  const float squared = squared3(p), sinc = sinc_of_root(0.25f * squared), cos = cos_of_root(0.25f * squared);
  const float first = inverse ? -0.5f : 0.5f * sinc * sinc, series = inverse ? 1.0f / 12.0f : 1.0f / 6.0f;
  return v + a * first + b * (squared > 1e-4f ? (1.0f - (inverse ? cos / sinc : sinc * cos)) / squared : series);
}

BadCall turn_towards(RotationFollower& state, const float (&target)[4], float dt_s, const RateLimit& limit) {
  MARROW_CHECK(is_time(dt_s));
  MARROW_CHECK(is_limit(limit));
  MARROW_CHECK(is_rotation(target));
  const WideRotation to = {load(target)}, unit = normalised(to);
  if (state.mode == kNotBegun || !is_sound(state)) {
    state = {};
    store(state.rotation, to.v);
    store(state.target, to.v);
    state.mode = kOnTarget;
    return {};
  }
  if (!(dt_s > 0)) return {};
  const float time_s = frame_time(dt_s);
  // Rotation vectors relative to the target's new rotation.
  const auto from_target = [&](const float(&q)[4]) {
    return log_of_shorter(normalised(WideRotation{load(q)}) * conjugate(unit)).v;
  };
  const bool was_on_target = state.mode == kOnTarget;
  const f32x4 from = from_target(state.target);
  Motion m = {was_on_target ? from : from_target(state.rotation), load_wide(state.velocity)};
  m.velocity = through_jacobian(m.at, m.velocity, true);
  const bool on_target = follow(m, from, was_on_target, time_s, state.frame_s, limit);
  if (!on_target) {
    m.velocity = through_jacobian(m.at, m.velocity, false);
    if (!all_finite(m.velocity)) m.velocity = splat(0.0f);  // far too fast
  }
  store(state.rotation, on_target ? to.v : normalised(exp_rotation(m.at) * unit).v);
  store(state.target, to.v);
  store_wide(state.velocity, m.velocity);
  state.frame_s = time_s;
  state.mode = on_target ? kOnTarget : kUnderWay;
  return {};
}

}  // namespace

Status follow_point(PointFollower& state, const float (&target)[3], float dt_s, const RateLimit& limit) {
  MARROW_REQUIRE(is_time(dt_s));
  MARROW_REQUIRE(is_limit(limit));
  const f32x4 to = to_f32x4(vector3(target));
  MARROW_REQUIRE(squared3(to) < 1e30f);
  if (state.mode == kNotBegun || !is_sound(state)) {
    state = {};
    store_wide(state.point, to);
    store_wide(state.target, to);
    state.mode = kOnTarget;
    return Status::ok;
  }
  if (!(dt_s > 0)) return Status::ok;
  const float time_s = frame_time(dt_s);
  Motion m = {load_wide(state.point) - to, load_wide(state.velocity)};
  const f32x4 from = load_wide(state.target) - to;
  const bool on_target = follow(m, from, state.mode == kOnTarget, time_s, state.frame_s, limit);
  store_wide(state.point, on_target ? to : m.at + to);
  store_wide(state.target, to);
  store_wide(state.velocity, m.velocity);
  state.frame_s = time_s;
  state.mode = on_target ? kOnTarget : kUnderWay;
  return Status::ok;
}

Status follow_rotation(RotationFollower& state, const float (&target)[4], float dt_s, const RateLimit& limit) {
  MARROW_REQUIRE_GOOD(turn_towards(state, target, dt_s, limit));
  return Status::ok;
}

Status follow_pose(Span<const JointLimit> limits, Span<RotationFollower> states, float dt_s, Span<SoaTransform> local) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_joints(limits, local));
  MARROW_REQUIRE(holds(states, limits.size));
  MARROW_REQUIRE(is_time(dt_s));
  for (std::size_t i = 0; i < limits.size; ++i) {
    const RateLimit& rate = limits[i].rate;
    if (rate.speed == 0 && rate.acceleration == 0) continue;
    float target[4];
    store(target, wide_rotation_of(local, limits[i].joint).v);
    if (turn_towards(states[i], target, dt_s, rate)) continue;
    set_rotation(local, limits[i].joint, WideRotation{load(states[i].rotation)});
  }
  return Status::ok;
}

}  // namespace marrow
