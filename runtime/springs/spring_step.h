// One step of four spring bones; see simulate_springs() for the model and the method.
#pragma once

#include "math/elementary.h"
#include "springs/spring_lanes.h"

namespace marrow {

// The strongest field that a step can take, in 1/s²: that of the earth's gravity on a bone of 3 mm.
inline constexpr float kMostField = 3000.0f;

// The strengths of a step's parts.
struct SpringStrengths {
  f32x4 decay;  // factor on the velocity in half a step
  f32x4 first_kick, drift, last_kick;
};

// For y'' + 2 γ y' + |F| y = 0 the step has the trace and the determinant of the exact solution, and so its frequency
// and decay; and it takes a velocity to the exact place. With x = γ h, q = |F| h² - x² and both kicks the same:
//   drift = h sin √q / √q,   1 - kick |F| drift = cos √q / cosh x,   decay = e^-x.
// The trace leaves one choice free: first kick (1 - β), last kick (1 + β e^2x). β makes a release from rest exact too,
// as |F| h² goes to 0: 1 - β = (1 + e^-2x) (1 / (1 - e^-2x) - 1 / 2x). damping: 2 γ.
inline SpringStrengths spring_strengths(f32x4 damping, f32x4 field, float step_s) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f), h = splat(step_s);
  const f32x4 most = splat(2.8f), highest = splat(4.2f), least = splat(1e-3f);
  const f32x4 x = lesser(damping * splat(0.5f * step_s), most), y = lesser(field * (h * h), highest);
  const f32x4 minus_xx = zero - x * x, q = y + minus_xx;
  f32x4 slope;
  const f32x4 cosh = cos_of_signed_root(minus_xx, q, slope);
  const f32x4 s = sinc_of_signed_root(q);
  const f32x4 kick = splat(-step_s) * slope / (cosh * s);
  const f32x4 decay = exp_negative(zero - x), squared = decay * decay;
  const auto damped = least < x;  // without damping β is 0; the formula would be ∞ - ∞
  const f32x4 divisor = select(damped, x, one), lost_share = select(damped, one - squared, one);
  const f32x4 first = (one + squared) * (one / lost_share - splat(0.5f) / divisor);  // 1 - β
  const f32x4 beta = select(damped, one - first, zero);
  return {decay, kick - kick * beta, h * s, kick + kick * beta / squared};
}

// What pulls four bones in a frame, linear in time from its beginning (u = 0) to its end (1).
struct SpringPull {
  Vector<f32x4> animated, animated_change;  // the animated direction, of any length
  f32x4 stiffness, most_pull;
  Vector<f32x4> dragged;              // 2 ζ ω dt'/dt
  Vector<f32x4> field, field_change;  // gravity, inertia, wind
};

// The animated direction at a time; 0 where there is none.
inline Vector<f32x4> animated_at(const SpringPull& pull, f32x4 u) {
  const Vector<f32x4> a = pull.animated + pull.animated_change * u;
  return normalised(a);
}

// A pull, shortened so that its part across the direction is at most `most`. Without a limit the bits stay.
inline Vector<f32x4> no_harder(const Vector<f32x4>& spring, const Vector<f32x4>& direction, f32x4 most) {
  const Vector<f32x4> across = spring - direction * dot(spring, direction);
  const f32x4 squared = dot(across, across), one = splat(1.0f);
  return spring * select(most * most < squared, most / sqrt(squared), one);
}

// The whole field on bones that point in `direction`. bent: see SpringGroup.
inline Vector<f32x4> field_at(const SpringPull& pull, const Vector<f32x4>& animated, f32x4 u,
                              const Quaternion<f32x4>& bent, const Vector<f32x4>& direction) {
  const Vector<f32x4> spring = rotate_by_any(bent, two_over_squared(bent), animated * pull.stiffness + pull.dragged);
  return no_harder(spring, direction, pull.most_pull) + pull.field + pull.field_change * u;
}

struct SpringMotion {
  Vector<f32x4> direction, velocity;
};

// A move along a great circle by Δ. The angle is 2 atan(|Δ| / 2), which takes no root and is off by |Δ|³ / 12.
struct SpringWay {
  Vector<f32x4> begin, end;  // Δ, as seen from both ends
  f32x4 scale, half;         // to - from = scale (begin - half from) = scale (end + half to)
};
inline SpringMotion drifted(const SpringMotion& m, f32x4 drift, SpringWay& way) {
  const Vector<f32x4> delta = m.velocity * drift;
  const f32x4 half = splat(0.5f) * dot(delta, delta), one = splat(1.0f);
  const f32x4 scale = one / (one + splat(0.5f) * half);
  // Half way is d + Δ/2. The velocity is carried along in parallel.
  const Vector<f32x4> middle = m.direction + delta * splat(0.5f);
  const SpringMotion out = {m.direction + (delta - m.direction * half) * scale,
                            m.velocity - middle * (dot(m.velocity, delta) * scale)};
  way = {delta, out.velocity * drift, scale, half};
  return out;
}

// A field's part along the bone, and the rest, which moves the bone.
struct SpringForce {
  f32x4 along;
  Vector<f32x4> across;
};
inline SpringForce force_on(const Vector<f32x4>& field, const Vector<f32x4>& direction) {
  const f32x4 along = dot(field, direction);
  return {along, field - direction * along};
}

// Twice the work of the mean force on a way. Taken from the parts of the field: most of the field is along the bone,
// and its rounding would exceed the energy of a small swing.
inline f32x4 twice_work(const SpringForce& begin, const SpringForce& end, const SpringWay& way) {
  return way.scale * (dot(begin.across, way.begin) + dot(end.across, way.end) + way.half * (end.along - begin.along));
}

// The same between any two directions, for a way that a collider has cut short.
inline f32x4 twice_work(const SpringForce& begin, const SpringForce& end, const Vector<f32x4>& from,
                        const Vector<f32x4>& to) {
  return dot(begin.across + from * begin.along + end.across + to * end.along, to - from);
}

// The columns of ½ (1 + K), with K Davenport's symmetric matrix: the projection onto the rotations that take `from` to
// `to`, both unit; the identity where `from` is 0. The ½ is a little more, so that nothing vanishes for opposite ones.
struct NearestRotation {
  f32x4 columns[kLanes][4];
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
// The rotation above each bone, see SpringGroup::bent. above: the last of them, to go on from; a chain begins anew.
inline Quaternion<f32x4> bend(const NearestRotation& nearest, const bool (&begins)[kLanes], f32x4& above) {
  f32x4 rows[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    if (begins[i]) above = no_turn().v;
    rows[i] = above;
    const f32x4(&c)[4] = nearest.columns[i];
    above = (c[0] * splat_lane<0>(above) + c[1] * splat_lane<1>(above)) +
            (c[2] * splat_lane<2>(above) + c[3] * splat_lane<3>(above));
  }
  return join_rotations(rows);
}

// A velocity, shortened so that the kinetic energy grows by no more than the field's work.
inline Vector<f32x4> no_faster(const Vector<f32x4>& velocity, const Vector<f32x4>& was, f32x4 twice_work) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f);
  f32x4 most = dot(was, was) + twice_work;
  most = select(zero < most, most, zero);
  const f32x4 squared = dot(velocity, velocity), least = splat(1e-30f);
  return velocity * select(most < squared, sqrt(most / select(least < squared, squared, least)), one);
}

}  // namespace marrow
