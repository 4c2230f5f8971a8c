// Curves through keys, easings and patches: a time, or any other parameter, → numbers. For user channels and
// procedural motion; outside the pipeline of poses and meshes.
//
// Everything is plain functions over the caller's memory; nothing is kept, nothing is allocated, all is thread-safe on
// different outputs. Results are the same bits on every processor.
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/api.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

// How values run between two keys, and what a key holds. N is Curve::components, u goes 0 … 1 from one key to the next.
enum class CurveKind : std::uint8_t {
  step,              // key: value. The earlier key's value
  linear,            // key: value. A straight line; for rotations the shorter great arc (slerp)
  hermite,           // key: in-tangent, value, out-tangent; tangents per second, as glTF 2.0 CUBICSPLINE has it
  quadratic_bezier,  // value, one control point, value, one control point, … value; Bernstein form
  cubic_bezier,      // value, two control points, value, two control points, … value; Bernstein form
  catmull_rom,       // key: value. Uniform; Catmull and Rom 1974: the tangent at P1 is (P2 - P0) / 2 a key interval
  centripetal,       // key: value. Catmull-Rom with knots √|P2 - P1| apart; Barry and Goldman, SIGGRAPH 1988, and
                     // Yuksel, Schaefer and Keyser 2011: no cusps or loops between two keys. Keys less than 1e18 apart
};

// Keys, as a view. catmull_rom and centripetal draw a smooth path whatever the times are, but its velocity is
// continuous only where key intervals are even (or go with √distance, centripetal); for motion that is smooth over
// uneven keys make a spline. Beyond the first and last key they continue with a mirrored point, so that the path leaves
// and arrives straight.
struct Curve {
  CurveKind kind = CurveKind::linear;  // what lies between keys
  // Values are unit quaternions x, y, z, w; components is 4. Each key and control point is taken with the sign that is
  // nearer to the one before it. The result is normalised and may have either sign, as q and -q are the same rotation.
  // Where a blend has no direction, the result is the earlier key.
  bool rotation = false;
  std::uint32_t components = 1;    // floats a value: 1 … 4
  Span<const float> times_s = {};  // one a key, strictly increasing; seconds, or whatever the curve runs over
  Span<const float> values = {};   // curve_value_count() floats
};

// How many floats `key_count` keys of `components` hold.
constexpr std::size_t curve_value_count(CurveKind kind, std::uint32_t components, std::size_t key_count) {
  if (key_count == 0) return 0;
  if (kind == CurveKind::hermite) return components * 3 * key_count;
  if (kind == CurveKind::quadratic_bezier) return components * (2 * key_count - 1);
  if (kind == CurveKind::cubic_bezier) return components * (3 * key_count - 2);
  return components * key_count;
}

// Whether a curve keeps the rules above; call it once for keys that come from outside. Errors: bad_argument if `kind`
// is unknown, there is no key, components is not 1 … 4 (4 for rotations) or values are missing. bad_data if times do
// not increase strictly, a number is not finite, a value or control point is beyond 1e18, a tangent times the longest
// interval is beyond 1e18, or a rotation key's squared length differs from 1 by more than 1e-3. Cost: once over the
// keys.
MARROW_API Status check_curve(const Curve& curve);

// The value at `time_s`, clamped to the first and last key; one key is a constant.
//
// out: at least curve.components floats. Errors: bad_argument as in check_curve(), if `out` is too short, or time_s is
// not a number. Keys that check_curve() refuses with bad_data are safe but give garbage; all other keys give finite
// values. At a key's time the value is exactly the key's (a rotation's except for normalisation and sign). Cost: a
// binary search and some dozen operations.
MARROW_API Status evaluate_curve(const Curve& curve, float time_s, Span<float> out);

// The derivative of evaluate_curve() by time, per second. At an inner key it is that of the interval after the key;
// before the first and after the last key it is 0. Arguments, errors and cost as in evaluate_curve(). Also unsupported
// for rotations; and bad_data, with nothing written, if the result is not finite because keys are so far apart in so
// little time.
MARROW_API Status curve_velocity(const Curve& curve, float time_s, Span<float> out);

// Cubic splines: tangents at the keys such that the second derivative is continuous too, for any key intervals.
//
// keys: kind linear. out: curve_value_count(hermite, …) floats, which with the same times are a curve of kind hermite;
// it does not overlap the keys. natural_spline: the second derivative is zero at both ends. clamped_spline: the first
// derivative at the ends is given, `components` floats a second each. One key: tangents 0, or those given.
// Rotations are written with signs that make neighbours nearest; then the spline runs through the four components.
// Errors: as check_curve(keys); bad_argument also if kind is not linear or a span is too short; bad_data also if keys
// are so close in time or so far in value that a tangent is not finite. After bad_data `out` may hold garbage. Method:
// tridiagonal system of the tangents, diagonally dominant, solved by elimination without pivots (de Boor, A Practical
// Guide to Splines, chapter IV) in `out` alone. Cost: twice over the keys.
MARROW_API Status natural_spline(const Curve& keys, Span<float> out);
MARROW_API Status clamped_spline(const Curve& keys, Span<const float> first_velocity, Span<const float> last_velocity,
                                 Span<float> out);

