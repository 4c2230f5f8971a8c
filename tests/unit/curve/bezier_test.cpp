// Bézier curves of any degree against Bernstein polynomials, patches against surfaces that they must reproduce.
#include "unit/curve/keys.h"

namespace marrow {
namespace {

using test::Random;

double binomial(int n, int k) {
  double b = 1;
  for (int i = 1; i <= k; ++i) b *= static_cast<double>(n - k + i) / i;
  return b;
}

double bernstein(const std::vector<float>& points, std::uint32_t n, std::uint32_t c, double u) {
  const int degree = static_cast<int>(points.size() / n) - 1;
  double sum = 0;
  for (int i = 0; i <= degree; ++i) {
    sum += binomial(degree, i) * std::pow(1 - u, degree - i) * std::pow(u, i) *
           static_cast<double>(points[static_cast<std::size_t>(i) * n + c]);
  }
  return sum;
}

std::vector<float> random_floats(Random& random, std::size_t count) {
  std::vector<float> out(count);
  for (float& f : out) f = static_cast<float>(random.between(-2, 2));
  return out;
}

TEST(Bezier, IsTheSumOfBernsteinPolynomials) {
  Random random(101);
  int cases = 0;
  for (std::uint32_t n = 1; n <= 4; ++n) {
    for (std::size_t degree = 0; degree <= 20; ++degree) {
      const std::vector<float> points = random_floats(random, (degree + 1) * n);
      std::vector<float> scratch(points.size()), out(n);
      for (int i = 0; i <= 16; ++i) {
        ASSERT_EQ(bezier(points, n, static_cast<float>(i) / 16, scratch, out), Status::ok);
        for (std::uint32_t c = 0; c < n; ++c, ++cases)
          EXPECT_NEAR(static_cast<double>(out[c]), bernstein(points, n, c, i / 16.0), 2e-6) << degree;
      }
    }
  }
  EXPECT_EQ(cases, 10 * 21 * 17);
}

TEST(Bezier, GoesOnBeyondItsEnds) {
  const std::vector<float> points = {1, 3, 2};  // 1 + 4u - 3u²
  std::vector<float> scratch(3), out(1);
  ASSERT_EQ(bezier(points, 1, 2.0f, scratch, out), Status::ok);
  EXPECT_EQ(out[0], -3.0f);
  ASSERT_EQ(bezier(points, 1, -1.0f, scratch, out), Status::ok);
  EXPECT_EQ(out[0], -6.0f);
}

TEST(Bezier, OfRotationsIsTheCurveOfOneInterval) {
  Random random(102);
  int cases = 0;
  for (const CurveKind kind : {CurveKind::quadratic_bezier, CurveKind::cubic_bezier}) {
    for (int round = 0; round < 10; ++round) {
      test::Keys keys = test::random_keys(random, kind, 4, 2, true);
      keys.times = {0, 1};
      std::vector<float> scratch(keys.values.size()), out(4);
      for (int i = 0; i <= 8; ++i, ++cases) {
        ASSERT_EQ(bezier_rotation(keys.values, static_cast<float>(i) / 8, scratch, out), Status::ok);
        const std::vector<float> want = test::evaluate(keys.view(), i / 8.0);
        for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(out[c], want[c], 2e-6f);
      }
    }
  }
  EXPECT_EQ(cases, 2 * 10 * 9);
}

// A Catmull-Rom patch reproduces what is quadratic along u and v.
TEST(Patch, CatmullRomReproducesABiquadraticSurface) {
  const auto height = [](double x, double y) { return (x * x - 2 * x + 3) * (0.5 * y * y + y - 1); };
  std::vector<float> points;
  for (int j = -1; j <= 2; ++j) {
    for (int i = -1; i <= 2; ++i) {
      points.push_back(static_cast<float>(height(i, j)));
      points.push_back(static_cast<float>(i));
      points.push_back(static_cast<float>(j));
    }
  }
  int cases = 0;
  std::vector<float> out(3);
  for (int j = 0; j <= 16; ++j) {
    for (int i = 0; i <= 16; ++i, ++cases) {
      const double u = i / 16.0, v = j / 16.0;
      ASSERT_EQ(bicubic_patch(PatchBasis::catmull_rom, points, 3, static_cast<float>(u), static_cast<float>(v), out),
                Status::ok);
      EXPECT_NEAR(static_cast<double>(out[0]), height(u, v), 5e-6);
      EXPECT_NEAR(static_cast<double>(out[1]), u, 1e-6);
      EXPECT_NEAR(static_cast<double>(out[2]), v, 1e-6);
    }
  }
  EXPECT_EQ(cases, 17 * 17);
}

TEST(Patch, BezierIsDeCasteljausBothWays) {
  Random random(103);
  int cases = 0;
  for (std::uint32_t n = 1; n <= 4; ++n) {
    const std::vector<float> points = random_floats(random, 16 * n);
    std::vector<float> out(n);
    for (int j = 0; j <= 8; ++j) {
      for (int i = 0; i <= 8; ++i) {
        ASSERT_EQ(
            bicubic_patch(PatchBasis::bezier, points, n, static_cast<float>(i) / 8, static_cast<float>(j) / 8, out),
            Status::ok);
        for (std::uint32_t c = 0; c < n; ++c, ++cases) {
          std::vector<double> columns;
          for (std::size_t x = 0; x < 4; ++x) {
            std::vector<double> column;
            for (std::size_t y = 0; y < 4; ++y) column.push_back(static_cast<double>(points[(4 * y + x) * n + c]));
            columns.push_back(test::casteljau(column, j / 8.0));
          }
          EXPECT_NEAR(static_cast<double>(out[c]), test::casteljau(columns, i / 8.0), 2e-6);
        }
      }
    }
  }
  EXPECT_EQ(cases, 10 * 81);
}

// Two Catmull-Rom patches that share twelve of their points meet with the same values and slopes.
TEST(Patch, CatmullRomNeighboursMeetSmoothly) {
  Random random(104);
  const std::vector<float> grid = random_floats(random, 4 * 5);
  std::vector<float> left, right;
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 4; ++x) {
      left.push_back(grid[5 * y + x]);
      right.push_back(grid[5 * y + x + 1]);
    }
  }
  const auto at = [](const std::vector<float>& points, float u, float v) {
    float out = 0;
    EXPECT_EQ(bicubic_patch(PatchBasis::catmull_rom, points, 1, u, v, Span<float>(&out, 1)), Status::ok);
    return out;
  };
  for (int j = 0; j <= 8; ++j) {
    const float v = static_cast<float>(j) / 8, step = 1.0f / 512;
    EXPECT_NEAR(at(left, 1, v), at(right, 0, v), 1e-6f);
    EXPECT_NEAR((at(left, 1 + step, v) - at(left, 1 - step, v)) / (2 * step),
                (at(right, step, v) - at(right, -step, v)) / (2 * step), 2e-3f);
  }
}

}  // namespace
}  // namespace marrow
