// Easings against their closed forms with the mathematical library, in double precision.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "marrow/curve.h"
#include "math/elementary.h"

namespace marrow {
namespace {

constexpr Easing kEasings[] = {Easing::linear, Easing::quad,    Easing::cubic, Easing::quart,
                               Easing::quint,  Easing::sine,    Easing::expo,  Easing::circ,
                               Easing::back,   Easing::elastic, Easing::bounce};

double bounce_out(double x) {
  const double n = 7.5625, d = 2.75;
  if (x < 1 / d) return n * x * x;
  if (x < 2 / d) return n * (x - 1.5 / d) * (x - 1.5 / d) + 0.75;
  if (x < 2.5 / d) return n * (x - 2.25 / d) * (x - 2.25 / d) + 0.9375;
  return n * (x - 2.625 / d) * (x - 2.625 / d) + 0.984375;
}

double closed_in(Easing easing, double x) {
  switch (easing) {
    case Easing::linear:
      return x;
    case Easing::quad:
      return std::pow(x, 2);
    case Easing::cubic:
      return std::pow(x, 3);
    case Easing::quart:
      return std::pow(x, 4);
    case Easing::quint:
      return std::pow(x, 5);
    case Easing::sine:
      return 1 - std::cos(x * M_PI / 2);
    case Easing::expo:
      return std::pow(2, 10 * x - 10);
    case Easing::circ:
      return 1 - std::sqrt(1 - x * x);
    case Easing::back:
      return 2.70158 * x * x * x - 1.70158 * x * x;
    case Easing::elastic:
      return -std::pow(2, 10 * x - 10) * std::sin((x * 10 - 10.75) * 2 * M_PI / 3);
    case Easing::bounce:
      return 1 - bounce_out(1 - x);
  }
  return -1;
}

// The forms of in-out that are written out by themselves, as they are usually given.
double closed_in_out(Easing easing, double x) {
  const double c = 1.70158 * 1.525;
  switch (easing) {
    case Easing::sine:
      return -(std::cos(M_PI * x) - 1) / 2;
    case Easing::back:
      return x < 0.5 ? std::pow(2 * x, 2) * ((c + 1) * 2 * x - c) / 2
                     : (std::pow(2 * x - 2, 2) * ((c + 1) * (x * 2 - 2) + c) + 2) / 2;
    case Easing::elastic:
      return x < 0.5 ? -std::pow(2, 20 * x - 10) * std::sin((20 * x - 11.125) * 2 * M_PI / 4.5) / 2
                     : std::pow(2, -20 * x + 10) * std::sin((20 * x - 11.125) * 2 * M_PI / 4.5) / 2 + 1;
    default:
      return x < 0.5 ? closed_in(easing, 2 * x) / 2 : 1 - closed_in(easing, 2 - 2 * x) / 2;
  }
}

TEST(Ease, IsTheClosedForm) {
  int cases = 0;
  for (const Easing easing : kEasings) {
    for (int i = 1; i < 1024; ++i, ++cases) {
      const double x = i / 1024.0;
      const float u = static_cast<float>(x);
      const int name = static_cast<int>(easing);
      EXPECT_NEAR(static_cast<double>(ease(easing, EaseMode::in, u)), closed_in(easing, x), 1e-6) << name << ' ' << x;
      EXPECT_NEAR(static_cast<double>(ease(easing, EaseMode::out, u)), 1 - closed_in(easing, 1 - x), 1e-6) << name;
      EXPECT_NEAR(static_cast<double>(ease(easing, EaseMode::in_out, u)), closed_in_out(easing, x), 1e-6) << name;
    }
  }
  EXPECT_EQ(cases, 11 * 1023);
}

TEST(Ease, EndsAreExactAndWhatIsOutsideIsClamped) {
  for (const Easing easing : kEasings) {
    for (const EaseMode mode : {EaseMode::in, EaseMode::out, EaseMode::in_out}) {
      for (const float u : {0.0f, -0.0f, -1.0f, -HUGE_VALF, std::nanf("")}) EXPECT_EQ(ease(easing, mode, u), 0.0f);
      for (const float u : {1.0f, 2.0f, HUGE_VALF}) EXPECT_EQ(ease(easing, mode, u), 1.0f);
    }
    EXPECT_EQ(ease(easing, EaseMode::in_out, 0.5f), 0.5f);
  }
  EXPECT_EQ(ease(static_cast<Easing>(99), EaseMode::in, 0.25f), 0.25f);
  EXPECT_EQ(ease(Easing::quad, static_cast<EaseMode>(99), 0.25f), 0.25f);
}

TEST(Ease, InOutIsSymmetricAndTheSteadyOnesAreMonotonic) {
  int cases = 0;
  for (const Easing easing : kEasings) {
    const bool steady = easing != Easing::back && easing != Easing::elastic && easing != Easing::bounce;
    float before[3] = {0, 0, 0};
    for (int i = 1; i <= 512; ++i, ++cases) {
      const float u = static_cast<float>(i) / 512;
      EXPECT_NEAR(ease(easing, EaseMode::in_out, u) + ease(easing, EaseMode::in_out, 1 - u), 1.0f, 2e-7f);
      for (const EaseMode mode : {EaseMode::in, EaseMode::out, EaseMode::in_out}) {
        float& last = before[static_cast<int>(mode)];
        const float now = ease(easing, mode, u);
        EXPECT_TRUE(!steady || now >= last) << static_cast<int>(easing) << ' ' << u;
        last = now;
      }
    }
  }
  EXPECT_EQ(cases, 11 * 512);
}

TEST(Ease, SineAndPowersOfTwoKeepTheirPromises) {
  double sine = 0, power = 0;
  for (int i = -40000; i <= 40000; ++i) {
    const float turns = static_cast<float>(i) / 8192;
    sine = std::max(
        sine, std::fabs(static_cast<double>(sine_of_turns(turns)) - std::sin(2 * M_PI * static_cast<double>(turns))));
  }
  for (int i = 0; i <= 126 * 512; ++i) {
    const float x = static_cast<float>(-i) / 512;
    power = std::max(power, std::fabs(static_cast<double>(power_of_two(x)) / std::exp2(static_cast<double>(x)) - 1));
  }
  EXPECT_LT(sine, 2e-7);
  EXPECT_LT(power, 2e-7);
  EXPECT_EQ(power_of_two(0.0f), 1.0f);
  EXPECT_EQ(power_of_two(-3.0f), 0.125f);
}

double bezier(double a, double b, double t) {
  return 3 * (1 - t) * (1 - t) * t * a + 3 * (1 - t) * t * t * b + t * t * t;
}

// The smallest and largest y of the curve for x within `off` of u.
struct Window {
  double low, high;
};
Window window(const CubicBezierEase& c, double u, double off) {
  const auto y_at = [&](double x) {
    double low = 0, high = 1;
    for (int i = 0; i < 80; ++i) {
      const double t = (low + high) / 2;
      (bezier(static_cast<double>(c.x1), static_cast<double>(c.x2), t) < x ? low : high) = t;
    }
    return std::pair(bezier(static_cast<double>(c.y1), static_cast<double>(c.y2), low), low);
  };
  Window w{1e9, -1e9};
  for (int i = 0; i <= 16; ++i) {
    const double y = y_at(std::clamp(u - off + off * i / 8, 0.0, 1.0)).first;
    w = {std::min(w.low, y), std::max(w.high, y)};
  }
  return w;
}

TEST(CubicBezierEasing, LiesOnTheCurve) {
  const CubicBezierEase curves[] = {
      {},           {0.42f, 0, 1, 1},  {0, 0, 0.58f, 1},   {0.42f, 0, 0.58f, 1}, {0, 0, 1, 1},
      {1, 0, 0, 1}, {0, 1, 1, 0},      {0, 0, 0, 1},       {1, 1, 1, 1},         {1, -2, 0, 3},
      {0, 5, 0, 5}, {1, -4, 1, -0.5f}, {0.3f, 2, 0.3f, -1}};
  int cases = 0;
  for (const CubicBezierEase& curve : curves) {
    const double slack = 4e-7 * static_cast<double>(1 + std::fabs(curve.y1) + std::fabs(curve.y2));
    for (int i = 1; i < 500; ++i, ++cases) {
      const float u = static_cast<float>(i) / 500;
      float y = -99;
      ASSERT_EQ(ease(curve, u, y), Status::ok);
      const Window w = window(curve, static_cast<double>(u), 3e-7);
      EXPECT_GE(static_cast<double>(y), w.low - slack) << curve.x1 << ' ' << curve.x2 << " at " << u;
      EXPECT_LE(static_cast<double>(y), w.high + slack) << curve.x1 << ' ' << curve.x2 << " at " << u;
    }
  }
  EXPECT_EQ(cases, 13 * 499);
}

TEST(CubicBezierEasing, EndsAndBadCalls) {
  const float bad[] = {std::nanf(""), HUGE_VALF, -HUGE_VALF};
  float y = -99;
  for (const float u : {0.0f, -3.0f, -HUGE_VALF}) EXPECT_TRUE(ease(CubicBezierEase{}, u, y) == Status::ok && y == 0.0f);
  for (const float u : {1.0f, 3.0f, HUGE_VALF}) EXPECT_TRUE(ease(CubicBezierEase{}, u, y) == Status::ok && y == 1.0f);
  y = -99;
  EXPECT_EQ(ease(CubicBezierEase{}, bad[0], y), Status::bad_argument);
  for (const float x : {-0.01f, 1.01f, bad[0], bad[1]}) {
    EXPECT_EQ(ease(CubicBezierEase{x, 0, 1, 1}, 0.5f, y), Status::bad_argument);
    EXPECT_EQ(ease(CubicBezierEase{0, 0, x, 1}, 0.5f, y), Status::bad_argument);
  }
  for (const float v : bad) {
    EXPECT_EQ(ease(CubicBezierEase{0, v, 1, 1}, 0.5f, y), Status::bad_argument);
    EXPECT_EQ(ease(CubicBezierEase{0, 0, 1, v}, 0.5f, y), Status::bad_argument);
  }
  EXPECT_EQ(y, -99.0f);
}

}  // namespace
}  // namespace marrow
