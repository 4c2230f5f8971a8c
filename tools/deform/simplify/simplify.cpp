#include "deform/simplify/simplify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>

#include "common/distinct.h"
#include "deform/simplify/quadric.h"

namespace marrow::deform {
namespace {

constexpr double kBorderWeight = 1;      // of planes through borders and seams, per length
constexpr double kDrift = 1e-4;          // of distances from points, beside those from planes: where all is flat
constexpr std::size_t kMostAround = 64;  // triangles at a point that an edge collapses to or from: bounds the time
constexpr double kLeastCosine = 0.2;     // of a bind-pose normal before and after a collapse

using Corners = std::array<std::uint32_t, 3>;

// One way to collapse an edge: `removed` goes to `kept`, which goes `t` of the way back to it.
struct Collapse {
  double cost = 0;
  std::uint32_t removed = 0, kept = 0;
  double t = 0;
  std::uint32_t removed_stamp = 0, kept_stamp = 0;
};

struct Later {
  bool operator()(const Collapse& a, const Collapse& b) const {
    return std::tie(a.cost, a.removed, a.kept) > std::tie(b.cost, b.removed, b.kept);
  }
};

enum class Kind : std::uint8_t { free, line, fixed };

class Simplifier {
 public:
  Simplifier(const SeamedSurface& surface, const std::vector<Shape>& shapes, Placement placement);
  void reduce_to(std::size_t target);
  SimplerSurface result() const;

 private:
  std::uint32_t point(std::uint32_t triangle, std::size_t corner) const {
    return surface_.point_of[triangles_[triangle][corner]];
  }
  bool has(std::uint32_t triangle, std::uint32_t p) const {
    return point(triangle, 0) == p || point(triangle, 1) == p || point(triangle, 2) == p;
  }
  std::uint32_t vertex_at(std::uint32_t triangle, std::uint32_t p) const {
    const Corners& c = triangles_[triangle];
    return surface_.point_of[c[0]] == p ? c[0] : surface_.point_of[c[1]] == p ? c[1] : c[2];
  }
  std::uint32_t chart_at(std::uint32_t triangle, std::uint32_t p) const {
    return surface_.chart_of[vertex_at(triangle, p)];
  }
  glm::dvec3& x(std::uint32_t p, std::size_t shape) { return x_[p * weights_.size() + shape]; }
  const glm::dvec3& x(std::uint32_t p, std::size_t shape) const { return x_[p * weights_.size() + shape]; }

