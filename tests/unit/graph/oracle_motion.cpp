// Clips, phases and spaces of the oracle, on time lines that do not wrap.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "unit/graph/graph_rig.h"
#include "unit/graph/oracle.h"

namespace marrow::test::oracle {

const std::vector<Clip>& clips() {
  static const std::vector<Clip> all = [] {
    std::vector<Clip> out;
    for (const GraphClipMade& made : kGraphClips) {
      Clip& clip = out.emplace_back();
      clip.name = made.name;
      clip.duration_s = static_cast<double>(made.duration_s);
      clip.speed_m_s = static_cast<double>(made.way_m) / clip.duration_s;
      for (const double mark : made.marks) clip.marks.push_back(static_cast<double>(static_cast<float>(mark)));
      if (clip.marks.empty()) clip.marks = {0};
      for (const auto& [name, time_s] : made.events)
        clip.events.emplace_back(name, static_cast<double>(static_cast<float>(time_s)));
      clip.way_m = static_cast<double>(made.way_m);
      clip.turn_rad = static_cast<double>(made.turn_rad);
    }
    return out;
  }();
  return all;
}

Rigid operator*(const Rigid& a, const Rigid& b) {
  return {glm::normalize(a.turn * b.turn), a.way + a.turn * b.way};
}
namespace {
Rigid inverse(const Rigid& a) {
  const glm::dquat back = glm::conjugate(a.turn);
  return {back, -(back * a.way)};
}
// V of the exponential: way = V · screw's way.
glm::dmat3 way_of_turn(const glm::dvec3& turn) {
  const double angle = glm::length(turn);
  const glm::dmat3 k(0, turn.z, -turn.y, -turn.z, 0, turn.x, turn.y, -turn.x, 0);
  double a = 0.5 - angle * angle / 24, b = 1.0 / 6 - angle * angle / 120;
  if (angle > 1e-3) {
    a = (1 - std::cos(angle)) / (angle * angle);
    b = (angle - std::sin(angle)) / (angle * angle * angle);
  }
  return glm::dmat3(1.0) + a * k + b * (k * k);
}
}  // namespace

Screw logarithm(const Rigid& rigid) {
  glm::dquat q = rigid.turn;
  if (q.w < 0) q = -q;
  const glm::dvec3 axis(q.x, q.y, q.z);
  const double sine = glm::length(axis), angle = 2 * std::atan2(sine, q.w);
  Screw out;
  out.turn = sine > 1e-12 ? axis * (angle / sine) : 2.0 * axis;
  out.way = glm::inverse(way_of_turn(out.turn)) * rigid.way;
  return out;
}
Rigid exponential(const Screw& screw) {
  const double angle = glm::length(screw.turn);
  Rigid out;
  if (angle > 1e-14) out.turn = glm::angleAxis(angle, screw.turn / angle);
  out.way = way_of_turn(screw.turn) * screw.way;
  return out;
}

double folded(const Clip& clip, Play play, double x) {
  const double d = clip.duration_s;
  if (play == Play::once) return std::clamp(x, 0.0, d);
  if (play == Play::loop) return x - d * std::floor(x / d);
  const double y = x - 2 * d * std::floor(x / (2 * d));
  return y <= d ? y : 2 * d - y;
}

namespace {
// M(t): the arc as 97 keys have it, straight lines and nlerp between them.
Rigid moved(const Clip& clip, double t) {
  Rigid out;
  const double share = t / clip.duration_s;
  if (clip.turn_rad == 0) {
    out.way.z = share * clip.way_m;
    return out;
  }
  const double i = std::min(95.0, std::floor(share * 96)), part = share * 96 - i, radius = clip.way_m / clip.turn_rad;
  const auto turn = [&](double k) { return clip.turn_rad * k / 96; };
  const auto way = [&](double k) {
    return glm::dvec3(radius * (1 - std::cos(turn(k))), 0, radius * std::sin(turn(k)));
  };
  const auto q = [&](double k) { return glm::dquat(std::cos(turn(k) / 2), 0, std::sin(turn(k) / 2), 0); };
  out.turn = glm::normalize(q(i) * (1 - part) + q(i + 1) * part);
  out.way = way(i) * (1 - part) + way(i + 1) * part;
  return out;
}
Rigid moved_on_line(const Clip& clip, Play play, double x) {
  if (play != Play::loop) return moved(clip, folded(clip, play, x));
  const double rounds = std::floor(x / clip.duration_s);
  Rigid round = moved(clip, clip.duration_s);
  if (rounds < 0) round = inverse(round);
  Rigid out;
  for (double i = 0; i < std::abs(rounds); ++i) out = out * round;
  return out * moved(clip, x - rounds * clip.duration_s);
}
}  // namespace

Screw root_between(const Clip& clip, Play play, double x0, double x1) {
  if (x0 == x1 || (clip.way_m == 0 && clip.turn_rad == 0)) return {};
  if (play == Play::loop) {  // the same place in an early round
    const double rounds = std::floor(x0 / clip.duration_s) * clip.duration_s;
    x0 -= rounds;
    x1 -= rounds;
  }
  return logarithm(inverse(moved_on_line(clip, play, x0)) * moved_on_line(clip, play, x1));
}

void count_events(const Clip& clip, Play play, double x0, double x1, bool with_begin, std::map<std::string, int>& out) {
  const double d = clip.duration_s, low = std::min(x0, x1), high = std::max(x0, x1);
  const auto is_met = [&](double moment) {
    if (moment == x0) return with_begin;
    return x1 > x0 ? moment > x0 && moment <= x1 : moment >= x1 && moment < x0;
  };
  const double period = play == Play::ping_pong ? 2 * d : d;
  const double first = play == Play::once ? 0 : std::floor(low / period) - 1;
  const double last = play == Play::once ? 0 : std::floor(high / period) + 1;
  for (const auto& [name, time_s] : clip.events) {
    int count = 0;
    for (double k = first; k <= last; ++k) {
      count += is_met(time_s + k * period) ? 1 : 0;
      if (play == Play::ping_pong && time_s > 0 && time_s < d) count += is_met(k * period - time_s) ? 1 : 0;
    }
    if (count > 0) out[name] += count;
  }
}

namespace {
long marks_of(const Clip& clip) {
  return static_cast<long>(clip.marks.size());
}
double mark(const Clip& clip, long segment) {
  const long n = marks_of(clip), round = segment >= 0 ? segment / n : -((n - 1 - segment) / n);
  return clip.marks[static_cast<std::size_t>(segment - round * n)] + static_cast<double>(round) * clip.duration_s;
}
}  // namespace

double segment_s(const Clip& clip, long segment) {
  return mark(clip, segment + 1) - mark(clip, segment);
}
double time_at(const Clip& clip, const Place& place) {
  return mark(clip, place.segment) + place.share * segment_s(clip, place.segment);
}
Place place_at(const Clip& clip, double time_s) {
  long segment = marks_of(clip) - 1;
  if (time_s < clip.marks[0]) time_s += clip.duration_s;
  while (segment > 0 && mark(clip, segment) > time_s) --segment;
  return {segment, (time_s - mark(clip, segment)) / segment_s(clip, segment)};
}

void go_on(const std::vector<std::pair<const Clip*, double>>& group, double dt_s, Place& place) {
  while (dt_s > 0) {
    double whole = 0, weight = 0;
    for (const auto& [clip, w] : group) {
      whole += w * segment_s(*clip, place.segment);
      weight += w;
    }
    const double length = whole / weight, left = (1 - place.share) * length;
    if (dt_s < left) {
      place.share += dt_s / length;
      return;
    }
    dt_s -= left;
    ++place.segment;
    place.share = 0;
  }
}

std::vector<double> line(const std::vector<Point>& points, double at) {
  std::vector<double> out(points.size(), 0);
  if (at <= points.front().x) {
    out.front() = 1;
    return out;
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (at > points[i].x) continue;
    out[i] = (at - points[i - 1].x) / (points[i].x - points[i - 1].x);
    out[i - 1] = 1 - out[i];
    return out;
  }
  out.back() = 1;
  return out;
}

std::vector<double> matched(const Graph& graph, const Node& space, double speed, double& rate) {
  long cycle = 1;
  std::vector<const Clip*> all;
  for (const Point& p : space.points) {
    all.push_back(&clips()[graph.nodes[static_cast<std::size_t>(p.node)].clip]);
    cycle = std::lcm(cycle, marks_of(*all.back()));
  }
  std::vector<double> out(all.size(), 0);
  const double v = std::max(0.0, speed);
  rate = 1;
  if (v <= space.points.front().x) {
    out.front() = 1;
    if (space.points.front().x > 0) rate = v / space.points.front().x;
    return out;
  }
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (v > space.points[i].x) continue;
    const auto time = [&](std::size_t k) {
      return all[k]->duration_s * static_cast<double>(cycle) / static_cast<double>(marks_of(*all[k]));
    };
    // (1 - w) s0 + w s1 = v ((1 - w) t0 + w t1): way and time of a cycle.
    const double s0 = space.points[i - 1].x * time(i - 1), s1 = space.points[i].x * time(i);
    out[i] = (v * time(i - 1) - s0) / (s1 - s0 - v * (time(i) - time(i - 1)));
    out[i - 1] = 1 - out[i];
    return out;
  }
  out.back() = 1;
  rate = v / space.points.back().x;
  return out;
}

