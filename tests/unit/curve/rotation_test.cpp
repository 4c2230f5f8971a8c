// Curves of unit quaternions: on the sphere, the short way round, whatever the signs of the keys.
#include "unit/curve/keys.h"

namespace marrow {
namespace {

using test::evaluate;
using test::kAllKinds;
using test::Keys;
using test::Quat;
using test::Random;
using test::random_keys;

Quat quat(const std::vector<float>& q) {
  return {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]), static_cast<double>(q[3])};
}
double dot4(const Quat& a, const Quat& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}
// The angle of the rotation between two rotations; exact for small ones, blind to the sign.
double angle_rad(const Quat& a, const Quat& b) {
  const double sign = dot4(a, b) < 0 ? -1 : 1;
  double squared = 0;
  for (std::size_t i = 0; i < 4; ++i) squared += std::pow(a[i] - sign * b[i], 2);
  return 4 * std::asin(std::min(1.0, std::sqrt(squared) / 2));
}
Quat point(const Keys& keys, std::size_t i) {
  return {keys.at(i, 0), keys.at(i, 1), keys.at(i, 2), keys.at(i, 3)};
}
Quat times(const Quat& q, double factor) {
  return {factor * q[0], factor * q[1], factor * q[2], factor * q[3]};
}
Quat nearer(const Quat& reference, const Quat& q) {
  return times(q, dot4(reference, q) < 0 ? -1 : 1);
}

TEST(CurveRotation, LinearIsSphericalAlongTheShorterArc) {
  Random random(81);
  int cases = 0;
  for (int round = 0; round < 20; ++round) {
    const Keys keys = random_keys(random, CurveKind::linear, 4, 5, true);
    ASSERT_EQ(check_curve(keys.view()), Status::ok);
    for (std::size_t key = 0; key < 4; ++key) {
      for (int i = 0; i <= 16; ++i, ++cases) {
        const double span_s = keys.time(key + 1) - keys.time(key);
        const double t = static_cast<double>(static_cast<float>(keys.time(key) + span_s * i / 16));
        const Quat want = test::slerp(point(keys, key), point(keys, key + 1), (t - keys.time(key)) / span_s);
        EXPECT_LT(angle_rad(quat(evaluate(keys.view(), t)), want), 3e-6);
      }
    }
  }
  EXPECT_EQ(cases, 20 * 4 * 17);
}

// The chained control points of an interval as a cubic or quadratic Bézier curve.
std::vector<Quat> control_points(const Keys& keys, std::size_t key) {
  std::vector<Quat> p;
  const double span_s = keys.time(key + 1) - keys.time(key);
  const auto tangent = [](const Quat& q, const Quat& along, double factor) {
    Quat out = q;
    for (std::size_t i = 0; i < 4; ++i) out[i] += factor * along[i];
    return out;
  };
  if (keys.kind == CurveKind::hermite) {
    const Quat a = point(keys, 3 * key + 1), b = point(keys, 3 * key + 4);
    const double sign = dot4(a, b) < 0 ? -1 : 1;
    return {a, tangent(a, point(keys, 3 * key + 2), span_s / 3),
            tangent(times(b, sign), point(keys, 3 * key + 3), -sign * span_s / 3), times(b, sign)};
  }
  for (std::size_t i = 0; i <= keys.stride(); ++i) {
    const Quat q = point(keys, keys.stride() * key + i);
    p.push_back(p.empty() ? q : nearer(p.back(), q));
  }
  if (keys.kind != CurveKind::catmull_rom) return p;
  const Quat before = key == 0 ? tangent(times(p[0], 2), p[1], -1) : nearer(p[0], point(keys, key - 1));
  const bool last = key + 2 == keys.times.size();
  const Quat after = last ? tangent(times(p[1], 2), p[0], -1) : nearer(p[1], point(keys, key + 2));
  return {p[0], tangent(tangent(p[0], p[1], 1.0 / 6), before, -1.0 / 6),
          tangent(tangent(p[1], p[0], 1.0 / 6), after, -1.0 / 6), p[1]};
}

TEST(CurveRotation, OthersGoByComponentsAlongTheChainAndAreNormalised) {
  Random random(82);
  int cases = 0;
  for (const CurveKind kind :
       {CurveKind::hermite, CurveKind::quadratic_bezier, CurveKind::cubic_bezier, CurveKind::catmull_rom}) {
    for (int round = 0; round < 20; ++round) {
      const Keys keys = random_keys(random, kind, 4, 4, true);
      for (std::size_t key = 0; key < 3; ++key) {
        const std::vector<Quat> control = control_points(keys, key);
        for (int i = 0; i <= 8; ++i, ++cases) {
          const double span_s = keys.time(key + 1) - keys.time(key);
          const double t = static_cast<double>(static_cast<float>(keys.time(key) + span_s * i / 8));
          Quat want{};
          for (std::size_t c = 0; c < 4; ++c) {
            std::vector<double> line;
            for (const Quat& q : control) line.push_back(q[c]);
            want[c] = test::casteljau(line, (t - keys.time(key)) / span_s);
          }
          const double length = std::sqrt(dot4(want, want));
          const Quat got = quat(evaluate(keys.view(), t));
          EXPECT_NEAR(dot4(got, got), 1, 1e-6);
          EXPECT_LT(angle_rad(got, times(want, 1 / length)), 3e-6 / std::min(1.0, length)) << static_cast<int>(kind);
        }
      }
    }
  }
  EXPECT_EQ(cases, 4 * 20 * 3 * 9);
}

