// Blend spaces: against what weights are for: they give back the point, or the speed, that was asked for.
#include "marrow/blend_space.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "support/bad_numbers.h"
#include "support/call_errors.h"
#include "support/rig.h"
#include "unit/motion/any_bits.h"

namespace marrow {
namespace {

using test::Random;

void expect_sum_of_one(const std::vector<float>& weights) {
  double sum = 0;
  for (const float w : weights) {
    ASSERT_GE(w, 0);
    sum += static_cast<double>(w);
  }
  ASSERT_NEAR(sum, 1, 1e-6);
}

// The greatest change of a weight.
double apart(const std::vector<float>& a, const std::vector<float>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::fmax(most, std::fabs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  return most;
}

std::vector<float> on_line(const std::vector<float>& points, float at) {
  std::vector<float> out(points.size(), 7);
  EXPECT_EQ(line_weights(points, at, out), Status::ok);
  return out;
}

TEST(BlendSpace, OnALineGivesBackThePlace) {
  Random random(31);
  for (int round = 0; round < 2000; ++round) {
    std::vector<float> points = {static_cast<float>(random.between(-5, 5))};
    while (points.size() < 2 + random.below(5))
      points.push_back(points.back() + static_cast<float>(random.between(0.1, 2)));
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(on_line(points, points[i])[i], 1);
    for (int n = 0; n < 20; ++n) {
      const float at = static_cast<float>(random.between(-7, 20)),
                  near = at + static_cast<float>(random.between(0, 1e-3));
      const std::vector<float> weights = on_line(points, at);
      expect_sum_of_one(weights);
      double place = 0;
      for (std::size_t i = 0; i < points.size(); ++i)
        place += static_cast<double>(weights[i]) * static_cast<double>(points[i]);
      ASSERT_NEAR(place, static_cast<double>(std::clamp(at, points.front(), points.back())), 2e-6);
      ASSERT_LE(apart(weights, on_line(points, near)), 10 * static_cast<double>(near - at) + 1e-6);
    }
  }
  EXPECT_EQ(on_line({3}, -9), std::vector<float>{1});
  EXPECT_EQ(on_line({0, 1}, test::kInfinity), (std::vector<float>{0, 1}));
}

// A grid, turned; each of its squares, whose corners lie on a circle, cut along either diagonal.
struct Grid {
  int across, up;
  double angle;
  std::vector<PlanePoint> points;
  std::vector<PlaneTriangle> triangles;
};
Grid some_grid(Random& random) {
  Grid g{1 + static_cast<int>(random.below(4)),
         1 + static_cast<int>(random.below(4)),
         random.below(2) == 0 ? 0 : random.between(0, 6),
         {},
         {}};
  for (int y = 0; y <= g.up; ++y)
    for (int x = 0; x <= g.across; ++x)
      g.points.push_back({static_cast<float>(x * std::cos(g.angle) - y * std::sin(g.angle)),
                          static_cast<float>(x * std::sin(g.angle) + y * std::cos(g.angle))});
  for (int y = 0; y < g.up; ++y) {
    for (int x = 0; x < g.across; ++x) {
      const auto a = static_cast<std::uint32_t>(y * (g.across + 1) + x), b = a + 1,
                 c = a + static_cast<std::uint32_t>(g.across) + 1, d = c + 1;
      if (random.below(2) == 0) {
        g.triangles.push_back({{a, b, d}});
        g.triangles.push_back({{d, c, a}});
      } else {
        g.triangles.push_back({{b, d, c}});
        g.triangles.push_back({{a, b, c}});
      }
    }
  }
  return g;
}

std::vector<float> in_plane(const Grid& g, const PlanePoint& at) {
  std::vector<float> out(g.points.size(), 7);
  EXPECT_EQ(plane_weights(g.points, g.triangles, at, out), Status::ok);
  return out;
}

TEST(BlendSpace, InAPlaneGivesBackThePointOrTheNearest) {
  Random random(32);
  int outside = 0, cases = 0;
  for (int round = 0; round < 1000; ++round) {
    const Grid g = some_grid(random);
    for (std::size_t i = 0; i < g.points.size(); ++i) ASSERT_EQ(in_plane(g, g.points[i])[i], 1);
    for (int n = 0; n < 50; ++n) {
      // In the grid's own axes, now and then on a line of it.
      double x = random.between(-2, 6), y = random.between(-2, 6);
      if (random.below(4) == 0) x = std::floor(x);
      if (random.below(8) == 0) y = x;
      const auto turned = [&](double u, double v) {
        return PlanePoint{static_cast<float>(u * std::cos(g.angle) - v * std::sin(g.angle)),
                          static_cast<float>(u * std::sin(g.angle) + v * std::cos(g.angle))};
      };
      const std::vector<float> weights = in_plane(g, turned(x, y));
      expect_sum_of_one(weights);
      ASSERT_LE(std::count_if(weights.begin(), weights.end(), [](float w) { return w > 0; }), 3);
      const double near_x = std::clamp(x, 0.0, double(g.across)), near_y = std::clamp(y, 0.0, double(g.up));
      const PlanePoint want = turned(near_x, near_y);
      double at[2] = {};
      for (std::size_t i = 0; i < weights.size(); ++i) {
        at[0] += static_cast<double>(weights[i]) * static_cast<double>(g.points[i].x);
        at[1] += static_cast<double>(weights[i]) * static_cast<double>(g.points[i].y);
      }
      ASSERT_NEAR(at[0], static_cast<double>(want.x), 3e-6);
      ASSERT_NEAR(at[1], static_cast<double>(want.y), 3e-6);
      // No weight changes faster than by 1 over a square, wherever the way leads.
      const double dx = random.between(-0.01, 0.01), dy = random.between(-0.01, 0.01);
      ASSERT_LE(apart(weights, in_plane(g, turned(x + dx, y + dy))), std::fabs(dx) + std::fabs(dy) + 3e-6);
      outside += near_x != x || near_y != y, ++cases;
    }
  }
  EXPECT_EQ(cases, 50000);
  EXPECT_GT(outside, 10000);
}

// The walk and the run of a hand-made character, and an idle clip.
TEST(BlendSpace, SpeedsAreExactlyThoseAskedFor) {
  Random random(33);
  double worst = 0;
  int between = 0, slower = 0, faster = 0;
  for (int round = 0; round < 50000; ++round) {
    std::vector<SpeedPoint> points;
    float speed = random.below(2) == 0 ? 0 : static_cast<float>(random.between(0.2, 2));
    for (std::uint32_t n = 1 + random.below(4); n > 0; --n) {
      points.push_back({speed, static_cast<float>(random.between(0.3, 3))});
      speed += static_cast<float>(random.between(0.1, 3));
    }
    const float asked = static_cast<float>(random.between(0, 10));
    std::vector<float> weights(points.size(), 7);
    float rate = 7;
    ASSERT_EQ(match_speed(points, asked, weights, rate), Status::ok);
    expect_sum_of_one(weights);
    double way = 0, time = 0;  // of a cycle
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double t = static_cast<double>(weights[i]) * static_cast<double>(points[i].duration_s);
      time += t, way += t * static_cast<double>(points[i].speed_m_s);
    }
    const double got = static_cast<double>(rate) * way / time;
    if (points[0].speed_m_s == 0 && points.size() == 1) continue;  // nobody walks
    worst = std::fmax(worst, std::fabs(got - static_cast<double>(asked)));
    const bool in = asked >= points.front().speed_m_s && asked <= points.back().speed_m_s;
    if (in) {
      ASSERT_EQ(rate, 1);
    }
    between += in, slower += asked<points.front().speed_m_s, faster += asked> points.back().speed_m_s;
    ASSERT_NEAR(got, static_cast<double>(asked), 1e-6) << "round " << round;
    // Continuous.
    std::vector<float> near(points.size());
    ASSERT_EQ(match_speed(points, asked + 1e-4f, near, rate), Status::ok);
    ASSERT_LE(apart(weights, near), 1e-4 * 10 / 0.1 + 1e-6);
  }
  EXPECT_GT(between, 10000);
  EXPECT_GT(slower, 1000);
  EXPECT_GT(faster, 10000);
  std::printf("at most %.2g m/s off\n", worst);
}

TEST(BlendSpace, SpeedsAtTheEndsPlaySlowerAndFaster) {
  const SpeedPoint gaits[] = {{1, 1}, {3, 0.5f}}, from_idle[] = {{0, 2}, {1, 1}};
  float weights[2], rate = 0;
  const auto expect = [&](Span<const SpeedPoint> points, float speed, float w0, float w1, float r) {
    EXPECT_EQ(match_speed(points, speed, weights, rate), Status::ok);
    EXPECT_EQ(weights[0], w0) << speed;
    EXPECT_EQ(weights[1], w1) << speed;
    EXPECT_EQ(rate, r) << speed;
  };
  expect(gaits, 0.5f, 1, 0, 0.5f);
  expect(gaits, 0, 1, 0, 0);
  expect(gaits, -3, 1, 0, 0);
  expect(gaits, 1, 1, 0, 1);
  expect(gaits, 3, 0, 1, 1);
  expect(gaits, 6, 0, 1, 2);
  // 1 m in 1 s and 1.5 m in 0.5 s: two thirds of the second are 1/3 + 1 m in 1/3 + 1/3 s.
  expect(gaits, 2, 1.0f / 3, 2.0f / 3, 1);
  expect(from_idle, 0, 1, 0, 1);
  expect(from_idle, 0.5f, 1.0f / 3, 2.0f / 3, 1);
  expect(from_idle, 2, 0, 1, 2);
}

TEST(BlendSpace, OfBadCallsIsRefused) {
  using test::kInfinity, test::kNan;
  const test::CallErrors errors;
  std::vector<float> weights(3, 7);
  float rate = 7;
  const auto line = [&](const std::vector<float>& points, float at) {
    EXPECT_EQ(line_weights(points, at, weights), Status::bad_argument);
  };
  line({}, 0);
  line({0, 1}, kNan);
  line({0, 0}, 0);
  line({1, 0}, 0);
  line({0, kInfinity}, 0);
  line({kNan}, 0);
  line({0, 1, 2, 3}, 0);
  const std::vector<PlanePoint> points = {{0, 0}, {1, 0}, {0, 1}};
  const auto plane = [&](std::vector<PlanePoint> p, std::vector<PlaneTriangle> t, PlanePoint at) {
    EXPECT_EQ(plane_weights(p, t, at, weights), Status::bad_argument);
  };
  plane(points, {}, {});
  plane(points, {{{0, 2, 1}}}, {});
  plane(points, {{{0, 1, 1}}}, {});
  plane(points, {{{0, 1, 3}}}, {});
  plane(points, {{{0, 1, 2}}}, {kNan, 0});
  plane(points, {{{0, 1, 2}}}, {0, kInfinity});
  plane({{0, 0}, {1, 0}, {0, 2e12f}}, {{{0, 1, 2}}}, {});
  plane({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{{0, 1, 2}}}, {});
  const auto speeds = [&](const std::vector<SpeedPoint>& p, float speed) {
    EXPECT_EQ(match_speed(p, speed, weights, rate), Status::bad_argument);
  };
  speeds({}, 1);
  speeds({{1, 1}}, kNan);
  speeds({{1, 0}}, 1);
  speeds({{-1, 1}}, 1);
  speeds({{1, kInfinity}}, 1);
  speeds({{1, 1}, {1, 1}}, 1);
  speeds({{1e-30f, 1}}, 1e30f);
  speeds({{0, 1}, {1, 1}, {2, 1}, {3, 1}}, 1);
  EXPECT_EQ(weights, std::vector<float>(3, 7));
  EXPECT_EQ(rate, 7);
}

TEST(BlendSpace, OfAnyBitsIsASumOfOneOrRefused) {
  Random random(34);
  int ok = 0, refused = 0;
  for (int round = 0; round < 100000; ++round) {
    std::vector<float> line(3), weights(3);
    std::vector<PlanePoint> points(3);
    std::vector<SpeedPoint> speeds(3);
    for (std::size_t i = 0; i < 3; ++i) {
      line[i] = test::any_float(random, 8, 4) + static_cast<float>(4 * i);
      points[i] = {test::any_float(random, 8, 4), test::any_float(random, 8, 4)};
      speeds[i] = {test::any_float(random, 8, 4) + static_cast<float>(4 * i), test::any_float(random, 8, 4)};
    }
    std::vector<PlaneTriangle> triangles(2);
    for (PlaneTriangle& t : triangles) t = {{0, 1 + random.below(2), random.below(4)}};
    if (random.below(2) == 0) triangles.pop_back();
    float rate = 0;
    for (int call = 0; call < 3; ++call) {
      const Status status = call == 0 ? line_weights(line, test::any_float(random, 8, 4), weights)
                            : call == 1
                                ? plane_weights(points, triangles,
                                                {test::any_float(random, 8, 4), test::any_float(random, 8, 4)}, weights)
                                : match_speed(speeds, test::any_float(random, 8, 4), weights, rate);
      ++(status == Status::ok ? ok : refused);
      if (status == Status::ok) expect_sum_of_one(weights);
      ASSERT_TRUE(std::isfinite(rate));
    }
    if (HasFatalFailure()) FAIL() << "round " << round;
  }
  EXPECT_GT(ok, 50000);
  EXPECT_GT(refused, 50000);
}

}  // namespace
}  // namespace marrow