namespace {
using Flat = glm::dvec2;
double cross(const Flat& a, const Flat& b) {
  return a.x * b.y - a.y * b.x;
}
Flat flat(const Point& p) {
  return {p.x, p.y};
}
}  // namespace

// Delaunay's, by its definition: no other point in the circle around three.
std::vector<std::array<std::size_t, 3>> triangulated(const std::vector<Point>& points) {
  std::vector<std::array<std::size_t, 3>> out;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        const Flat a = flat(points[i]), b = flat(points[j]) - a, c = flat(points[k]) - a;
        const double area = 2 * cross(b, c);
        if (area == 0) continue;
        const double bb = glm::dot(b, b), cc = glm::dot(c, c);
        const Flat middle = Flat(c.y * bb - b.y * cc, b.x * cc - c.x * bb) / area;
        bool is_empty = true;
        for (std::size_t o = 0; o < n; ++o)
          if (o != i && o != j && o != k && glm::distance(flat(points[o]) - a, middle) < glm::length(middle))
            is_empty = false;
        if (!is_empty) continue;
        if (area > 0)
          out.push_back({i, j, k});
        else
          out.push_back({i, k, j});
      }
  return out;
}

std::vector<double> plane(const Node& space, double x, double y) {
  std::vector<double> best(space.points.size(), 0);
  double nearest = 1e300;
  const Flat p(x, y);
  for (const auto& t : space.triangles) {
    const std::array<Flat, 3> c = {flat(space.points[t[0]]), flat(space.points[t[1]]), flat(space.points[t[2]])};
    std::array<double, 3> w{};
    for (std::size_t i = 0; i < 3; ++i) w[i] = cross(c[(i + 1) % 3] - p, c[(i + 2) % 3] - p);
    const double area = w[0] + w[1] + w[2];
    double far = 0;
    if (w[0] < 0 || w[1] < 0 || w[2] < 0) {  // the nearest point of the edges
      far = 1e300;
      std::array<double, 3> on{};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = i, b = (i + 1) % 3;
        const double s = std::clamp(glm::dot(p - c[a], c[b] - c[a]) / glm::dot(c[b] - c[a], c[b] - c[a]), 0.0, 1.0);
        const double distance = glm::distance(p, c[a] + s * (c[b] - c[a]));
        if (distance >= far) continue;
        far = distance;
        on = {};
        on[a] = (1 - s) * area;
        on[b] = s * area;
      }
      w = on;
    }
    if (far >= nearest) continue;
    nearest = far;
    std::fill(best.begin(), best.end(), 0);
    for (std::size_t i = 0; i < 3; ++i) best[t[i]] = w[i] / area;
  }
  return best;
}

}  // namespace marrow::test::oracle