// Barry and Goldman's pyramid over four chained quaternions, knots √distance apart; an inner interval.
Quat pyramid(const Keys& keys, std::size_t key, double u) {
  Quat level[4] = {{}, point(keys, key), {}, {}};
  level[0] = nearer(level[1], point(keys, key - 1));
  level[2] = nearer(level[1], point(keys, key + 1));
  level[3] = nearer(level[2], point(keys, key + 2));
  double knot[4] = {0, 0, 0, 0};
  for (std::size_t i = 1; i < 4; ++i) {
    double squared = 0;
    for (std::size_t c = 0; c < 4; ++c) squared += std::pow(level[i][c] - level[i - 1][c], 2);
    knot[i] = knot[i - 1] + std::pow(squared, 0.25);
  }
  const double t = knot[1] + u * (knot[2] - knot[1]);
  for (std::size_t width = 1; width <= 3; ++width) {
    for (std::size_t i = 0; i + width < 4; ++i) {
      // The last level blends over the inner interval only, as do neighbours on the first.
      const std::size_t from = width == 3 ? 1 : i, to = width == 3 ? 2 : i + width;
      const double share = (t - knot[from]) / (knot[to] - knot[from]);
      for (std::size_t c = 0; c < 4; ++c) level[i][c] = (1 - share) * level[i][c] + share * level[i + 1][c];
    }
  }
  return test::normalised(level[0]);
}

TEST(CurveRotation, CentripetalIsThePyramidOfTheChain) {
  Random random(85);
  int cases = 0;
  for (int round = 0; round < 40; ++round) {
    const Keys keys = random_keys(random, CurveKind::centripetal, 4, 5, true);
    for (std::size_t key = 1; key < 3; ++key) {
      for (int i = 0; i <= 8; ++i, ++cases) {
        const double span_s = keys.time(key + 1) - keys.time(key);
        const double t = static_cast<double>(static_cast<float>(keys.time(key) + span_s * i / 8));
        EXPECT_LT(angle_rad(quat(evaluate(keys.view(), t)), pyramid(keys, key, (t - keys.time(key)) / span_s)), 2e-5);
      }
    }
  }
  EXPECT_EQ(cases, 40 * 2 * 9);
}

TEST(CurveRotation, TheSignsOfKeysDoNotMatter) {
  Random random(83);
  int cases = 0;
  for (const CurveKind kind : kAllKinds) {
    const Keys keys = random_keys(random, kind, 4, 6, true);
    for (int round = 0; round < 10; ++round) {
      Keys turned = keys;
      const std::size_t packet = kind == CurveKind::hermite ? 12 : 4;  // a key's tangents turn with it
      for (std::size_t i = 0; i < turned.values.size(); i += packet) {
        const float sign = random.below(2) ? -1.0f : 1.0f;
        for (std::size_t k = 0; k < packet; ++k) turned.values[i + k] *= sign;
      }
      for (int i = 0; i <= 40; ++i, ++cases) {
        const double t = keys.time(0) + (keys.time(5) - keys.time(0)) * i / 40;
        EXPECT_LT(angle_rad(quat(evaluate(keys.view(), t)), quat(evaluate(turned.view(), t))), 1e-6);
      }
    }
  }
  EXPECT_EQ(cases, 7 * 10 * 41);
}

TEST(CurveRotation, ABlendWithoutDirectionGivesTheEarlierKey) {
  // Halfway ½ (a + b) + ⅛ (out - in) · 1 s = 0 by these tangents.
  Keys keys{
      CurveKind::hermite, true, 4, {0, 1}, {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -4, 0, 0, 0, 4, 0, 0, 0, 1, 0, 0, 0, 0}};
  ASSERT_EQ(check_curve(keys.view()), Status::ok);
  EXPECT_EQ(evaluate(keys.view(), 0.5), (std::vector<float>{0, 0, 0, 1}));
}

TEST(CurveRotation, HasNoVelocity) {
  Random random(84);
  const Keys keys = random_keys(random, CurveKind::linear, 4, 3, true);
  float out[4];
  EXPECT_EQ(curve_velocity(keys.view(), 1.0f, Span<float>(out, 4)), Status::unsupported);
}

}  // namespace
}  // namespace marrow
