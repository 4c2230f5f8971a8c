// Interpolation between frames: polynomials that it must give back, and turns.
#include "deform/motion/between_frames.h"

#include <complex>
#include <functional>

#include <gtest/gtest.h>

#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

using Curve = std::function<double(double)>;

// How far from a curve whose whole numbers are frames.
double worst_between(BetweenFrames kind, const Curve& curve, double from, double to, int count = 7) {
  std::vector<glm::dvec3> frames;
  for (int i = 0; i < count; ++i) frames.emplace_back(curve(i), 2 * curve(i), -curve(i));
  double worst = 0;
  for (double at = from; at <= to; at += 0.125) {
    const glm::dvec3 got = between_frames(kind, frames, at);
    EXPECT_NEAR(got.y, 2 * got.x, 1e-9);
    EXPECT_NEAR(got.z, -got.x, 1e-9);
    worst = std::max(worst, std::abs(got.x - curve(at)));
  }
  return worst;
}

TEST(BetweenFrames, GivesBackPolynomialsOfItsDegree) {
  const Curve line = [](double x) { return 3 * x - 2; }, parabola = [](double x) { return x * x - 5 * x + 1; },
              cube = [](double x) { return x * x * x; };
  for (const auto& [name, kind] : kBetweenFrames) EXPECT_LT(worst_between(kind, line, 0, 6), 1e-12) << name;
  for (const BetweenFrames kind : {BetweenFrames::quadratic, BetweenFrames::cubic})
    EXPECT_LT(worst_between(kind, parabola, 0, 6), 1e-12) << "at the ends too";
  EXPECT_NEAR(worst_between(BetweenFrames::linear, parabola, 0, 6), 0.25, 1e-12);
  // The cube less the parabola through -1, 0 and 1 is x³ - x, most at √⅓ (sampled at 0.625); of Overhauser's curve it
  // is x (x - 1) (2x - 1), which is 0.09375 at ¼ and 0.08 and less elsewhere.
  EXPECT_NEAR(worst_between(BetweenFrames::quadratic, cube, 1, 6), 0.625 - 0.625 * 0.625 * 0.625, 1e-12);
  EXPECT_NEAR(worst_between(BetweenFrames::cubic, cube, 1, 5), 0.09375, 1e-12);
}

TEST(BetweenFrames, MeetsFramesAndDoesWithFew) {
  const Curve bumpy = [](double x) { return std::sin(7 * x); };
  std::vector<glm::dvec3> frames;
  for (int i = 0; i < 5; ++i) frames.emplace_back(bumpy(i), 0, 0);
  for (const auto& [name, kind] : kBetweenFrames) {
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(between_frames(kind, frames, i).x, bumpy(i), 1e-12) << name << i;
    EXPECT_NEAR(between_frames(kind, frames, 5).x, bumpy(4), 1e-12) << "not beyond the last";
    EXPECT_NEAR(between_frames(kind, frames, -1).x, bumpy(0), 1e-12);
    EXPECT_EQ(between_frames(kind, std::vector<glm::dvec3>{{3, 0, 0}}, 0).x, 3);
    EXPECT_NEAR(between_frames(kind, std::vector<glm::dvec3>{{3, 0, 0}, {5, 0, 0}}, 0.25).x, 3.5, 1e-12);
    EXPECT_EQ(worst_between(
                  kind, [](double x) { return 4 - x; }, 0, 2, 3),
              0)
        << name;
  }
}

// About one axis by 40° a frame, so a quaternion is e^(20° i) to the power of the frame, in a plane.
TEST(BetweenFrames, TurnsWhateverTheSigns) {
  std::vector<glm::dquat> frames;
  for (int i = 0; i < 6; ++i) frames.push_back(turn(40 * i, {1, 2, 3}) * (i % 2 == 0 ? 1.0 : -1.0));
  const auto expect_turn = [&](BetweenFrames kind, double at, double degrees) {
    const glm::dquat got = between_frames(kind, frames, at);
    EXPECT_NEAR(glm::dot(got, got), 1, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(got, turn(degrees, {1, 2, 3}))), 1, 1e-14) << at;
  };
  for (double at = 0; at <= 5; at += 0.125) expect_turn(BetweenFrames::linear, at, 40 * at);
  for (const auto& [name, kind] : kBetweenFrames)
    for (int i = 0; i < 6; ++i) expect_turn(kind, i, 40 * i);
  // Half way: -1/8, 6/8 and 3/8 of three frames, and -1/16, 9/16, 9/16 and -1/16 of four, which is even.
  const std::complex<double> e = std::polar(1.0, 20 * kDegree), sum = -0.125 + 0.75 * e + 0.375 * e * e;
  EXPECT_NEAR(std::arg(sum) / kDegree, 29.850, 1e-3);
  expect_turn(BetweenFrames::quadratic, 1.5, 2 * std::arg(sum) / kDegree);
  expect_turn(BetweenFrames::cubic, 1.5, 60);
}

}  // namespace
}  // namespace marrow::deform
