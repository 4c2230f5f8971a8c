// evaluate_examples: numbers by hand, and the paper's formula in double precision.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/example_space.h"
#include "support/allocations.h"
#include "support/rig.h"

namespace marrow {
namespace {

// A space in memory of its own.
struct Space {
  std::vector<ExampleParameter> parameters;
  std::vector<std::uint32_t> targets;
  std::vector<float> linear, radial, places, widths;
  ExampleSpace view() const {
    ExampleSpace out;
    out.example_count = static_cast<std::uint32_t>(widths.size());
    out.parameters = parameters;
    out.targets = targets;
    out.linear = linear;
    out.radial = radial;
    out.places = places;
    out.inverse_widths = widths;
    return out;
  }
};

// One target, 1 at 1 of the examples 0, 1, 2 of a line. By hand: the least-squares line is 1/3; what is left,
// (-1/3, 2/3, -1/3), is (4 1 0, 1 4 1, 0 1 4) / 6 times (-6/7, 10/7, -6/7).
Space three_on_a_line() {
  Space s;
  s.parameters = {{0, 0}};
  s.targets = {1};
  s.linear = {1.0f / 3, 0, 0, 0, 0, 0, 0, 0};
  s.radial = {-6.0f / 7, 0, 0, 0, 10.0f / 7, 0, 0, 0, -6.0f / 7, 0, 0, 0};
  s.places = {0, 1, 2};
  s.widths = {1, 1, 1};
  return s;
}

float weight_at(const Space& s, float p) {
  float weights[2] = {-5, -5};
  EXPECT_EQ(evaluate_examples(s.view(), {&p, 1}, weights), Status::ok);
  EXPECT_EQ(weights[0], -5) << "no target of the space";
  return weights[1];
}

TEST(ExampleSpace, ThreeExamplesOnALineByHand) {
  const Space s = three_on_a_line();
  EXPECT_NEAR(weight_at(s, 0), 0, 1e-6);
  EXPECT_NEAR(weight_at(s, 1), 1, 1e-6);
  EXPECT_NEAR(weight_at(s, 2), 0, 1e-6);
  // 1/3 + (-6/7 + 10/7) · 23/48 - 6/7 · 1/48
  EXPECT_NEAR(weight_at(s, 0.5f), 33.0 / 56, 1e-6);
  // 1/3 - 6/7 · 1/48, as 2.5 is two and a half, one and a half and half a width away: … + 10/7 · 1/48 - 6/7 · 23/48
  EXPECT_NEAR(weight_at(s, 2.5f), 1.0 / 3 + 10.0 / 7 / 48 - 6.0 / 7 * 23 / 48, 1e-6);
  EXPECT_NEAR(weight_at(s, 4), 1.0 / 3, 1e-6) << "two widths from all";
  EXPECT_NEAR(weight_at(s, -1e30f), 1.0 / 3, 1e-6) << "where squares overflow";
}

double spline(double x) {
  if (x < 1) return (4 - 6 * x * x + 3 * x * x * x) / 6;
  return x < 2 ? (2 - x) * (2 - x) * (2 - x) / 6 : 0;
}

TEST(ExampleSpace, IsThePapersFormula) {
  test::Random random(5);
  int compared = 0;
  double worst = 0;
  for (std::size_t round = 0; round < 300; ++round) {
    const std::size_t dimensions = 1 + round % 8, examples = 1 + random.below(64), targets = 1 + random.below(64);
    const std::size_t row = (targets + 3) / 4 * 4;
    Space s;
    const auto fill = [&](std::vector<float>& to, std::size_t count, double low, double high) {
      for (std::size_t i = 0; i < count; ++i) to.push_back(static_cast<float>(random.between(low, high)));
    };
    s.parameters.resize(dimensions);
    for (std::uint32_t t = 0; t < targets; ++t) s.targets.push_back(2 * t);
    fill(s.linear, (1 + dimensions) * row, -1, 1);
    fill(s.radial, examples * row, -2, 2);
    fill(s.places, examples * dimensions, -1, 1);
    fill(s.widths, examples, 0.5, 3);
    std::vector<float> point, weights(2 * targets, 7);
    fill(point, dimensions, -1.5, 1.5);
    ASSERT_EQ(evaluate_examples(s.view(), point, weights), Status::ok);
    for (std::size_t t = 0; t < targets; ++t) {
      double sum = static_cast<double>(s.linear[t]);
      for (std::size_t d = 0; d < dimensions; ++d)
        sum += static_cast<double>(s.linear[(d + 1) * row + t]) * static_cast<double>(point[d]);
      for (std::size_t k = 0; k < examples; ++k) {
        double squared = 0;
        for (std::size_t d = 0; d < dimensions; ++d)
          squared += std::pow(static_cast<double>(point[d]) - static_cast<double>(s.places[k * dimensions + d]), 2);
        sum +=
            static_cast<double>(s.radial[k * row + t]) * spline(std::sqrt(squared) * static_cast<double>(s.widths[k]));
      }
      worst = std::max(worst, std::fabs(sum - static_cast<double>(weights[2 * t])));
      EXPECT_EQ(weights[2 * t + 1], 7);
      ++compared;
    }
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GT(compared, 5000);
}

TEST(ExampleSpace, RefusesBadCallsAndWritesNothing) {
  const Space s = three_on_a_line();
  float p = 0.5f, weights[2] = {3, 3};
  EXPECT_EQ(evaluate_examples(s.view(), {&p, 1}, {weights, 1}), Status::bad_argument) << "target 1 of one";
  EXPECT_EQ(evaluate_examples(s.view(), {}, weights), Status::bad_argument);
  const float bad[] = {NAN, INFINITY, -INFINITY};
  for (const float b : bad) EXPECT_EQ(evaluate_examples(s.view(), {&b, 1}, weights), Status::bad_argument);
  for (int broken = 0; broken < 6; ++broken) {
    ExampleSpace v = s.view();
    if (broken == 0) --v.linear.size;
    if (broken == 1) --v.radial.size;
    if (broken == 2) --v.places.size;
    if (broken == 3) --v.inverse_widths.size;
    if (broken == 4) v.example_count = kMaxExamples + 1;
    if (broken == 5) v.targets.size = kMaxExamples + 1;
    EXPECT_EQ(evaluate_examples(v, {&p, 1}, weights), Status::bad_argument) << broken;
  }
  Space huge = three_on_a_line();
  huge.linear[4] = 3e38f;
  p = 100;
  EXPECT_EQ(evaluate_examples(huge.view(), {&p, 1}, weights), Status::bad_data);
  EXPECT_EQ(weights[1], 3);
  EXPECT_EQ(weights[0], 3);
}

TEST(ExampleSpace, AllocatesNothing) {
  const Space s = three_on_a_line();
  const ExampleSpace v = s.view();
  float weights[2] = {};
  const std::size_t before = test::allocation_count();
  int failures = 0;
  for (int i = 0; i < 1000; ++i) {
    const float p = static_cast<float>(i) / 400;
    failures += evaluate_examples(v, {&p, 1}, weights) != Status::ok;
  }
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_EQ(failures, 0);
}

}  // namespace
}  // namespace marrow
