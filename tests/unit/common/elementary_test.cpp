// The cooker's own sines and powers, beside the C library's of higher precision.
#include "common/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

using Function = double (*)(double);
using Precise = long double (*)(long double);

// The largest error at 200 000 places from `low` to `high`, absolute or as a share of the value.
double worst_error(Function got, Precise want, double low, double high, bool is_share) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double u = static_cast<double>(random() >> 11) * 0x1p-53, x = low + u * (high - low);
    const long double wanted = want(static_cast<long double>(x));
    const long double error = std::abs(static_cast<long double>(got(x)) - wanted);
    worst = std::max(worst, static_cast<double>(is_share ? error / std::abs(wanted) : error));
  }
  return worst;
}

TEST(Elementary, IsAsPreciseAsItSays) {
  const auto a_sine = [](long double x) { return std::sin(x); };
  const auto a_cosine = [](long double x) { return std::cos(x); };
  const auto an_arc_cosine = [](long double x) { return std::acos(x); };
  const auto an_exponential = [](long double x) { return std::exp(x); };
  const auto less_1 = [](long double x) { return std::expm1(x); };
  const auto a_cube_root = [](long double x) { return std::cbrt(x); };
  for (const double most : {0.5, 4.0, 100.0, 1e5}) {
    EXPECT_LT(worst_error(sine, a_sine, -most, most, false), 3e-16) << most;
    EXPECT_LT(worst_error(cosine, a_cosine, -most, most, false), 3e-16) << most;
  }
  EXPECT_LT(worst_error(sine, a_sine, -0.75, 0.75, true), 3e-16) << "small ones as a share";
  EXPECT_LT(worst_error(sine, a_sine, 1e5, 1e8, false), 1e8 * 0x1p-54) << "half a last place of the argument";
  EXPECT_LT(worst_error(arc_cosine, an_arc_cosine, -1, 1, false), 5e-16);
  EXPECT_LT(worst_error(arc_cosine, an_arc_cosine, 0.999999, 1, true), 5e-16) << "small angles as a share";
  EXPECT_LT(worst_error(exponential, an_exponential, -700, 700, true), 4e-16);
  EXPECT_LT(worst_error(exponential, an_exponential, -1, 1, true), 4e-16);
  EXPECT_LT(worst_error(exponential_less_1, less_1, -1e-3, 1e-3, true), 8e-16);
  EXPECT_LT(worst_error(exponential_less_1, less_1, -40, 1, true), 8e-16);
  EXPECT_LT(worst_error(cube_root, a_cube_root, 0, 10, true), 4e-16);
  EXPECT_LT(worst_error(cube_root, a_cube_root, 0, 1e-300, true), 4e-16);
  EXPECT_LT(worst_error(cube_root, a_cube_root, 0, 1e300, true), 4e-16);
}

TEST(Elementary, AnglesAllRound) {
  std::mt19937_64 random(2);
  const auto between = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
  for (int i = 0; i < 200'000; ++i) {
    const double y = std::ldexp(between(), static_cast<int>(random() % 40) - 20), x = between();
    const long double want = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    ASSERT_NEAR(static_cast<double>(static_cast<long double>(angle_of(y, x)) - want), 0, 5e-16) << y << " " << x;
  }
  constexpr double kPi = 3.141592653589793;
  EXPECT_EQ(angle_of(0, 0), 0);
  EXPECT_EQ(angle_of(0, 2), 0);
  EXPECT_EQ(angle_of(0, -2), kPi);
  EXPECT_EQ(angle_of(3, 0), kPi / 2);
  EXPECT_EQ(angle_of(-3, 0), -kPi / 2);
}

TEST(Elementary, LengthsOfAnySize) {
  EXPECT_EQ(length_of(0, 0, 0, 0), 0);
  EXPECT_EQ(length_of(0, 3, 0, -4), 5);
  EXPECT_EQ(length_of(1e300, 1e300, 1e300, 1e300), 2e300);
  EXPECT_EQ(length_of(3e-200, 0, 4e-200, 0), 5e-200);
}

TEST(Elementary, WholeResultsAreExact) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(arc_cosine(1), 0);
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential_less_1(0), 0);
  EXPECT_EQ(cube_root(8), 2);
  EXPECT_EQ(cube_root(1), 1);
}

TEST(Elementary, TheEndsOfTheRange) {
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(exponential(-infinite), 0);
  EXPECT_EQ(exponential(infinite), infinite);
  EXPECT_EQ(exponential_less_1(-infinite), -1);
  for (const Function f : {sine, cosine, exponential, exponential_less_1, arc_cosine}) EXPECT_TRUE(std::isnan(f(nan)));
  for (const Function f : {sine, cosine}) EXPECT_TRUE(std::isnan(f(infinite)));
}

}  // namespace
}  // namespace marrow::tools
