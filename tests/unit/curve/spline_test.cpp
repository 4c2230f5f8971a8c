// Cubic splines against a dense solve in double precision, closed forms and difference quotients.
#include "unit/curve/keys.h"

namespace marrow {
namespace {

using test::evaluate;
using test::Keys;
using test::Random;
using test::random_keys;
using test::velocity;

Keys natural(const Keys& keys) {
  Keys out{CurveKind::hermite, keys.rotation, keys.components, keys.times, {}};
  out.values.resize(curve_value_count(CurveKind::hermite, keys.components, keys.times.size()));
  EXPECT_EQ(natural_spline(keys.view(), out.values), Status::ok);
  return out;
}

Keys clamped(const Keys& keys, const std::vector<float>& first, const std::vector<float>& last) {
  Keys out{CurveKind::hermite, keys.rotation, keys.components, keys.times, {}};
  out.values.resize(curve_value_count(CurveKind::hermite, keys.components, keys.times.size()));
  EXPECT_EQ(clamped_spline(keys.view(), first, last, out.values), Status::ok);
  return out;
}

// Second derivatives M of the natural spline of component c: the textbook system, by Gaussian elimination with pivots.
std::vector<double> moments(const Keys& keys, std::uint32_t c) {
  const std::size_t n = keys.times.size();
  std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
  rows[0][0] = rows[n - 1][n - 1] = 1;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = keys.time(i) - keys.time(i - 1), right = keys.time(i + 1) - keys.time(i);
    rows[i][i - 1] = left / 6;
    rows[i][i] = (left + right) / 3;
    rows[i][i + 1] = right / 6;
    rows[i][n] = (keys.at(i + 1, c) - keys.at(i, c)) / right - (keys.at(i, c) - keys.at(i - 1, c)) / left;
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i; r < n; ++r) pivot = std::fabs(rows[r][i]) > std::fabs(rows[pivot][i]) ? r : pivot;
    std::swap(rows[i], rows[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      const double factor = r == i ? 0 : rows[r][i] / rows[i][i];
      for (std::size_t k = i; k <= n; ++k) rows[r][k] -= factor * rows[i][k];
    }
  }
  std::vector<double> m(n);
  for (std::size_t i = 0; i < n; ++i) m[i] = rows[i][n] / rows[i][i];
  return m;
}

TEST(Spline, NaturalIsTheDenseSolution) {
  Random random(91);
  int cases = 0;
  for (std::uint32_t components = 1; components <= 4; ++components) {
    for (std::size_t count = 2; count <= 12; ++count) {
      const Keys keys = random_keys(random, CurveKind::linear, components, count);
      const Keys spline = natural(keys);
      ASSERT_EQ(check_curve(spline.view()), Status::ok);
      for (std::uint32_t c = 0; c < components; ++c) {
        const std::vector<double> m = moments(keys, c);
        for (std::size_t k = 0; k + 1 < count; ++k) {
          const double h = keys.time(k + 1) - keys.time(k);
          for (int i = 0; i <= 8; ++i, ++cases) {
            const double t = static_cast<double>(static_cast<float>(keys.time(k) + h * i / 8));
            const double to = keys.time(k + 1) - t, from = t - keys.time(k);
            const double want = (m[k] * to * to * to + m[k + 1] * from * from * from) / (6 * h) +
                                (keys.at(k, c) / h - m[k] * h / 6) * to +
                                (keys.at(k + 1, c) / h - m[k + 1] * h / 6) * from;
            EXPECT_NEAR(static_cast<double>(evaluate(spline.view(), t)[c]), want, 5e-6) << count << ' ' << t;
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 10 * 66 * 9);
}

// The second derivative at u = 0 or 1 of the interval from `key`, from three velocities in it: exact for a cubic.
double bend(const Keys& spline, std::size_t key, bool at_end, std::uint32_t c) {
  const double from = spline.time(key), to = spline.time(key + 1), near = at_end ? to : from;
  const double step = (at_end ? from - to : to - from) / 4;
  double v[3];
  for (int i = 0; i < 3; ++i) {
    // Just inside, so that a key belongs to this interval.
    const double t = i == 0 ? near + step * 1e-5 : near + step * i;
    v[i] = static_cast<double>(velocity(spline.view(), t)[c]);
  }
  return (-3 * v[0] + 4 * v[1] - v[2]) / (2 * step);
}

TEST(Spline, SecondDerivativesMeetAndVanishAtNaturalEnds) {
  Random random(92);
  int cases = 0;
  for (int round = 0; round < 10; ++round) {
    const Keys spline = natural(random_keys(random, CurveKind::linear, 3, 8));
    for (std::uint32_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(bend(spline, 0, false, c), 0, 2e-3);
      EXPECT_NEAR(bend(spline, 6, true, c), 0, 2e-3);
      for (std::size_t k = 1; k < 7; ++k, ++cases) {
        EXPECT_NEAR(bend(spline, k - 1, true, c), bend(spline, k, false, c), 4e-3) << round << ' ' << k;
        const double t = spline.time(k);
        EXPECT_NEAR(velocity(spline.view(), t - 1e-6)[c], velocity(spline.view(), t)[c], 1e-4f) << round << ' ' << k;
      }
    }
  }
  EXPECT_EQ(cases, 10 * 3 * 6);
}

TEST(Spline, ClampedReproducesACubicPolynomial) {
  const auto value = [](double t) { return t * t * t / 4 - t * t + 2 * t - 1; };
  const auto slope = [](double t) { return 0.75 * t * t - 2 * t + 2; };
  Keys keys{CurveKind::linear, false, 1, {-1, -0.5f, 0.75f, 1, 2.5f, 4}, {}};
  for (const float t : keys.times) keys.values.push_back(static_cast<float>(value(static_cast<double>(t))));
  const Keys spline = clamped(keys, {static_cast<float>(slope(-1))}, {static_cast<float>(slope(4))});
  for (int i = 0; i <= 160; ++i) {
    const double t = -1 + i / 32.0;
    EXPECT_NEAR(static_cast<double>(evaluate(spline.view(), t)[0]), value(t), 5e-6) << t;
    EXPECT_NEAR(static_cast<double>(velocity(spline.view(), t)[0]), slope(t), 1e-5) << t;
  }
  EXPECT_EQ(velocity(spline.view(), -1), (std::vector<float>{static_cast<float>(slope(-1))}));
  EXPECT_EQ(velocity(spline.view(), 4), (std::vector<float>{static_cast<float>(slope(4))}));
}

TEST(Spline, OneKeyAndTwo) {
  const Keys one{CurveKind::linear, false, 2, {3}, {5, 6}};
  EXPECT_EQ(natural(one).values, (std::vector<float>{0, 0, 5, 6, 0, 0}));
  EXPECT_EQ(clamped(one, {1, 2}, {3, 4}).values, (std::vector<float>{1, 2, 5, 6, 3, 4}));
  const Keys two{CurveKind::linear, false, 1, {1, 3}, {2, 8}};
  EXPECT_EQ(natural(two).values, (std::vector<float>{3, 2, 3, 3, 8, 3}));
  EXPECT_EQ(clamped(two, {1}, {-1}).values, (std::vector<float>{1, 2, 1, -1, 8, -1}));
}

TEST(Spline, OfRotationsChainsSigns) {
  Random random(93);
  const Keys keys = random_keys(random, CurveKind::linear, 4, 7, true);
  Keys turned = keys;
  for (std::size_t i = 8; i < 12; ++i) turned.values[i] = -turned.values[i];
  const Keys spline = natural(keys);
  EXPECT_EQ(spline.values, natural(turned).values);
  for (std::size_t k = 1; k < 7; ++k) {
    double dot = 0;
    for (std::uint32_t c = 0; c < 4; ++c) dot += spline.at(3 * k + 1, c) * spline.at(3 * k - 2, c);
    EXPECT_GE(dot, 0) << k;
  }
  EXPECT_EQ(check_curve(spline.view()), Status::ok);
}

}  // namespace
}  // namespace marrow
