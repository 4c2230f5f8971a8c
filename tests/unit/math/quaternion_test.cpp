// The polynomials of quaternion.h against trigonometry in double precision.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "math/quaternion.h"
#include "support/rig.h"

namespace marrow {
namespace {

float first(f32x4 a) {
  float lanes[4];
  store(lanes, a);
  return lanes[0];
}

double value(f32x4 a) {
  return static_cast<double>(first(a));
}

Quaternion<f32x4> all_lanes(const test::Quat& q) {
  return {splat(static_cast<float>(q[0])), splat(static_cast<float>(q[1])), splat(static_cast<float>(q[2])),
          splat(static_cast<float>(q[3]))};
}

TEST(Quaternion, PolynomialsOverTheirWholeRange) {
  double worst_cos = 0, worst_sinc = 0, worst_asinc = 0;
  for (int i = 0; i <= 20000; ++i) {
    const float y = static_cast<float>(M_PI * M_PI * i / 20000), z = 0.5f * static_cast<float>(i) / 20000;
    const double root = std::sqrt(static_cast<double>(y)), small = std::sqrt(static_cast<double>(z));
    worst_cos = std::max(worst_cos, std::fabs(value(cos_of_root(splat(y))) - std::cos(root)));
    if (i == 0) continue;
    worst_sinc = std::max(worst_sinc, std::fabs(value(sinc_of_root(splat(y))) - std::sin(root) / root));
    worst_asinc = std::max(worst_asinc, std::fabs(value(asinc_of_root(splat(z))) - std::asin(small) / small));
  }
  EXPECT_LT(worst_cos, 6e-7);
  EXPECT_LT(worst_sinc, 3e-7);
  EXPECT_LT(worst_asinc, 2e-7);
  EXPECT_EQ(first(cos_of_root(splat(0.0f))), 1.0f);
  EXPECT_EQ(first(sinc_of_root(splat(0.0f))), 1.0f);
  EXPECT_EQ(first(asinc_of_root(splat(0.0f))), 1.0f);
}

TEST(Quaternion, ExponentialOfAnyTurnUpToAWholeOne) {
  test::Random random(71);
  double worst = 0;
  int cases = 0;
  for (int i = 0; i < 5000; ++i, ++cases) {
    const test::Quat q = random.rotation();
    const test::Vec3 axis = test::normalised(test::Vec3{q[0], q[1], q[2]});
    const double angle = i % 3 == 0 ? random.between(0, 1e-3) : random.between(0, 2 * M_PI);
    const test::Quat want = test::axis_angle(axis, angle);
    const Quaternion<f32x4> got = exp_rotation(Vector<f32x4>{splat(static_cast<float>(axis[0] * angle)),
                                                             splat(static_cast<float>(axis[1] * angle)),
                                                             splat(static_cast<float>(axis[2] * angle))});
    const f32x4 lanes[4] = {got.x, got.y, got.z, got.w};
    for (std::size_t c = 0; c < 4; ++c) worst = std::max(worst, std::fabs(value(lanes[c]) - want[c]));
  }
  EXPECT_EQ(cases, 5000);
  EXPECT_LT(worst, 1e-6);
}

TEST(Quaternion, LogarithmOfTurnsUpToThreeQuarters) {
  test::Random random(72);
  double worst = 0;
  int cases = 0;
  for (int i = 0; i < 6000; ++i, ++cases) {
    const test::Quat q = random.rotation();
    const test::Vec3 axis = test::normalised(test::Vec3{q[0], q[1], q[2]});
    const double angle = i % 3 == 0 ? random.between(0, 1e-4) : random.between(0, 1.49 * M_PI);
    const Vector<f32x4> got = log_rotation(all_lanes(test::axis_angle(axis, angle)));
    const f32x4 lanes[3] = {got.x, got.y, got.z};
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::fabs(value(lanes[c]) - axis[c] * angle));
  }
  EXPECT_EQ(cases, 6000);
  EXPECT_LT(worst, 1.5e-6);
  const Vector<f32x4> none = log_rotation(all_lanes({0, 0, 0, 1}));
  EXPECT_EQ(first(none.x), 0.0f);
  EXPECT_EQ(first(none.y), 0.0f);
  EXPECT_EQ(first(none.z), 0.0f);
}

}  // namespace
}  // namespace marrow