  void place(const std::vector<Shape>& shapes);
  void classify();
  bool one_fan(std::uint32_t p) const;
  void add_quadrics();
  void add_border(std::uint32_t a, std::uint32_t b, std::uint32_t triangle);
  std::vector<std::uint32_t> neighbours(std::uint32_t p) const;
  std::vector<std::uint32_t> shared(std::uint32_t a, std::uint32_t b) const;
  bool may_remove(std::uint32_t removed, std::uint32_t kept) const;
  bool keeps_topology(std::uint32_t removed, std::uint32_t kept, const std::vector<std::uint32_t>& both) const;
  bool may_blend(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t nearest_vertex(std::uint32_t vertex, std::uint32_t p, std::uint32_t chart) const;
  bool flips(const Collapse& c) const;
  bool flips_around(std::uint32_t p, std::uint32_t other, const Collapse& c) const;
  double cost(std::uint32_t removed, std::uint32_t kept, double t) const;
  void consider(std::uint32_t a, std::uint32_t b);
  void consider_all();
  void collapse(const Collapse& c);

  const SeamedSurface& surface_;
  std::vector<Corners> triangles_;
  std::vector<char> alive_;  // a triangle
  std::size_t alive_count_ = 0;
  std::vector<double> weights_;  // a shape
  std::vector<glm::dvec3> x_;    // a point and shape; the shape's centroid is 0
  std::vector<Quadric> quadrics_;
  std::vector<std::vector<std::uint32_t>> around_;  // a point: its triangles
  std::vector<Kind> kind_;
  std::vector<char> border_;
  std::vector<Combination> made_of_;  // a vertex
  std::vector<std::uint32_t> home_, stamp_;
  Placement placement_;
  std::priority_queue<Collapse, std::vector<Collapse>, Later> queue_;
};

Simplifier::Simplifier(const SeamedSurface& surface, const std::vector<Shape>& shapes, Placement placement)
    : surface_(surface), placement_(placement) {
  const std::size_t points = shapes.front().positions.size();
  around_.resize(points);
  for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
    const Corners c = {surface.indices[i], surface.indices[i + 1], surface.indices[i + 2]};
    const std::uint32_t p[] = {surface_.point_of[c[0]], surface_.point_of[c[1]], surface_.point_of[c[2]]};
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
    for (const std::uint32_t at : p) around_[at].push_back(static_cast<std::uint32_t>(triangles_.size()));
    triangles_.push_back(c);
  }
  alive_.assign(triangles_.size(), 1);
  alive_count_ = triangles_.size();
  for (std::uint32_t v = 0; v < surface_.point_of.size(); ++v) made_of_.push_back({{v, 1.0}});
  home_.resize(points);
  std::iota(home_.begin(), home_.end(), 0u);
  stamp_.assign(points, 0);
  place(shapes);
  classify();
  add_quadrics();
}

// Each shape round its centroid, in diagonals of the first.
void Simplifier::place(const std::vector<Shape>& shapes) {
  const std::size_t points = around_.size();
  x_.resize(points * shapes.size());
  double sum = 0;
  for (const Shape& s : shapes) sum += s.weight;
  for (const Shape& s : shapes) weights_.push_back(s.weight / sum);
  double scale = 0;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Positions& from = shapes[k].positions;
    glm::dvec3 mean(0), low(from.front()), high(from.front());
    for (const glm::dvec3& v : from) {
      mean += v / static_cast<double>(points);
      low = glm::min(low, v);
      high = glm::max(high, v);
    }
    if (k == 0) scale = glm::length(high - low) > 0 ? 1 / glm::length(high - low) : 1;
    for (std::uint32_t p = 0; p < points; ++p) x(p, k) = (from[p] - mean) * scale;
  }
}

// Whether the triangles round a point form one disc or half-disc.
bool Simplifier::one_fan(std::uint32_t p) const {
  std::map<std::uint32_t, std::vector<std::uint32_t>> beside;  // opposite edges
  for (const std::uint32_t t : around_[p]) {
    std::vector<std::uint32_t> others;
    for (std::size_t c = 0; c < 3; ++c)
      if (point(t, c) != p) others.push_back(point(t, c));
    beside[others[0]].push_back(others[1]);
    beside[others[1]].push_back(others[0]);
  }
  std::set<std::uint32_t> seen;
  std::vector<std::uint32_t> open = {beside.begin()->first};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    if (beside[at].size() > 2) return false;
    if (!seen.insert(at).second) continue;
    for (const std::uint32_t next : beside[at]) open.push_back(next);
  }
  return seen.size() == beside.size();
}

void Simplifier::classify() {
  const std::size_t points = around_.size();
  kind_.assign(points, Kind::free);
  border_.assign(points, 0);
  std::map<std::tuple<double, double, double>, std::uint32_t> places;
  for (std::uint32_t p = 0; p < points; ++p) {
    if (around_[p].empty()) continue;
    std::set<std::uint32_t> charts, beside;
    for (const std::uint32_t t : around_[p]) {
      charts.insert(chart_at(t, p));
      for (std::size_t c = 0; c < 3; ++c)
        if (point(t, c) != p) beside.insert(point(t, c));
    }
    border_[p] = beside.size() > around_[p].size();
    if (charts.size() > 1 || border_[p] != 0) kind_[p] = Kind::line;
    if (!one_fan(p)) kind_[p] = Kind::fixed;
    const auto [at, is_new] = places.try_emplace({x(p, 0).x, x(p, 0).y, x(p, 0).z}, p);
    if (!is_new) kind_[p] = kind_[at->second] = Kind::fixed;
  }
}

