#include "math/rotation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "math/joint.h"
#include "support/rig.h"

namespace marrow {
namespace {

void expect_near(const Vector3& got, const Vector3& want, float tolerance = 1e-6f) {
  EXPECT_NEAR(got.x, want.x, tolerance);
  EXPECT_NEAR(got.y, want.y, tolerance);
  EXPECT_NEAR(got.z, want.z, tolerance);
}

constexpr float kHalfRoot = 0.70710678f;  // cos and sin of 45°

TEST(Vector3, CrossIsRightHanded) {
  expect_near(cross(Vector3{1, 0, 0}, Vector3{0, 1, 0}), {0, 0, 1});
  expect_near(cross(Vector3{1, 2, 3}, Vector3{4, 5, 6}), {-3, 6, -3});
}

TEST(Vector3, WithoutDirectionTakesTheOther) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const Vector3& v : {Vector3{}, Vector3{1e-20f, 0, 0}, Vector3{nan, 1, 1}, Vector3{infinite, 0, 0}}) {
    expect_near(normalised_or(v, {0, 1, 0}), {0, 1, 0}, 0);
  }
  expect_near(normalised_or({3, 0, 4}, {}), {0.6f, 0, 0.8f});
}

TEST(Vector3, AcrossIsAUnitAtARightAngle) {
  for (const Vector3& v : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, -1}, Vector3{0.6f, 0, 0.8f}}) {
    const Vector3 across = any_across(v);
    EXPECT_NEAR(length(across), 1, 1e-6f);
    EXPECT_NEAR(dot(across, v), 0, 1e-6f);
  }
}

TEST(Rotation, TurnsAboutAnAxisByTheRightHand) {
  const Rotation quarter_z = {0, 0, kHalfRoot, kHalfRoot};
  expect_near(rotate(quarter_z, {1, 0, 0}), {0, 1, 0});
  expect_near(rotate(conjugate(quarter_z), {1, 0, 0}), {0, -1, 0});
}

TEST(Rotation, ProductTurnsByTheRightFactorFirst) {
  const Rotation quarter_x = {kHalfRoot, 0, 0, kHalfRoot}, quarter_z = {0, 0, kHalfRoot, kHalfRoot};
  expect_near(rotate(quarter_x * quarter_z, {1, 0, 0}), {0, 0, 1});  // to y, then from y to z
}

TEST(Rotation, ShortestArcTakesOneToTheOther) {
  const Vector3 directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0.1f, -3, 5}, {1, 1e-4f, 0}, {-1, 1e-4f, 0}};
  int pairs = 0;
  for (const Vector3& from : directions) {
    for (const Vector3& to : directions) {
      float f[4];
      store(f, shortest_arc(to_f32x4(from), to_f32x4(to)).v);
      const Rotation q = rotation(f);
      EXPECT_NEAR(dot(q, q), 1, 1e-6f);
      expect_near(rotate(q, normalised_or(from, {})), normalised_or(to, {}), 2e-6f + (q.w < 1e-3f ? 2e-4f : 0));
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 36);
  EXPECT_EQ(w_lane(shortest_arc(splat(0.0f), to_f32x4({1, 0, 0}))), 1);
}

// The axes are computed in double precision; the rotation may be either of the two quaternions.
TEST(Rotation, OfAxesIsTheOneThatHasThem) {
  test::Random random(5);
  int cases = 0, far = 0;
  for (; cases < 20000; ++cases) {
    double q[4], squared = 0;
    for (double& x : q) x = random.between(-1, 1);
    if (cases % 4 == 1) q[3] *= 1e-4;              // about half a turn
    if (cases % 4 == 2) q[cases / 4 % 3] *= 1e-4;  // or about an axis in a plane
    for (const double x : q) squared += x * x;
    if (squared < 1e-4) continue;
    for (double& x : q) x /= std::sqrt(squared);
    const auto [x, y, z, w] = q;
    const f32x4 axes[3] = {
        to_f32x4({float(1 - 2 * (y * y + z * z)), float(2 * (x * y + w * z)), float(2 * (x * z - w * y))}),
        to_f32x4({float(2 * (x * y - w * z)), float(1 - 2 * (x * x + z * z)), float(2 * (y * z + w * x))}),
        to_f32x4({float(2 * (x * z + w * y)), float(2 * (y * z - w * x)), float(1 - 2 * (x * x + y * y))})};
    float got[4];
    store(got, rotation_of(axes).v);
    const double sign = q[0] * got[0] + q[1] * got[1] + q[2] * got[2] + q[3] * got[3] < 0 ? -1 : 1;
    for (int i = 0; i < 4; ++i) ASSERT_NEAR(sign * got[i], q[i], 4e-7);
    far += std::abs(w) < 1e-3 ? 1 : 0;
  }
  EXPECT_EQ(cases, 20000);
  EXPECT_GT(far, 1000);
}

TEST(Rotation, JointsOfAPoseAreReadAndWrittenInTheirLane) {
  std::array<SoaTransform, 2> pose = {};
  set_rotation(pose, 6, Rotation{1, 2, 3, 4});
  EXPECT_EQ(pose[1].rotation[0][2], 1);
  EXPECT_EQ(pose[1].rotation[3][2], 4);
  pose[1].translation[1][2] = 5;
  pose[1].scale[2][2] = 7;
  EXPECT_EQ(rotation_of(pose, 6).z, 3);
  EXPECT_EQ(narrow(wide_translation_of(pose, 6)).y, 5);
  EXPECT_EQ(scale_of(pose, 6).z, 7);
}

}  // namespace
}  // namespace marrow
