#include "marrow/blend_space.h"

#include "core/check.h"
#include "math/finite.h"

namespace marrow {
namespace {

constexpr float kFarthestPoint = 1e12f;

double in_double(float x) {
  return static_cast<double>(x);
}

void clear(Span<float> weights, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) weights[i] = 0;
}

// Gives `share` of all to the point after `first`.
void share_two(Span<float> weights, std::size_t first, double share) {
  weights[first] = static_cast<float>(1.0 - share);
  weights[first + 1] = static_cast<float>(share);
}

// The plane in double: what is left and right of a line is exact then but for the last bits.
struct Point2 {
  double x, y;
};
Point2 operator-(const Point2& a, const Point2& b) {
  return {a.x - b.x, a.y - b.y};
}
double dot2(const Point2& a, const Point2& b) {
  return a.x * b.x + a.y * b.y;
}
// Twice the area to the left of a before b.
double area2(const Point2& a, const Point2& b) {
  return a.x * b.y - a.y * b.x;
}

struct Corners {
  Point2 at[3];
};
Corners corners_of(Span<const PlanePoint> points, const PlaneTriangle& t) {
  Corners out;
  for (int i = 0; i < 3; ++i) out.at[i] = {in_double(points[t.corners[i]].x), in_double(points[t.corners[i]].y)};
  return out;
}

// The areas across from the three corners; false outside.
bool is_inside(const Corners& c, const Point2& p, double (&areas)[3]) {
  for (int i = 0; i < 3; ++i) {
    const Point2 &a = c.at[(i + 1) % 3], &b = c.at[(i + 2) % 3];
    areas[i] = area2(b - a, p - a);
  }
  return areas[0] >= 0 && areas[1] >= 0 && areas[2] >= 0;
}

void share_triangle(const PlaneTriangle& t, const double (&areas)[3], Span<float> weights) {
  const double whole = areas[0] + areas[1] + areas[2];
  for (int i = 0; i < 3; ++i) weights[t.corners[i]] = static_cast<float>(areas[i] / whole);
}

// The nearest point of all edges. Between two triangles it is theirs, so that rounding leaves no gap.
void share_nearest(Span<const PlanePoint> points, Span<const PlaneTriangle> triangles, const Point2& p,
                   Span<float> weights) {
  double least = 0, share = 0;
  std::uint32_t from = 0, to = 0;
  bool found = false;
  for (const PlaneTriangle& t : triangles) {
    const Corners c = corners_of(points, t);
    for (int i = 0; i < 3; ++i) {
      const Point2 edge = c.at[(i + 1) % 3] - c.at[i], way = p - c.at[i];
      const double along = dot2(way, edge) / dot2(edge, edge), u = along < 0 ? 0 : along < 1 ? along : 1;
      const Point2 off = {way.x - u * edge.x, way.y - u * edge.y};
      const double squared = dot2(off, off);
      if (found && !(squared < least)) continue;
      found = true;
      least = squared, share = u;
      from = t.corners[i], to = t.corners[(i + 1) % 3];
    }
  }
  weights[from] = static_cast<float>(1.0 - share);
  weights[to] = static_cast<float>(share);
}

BadCall check_plane(Span<const PlanePoint> points, Span<const PlaneTriangle> triangles) {
  MARROW_CHECK(holds(points));
  MARROW_CHECK(!triangles.empty() && holds(triangles));
  for (const PlanePoint& p : points)
    MARROW_CHECK(within(p.x, -kFarthestPoint, kFarthestPoint) && within(p.y, -kFarthestPoint, kFarthestPoint));
  for (const PlaneTriangle& t : triangles) {
    for (const std::uint32_t corner : t.corners) MARROW_CHECK(corner < points.size);
    const Corners c = corners_of(points, t);
    MARROW_CHECK(area2(c.at[1] - c.at[0], c.at[2] - c.at[0]) > 0 && "counter-clockwise triangles");
  }
  return {};
}

bool good_speeds(Span<const SpeedPoint> points) {
  float last = -1;
  for (const SpeedPoint& p : points) {
    if (!within(p.speed_m_s, 0, kFarthestPoint) || !(last < p.speed_m_s)) return false;
    if (!(p.duration_s > 0) || !(p.duration_s <= kFarthestPoint)) return false;
    last = p.speed_m_s;
  }
  return true;
}

}  // namespace

Status line_weights(Span<const float> points, float at, Span<float> weights) {
  MARROW_REQUIRE(!points.empty() && holds(points));
  MARROW_REQUIRE(holds(weights, points.size));
  MARROW_REQUIRE(is_number(at));
  for (std::size_t i = 0; i < points.size; ++i)
    MARROW_REQUIRE(is_finite(points[i]) && (i == 0 || points[i - 1] < points[i]) && "points that ascend");
  clear(weights, points.size);
  const std::size_t last = points.size - 1;
  std::size_t i = 0;
  while (i < last && points[i + 1] <= at) ++i;
  if (i == last || !(points[0] < at)) {
    weights[i] = 1;
    return Status::ok;
  }
  share_two(weights, i, (in_double(at) - in_double(points[i])) / (in_double(points[i + 1]) - in_double(points[i])));
  return Status::ok;
}

Status plane_weights(Span<const PlanePoint> points, Span<const PlaneTriangle> triangles, const PlanePoint& at,
                     Span<float> weights) {
  MARROW_REQUIRE_GOOD(check_plane(points, triangles));
  MARROW_REQUIRE(holds(weights, points.size));
  MARROW_REQUIRE(within(at.x, -kFarthestPoint, kFarthestPoint) && within(at.y, -kFarthestPoint, kFarthestPoint));
  clear(weights, points.size);
  const Point2 p = {in_double(at.x), in_double(at.y)};
  double areas[3];
  for (const PlaneTriangle& t : triangles) {
    if (!is_inside(corners_of(points, t), p, areas)) continue;
    share_triangle(t, areas, weights);
    return Status::ok;
  }
  share_nearest(points, triangles, p, weights);
  return Status::ok;
}

Status match_speed(Span<const SpeedPoint> points, float speed_m_s, Span<float> weights, float& rate) {
  MARROW_REQUIRE(!points.empty() && holds(points));
  MARROW_REQUIRE(holds(weights, points.size));
  MARROW_REQUIRE(is_finite(speed_m_s));
  MARROW_REQUIRE(good_speeds(points));
  const std::size_t last = points.size - 1;
  const float speed = speed_m_s < 0 ? 0 : speed_m_s;
  std::size_t i = 0;
  while (i < last && points[i + 1].speed_m_s <= speed) ++i;
  const bool beyond = i == last || !(points[0].speed_m_s < speed);
  const double own = in_double(points[i].speed_m_s), times = beyond && own > 0 ? in_double(speed) / own : 1.0;
  MARROW_REQUIRE(times < 1e38 && "a speed that the clips come near");
  clear(weights, points.size);
  rate = static_cast<float>(times);
  if (beyond) {
    weights[i] = 1;
    return Status::ok;
  }
  // (v - v0) t0 / ((v1 - v) t1 + (v - v0) t0), which is the same without a difference of products.
  const SpeedPoint &a = points[i], &b = points[i + 1];
  const double more = (in_double(speed) - own) * in_double(a.duration_s);
  const double less = (in_double(b.speed_m_s) - in_double(speed)) * in_double(b.duration_s);
  share_two(weights, i, more / (less + more));
  return Status::ok;
}

}  // namespace marrow