void Simplifier::add_quadrics() {
  const std::size_t shapes = weights_.size();
  quadrics_.resize(x_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const std::uint32_t p[] = {point(t, 0), point(t, 1), point(t, 2)};
    for (std::size_t k = 0; k < shapes; ++k) {
      const glm::dvec3 n = glm::cross(x(p[1], k) - x(p[0], k), x(p[2], k) - x(p[0], k));
      const double twice = glm::length(n);
      if (!(twice > 0)) continue;
      const double weight = weights_[k] * std::sqrt(twice / 2);
      for (const std::uint32_t at : p) {
        Quadric& q = quadrics_[at * shapes + k];
        q.add_plane(n / twice, x(at, k), weight);
        q.add_point(x(at, k), kDrift * weight);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = p[c], b = p[(c + 1) % 3];
      if (kind_[a] == Kind::free || kind_[b] == Kind::free) continue;
      const std::vector<std::uint32_t> both = shared(a, b);
      const bool seam = both.size() == 2 &&
                        (chart_at(both[0], a) != chart_at(both[1], a) || chart_at(both[0], b) != chart_at(both[1], b));
      if (both.size() == 1 || seam) add_border(a, b, t);
    }
  }
}

// The plane through an edge of a triangle, upright on it.
void Simplifier::add_border(std::uint32_t a, std::uint32_t b, std::uint32_t triangle) {
  const std::size_t shapes = weights_.size();
  const std::uint32_t p[] = {point(triangle, 0), point(triangle, 1), point(triangle, 2)};
  for (std::size_t k = 0; k < shapes; ++k) {
    const glm::dvec3 edge = x(b, k) - x(a, k);
    const glm::dvec3 n = glm::cross(edge, glm::cross(x(p[1], k) - x(p[0], k), x(p[2], k) - x(p[0], k)));
    const double length = glm::length(n);
    if (!(length > 0)) continue;
    const double weight = kBorderWeight * weights_[k] * glm::length(edge);
    quadrics_[a * shapes + k].add_plane(n / length, x(a, k), weight);
    quadrics_[b * shapes + k].add_plane(n / length, x(a, k), weight);
  }
}

std::vector<std::uint32_t> Simplifier::neighbours(std::uint32_t p) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t t : around_[p])
    for (std::size_t c = 0; c < 3; ++c)
      if (point(t, c) != p) out.push_back(point(t, c));
  tools::make_distinct(out);
  return out;
}

std::vector<std::uint32_t> Simplifier::shared(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t t : around_[a])
    if (has(t, b)) out.push_back(t);
  return out;
}

// The link condition: what the ends have in common is what the edge's own triangles span.
bool Simplifier::keeps_topology(std::uint32_t removed, std::uint32_t kept,
                                const std::vector<std::uint32_t>& both) const {
  const std::vector<std::uint32_t> a = neighbours(removed), b = neighbours(kept);
  std::vector<std::uint32_t> common;
  std::ranges::set_intersection(a, b, std::back_inserter(common));
  if (common.size() != both.size()) return false;
  for (const std::uint32_t t : around_[removed]) {
    if (has(t, kept)) continue;
    std::size_t held = 0;
    for (std::size_t c = 0; c < 3; ++c) held += std::ranges::binary_search(common, point(t, c)) ? 1u : 0u;
    if (held < 2) continue;
    // (removed, u, v): with (kept, u, v) there would be two of it.
    for (const std::uint32_t other : around_[kept]) {
      std::size_t same = 0;
      for (std::size_t c = 0; c < 3; ++c) same += point(t, c) != removed && has(other, point(t, c)) ? 1u : 0u;
      if (same == 2) return false;
    }
  }
  return true;
}

bool Simplifier::may_remove(std::uint32_t removed, std::uint32_t kept) const {
  if (kind_[removed] == Kind::fixed || std::max(around_[removed].size(), around_[kept].size()) > kMostAround)
    return false;
  const std::vector<std::uint32_t> both = shared(removed, kept);
  if (both.empty() || both.size() > 2 || (border_[removed] != 0 && both.size() != 1)) return false;
  if (both.size() == around_[removed].size() && both.size() == around_[kept].size()) return false;  // all there is
  // Each chart of the one goes on as just one of the other.
  if (both.size() == 2 && chart_at(both[0], removed) == chart_at(both[1], removed) &&
      chart_at(both[0], kept) != chart_at(both[1], kept))
    return false;
  for (const std::uint32_t t : around_[removed])
    if (std::ranges::none_of(both, [&](std::uint32_t b) { return chart_at(b, removed) == chart_at(t, removed); }))
      return false;
  return keeps_topology(removed, kept, both);
}

