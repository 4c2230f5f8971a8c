// Curves that break the rules: refused where asked, safe everywhere.
#include <algorithm>

#include "support/allocations.h"
#include "support/bad_numbers.h"
#include "unit/curve/keys.h"

namespace marrow {
namespace {

using test::kAllKinds;
using test::Keys;
using test::kInfinity;
using test::kNan;
using test::Random;
using test::random_keys;

// Every function that takes a curve, for whether it refuses.
void expect_refused(const Keys& keys) {
  const Curve curve = keys.view();
  std::vector<float> out(64, -77.0f);
  float time_s = -77.0f;
  EXPECT_EQ(check_curve(curve), Status::bad_argument);
  EXPECT_EQ(evaluate_curve(curve, 1.0f, out), Status::bad_argument);
  EXPECT_EQ(curve_velocity(curve, 1.0f, out), Status::bad_argument);
  EXPECT_EQ(natural_spline(curve, out), Status::bad_argument);
  EXPECT_EQ(clamped_spline(curve, out, out, out), Status::bad_argument);
  EXPECT_EQ(make_arc_length(curve, 1, out), Status::bad_argument);
  EXPECT_EQ(time_at_distance(curve, {1, out}, 0.0f, time_s), Status::bad_argument);
  EXPECT_EQ(out, std::vector<float>(64, -77.0f));
  EXPECT_EQ(time_s, -77.0f);
}

TEST(BadCurves, CountsThatDoNotFit) {
  Random random(121);
  for (const CurveKind kind : kAllKinds) {
    Keys keys = random_keys(random, kind, 2, 3);
    keys.values.pop_back();
    expect_refused(keys);
    expect_refused({kind, false, 1, {}, {}});
    expect_refused({kind, false, 0, {1}, {1}});
    expect_refused({kind, false, 5, {1}, std::vector<float>(15, 1.0f)});
    expect_refused({kind, true, 3, {1}, std::vector<float>(9, 1.0f)});
  }
  expect_refused({static_cast<CurveKind>(7), false, 1, {1, 2}, {1, 2, 3, 4, 5, 6}});
}

TEST(BadCurves, OneKeyIsAConstant) {
  Random random(122);
  int cases = 0;
  for (const CurveKind kind : kAllKinds) {
    for (const bool rotation : {false, true}) {
      const Keys keys = random_keys(random, kind, 4, 1, rotation);
      EXPECT_EQ(check_curve(keys.view()), Status::ok);
      const std::size_t first = 4 * keys.value_of(0);
      for (const double time_s : {-HUGE_VAL, 0.0, 1.0, 2.0, HUGE_VAL}) {
        const std::vector<float> got = test::evaluate(keys.view(), time_s);
        for (std::size_t c = 0; c < 4; ++c, ++cases) EXPECT_EQ(got[c], keys.values[first + c]);
      }
      EXPECT_TRUE(rotation || test::velocity(keys.view(), 1.0) == std::vector<float>(4, 0.0f));
    }
  }
  EXPECT_EQ(cases, 7 * 2 * 5 * 4);
}

TEST(BadCurves, NumbersThatAreNotFinite) {
  Random random(123);
  int cases = 0;
  for (const CurveKind kind : kAllKinds) {
    const Keys good = random_keys(random, kind, 3, 4);
    ASSERT_EQ(check_curve(good.view()), Status::ok);
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
      for (std::size_t i = 0; i < good.times.size() + good.values.size(); ++i, ++cases) {
        Keys keys = good;
        (i < 4 ? keys.times[i] : keys.values[i - 4]) = bad;
        EXPECT_EQ(check_curve(keys.view()), Status::bad_data) << static_cast<int>(kind) << ' ' << i;
        for (const float time_s : {-kInfinity, 1.5f, 3.0f, kInfinity}) {  // safe, whatever comes out
          float out[3];
          EXPECT_EQ(evaluate_curve(keys.view(), time_s, Span<float>(out, 3)), Status::ok);
          const Status velocity = curve_velocity(keys.view(), time_s, Span<float>(out, 3));
          EXPECT_TRUE(velocity == Status::ok || velocity == Status::bad_data);
        }
      }
    }
  }
  EXPECT_EQ(cases, 3 * (7 * 4 + 4 * 12 + 36 + 21 + 30));
}

// Whatever check_curve() lets pass has finite values everywhere; a velocity is finite, or said not to be.
TEST(BadCurves, LargeNumbersGiveFiniteValues) {
  Random random(127);
  const float sizes[] = {1e-40f, 1.0f, 1e9f, 1e18f, 2e18f, 3e38f};
  int good = 0, refused = 0, fast = 0;
  for (const CurveKind kind : kAllKinds) {
    for (int round = 0; round < 600; ++round) {
      Keys keys{kind, false, 2, {0}, {}};
      for (int k = 1; k < 4; ++k) keys.times.push_back(keys.times.back() + std::max(sizes[random.below(5)], 1e-38f));
      for (std::size_t i = 0; i < curve_value_count(kind, 2, 4); ++i)
        keys.values.push_back(sizes[random.below(round % 2 == 0 ? 6 : 4)] * (random.below(2) == 0 ? -1.0f : 1.0f));
      const Curve curve = keys.view();
      ++(check_curve(curve) == Status::ok ? good : refused);
      if (check_curve(curve) != Status::ok) continue;
      for (int i = 0; i <= 8; ++i) {
        const std::size_t key = static_cast<std::size_t>(i) % 3;
        const float u = static_cast<float>(i) / 8, time_s = (1 - u) * keys.times[key] + u * keys.times[key + 1];
        float out[2] = {-77, -77};
        ASSERT_EQ(evaluate_curve(curve, time_s, out), Status::ok);
        ASSERT_TRUE(std::isfinite(out[0]) && std::isfinite(out[1])) << static_cast<int>(kind) << ' ' << out[0];
        out[0] = -77;
        const Status velocity = curve_velocity(curve, time_s, out);
        ASSERT_TRUE(std::isfinite(out[0]) && std::isfinite(out[1])) << static_cast<int>(kind) << ' ' << out[0];
        if (velocity == Status::ok) continue;
        ASSERT_EQ(velocity, Status::bad_data);
        ASSERT_EQ(out[0], -77);
        ++fast;
      }
    }
  }
  EXPECT_GT(good, 500);
  EXPECT_GT(refused, 1000);
  EXPECT_GT(fast, 100);
}

TEST(BadCurves, TimesThatDoNotIncrease) {
  for (const std::vector<float>& times :
       {std::vector<float>{0, 1, 1, 2}, {0, 2, 1, 3}, {3, 2, 1, 0}, {0, 0, 0, 0}, {-3e38f, -1, 0, 3e38f}}) {
    const Keys keys{CurveKind::linear, false, 1, times, {0, 1, 2, 3}};
    EXPECT_EQ(check_curve(keys.view()), Status::bad_data);
    for (int i = -4; i <= 16; ++i) {
      const float value = test::evaluate(keys.view(), i / 4.0)[0];
      EXPECT_TRUE(value >= 0.0f && value <= 3.0f) << "a blend of two neighbours all the same: " << value;
    }
  }
}

TEST(BadCurves, RotationsThatAreNotUnit) {
  for (const CurveKind kind : kAllKinds) {
    Random random(124);
    Keys keys = random_keys(random, kind, 4, 3, true);
    EXPECT_EQ(check_curve(keys.view()), Status::ok);
    for (std::size_t c = 0; c < 4; ++c) keys.values[4 * keys.value_of(2) + c] *= 1.01f;
    EXPECT_EQ(check_curve(keys.view()), Status::bad_data) << static_cast<int>(kind);
  }
}

TEST(BadCurves, CallsThatAreWrong) {
  Random random(125);
  const Keys keys = random_keys(random, CurveKind::linear, 3, 4);
  const Keys smooth = random_keys(random, CurveKind::catmull_rom, 3, 4);
  std::vector<float> two(2), three(3), short_out(35), out(36), lengths(7);
  float time_s = 0;
  EXPECT_EQ(evaluate_curve(keys.view(), 1.0f, two), Status::bad_argument);
  EXPECT_EQ(evaluate_curve(keys.view(), kNan, three), Status::bad_argument);
  EXPECT_EQ(curve_velocity(keys.view(), 1.0f, two), Status::bad_argument);
  EXPECT_EQ(curve_velocity(keys.view(), kNan, three), Status::bad_argument);
  EXPECT_EQ(natural_spline(keys.view(), short_out), Status::bad_argument);
  EXPECT_EQ(natural_spline(smooth.view(), out), Status::bad_argument);
  EXPECT_EQ(clamped_spline(keys.view(), two, three, out), Status::bad_argument);
  EXPECT_EQ(clamped_spline(keys.view(), three, two, out), Status::bad_argument);
  EXPECT_EQ(clamped_spline(keys.view(), std::vector<float>{0, kNan, 0}, three, out), Status::bad_data);
  EXPECT_EQ(make_arc_length(keys.view(), 0, out), Status::bad_argument);
  EXPECT_EQ(make_arc_length(keys.view(), 2, Span<float>(lengths.data(), 6)), Status::bad_argument);
  EXPECT_EQ(make_arc_length(keys.view(), 0xFFFFFFFFu, lengths), Status::bad_argument);
  EXPECT_EQ(make_arc_length(keys.view(), 2, lengths), Status::ok);
  EXPECT_EQ(time_at_distance(keys.view(), {3, lengths}, 0.0f, time_s), Status::bad_argument);
  EXPECT_EQ(time_at_distance(keys.view(), {0, lengths}, 0.0f, time_s), Status::bad_argument);
  EXPECT_EQ(time_at_distance(keys.view(), {2, lengths}, kNan, time_s), Status::bad_argument);
  const Keys turning = random_keys(random, CurveKind::linear, 4, 3, true);
  EXPECT_EQ(make_arc_length(turning.view(), 1, out), Status::unsupported);
  const Keys steps = random_keys(random, CurveKind::step, 1, 3);
  EXPECT_EQ(make_arc_length(steps.view(), 1, out), Status::unsupported);
  const Keys huge{CurveKind::linear, false, 2, {0, 1}, {-3e38f, 0, 3e38f, 0}};
  EXPECT_EQ(make_arc_length(huge.view(), 1, out), Status::bad_data);
}

TEST(BadCurves, SplineOfKeysTooCloseInTime) {
  const Keys keys{CurveKind::linear, false, 1, {0, 1e-42f, 1}, {0, 1, 2}};
  std::vector<float> out(9);
  EXPECT_EQ(check_curve(keys.view()), Status::ok);
  EXPECT_EQ(natural_spline(keys.view(), out), Status::bad_data);
}

TEST(BadCurves, ControlPoints) {
  std::vector<float> points(16 * 2, 1.0f), scratch(32), out(2);
  EXPECT_EQ(bezier(points, 2, 0.5f, scratch, out), Status::ok);
  EXPECT_EQ(bezier({}, 2, 0.5f, scratch, out), Status::bad_argument);
  EXPECT_EQ(bezier(points, 0, 0.5f, scratch, out), Status::bad_argument);
  EXPECT_EQ(bezier(points, 3, 0.5f, scratch, out), Status::bad_argument);
  EXPECT_EQ(bezier(points, 4, 0.5f, scratch, out), Status::bad_argument);
  EXPECT_EQ(bezier(points, 2, 0.5f, Span<float>(scratch.data(), 31), out), Status::bad_argument);
  EXPECT_EQ(bicubic_patch(PatchBasis::bezier, Span<float>(points.data(), 31), 2, 0, 0, out), Status::bad_argument);
  EXPECT_EQ(bicubic_patch(PatchBasis::bezier, points, 0, 0, 0, out), Status::bad_argument);
  EXPECT_EQ(bicubic_patch(PatchBasis::bezier, points, 2, 0, 0, Span<float>(out.data(), 1)), Status::bad_argument);
  EXPECT_EQ(bicubic_patch(static_cast<PatchBasis>(2), points, 2, 0, 0, out), Status::bad_argument);
  for (const float bad : {kNan, kInfinity}) {
    EXPECT_EQ(bezier(points, 2, bad, scratch, out), Status::bad_argument);
    EXPECT_EQ(bicubic_patch(PatchBasis::bezier, points, 2, bad, 0, out), Status::bad_argument);
    EXPECT_EQ(bicubic_patch(PatchBasis::bezier, points, 2, 0, bad, out), Status::bad_argument);
  }
  EXPECT_EQ(bicubic_patch(PatchBasis::bezier, points, 2, 0.5f, 0.5f, out), Status::ok);
  std::vector<float> far(32, 3e38f);
  const std::vector<float> before = out;
  EXPECT_EQ(bicubic_patch(PatchBasis::bezier, far, 2, 3.0f, 0.5f, out), Status::bad_data);
  EXPECT_EQ(out, before);
  points[3] = kNan;
  EXPECT_EQ(bezier(points, 2, 0.5f, scratch, out), Status::bad_data);
  std::vector<float> four(4);
  EXPECT_EQ(bezier_rotation(std::vector<float>(8, 0.0f), 0.5f, scratch, four), Status::bad_data);
  EXPECT_EQ(bezier_rotation(std::vector<float>(8, 1e25f), 0.5f, scratch, four), Status::bad_data);
  EXPECT_EQ(bezier_rotation(std::vector<float>(7, 0.5f), 0.5f, scratch, four), Status::bad_argument);
  EXPECT_EQ(bezier_rotation({0, 0}, 0.5f, scratch, four), Status::bad_argument);
}

TEST(BadCurves, NothingIsAllocated) {
  Random random(126);
  const Keys keys = random_keys(random, CurveKind::linear, 4, 20);
  std::vector<float> spline(12 * 20), lengths(19 * 8 + 1), out(4), scratch(80);
  float time_s = 0;
  int failures = 0;
  const std::size_t before = test::allocation_count();
  failures += natural_spline(keys.view(), spline) != Status::ok;
  const Curve smooth{CurveKind::hermite, false, 4, keys.times, spline};
  failures += make_arc_length(smooth, 8, lengths) != Status::ok;
  for (int i = 0; i < 1000; ++i) {
    const float u = static_cast<float>(i) / 1000;
    failures += time_at_distance(smooth, {8, lengths}, u * lengths.back(), time_s) != Status::ok;
    failures += evaluate_curve(smooth, time_s, out) != Status::ok;
    failures += bezier(keys.values, 4, u, scratch, out) != Status::ok;
    failures += ease(CubicBezierEase{}, u, time_s) != Status::ok;
  }
  EXPECT_EQ(test::allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
}

}  // namespace
}  // namespace marrow
