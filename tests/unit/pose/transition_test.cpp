// Weights of fades, and the fade of two poses.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "marrow/transition.h"
#include "support/poses.h"

namespace marrow {
namespace {

TEST(Transition, WeightsFollowTheirPolynomials) {
  int cases = 0;
  for (int i = -50; i <= 450; ++i, ++cases) {
    const float time_s = static_cast<float>(i) / 1000;
    const double u = std::fmin(std::fmax(static_cast<double>(time_s) / 0.4, 0), 1);
    EXPECT_NEAR(fade_weight(Fade::linear, time_s, 0.4f), u, 2e-7);
    EXPECT_NEAR(fade_weight(Fade::smoothstep, time_s, 0.4f), u * u * (3 - 2 * u), 3e-7);
    EXPECT_NEAR(fade_weight(Fade::smootherstep, time_s, 0.4f), u * u * u * (10 + u * (6 * u - 15)), 4e-7);
  }
  EXPECT_EQ(cases, 501);
}

TEST(Transition, WeightsStayInTheirRangeWhateverTheTimes) {
  const float odd[] = {0,
                       -0.0f,
                       -1,
                       1e-40f,
                       0.3f,
                       0.4f,
                       1e30f,
                       std::numeric_limits<float>::infinity(),
                       std::numeric_limits<float>::quiet_NaN()};
  for (const Fade shape : {Fade::linear, Fade::smoothstep, Fade::smootherstep}) {
    for (const float time_s : odd) {
      for (const float duration_s : odd) {
        const float w = fade_weight(shape, time_s, duration_s);
        EXPECT_TRUE(0 <= w && w <= 1) << time_s << " of " << duration_s;
        EXPECT_TRUE(time_s > 0 || w == 0) << time_s;
        EXPECT_TRUE(!(time_s > 0) || time_s < duration_s || w == 1) << time_s;
      }
    }
  }
}

TEST(Transition, CrossFadeEndsInThePosesThemselves) {
  test::Poses p(61, 21, 2);
  ASSERT_EQ(cross_fade(p.skeleton, p.pose[0], p.pose[1], 0, p.out), Status::ok);
  EXPECT_TRUE(p.same(p.out, p.pose[0]));
  ASSERT_EQ(cross_fade(p.skeleton, p.pose[0], p.pose[1], 1, p.out), Status::ok);
  EXPECT_TRUE(p.same(p.out, p.pose[1]));
  ASSERT_EQ(cross_fade(p.skeleton, p.pose[0], p.pose[1], 0.25f, p.out), Status::ok);
  for (std::size_t j = 0; j < 21; ++j) {
    const test::TestJoint a = test::joint_of(p.pose[0].data(), j), b = test::joint_of(p.pose[1].data(), j);
    const test::TestJoint got = test::joint_of(p.out.data(), j);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(got.translation[i], 0.75 * a.translation[i] + 0.25 * b.translation[i], 1e-6);
  }
}

TEST(Transition, BadCalls) {
  test::Poses p(62, 21, 2);
  const std::size_t few = p.groups() - 1;
  for (const float weight : {-0.1f, 1.5f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(cross_fade(p.skeleton, p.pose[0], p.pose[1], weight, p.out), Status::bad_argument);
  EXPECT_EQ(cross_fade(p.skeleton, {p.pose[0].data(), few}, p.pose[1], 0.5f, p.out), Status::bad_argument);
  EXPECT_EQ(cross_fade(p.skeleton, p.pose[0], {p.pose[1].data(), few}, 0.5f, p.out), Status::bad_argument);
  EXPECT_EQ(cross_fade(p.skeleton, p.pose[0], p.pose[1], 0.5f, {p.out.data(), few}), Status::bad_argument);
}

}  // namespace
}  // namespace marrow
