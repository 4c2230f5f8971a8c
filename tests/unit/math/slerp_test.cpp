// The polynomial slerp weights against trigonometry in double precision.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "math/slerp.h"

namespace marrow {
namespace {

TEST(Slerp, WeightsAreWithinAMillionthOverTheWholeRange) {
  double worst_rad = 0;
  int cases = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double theta = i * (M_PI / 2) / 1000;  // between quaternions on the shorter arc: half the rotation's angle
    const float chord_squared = static_cast<float>(2 - 2 * std::cos(theta));
    for (int k = 0; k <= 64; ++k, ++cases) {
      const double u = k / 64.0;
      const SlerpWeights w = slerp_weights(chord_squared, static_cast<float>(u));
      // The point a·(1,0) + b·(cos θ, sin θ) must lie at angle u θ on the unit circle.
      const double x = static_cast<double>(w.a) + static_cast<double>(w.b) * std::cos(theta);
      const double y = static_cast<double>(w.b) * std::sin(theta);
      worst_rad = std::max(worst_rad, 2 * std::fabs(std::atan2(y, x) - u * theta));
      ASSERT_NEAR(std::hypot(x, y), 1.0, 1e-6) << theta << " at " << u;
    }
  }
  EXPECT_EQ(cases, 1001 * 65);
  EXPECT_LT(worst_rad, 1.5e-6) << "sample.h promises 1e-6 rad and float rounding";
}

TEST(Slerp, SeriesIsWithinItsStatedError) {
  double worst = 0;
  int cases = 0;
  for (int k = 0; k <= 64; ++k) {
    const double u = k / 64.0;
    const SlerpSeries series = slerp_series(static_cast<float>(u));
    for (int i = 1; i <= 1000; ++i, ++cases) {
      const double chord_squared = static_cast<double>(kSlerpSeriesLimit) * i / 1000;
      const double theta = std::acos(1 - chord_squared / 2);
      float got[4];
      store(got, slerp_weight(series, splat(static_cast<float>(chord_squared))));
      worst = std::max(worst, std::fabs(static_cast<double>(got[3]) - std::sin(u * theta) / std::sin(theta)));
    }
  }
  EXPECT_EQ(cases, 65000);
  EXPECT_LT(worst, 5e-7) << "4e-7 and float rounding";
}

TEST(Slerp, EndsAreExact) {
  for (const float chord_squared : {0.0f, 1e-12f, 0.5f, 2.0f}) {
    const SlerpWeights begin = slerp_weights(chord_squared, 0.0f), end = slerp_weights(chord_squared, 1.0f);
    EXPECT_EQ(begin.a, 1.0f);
    EXPECT_EQ(begin.b, 0.0f);
    EXPECT_EQ(end.a, 0.0f);
    EXPECT_EQ(end.b, 1.0f);
  }
}

}  // namespace
}  // namespace marrow
