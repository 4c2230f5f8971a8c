// Blend spaces: a number or two of a game → weights of clips that stand at points, and the speed that it asks for.
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/api.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

// Weights of points on a line: the two beside `at` share them, and beyond an end that point has all.
//
// points: strictly ascending. weights: at least points.size; the first points.size are written. Their sum is 1 within
// 1e-6; a point has exactly 1 where it stands; they are continuous in `at`.
// Errors: bad_argument if there is no point, they do not ascend or are not finite, `at` is no number, or a span is too
// short; nothing is written. Cost: over the points.
MARROW_API Status line_weights(Span<const float> points, float at, Span<float> weights);

// A point of a plane.
struct PlanePoint {
  float x = 0, y = 0;  // at most 1e12
};
// Three points of it, counter-clockwise.
struct PlaneTriangle {
  std::uint32_t corners[3] = {};  // which points
};

// Weights of points in a plane, over triangles that cover what they span, as Delaunay's do: inside a triangle its
// corners share the weight by areas. Outside of all the nearest point of the triangles counts.
//
// weights: at least points.size; the first points.size are written. Their sum is 1 within 1e-6; a point that is a
// corner has exactly 1 where it stands. Weights are continuous where triangles meet in whole edges and what they cover
// is convex. Errors: bad_argument if there is no triangle, one has a corner that is no point, or is not
// counter-clockwise, `at` or a point is not finite or beyond 1e12, or a span is too short; nothing is written. Cost:
// over the triangles; outside of all of them some 20 operations an edge.
MARROW_API Status plane_weights(Span<const PlanePoint> points, Span<const PlaneTriangle> triangles,
                                const PlanePoint& at, Span<float> weights);

// A clip that moves over the ground, in a group of clips that go by one phase (phase.h).
struct SpeedPoint {
  float speed_m_s = 0;   // ≥ 0; ClipMotion::speed_m_s
  float duration_s = 0;  // > 0; of as many segments as the others' durations are
};

// Weights of clips in step, such that their blend goes at exactly speed_m_s.
//
// Linear weights miss it, as the slower clip's steps take longer. With strides s = speed · duration, the share of the
// faster neighbour is w = (v t0 - s0) / ((s1 - s0) - v (t1 - t0)). rate: what to multiply dt_s by. It is 1 between the
// slowest and the fastest clip. Below the slowest, and above the fastest, that clip has all the weight, and plays
// slower, or faster; a slowest clip of speed 0 keeps rate 1.
//
// points: by speed, strictly ascending. speed_m_s: below 0 counts as 0. weights: at least points.size; the first
// points.size are written. Errors: bad_argument if there is no point, they are not as said, or a number is not finite
// or beyond 1e12, or the rate is not finite; nothing is written. Cost: over the points.
MARROW_API Status match_speed(Span<const SpeedPoint> points, float speed_m_s, Span<float> weights, float& rate);

}  // namespace marrow