// A Bézier curve of any degree at u, by de Casteljau's algorithm.
//
// points: degree + 1 points of `components` floats (1 … 4). scratch: at least points.size floats, overlapping nothing.
// out: at least `components`. u outside [0, 1] extrapolates. Errors: bad_argument if there is no point, points.size is
// no multiple of components, a span is too short, or u is not finite; bad_data if the result is not finite.
// Cost: degree · (degree + 1) / 2 interpolations.
MARROW_API Status bezier(Span<const float> points, std::uint32_t components, float u, Span<float> scratch,
                         Span<float> out);
// The same for unit quaternions; each is taken with the sign nearer to the one before it, and the result is normalised.
// bad_data also if the result has no direction, or is too long to be squared.
MARROW_API Status bezier_rotation(Span<const float> quaternions, float u, Span<float> scratch, Span<float> out);

// How a patch's points shape it.
enum class PatchBasis : std::uint8_t {
  catmull_rom,  // through its inner points: u, v = 0 … 1 lead from point (1, 1) to point (2, 2)
  bezier,       // through its corners: from point (0, 0) to point (3, 3)
};

// A bicubic patch over 4 × 4 points: the tensor product of two cubics.
//
// points: 16 · components floats, component by component within a point, points along u first, then v. out: at least
// `components` (1 … 4). Errors: bad_argument if a span is too short, the basis is unknown, or u or v is not finite;
// bad_data, with nothing written, if the result is not finite.
// Cost: 20 blends of four points.
MARROW_API Status bicubic_patch(PatchBasis basis, Span<const float> points, std::uint32_t components, float u, float v,
                                Span<float> out);

// Arc length: at which time to evaluate a curve to move along it at an even speed.
//
// The table holds the length of the path up to each of `steps` equal parts of every key interval.
struct ArcLength {
  std::uint32_t steps = 0;         // a key interval, at least 1
  Span<const float> lengths = {};  // arc_length_count() of them, ascending
};

// How many floats the table of a curve has.
constexpr std::size_t arc_length_count(std::size_t key_count, std::uint32_t steps) {
  return key_count == 0 ? 0 : (key_count - 1) * steps + 1;
}

// Measures `curve` once. out: arc_length_count() floats; the last is the length of all, in the unit of the values.
// Errors: as evaluate_curve(); unsupported for rotations (slerp is even as it is) and for kind step; bad_argument if
// `steps` is 0 or `out` too short; bad_data if a length is not finite. Three-point Gauss quadrature a step: exact for
// linear, and else of the order steps⁻⁶ where the path does not stop inside a step. Cost: 3 square roots a step.
MARROW_API Status make_arc_length(const Curve& curve, std::uint32_t steps, Span<float> out);

// The time at which `curve` has gone `distance`, clamped to the path; where the path rests, the end of the rest.
// Between two entries the length is taken as linear, so the point found is off along the path by at most
// A / (8 steps²), A being the largest second derivative by u in that key interval, plus rounding: twice the steps,
// a quarter of the error. Errors: bad_argument if the table is too short for this curve or `distance` is not a number.
// Cost: a binary search.
MARROW_API Status time_at_distance(const Curve& curve, const ArcLength& table, float distance, float& time_s);

// R. Penner's easings (Programming Macromedia Flash MX, 2002, chapter 7).
enum class Easing : std::uint8_t { linear, quad, cubic, quart, quint, sine, expo, circ, back, elastic, bounce };
// At which end a movement is eased.
enum class EaseMode : std::uint8_t { in, out, in_out };

// From 0 at u = 0 to 1 at u = 1, both exactly; u is clamped, and what is not a number counts as 0. back and elastic
// overshoot. out(u) = 1 - in(1 - u), in_out is the one, then the other at half size. As in Penner's, expo and elastic
// leave 0 (out: reach 1) with a jump of 1e-3 or less; back's overshoot is 1.70158, 1.525 times that for in_out;
// elastic's period is 0.3, 0.45 for in_out. Within 1e-6 of the closed forms. Unknown enumerators: linear.
MARROW_API float ease(Easing easing, EaseMode mode, float u);

// The timing function of CSS Easing Functions Level 1: the cubic Bézier curve (0, 0), (x1, y1), (x2, y2), (1, 1), y
// over x.
struct CubicBezierEase {
  float x1 = 0.25f, y1 = 0.1f, x2 = 0.25f, y2 = 1.0f;  // CSS "ease"
};

// y at x = u, with u clamped to [0, 1]. The point lies on the curve within 3e-7 in x (4e-7 (1 + |y1| + |y2|) in y):
// where the curve is steep, y is as uncertain as x is. Errors: bad_argument unless x1 and x2 are in [0, 1], y1 and y2
// finite and u a number. Newton's method within a shrinking bracket. Cost: about 5 steps, at most 40.
MARROW_API Status ease(const CubicBezierEase& curve, float u, float& out);

}  // namespace marrow
