// Every kind of curve against closed forms in double precision.
#include "unit/curve/keys.h"

namespace marrow {
namespace {

using test::evaluate;
using test::kAllKinds;
using test::Keys;
using test::Random;
using test::random_keys;
using test::velocity;

// The value expected of component c between key and key + 1, at u.
using Formula = double (*)(const Keys& keys, std::size_t key, double u, std::uint32_t c);

// Every number of components, every interval, 33 moments each.
void expect_formula(CurveKind kind, Formula formula, double tolerance) {
  Random random(71);
  int cases = 0;
  for (std::uint32_t n = 1; n <= 4; ++n) {
    const Keys keys = random_keys(random, kind, n, 6);
    ASSERT_EQ(check_curve(keys.view()), Status::ok);
    for (std::size_t key = 0; key < 5; ++key) {
      for (int i = 0; i <= 32; ++i) {
        const double from_s = keys.time(key), span_s = keys.time(key + 1) - from_s;
        const float time_s = static_cast<float>(from_s + span_s * i / 32);
        const double u = (static_cast<double>(time_s) - from_s) / span_s;
        const std::vector<float> got = evaluate(keys.view(), static_cast<double>(time_s));
        for (std::uint32_t c = 0; c < n; ++c, ++cases) {
          EXPECT_NEAR(static_cast<double>(got[c]), formula(keys, key, u, c), tolerance) << n << ' ' << key << ' ' << u;
        }
      }
    }
  }
  EXPECT_EQ(cases, 10 * 5 * 33);
}

TEST(Curve, Step) {
  expect_formula(
      CurveKind::step,
      [](const Keys& keys, std::size_t key, double u, std::uint32_t c) { return keys.at(u < 1 ? key : key + 1, c); },
      0);
}

TEST(Curve, Linear) {
  expect_formula(
      CurveKind::linear,
      [](const Keys& keys, std::size_t key, double u, std::uint32_t c) {
        return keys.at(key, c) + u * (keys.at(key + 1, c) - keys.at(key, c));
      },
      1e-6);
}

TEST(Curve, QuadraticBezierIsDeCasteljaus) {
  expect_formula(
      CurveKind::quadratic_bezier,
      [](const Keys& keys, std::size_t key, double u, std::uint32_t c) {
        const std::size_t i = 2 * key;
        return test::casteljau({keys.at(i, c), keys.at(i + 1, c), keys.at(i + 2, c)}, u);
      },
      1e-6);
}

TEST(Curve, CubicBezierIsDeCasteljaus) {
  expect_formula(
      CurveKind::cubic_bezier,
      [](const Keys& keys, std::size_t key, double u, std::uint32_t c) {
        const std::size_t i = 3 * key;
        return test::casteljau({keys.at(i, c), keys.at(i + 1, c), keys.at(i + 2, c), keys.at(i + 3, c)}, u);
      },
      1e-6);
}

// A Hermite interval is the Bézier curve whose handles are a third of the tangents long.
TEST(Curve, HermiteIsABezierCurveWithThirdsOfTangents) {
  expect_formula(
      CurveKind::hermite,
      [](const Keys& keys, std::size_t key, double u, std::uint32_t c) {
        const double span_s = keys.time(key + 1) - keys.time(key), a = keys.at(3 * key + 1, c);
        const double b = keys.at(3 * key + 4, c);
        return test::casteljau(
            {a, a + keys.at(3 * key + 2, c) * span_s / 3, b - keys.at(3 * key + 3, c) * span_s / 3, b}, u);
      },
      2e-6);
}

double neighbour(const Keys& keys, std::size_t key, int offset, std::uint32_t c) {
  if (offset < 0 && key == 0) return 2 * keys.at(0, c) - keys.at(1, c);
  const std::size_t last = keys.times.size() - 1;
  if (offset == 2 && key + 1 == last) return 2 * keys.at(last, c) - keys.at(last - 1, c);
  return keys.at(static_cast<std::size_t>(static_cast<int>(key) + offset), c);
}

// The matrix of Catmull and Rom, with tension ½.
TEST(Curve, CatmullRom) {
  expect_formula(
      CurveKind::catmull_rom,
      [](const Keys& keys, std::size_t key, double u, std::uint32_t c) {
        const double a = neighbour(keys, key, -1, c), b = neighbour(keys, key, 0, c);
        const double d = neighbour(keys, key, 1, c), e = neighbour(keys, key, 2, c);
        return ((((-a + 3 * b - 3 * d + e) * u + (2 * a - 5 * b + 4 * d - e)) * u + (d - a)) * u + 2 * b) / 2;
      },
      3e-6);
}

// Barry and Goldman's pyramid over knots √distance apart.
double pyramid(const Keys& keys, std::size_t key, double u, std::uint32_t c) {
  double knot[4] = {0, 0, 0, 0}, point[4];
  for (int i = 0; i < 4; ++i) {
    point[i] = neighbour(keys, key, i - 1, c);
    double squared = 0;
    for (std::uint32_t k = 0; k < keys.components && i > 0; ++k)
      squared += std::pow(neighbour(keys, key, i - 1, k) - neighbour(keys, key, i - 2, k), 2);
    if (i > 0) knot[i] = knot[i - 1] + std::pow(squared, 0.25);
  }
  const double t = knot[1] + u * (knot[2] - knot[1]);
  const auto between = [&](double from, double to, int i, int j) {
    return ((knot[j] - t) * from + (t - knot[i]) * to) / (knot[j] - knot[i]);
  };
  const double a1 = between(point[0], point[1], 0, 1), a2 = between(point[1], point[2], 1, 2);
  const double a3 = between(point[2], point[3], 2, 3);
  return between(between(a1, a2, 0, 2), between(a2, a3, 1, 3), 1, 2);
}

TEST(Curve, CentripetalIsBarryAndGoldmansPyramid) {
  expect_formula(CurveKind::centripetal, pyramid, 5e-6);
}

TEST(Curve, CentripetalRestsWhereKeysCoincideAndStaysFinite) {
  const Keys keys{CurveKind::centripetal, false, 2, {0, 1, 2, 3}, {0, 0, 1, 1, 1, 1, 3, 1}};
  for (int i = 0; i <= 16; ++i) EXPECT_EQ(evaluate(keys.view(), 1 + i / 16.0), (std::vector<float>{1, 1})) << i;
  for (int i = 0; i <= 48; ++i) {
    for (const float f : evaluate(keys.view(), i / 16.0)) EXPECT_TRUE(std::isfinite(f)) << i;
  }
}

TEST(Curve, HermiteReproducesACubicPolynomial) {
  const auto value = [](double t) { return 0.5 * t * t * t - 2 * t * t + t - 3; };
  const auto slope = [](double t) { return 1.5 * t * t - 4 * t + 1; };
  Keys keys{CurveKind::hermite, false, 1, {-1, -0.25f, 0.5f, 2, 3.5f}, {}};
  for (const float t : keys.times) {
    for (const double v : {slope(static_cast<double>(t)), value(static_cast<double>(t)), slope(static_cast<double>(t))})
      keys.values.push_back(static_cast<float>(v));
  }
  for (int i = 0; i <= 144; ++i) {
    const double t = -1 + i / 32.0;
    EXPECT_NEAR(static_cast<double>(evaluate(keys.view(), t)[0]), value(t), 4e-6) << t;
    EXPECT_NEAR(static_cast<double>(velocity(keys.view(), t)[0]), slope(t), 1e-5) << t;
  }
}

TEST(Curve, CatmullRomReproducesAParabolaAtEvenTimes) {
  Keys keys{CurveKind::catmull_rom, false, 1, {}, {}};
  const auto value = [](double t) { return t * t - 3 * t + 1; };
  for (int k = 0; k <= 6; ++k) {
    keys.times.push_back(static_cast<float>(k) * 0.5f);
    keys.values.push_back(static_cast<float>(value(k * 0.5)));
  }
  for (int i = 0; i <= 64; ++i) {  // the outer intervals continue straight
    const double t = 0.5 + i / 32.0;
    EXPECT_NEAR(static_cast<double>(evaluate(keys.view(), t)[0]), value(t), 1e-6) << t;
    EXPECT_NEAR(static_cast<double>(velocity(keys.view(), t)[0]), 2 * t - 3, 3e-6) << t;
  }
}

TEST(Curve, PassesThroughItsKeysAndIsClampedOutside) {
  Random random(72);
  int cases = 0;
  for (const CurveKind kind : kAllKinds) {
    for (std::uint32_t n = 1; n <= 4; ++n) {
      const Keys keys = random_keys(random, kind, n, 5);
      for (std::size_t k = 0; k < 5; ++k, ++cases) {
        const std::vector<float> got = evaluate(keys.view(), keys.time(k));
        for (std::uint32_t c = 0; c < n; ++c) EXPECT_EQ(static_cast<double>(got[c]), keys.at(keys.value_of(k), c));
      }
      const double first_s = keys.time(0), last_s = keys.time(4), infinite = HUGE_VAL;
      for (const double early_s : {first_s - 1, -infinite})
        EXPECT_EQ(evaluate(keys.view(), early_s), evaluate(keys.view(), first_s));
      for (const double late_s : {last_s + 1, infinite})
        EXPECT_EQ(evaluate(keys.view(), late_s), evaluate(keys.view(), last_s));
      for (const double outside_s : {first_s - 1, last_s + 1, -infinite, infinite})
        EXPECT_EQ(velocity(keys.view(), outside_s), std::vector<float>(n, 0.0f));
    }
  }
  EXPECT_EQ(cases, 7 * 4 * 5);
}

TEST(Curve, VelocityIsTheDifferenceQuotient) {
  Random random(73);
  int cases = 0;
  for (const CurveKind kind : kAllKinds) {
    for (std::uint32_t n = 1; n <= 4; ++n) {
      const Keys keys = random_keys(random, kind, n, 5);
      for (std::size_t key = 0; key < 4; ++key) {
        const double span_s = keys.time(key + 1) - keys.time(key), step_s = 1.0 / 256;
        for (int i = 1; i < 8; ++i) {
          const double t = static_cast<double>(static_cast<float>(keys.time(key) + span_s * i / 8));
          const std::vector<float> before = evaluate(keys.view(), t - step_s),
                                   after = evaluate(keys.view(), t + step_s);
          const std::vector<float> got = velocity(keys.view(), t);
          for (std::uint32_t c = 0; c < n; ++c, ++cases) {
            const double want = (static_cast<double>(after[c]) - static_cast<double>(before[c])) / (2 * step_s);
            EXPECT_NEAR(static_cast<double>(got[c]), want, 0.02) << static_cast<int>(kind) << ' ' << t;
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 7 * 10 * 4 * 7);
}

// From just before a key to just after it, the velocity of a Catmull-Rom curve over even times does not jump.
TEST(Curve, CatmullRomIsSmoothOverEvenTimes) {
  Random random(74);
  Keys keys = random_keys(random, CurveKind::catmull_rom, 3, 9);
  for (std::size_t k = 0; k < 9; ++k) keys.times[k] = static_cast<float>(k) * 0.5f;
  for (int k = 1; k < 8; ++k) {
    const std::vector<float> before = velocity(keys.view(), k * 0.5 - 1e-6), after = velocity(keys.view(), k * 0.5);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(before[c], after[c], 1e-4f);
  }
}

}  // namespace
}  // namespace marrow