bool Simplifier::may_blend(std::uint32_t a, std::uint32_t b) const {
  for (const std::uint32_t p : {a, b})
    for (const std::uint32_t t : around_[p])
      if (kind_[p] != Kind::free || vertex_at(t, p) != vertex_at(around_[p].front(), p)) return false;
  return true;
}

// Of a chart at a point, the one whose normal is most like another vertex's.
std::uint32_t Simplifier::nearest_vertex(std::uint32_t vertex, std::uint32_t p, std::uint32_t chart) const {
  std::uint32_t best = kNoHome;
  double most = 0;
  for (const std::uint32_t t : around_[p]) {
    const std::uint32_t v = vertex_at(t, p);
    if (surface_.chart_of[v] != chart) continue;
    const double alike = glm::dot(surface_.normals[v], surface_.normals[vertex]);
    if (best != kNoHome && (alike < most || (alike == most && v >= best))) continue;
    best = v;
    most = alike;
  }
  return best;
}

bool Simplifier::flips_around(std::uint32_t p, std::uint32_t other, const Collapse& c) const {
  for (const std::uint32_t t : around_[p]) {
    if (has(t, other)) continue;
    for (std::size_t k = 0; k < weights_.size(); ++k) {
      glm::dvec3 at[3];
      for (std::size_t i = 0; i < 3; ++i) at[i] = x(point(t, i), k);
      const glm::dvec3 before = glm::cross(at[1] - at[0], at[2] - at[0]);
      for (std::size_t i = 0; i < 3; ++i)
        if (point(t, i) == p) at[i] = x(c.kept, k) + (x(c.removed, k) - x(c.kept, k)) * c.t;
      const glm::dvec3 after = glm::cross(at[1] - at[0], at[2] - at[0]);
      const double a = glm::dot(before, before), b = glm::dot(after, after);
      const double least = k == 0 ? kLeastCosine : 0;
      if (a > 1e-24 && glm::dot(before, after) <= least * std::sqrt(a * b)) return true;
    }
  }
  return false;
}

bool Simplifier::flips(const Collapse& c) const {
  return flips_around(c.removed, c.kept, c) || (c.t > 0 && flips_around(c.kept, c.removed, c));
}

double Simplifier::cost(std::uint32_t removed, std::uint32_t kept, double t) const {
  const std::size_t shapes = weights_.size();
  double sum = 0;
  for (std::size_t k = 0; k < shapes; ++k) {
    const glm::dvec3 at = x(kept, k) + (x(removed, k) - x(kept, k)) * t;
    sum += quadrics_[removed * shapes + k].at(at) + quadrics_[kept * shapes + k].at(at);
  }
  return std::max(sum, 0.0);
}

// Puts the cheapest way in which an edge may collapse into the queue, if there is one.
void Simplifier::consider(std::uint32_t a, std::uint32_t b) {
  if (a > b) std::swap(a, b);
  const double at_a = cost(b, a, 0), at_b = cost(b, a, 1);
  std::vector<Collapse> ways;
  if (may_remove(b, a)) {
    ways.push_back({at_a, b, a, 0});
    if (placement_ == Placement::line && may_blend(a, b)) {
      const double half = cost(b, a, 0.5), curve = 2 * (at_a + at_b) - 4 * half;
      const double t = curve > 0 ? std::clamp((at_a - at_b + curve) / (2 * curve), 0.0, 1.0) : 0.5;
      ways.push_back({cost(b, a, t), b, a, t});
    }
  }
  if (may_remove(a, b)) ways.push_back({at_b, a, b, 0});
  std::ranges::stable_sort(ways, {}, &Collapse::cost);
  for (Collapse& way : ways) {
    if (flips(way)) continue;
    way.removed_stamp = stamp_[way.removed];
    way.kept_stamp = stamp_[way.kept];
    queue_.push(way);
    return;
  }
}

