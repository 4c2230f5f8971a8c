// One step of the spring bones that go at once; see simulate_springs() for the model and the method.
#pragma once

#include "math/elementary.h"
#include "springs/spring_lanes.h"

namespace marrow {

// No acceleration beyond what a step can take: that of a bone of 3 mm in the gravity of the earth.
inline constexpr float kMostField = 3000.0f;  // 1/s²

// How a step of a bone is weighed.
struct SpringStrengths {
  Number decay;  // of the velocity in half a step
  Number first_kick, drift, last_kick;
};

// For y'' + 2 γ y' + |F| y = 0 the step has the trace and the determinant of the exact solution, hence its frequency
// and its decay, and takes a velocity to the exact place: with x = γ h, q = |F| h² - x² and both kicks the same
//   drift = h sin √q / √q,   1 - kick |F| drift = cos √q / cosh x,   decay = e^-x.
// What keeps the trace is free: first kick (1 - β), last kick (1 + β e^2x). β makes a release from rest exact, too, as
// |F| h² goes to 0: 1 - β = (1 + e^-2x) (1 / (1 - e^-2x) - 1 / 2x).
// damping: 2 γ.
inline SpringStrengths spring_strengths(Number damping, Number field, float step_s) {
  const Number zero = number(0.0f), one = number(1.0f), h = number(step_s);
  const Number most = number(2.8f), highest = number(4.2f), least = number(1e-3f);
  const Number x = lesser(damping * number(0.5f * step_s), most), y = lesser(field * (h * h), highest);
  const Number minus_xx = zero - x * x, q = y + minus_xx;
  Number slope;
  const Number cosh = cos_of_signed_root(minus_xx, q, slope);
  const Number s = sinc_of_signed_root(q);
  const Number kick = number(-step_s) * slope / (cosh * s);
  const Number decay = exp_negative(zero - x), squared = decay * decay;
  const auto damped = least < x;  // without damping β is 0, and would be a difference of infinities
  const Number divisor = select(damped, x, one), lost_share = select(damped, one - squared, one);
  const Number first = (one + squared) * (one / lost_share - number(0.5f) / divisor);  // 1 - β
  const Number beta = select(damped, one - first, zero);
  return {decay, kick - kick * beta, h * s, kick + kick * beta / squared};
}

// What pulls four bones in this frame, linear in time from its beginning (u = 0) to its end (1).
struct SpringPull {
  Vector<Number> animated, animated_change;  // the animated direction, up to its length
  Number stiffness, most_pull;
  Vector<Number> dragged;              // 2 ζ ω dt'/dt
  Vector<Number> field, field_change;  // gravity, inertia, wind
};

// The animated direction at a time; 0 where there is none.
inline Vector<Number> animated_at(const SpringPull& pull, Number u) {
  const Vector<Number> a = pull.animated + pull.animated_change * u;
  return normalised(a);
}

// The same way, no harder across the direction than `most`. Without a limit the bits stay.
inline Vector<Number> no_harder(const Vector<Number>& spring, const Vector<Number>& direction, Number most) {
  const Vector<Number> across = spring - direction * dot(spring, direction);
  const Number squared = dot(across, across), one = number(1.0f);
  return spring * select(most * most < squared, most / sqrt(squared), one);
}

// The whole field on bones that point in `direction`, the bones above being bent as they are.
inline Vector<Number> field_at(const SpringPull& pull, const Vector<Number>& animated, Number u,
                               const Quaternion<Number>& bent, const Vector<Number>& direction) {
  const Vector<Number> spring = rotate_by_any(bent, two_over_squared(bent), animated * pull.stiffness + pull.dragged);
  return no_harder(spring, direction, pull.most_pull) + pull.field + pull.field_change * u;
}

struct SpringMotion {
  Vector<Number> direction, velocity;
};

// Along the great circle by the angle 2 atan(|Δ| / 2), which needs no root: off by |Δ|³ / 12.
struct SpringWay {
  Vector<Number> begin, end;  // Δ, as seen from both ends
  Number scale, half;         // to - from = scale (begin - half from) = scale (end + half to)
};
inline SpringMotion drifted(const SpringMotion& m, Number drift, SpringWay& way) {
  const Vector<Number> delta = m.velocity * drift;
  const Number half = number(0.5f) * dot(delta, delta), one = number(1.0f);
  const Number scale = one / (one + number(0.5f) * half);
  // Halfway is d + Δ/2; what the velocity is at the end is parallel to what it was.
  const Vector<Number> middle = m.direction + delta * number(0.5f);
  const SpringMotion out = {m.direction + (delta - m.direction * half) * scale,
                            m.velocity - middle * (dot(m.velocity, delta) * scale)};
  way = {delta, out.velocity * drift, scale, half};
  return out;
}

// The field's part along the bone, and the rest, which moves it.
struct SpringForce {
  Number along;
  Vector<Number> across;
};
inline SpringForce force_on(const Vector<Number>& field, const Vector<Number>& direction) {
  const Number along = dot(field, direction);
  return {along, field - direction * along};
}

// Twice the work of the forces on a way, by their mean. Not by the field itself: most of that is along the bone, and
// its rounding would be more than the energy of a small swing.
inline Number twice_work(const SpringForce& begin, const SpringForce& end, const SpringWay& way) {
  return way.scale * (dot(begin.across, way.begin) + dot(end.across, way.end) + way.half * (end.along - begin.along));
}

// The same between any two directions: where a collider has cut the way short.
inline Number twice_work(const SpringForce& begin, const SpringForce& end, const Vector<Number>& from,
                         const Vector<Number>& to) {
  return dot(begin.across + from * begin.along + end.across + to * end.along, to - from);
}

// Columns of ½ (1 + K), K Davenport's symmetric matrix: the projection on the rotations that take `from` to `to`, both
// unit; the identity where `from` is 0. Slightly more than a half, so that nothing vanishes where they are opposite.
struct NearestRotation {
  f32x4 columns[Lanes::kCount][4];
};
inline void nearest_rotation(const Vector<f32x4>& from, const Vector<f32x4>& to, f32x4 (&out)[4][4]) {
  const f32x4 half = splat(0.5f), zero = splat(0.0f);
  const Vector<f32x4> t = to * half;
  const f32x4 xx = t.x * from.x, yy = t.y * from.y, zz = t.z * from.z;
  const f32x4 one = select(zero < dot(from, from), splat(0.500001f), splat(1.0f));
  const f32x4 xy = t.x * from.y + t.y * from.x, xz = t.x * from.z + t.z * from.x, yz = t.y * from.z + t.z * from.y;
  const Vector<f32x4> z = cross(from, t);
  const f32x4 columns[4][4] = {{one + (xx - yy - zz), xy, xz, z.x},
                               {xy, one + (yy - xx - zz), yz, z.y},
                               {xz, yz, one + (zz - xx - yy), z.z},
                               {z.x, z.y, z.z, one + (xx + yy + zz)}};
  for (int c = 0; c < 4; ++c) {
    f32x4 a = columns[c][0], b = columns[c][1], d = columns[c][2], e = columns[c][3];
    transpose(a, b, d, e);
    out[0][c] = a, out[1][c] = b, out[2][c] = d, out[3][c] = e;
  }
}
inline void nearest_rotation(Vector<One> from, Vector<One> to, f32x4 (&out)[1][4]) {
  const f32x4 t = to.v * splat(0.5f), squares = t * from.v;
  const float one = squared3(from.v) > 0 ? 0.500001f : 1.0f;
  float d[4], mixed[4], z[4];  // mixed: xy, yz, xz
  store(d, splat(one) + (squares - reordered<1, 0, 0, 3>(squares) - reordered<2, 2, 1, 3>(squares)));
  store(mixed, t * rotated_xyz(from.v) + rotated_xyz(t) * from.v);
  store(z, cross3(from.v, t));
  out[0][0] = lanes(d[0], mixed[0], mixed[2], z[0]);
  out[0][1] = lanes(mixed[0], d[1], mixed[1], z[1]);
  out[0][2] = lanes(mixed[2], mixed[1], d[2], z[2]);
  out[0][3] = lanes(z[0], z[1], z[2], one + dot3(t, from.v));
}

// How the bones above each are bent; `above` is taken on from bone to bone, and begins anew with a chain.
inline Quaternion<Number> bend(const NearestRotation& nearest, const bool (&begins)[Lanes::kCount], f32x4& above) {
  f32x4 rows[Lanes::kCount];
  for (int i = 0; i < Lanes::kCount; ++i) {
    if (begins[i]) above = no_turn().v;
    rows[i] = above;
    const f32x4(&c)[4] = nearest.columns[i];
    above = (c[0] * splat_lane<0>(above) + c[1] * splat_lane<1>(above)) +
            (c[2] * splat_lane<2>(above) + c[3] * splat_lane<3>(above));
  }
  return Lanes::quaternion(rows);
}

// Held down so that the kinetic energy grows by no more than the field's work.
inline Vector<Number> no_faster(const Vector<Number>& velocity, const Vector<Number>& was, Number twice_work) {
  const Number zero = number(0.0f), one = number(1.0f);
  Number most = dot(was, was) + twice_work;
  most = select(zero < most, most, zero);
  const Number squared = dot(velocity, velocity), least = number(1e-30f);
  return velocity * select(most < squared, sqrt(most / select(least < squared, squared, least)), one);
}

}  // namespace marrow
