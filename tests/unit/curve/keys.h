// Keys in memory for the tests of curves, and their expected values in double precision.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/curve.h"
#include "support/rig.h"

namespace marrow::test {

inline constexpr CurveKind kAllKinds[] = {
    CurveKind::step,         CurveKind::linear,      CurveKind::hermite,    CurveKind::quadratic_bezier,
    CurveKind::cubic_bezier, CurveKind::catmull_rom, CurveKind::centripetal};

struct Keys {
  Curve view() const { return {kind, rotation, components, times, values}; }
  // Component c of point i; a Hermite key is three points.
  double at(std::size_t i, std::uint32_t c) const { return static_cast<double>(values[i * components + c]); }
  double time(std::size_t key) const { return static_cast<double>(times[key]); }
  // How many points lie from one key's to the next's.
  std::size_t stride() const {
    return kind == CurveKind::hermite || kind == CurveKind::cubic_bezier ? 3
           : kind == CurveKind::quadratic_bezier                         ? 2
                                                                         : 1;
  }
  std::size_t value_of(std::size_t key) const { return key * stride() + (kind == CurveKind::hermite ? 1 : 0); }

  CurveKind kind;
  bool rotation = false;
  std::uint32_t components = 1;
  std::vector<float> times, values;
};

// Uneven times from 1 s on, values within ±2; or random unit quaternions.
inline Keys random_keys(Random& random, CurveKind kind, std::uint32_t components, std::size_t count,
                        bool rotation = false) {
  Keys keys{kind, rotation, components, {}, {}};
  double time_s = 1;
  for (std::size_t k = 0; k < count; ++k) {
    keys.times.push_back(static_cast<float>(time_s));
    time_s += random.between(0.25, 1.5);
  }
  const std::size_t floats = curve_value_count(kind, components, count);
  while (keys.values.size() < floats) {
    if (!rotation) {
      keys.values.push_back(static_cast<float>(random.between(-2, 2)));
      continue;
    }
    for (const double q : random.rotation()) keys.values.push_back(static_cast<float>(q));
  }
  return keys;
}

inline std::vector<float> evaluate(const Curve& curve, double time_s) {
  std::vector<float> out(curve.components);
  EXPECT_EQ(evaluate_curve(curve, static_cast<float>(time_s), out), Status::ok);
  return out;
}

inline std::vector<float> velocity(const Curve& curve, double time_s) {
  std::vector<float> out(curve.components);
  EXPECT_EQ(curve_velocity(curve, static_cast<float>(time_s), out), Status::ok);
  return out;
}

// De Casteljau's algorithm from its geometry: a point of the curve divides the line between two curves of lower degree.
inline double casteljau(const std::vector<double>& points, double u) {
  if (points.size() == 1) return points[0];
  const std::vector<double> left(points.begin(), points.end() - 1), right(points.begin() + 1, points.end());
  return (1 - u) * casteljau(left, u) + u * casteljau(right, u);
}

}  // namespace marrow::test
