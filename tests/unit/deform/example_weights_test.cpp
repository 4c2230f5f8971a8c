// Cardinal functions over a space of examples: by hand, and by Gauss's elimination of the paper's equations.
#include "deform/fit/example_weights.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/rig.h"

namespace marrow::deform {
namespace {

using Rows = std::vector<std::vector<double>>;
using Places = std::vector<std::vector<float>>;

double spline(double x) {
  if (x < 1) return (4 - 6 * x * x + 3 * x * x * x) / 6;
  return x < 2 ? (2 - x) * (2 - x) * (2 - x) / 6 : 0;
}

template <class A, class B>
double distance(const A& a, const B& b) {
  double squared = 0;
  for (std::size_t d = 0; d < a.size(); ++d)
    squared += std::pow(static_cast<double>(a[d]) - static_cast<double>(b[d]), 2);
  return std::sqrt(squared);
}

// Every target at p, of functions that were solved for.
std::vector<double> evaluate(const ExampleFunctions& f, const Places& places, const std::vector<float>& p) {
  std::vector<double> out = f.linear[0];
  for (std::size_t t = 0; t < out.size(); ++t) {
    for (std::size_t d = 0; d < p.size(); ++d) out[t] += f.linear[d + 1][t] * static_cast<double>(p[d]);
    for (std::size_t k = 0; k < places.size(); ++k)
      out[t] += f.radial[k][t] * spline(distance(p, places[k]) * static_cast<double>(f.inverse_widths[k]));
  }
  return out;
}

// Each example's target is its own.
Rows identity(std::size_t count) {
  Rows out(count, std::vector<double>(count, 0));
  for (std::size_t i = 0; i < count; ++i) out[i][i] = 1;
  return out;
}

TEST(ExampleWeights, ThreeOnALineByHand) {
  const Places places = {{0}, {1}, {2}};
  const std::optional<ExampleFunctions> f = solve_examples(places, identity(3));
  ASSERT_TRUE(f);
  EXPECT_EQ(f->inverse_widths, (std::vector<float>{1, 1, 1}));
  EXPECT_EQ(f->spanned, 1u);
  // Least-squares lines 5/6 - p/2, 1/3, p/2 - 1/6; what is left is (1, -2, 1) / 6 of the outer ones, and minus twice
  // that of the middle one; (4 1 0, 1 4 1, 0 1 4) / 6 times (3, -5, 3) / 7 is (1, -2, 1) / 6.
  const Rows linear = {{5.0 / 6, 1.0 / 3, -1.0 / 6}, {-0.5, 0, 0.5}};
  const double radial[] = {3.0 / 7, -5.0 / 7, 3.0 / 7}, times[] = {1, -2, 1};
  for (std::size_t t = 0; t < 3; ++t) {
    for (std::size_t r = 0; r < 2; ++r) EXPECT_NEAR(f->linear[r][t], linear[r][t], 1e-12);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(f->radial[k][t], radial[k] * times[t], 1e-12);
  }
  const std::vector<double> half = evaluate(*f, places, {0.5f});
  EXPECT_NEAR(half[0], 51.0 / 112, 1e-12);
  EXPECT_NEAR(half[1], 33.0 / 56, 1e-12);
  EXPECT_NEAR(half[2], -5.0 / 112, 1e-12);
}

TEST(ExampleWeights, TwoExamplesAreALine) {
  const std::optional<ExampleFunctions> f = solve_examples({{1}, {3}}, identity(2));
  ASSERT_TRUE(f);
  EXPECT_EQ(f->inverse_widths, (std::vector<float>{0.5f, 0.5f}));
  const double expected[2][2] = {{1.5, -0.5}, {-0.5, 0.5}};  // (3 - p) / 2, (p - 1) / 2
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t t = 0; t < 2; ++t) {
      EXPECT_NEAR(f->linear[r][t], expected[r][t], 1e-14);
      EXPECT_EQ(f->radial[r][t], 0) << "nothing is left";
    }
}

// A x = b with pivots.
std::vector<double> eliminate(Rows a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::fabs(a[r][c]) > std::fabs(a[pivot][c])) pivot = r;
    std::swap(a[c], a[pivot]);
    std::swap(b[c], b[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const double factor = a[r][c] / a[c][c];
      for (std::size_t i = c; i < n; ++i) a[r][i] -= factor * a[c][i];
      b[r] -= factor * b[c];
    }
  }
  for (std::size_t r = 0; r < n; ++r) b[r] /= a[r][r];
  return b;
}

