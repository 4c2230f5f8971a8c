// Vectors and rotations in a register have the bits of Vector3 and Rotation, but for the sign of zeros.
#include <gtest/gtest.h>

#include "math/columns.h"
#include "math/rotation.h"
#include "support/rig.h"

namespace marrow {
namespace {

float any_number(test::Random& random) {
  constexpr float kOdd[] = {0, 1, -1, 1e-20f, 1e20f, 0.5f};
  return random.below(8) == 0 ? kOdd[random.below(6)] : static_cast<float>(random.between(-2, 2));
}
Vector3 any_vector(test::Random& random) {
  return {any_number(random), any_number(random), any_number(random)};
}
Rotation any_rotation(test::Random& random) {
  return normalised(Rotation{any_number(random), any_number(random), any_number(random), any_number(random)});
}
WideRotation wide_of(const Rotation& q) {
  return {lanes(q.x, q.y, q.z, q.w)};
}

void expect_same(float a, float b) {
  EXPECT_TRUE(a == b || (a != a && b != b)) << a << ' ' << b;
}
void expect_same(f32x4 a, const Vector3& b) {
  const Vector3 v = narrow(a);
  expect_same(v.x, b.x);
  expect_same(v.y, b.y);
  expect_same(v.z, b.z);
}
void expect_same(WideRotation a, const Rotation& b) {
  float q[4];
  store(q, a.v);
  expect_same(q[0], b.x);
  expect_same(q[1], b.y);
  expect_same(q[2], b.z);
  expect_same(q[3], b.w);
}

TEST(Wide, VectorsHaveTheBitsOfVector3) {
  test::Random random(3);
  int cases = 0;
  for (; cases < 20000; ++cases) {
    const Vector3 a = any_vector(random), b = any_vector(random), unit = normalised_or(b, {0, 1, 0});
    const f32x4 wa = to_f32x4(a), wb = to_f32x4(b), wide_unit = to_f32x4(unit);
    expect_same(dot3(wa, wb), dot(a, b));
    expect_same(squared3(wa), dot(a, a));
    expect_same(cross3(wa, wb), cross(a, b));
    expect_same(across3(wa, wide_unit), across(a, unit));
    expect_same(unit3_or(wa, wb), normalised_or(a, b));
    expect_same(any_across3(wa), any_across(a));
    expect_same(narrow(with_z(wa, b.z)).z, b.z);
    const f32x4 of[3] = {wa, wb, wide_unit};
    expect_same(products(of, wb), {dot(a, b), dot(b, b), dot(unit, b)});
  }
  EXPECT_EQ(cases, 20000);
}

TEST(Wide, RotationsHaveTheBitsOfRotation) {
  test::Random random(4);
  int cases = 0;
  for (; cases < 20000; ++cases) {
    const Rotation p = any_rotation(random), q = any_rotation(random);
    const Vector3 v = any_vector(random);
    const float share = static_cast<float>(random.between(0, 1));
    const WideRotation wp = wide_of(p), wq = wide_of(q);
    expect_same(wp * wq, p * q);
    expect_same(conjugate(wp), conjugate(p));
    expect_same(dot4(wp.v, wq.v), dot(p, q));
    expect_same(normalised(WideRotation{wp.v * 3.0f}), normalised(p * 3.0f));
    expect_same(rotate(wp, to_f32x4(v)), rotate(p, v));
    const Rotation shorter = flip(p, p.w);
    expect_same(share_of(wide_of(shorter), share), share_of(shorter, share));
    expect_same(log_of_shorter(wp).v, log_of_shorter(p));
    const Vector3 turn = log_of_shorter(q);
    expect_same(exp_rotation(to_f32x4(turn)), exp_rotation(turn));
    f32x4 axes[3];
    set_axes(wp, axes);
    expect_same(axes[1], columns_of(p).y);
    EXPECT_TRUE(same(wp, wp));
    EXPECT_EQ(same(wp, wq), p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w);
  }
  EXPECT_EQ(cases, 20000);
}

TEST(Wide, LanesAreReordered) {
  float out[4];
  store(out, reordered<3, 0, 2, 0>(lanes(1, 2, 3, 4)));
  EXPECT_EQ(out[0], 4);
  EXPECT_EQ(out[1], 1);
  EXPECT_EQ(out[2], 3);
  EXPECT_EQ(out[3], 1);
}

}  // namespace
}  // namespace marrow
