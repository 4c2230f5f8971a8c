// Arc length against circles, straight lines and fine integration in double precision.
#include "unit/curve/keys.h"

namespace marrow {
namespace {

using test::Keys;
using test::Random;

std::vector<float> measure(const Keys& keys, std::uint32_t steps) {
  std::vector<float> lengths(arc_length_count(keys.times.size(), steps));
  EXPECT_EQ(make_arc_length(keys.view(), steps, lengths), Status::ok);
  return lengths;
}

double time_at(const Keys& keys, std::uint32_t steps, const std::vector<float>& lengths, double distance) {
  float time_s = -1;
  EXPECT_EQ(time_at_distance(keys.view(), {steps, lengths}, static_cast<float>(distance), time_s), Status::ok);
  return static_cast<double>(time_s);
}

// Radius 2 in `count` Hermite intervals over 1 s each, with the circle's own tangents.
Keys circle(int count) {
  Keys keys{CurveKind::hermite, false, 2, {}, {}};
  for (int k = 0; k <= count; ++k) {
    const double turn = 2 * M_PI / count, angle = turn * k;
    keys.times.push_back(static_cast<float>(k));
    for (const double v : {-turn * std::sin(angle), turn * std::cos(angle), std::cos(angle), std::sin(angle),
                           -turn * std::sin(angle), turn * std::cos(angle)})
      keys.values.push_back(static_cast<float>(2 * v));
  }
  return keys;
}

TEST(ArcLength, OfACircle) {
  const Keys keys = circle(64);
  const std::vector<float> lengths = measure(keys, 4);
  EXPECT_NEAR(static_cast<double>(lengths.back()), 4 * M_PI, 5e-6);
  for (int i = 0; i <= 100; ++i)
    EXPECT_NEAR(time_at(keys, 4, lengths, 4 * M_PI * i / 100), 64 * i / 100.0, 2e-4) << "its speed is even already";
}

TEST(ArcLength, OfStraightLinesIsExact) {
  const Keys keys{CurveKind::linear, false, 2, {0, 1, 5, 6}, {0, 0, 3, 4, 3, 4, 3, 14}};
  const std::vector<float> lengths = measure(keys, 2);
  EXPECT_EQ(lengths, (std::vector<float>{0, 2.5f, 5, 5, 5, 10, 15}));
  EXPECT_EQ(time_at(keys, 2, lengths, 1), 0.20000000298023224);
  EXPECT_EQ(time_at(keys, 2, lengths, 5), 5) << "the end of the rest";
  EXPECT_EQ(time_at(keys, 2, lengths, 10), 5.5);
  EXPECT_EQ(time_at(keys, 2, lengths, -1), 0);
  EXPECT_EQ(time_at(keys, 2, lengths, 15), 6);
  EXPECT_EQ(time_at(keys, 2, lengths, HUGE_VAL), 6);
}

TEST(ArcLength, OfAPathThatRestsAllAlong) {
  const Keys keys{CurveKind::catmull_rom, false, 1, {2, 3}, {7, 7}};
  const std::vector<float> lengths = measure(keys, 3);
  EXPECT_EQ(lengths, (std::vector<float>{0, 0, 0, 0}));
  const Keys one{CurveKind::linear, false, 1, {2}, {7}};
  for (const double distance : {-HUGE_VAL, -1.0, -0.0, 0.0, 1.0, HUGE_VAL}) {
    EXPECT_EQ(time_at(keys, 3, lengths, distance), 3) << distance;
    EXPECT_EQ(time_at(one, 3, measure(one, 3), distance), 2) << distance;
  }
}

TEST(ArcLength, TablesOfAnything) {
  const Keys keys{CurveKind::linear, false, 1, {2, 3, 7}, {0, 1, 2}};
  const float values[] = {NAN, -INFINITY, -1, 0, 1e-45f, 1, 3e38f, INFINITY};
  constexpr int kCount = 8;
  for (int i = 0; i < kCount * kCount * kCount; ++i) {
    const std::vector<float> table = {values[i % kCount], values[i / kCount % kCount], values[i / kCount / kCount]};
    for (const double distance : {-1.0, 0.0, 0.5, 1e38, HUGE_VAL}) {
      const double time_s = time_at(keys, 1, table, distance);
      EXPECT_TRUE(time_s >= 2 && time_s <= 7) << i << ' ' << distance << ": " << time_s;
    }
  }
}

// A cubic Bézier curve in the plane in double precision.
struct Path {
  double p[4][2];
  double speed(double u) const {
    double squared = 0;
    for (int c = 0; c < 2; ++c) {
      const double v = 1 - u;
      squared += std::pow(
          3 * v * v * (p[1][c] - p[0][c]) + 6 * u * v * (p[2][c] - p[1][c]) + 3 * u * u * (p[3][c] - p[2][c]), 2);
    }
    return std::sqrt(squared);
  }
  double length(double to) const {  // Simpson
    const int n = 1000;
    double sum = speed(0) + speed(to);
    for (int i = 1; i < n; ++i) sum += speed(to * i / n) * (i % 2 ? 4 : 2);
    return sum * to / (3 * n);
  }
  // The second derivative is linear: the largest is at an end.
  double largest_bend() const {
    const auto at = [&](int i) {
      return 6 * std::hypot(p[i][0] - 2 * p[i + 1][0] + p[i + 2][0], p[i][1] - 2 * p[i + 1][1] + p[i + 2][1]);
    };
    return std::max(at(0), at(1));
  }
};

TEST(ArcLength, ErrorIsWithinTheBoundAndAQuarterForTwiceTheSteps) {
  Random random(111);
  double worst[4] = {0, 0, 0, 0};
  int cases = 0;
  for (int round = 0; round < 25; ++round) {
    Keys keys = test::random_keys(random, CurveKind::cubic_bezier, 2, 2);
    keys.times = {0, 1};
    Path path{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::uint32_t c = 0; c < 2; ++c) path.p[i][c] = keys.at(i, c);
    const double whole = path.length(1);
    for (int level = 0; level < 4; ++level) {
      const std::uint32_t steps = 8u << level;
      const std::vector<float> lengths = measure(keys, steps);
      const double bound = path.largest_bend() / (8.0 * steps * steps);
      EXPECT_NEAR(static_cast<double>(lengths.back()), whole, bound / 4 + 1e-5 * whole);
      for (int i = 1; i < 20; ++i, ++cases) {
        const double error = std::fabs(path.length(time_at(keys, steps, lengths, whole * i / 20)) - whole * i / 20);
        EXPECT_LE(error, bound + 1e-5 * whole) << round << ' ' << steps;
        worst[level] = std::max(worst[level], error);
      }
    }
  }
  EXPECT_EQ(cases, 25 * 4 * 19);
  for (int level = 1; level < 4; ++level) EXPECT_LT(worst[level], 0.4 * worst[level - 1]) << level;
}

}  // namespace
}  // namespace marrow