void Simplifier::consider_all() {
  queue_ = {};
  for (std::uint32_t p = 0; p < around_.size(); ++p)
    for (const std::uint32_t other : neighbours(p))
      if (p < other) consider(p, other);
}

void Simplifier::collapse(const Collapse& c) {
  const std::size_t shapes = weights_.size();
  const std::vector<std::uint32_t> both = shared(c.removed, c.kept);
  std::map<std::uint32_t, std::uint32_t> charts, vertices;
  for (const std::uint32_t t : both) charts[chart_at(t, c.removed)] = chart_at(t, c.kept);
  for (const std::uint32_t t : around_[c.removed]) {
    const std::uint32_t v = vertex_at(t, c.removed);
    if (!vertices.contains(v)) vertices[v] = nearest_vertex(v, c.kept, charts.at(surface_.chart_of[v]));
  }
  if (c.t > 0)
    for (const auto& [from, to] : vertices) made_of_[to] = blend(made_of_[to], made_of_[from], c.t);
  for (const std::uint32_t t : both) {
    alive_[t] = 0;
    --alive_count_;
    for (std::size_t i = 0; i < 3; ++i) std::erase(around_[point(t, i)], t);
  }
  for (const std::uint32_t t : around_[c.removed]) {
    for (std::uint32_t& v : triangles_[t])
      if (surface_.point_of[v] == c.removed) v = vertices.at(v);
    around_[c.kept].push_back(t);
  }
  around_[c.removed].clear();
  for (std::size_t k = 0; k < shapes; ++k) {
    x(c.kept, k) += (x(c.removed, k) - x(c.kept, k)) * c.t;
    quadrics_[c.kept * shapes + k] += quadrics_[c.removed * shapes + k];
  }
  home_[c.removed] = c.kept;
  ++stamp_[c.removed];
  ++stamp_[c.kept];
  for (const std::uint32_t p : neighbours(c.kept)) consider(c.kept, p);
}

void Simplifier::reduce_to(std::size_t target) {
  // What could not collapse may once its neighbours have.
  for (std::size_t before = alive_count_ + 1; alive_count_ > target && alive_count_ < before;) {
    before = alive_count_;
    consider_all();
    while (alive_count_ > target && !queue_.empty()) {
      const Collapse c = queue_.top();
      queue_.pop();
      if (c.removed_stamp != stamp_[c.removed] || c.kept_stamp != stamp_[c.kept]) continue;
      if (may_remove(c.removed, c.kept) && !flips(c)) collapse(c);
    }
  }
}

SimplerSurface Simplifier::result() const {
  SimplerSurface out;
  std::map<std::uint32_t, std::uint32_t> vertices, points;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    if (alive_[t] != 0)
      for (const std::uint32_t v : triangles_[t]) vertices[v] = points[surface_.point_of[v]] = 0;
  std::uint32_t number = 0;
  for (auto& [point, to] : points) to = number++;
  for (auto& [vertex, to] : vertices) {
    to = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.push_back(made_of_[vertex]);
    out.point_of.push_back(points.at(surface_.point_of[vertex]));
  }
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    if (alive_[t] != 0)
      for (const std::uint32_t v : triangles_[t]) out.indices.push_back(vertices.at(v));
  for (std::uint32_t p = 0; p < home_.size(); ++p) {
    std::uint32_t at = p;
    while (home_[at] != at) at = home_[at];
    const auto found = points.find(at);
    out.home.push_back(found == points.end() ? kNoHome : found->second);
  }
  return out;
}

}  // namespace

std::vector<SimplerSurface> simplify(const SeamedSurface& surface, const std::vector<Shape>& shapes,
                                     const std::vector<std::size_t>& targets, Placement placement) {
  std::vector<SimplerSurface> out(targets.size());
  if (surface.indices.empty() || shapes.empty() || shapes.front().positions.empty()) return out;
  Simplifier simplifier(surface, shapes, placement);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    simplifier.reduce_to(targets[i]);
    out[i] = simplifier.result();
  }
  return out;
}

}  // namespace marrow::deform