// Normal equations of the linear part, then the radial part, as the paper has them.
std::vector<double> by_the_paper(const Places& places, const std::vector<double>& values, const std::vector<float>& p) {
  const std::size_t n = places.size(), m = p.size() + 1;
  const auto one_p = [](const std::vector<float>& x, std::size_t i) {
    return i == 0 ? 1.0 : static_cast<double>(x[i - 1]);
  };
  Rows normal(m, std::vector<double>(m, 0));
  std::vector<double> right(m, 0);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < m; ++i) {
      right[i] += one_p(places[k], i) * values[k];
      for (std::size_t j = 0; j < m; ++j) normal[i][j] += one_p(places[k], i) * one_p(places[k], j);
    }
  const std::vector<double> linear = eliminate(normal, right);
  const auto line_at = [&](const std::vector<float>& x) {
    double out = 0;
    for (std::size_t i = 0; i < m; ++i) out += linear[i] * one_p(x, i);
    return out;
  };
  std::vector<double> width(n, 1e300), left;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      if (i != k) width[k] = std::min(width[k], distance(places[i], places[k]));
  Rows radial(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    left.push_back(values[i] - line_at(places[i]));
    for (std::size_t k = 0; k < n; ++k) radial[i][k] = spline(distance(places[i], places[k]) / width[k]);
  }
  const std::vector<double> shares = eliminate(radial, left);
  double out = line_at(p);
  for (std::size_t k = 0; k < n; ++k) out += shares[k] * spline(distance(p, places[k]) / width[k]);
  return {out};
}

Places random_places(test::Random& random, std::size_t count, std::size_t dimensions) {
  Places out;
  for (std::size_t k = 0; k < count; ++k) {
    out.emplace_back();
    for (std::size_t d = 0; d < dimensions; ++d) out.back().push_back(static_cast<float>(random.between(-1, 1)));
  }
  return out;
}

TEST(ExampleWeights, AreThePapersAndCardinal) {
  test::Random random(31);
  double worst = 0;
  for (std::size_t round = 0; round < 60; ++round) {
    const std::size_t dimensions = 1 + round % 4, count = dimensions + 2 + random.below(12);
    const Places places = random_places(random, count, dimensions);
    const Rows values = identity(count);
    const std::optional<ExampleFunctions> f = solve_examples(places, values);
    ASSERT_TRUE(f);
    EXPECT_EQ(f->spanned, dimensions);
    for (std::size_t k = 0; k < count; ++k) {
      const std::vector<double> at = evaluate(*f, places, places[k]);
      for (std::size_t t = 0; t < count; ++t) EXPECT_NEAR(at[t], t == k ? 1 : 0, 1e-9);
    }
    for (int probe = 0; probe < 5; ++probe) {
      const std::vector<float> p = random_places(random, 1, dimensions)[0];
      const std::vector<double> got = evaluate(*f, places, p);
      double sum = 0;
      for (const double w : got) sum += w;
      EXPECT_NEAR(sum, 1, 1e-9) << "constants are reproduced";
      for (std::size_t d = 0; d < dimensions; ++d) {
        double mean = 0;
        for (std::size_t t = 0; t < count; ++t) mean += got[t] * static_cast<double>(places[t][d]);
        EXPECT_NEAR(mean, static_cast<double>(p[d]), 1e-9) << "so is what is linear";
      }
      for (std::size_t t = 0; t < count; ++t) {
        std::vector<double> own(count, 0);
        own[t] = 1;
        worst = std::max(worst, std::fabs(got[t] - by_the_paper(places, own, p)[0]));
      }
    }
  }
  EXPECT_LT(worst, 1e-5) << "widths are rounded to floats";
}

// Examples on a slanting line of a plane: across it nothing changes, along it all is as on a line.
TEST(ExampleWeights, WhatExamplesDoNotSpanIsConstant) {
  const Places places = {{0, 1}, {3, 5}, {6, 9}};  // five apart
  const std::optional<ExampleFunctions> f = solve_examples(places, identity(3));
  ASSERT_TRUE(f);
  EXPECT_EQ(f->spanned, 1u);
  for (std::size_t t = 0; t < 3; ++t)
    EXPECT_NEAR(f->linear[1][t] * -4 + f->linear[2][t] * 3, 0, 1e-12) << "across: (-4, 3)";
  const std::vector<double> half = evaluate(*f, places, {1.5f, 3});
  EXPECT_NEAR(half[1], 33.0 / 56, 1e-7);
  // A parameter that is the same in all examples.
  const std::optional<ExampleFunctions> flat = solve_examples({{2, 0}, {2, 1}}, identity(2));
  ASSERT_TRUE(flat);
  for (std::size_t t = 0; t < 2; ++t) EXPECT_NEAR(flat->linear[1][t], 0, 1e-14);
  EXPECT_NEAR(flat->linear[0][0], 1, 1e-14);
}

TEST(ExampleWeights, ATargetMayStandAtSeveralPlaces) {
  const Places places = {{0}, {1}, {2}};
  const std::optional<ExampleFunctions> f = solve_examples(places, {{1}, {0}, {1}});
  ASSERT_TRUE(f);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(evaluate(*f, places, places[k])[0], k == 1 ? 0 : 1, 1e-12);
  EXPECT_NEAR(evaluate(*f, places, {0.5f})[0], 1 - 33.0 / 56, 1e-12);
}

TEST(ExampleWeights, OneExampleIsEverywhere) {
  const std::optional<ExampleFunctions> f = solve_examples({{4, 2}}, {{1}});
  ASSERT_TRUE(f);
  EXPECT_EQ(f->spanned, 0u);
  EXPECT_NEAR(evaluate(*f, {{4, 2}}, {-7, 1})[0], 1, 1e-14);
}

}  // namespace
}  // namespace marrow::deform
