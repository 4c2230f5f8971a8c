#include "deform/helpers/tangents.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace marrow::deform {
namespace {

constexpr double kFlat = 1e-3;  // of a ring's areas, below which they cancel out

// Perpendicular to a unit vector, and unit.
glm::dvec3 perpendicular(const glm::dvec3& n) {
  const glm::dvec3 a = glm::abs(n);
  const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                          : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(n, axis));
}

// What one vertex's entries make of the coordinates of another, which may follow other entries. An entry is h of
// joints: a joint itself, a helper the shares of two. One that the vertex lacks counts as the sum Σ x_i h_i of the
// vertex's own entries that is h, or closest to it: a helper at 3/4 as twice that at 1/2 less that at 1/4. Of h what
// joints have that none of the vertex's entries blends counts as that joint of the vertex's which the other follows
// most, or else as the vertex's own heaviest.
class StandIns {
 public:
  StandIns(const std::vector<Coordinate>& vertex, const std::vector<Helper>& helpers, std::uint32_t joint_count)
      : vertex_(vertex), helpers_(helpers), joint_count_(joint_count) {
    for (const Coordinate& c : vertex)
      for (const Influence& i : joints_of(c.joint)) joints_.push_back({i.joint, 0});
    std::ranges::sort(joints_, {}, &Influence::joint);
    const auto is_same = [](const Influence& a, const Influence& b) { return a.joint == b.joint; };
    joints_.erase(std::unique(joints_.begin(), joints_.end(), is_same), joints_.end());
    for (const Coordinate& c : vertex)
      for (const Influence& i : joints_of(c.joint)) joints_[place_of(i.joint)].weight += i.weight * c.q.w;
    for (std::size_t i = 0; i < vertex.size(); ++i) add_direction(i);
  }

  // q as the vertex's entries have it, in their order.
  std::vector<Coordinate> seen(const std::vector<Coordinate>& q) const {
    std::vector<Coordinate> out = vertex_;
    for (Coordinate& c : out) c.q = glm::dvec4(0);
    const std::size_t heir = heir_of(q);
    for (const Coordinate& c : q) {
      const auto same = std::ranges::find(out, c.joint, &Coordinate::joint);
      if (same != out.end()) {
        same->q += c.q;
        continue;
      }
      const std::vector<double> x = shares_for(c.joint, heir);
      for (std::size_t i = 0; i < out.size(); ++i) out[i].q += c.q * x[i];
    }
    return out;
  }

 private:
  // Perpendicular to those before it, unit; and what it is of the vertex's entries.
  struct Direction {
    std::vector<double> along, of_entries;
  };

  std::vector<Influence> joints_of(std::uint32_t entry) const {
    if (entry < joint_count_) return {{entry, 1.0}};
    const Helper& h = helpers_[entry - joint_count_];
    return {{h.first, 1 - h.share}, {h.second, h.share}};
  }
  std::size_t place_of(std::uint32_t joint) const {
    return static_cast<std::size_t>(std::ranges::find(joints_, joint, &Influence::joint) - joints_.begin());
  }

  void add_direction(std::size_t entry) {
    constexpr double kLeastSquare = 1e-3;  // of the sine: below that an entry says nothing new
    Direction d{std::vector<double>(joints_.size(), 0.0), std::vector<double>(vertex_.size(), 0.0)};
    for (const Influence& i : joints_of(vertex_[entry].joint)) d.along[place_of(i.joint)] = i.weight;
    d.of_entries[entry] = 1;
    const double before = std::inner_product(d.along.begin(), d.along.end(), d.along.begin(), 0.0);
    const auto take = [](std::vector<double>& from, const std::vector<double>& what, double factor) {
      for (std::size_t i = 0; i < from.size(); ++i) from[i] -= factor * what[i];
    };
    for (const Direction& other : directions_) {
      const double part = std::inner_product(d.along.begin(), d.along.end(), other.along.begin(), 0.0);
      take(d.along, other.along, part);
      take(d.of_entries, other.of_entries, part);
    }
    const double square = std::inner_product(d.along.begin(), d.along.end(), d.along.begin(), 0.0);
    if (!(square > kLeastSquare * before)) return;
    for (std::vector<double>* const v : {&d.along, &d.of_entries})
      for (double& x : *v) x /= std::sqrt(square);
    directions_.push_back(std::move(d));
  }

  // Of the vertex's joints the place of that which q follows most.
  std::size_t heir_of(const std::vector<Coordinate>& q) const {
    std::vector<double> followed(joints_.size() + 1, 0.0);
    for (const Coordinate& c : q)
      for (const Influence& i : joints_of(c.joint)) followed[place_of(i.joint)] += i.weight * c.q.w;
    const auto most = std::max_element(followed.begin(), followed.end() - 1);
    if (*most > 0) return static_cast<std::size_t>(most - followed.begin());
    return static_cast<std::size_t>(std::ranges::max_element(joints_, {}, &Influence::weight) - joints_.begin());
  }

  std::vector<double> shares_for(std::uint32_t entry, std::size_t heir) const {
    std::vector<double> h(joints_.size(), 0.0), out(vertex_.size(), 0.0);
    for (const Influence& i : joints_of(entry)) {
      const std::size_t place = place_of(i.joint);
      h[place < joints_.size() ? place : heir] += i.weight;
    }
    double left = 1;
    for (const Direction& d : directions_) {
      const double part = std::inner_product(h.begin(), h.end(), d.along.begin(), 0.0);
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += part * d.of_entries[i];
    }
    for (const double x : out) left -= x;
    const auto heaviest = std::ranges::max_element(vertex_, {}, [](const Coordinate& c) { return c.q.w; });
    out[static_cast<std::size_t>(heaviest - vertex_.begin())] += left;
    return out;
  }

  const std::vector<Coordinate>& vertex_;
  const std::vector<Helper>& helpers_;
  std::uint32_t joint_count_;
  std::vector<Influence> joints_;  // that its entries blend, ascending, with their weights
  std::vector<Direction> directions_;
};

// Two corners a triangle that follow one at the vertex.
using Ring = std::vector<std::array<std::uint32_t, 2>>;

std::array<std::vector<Coordinate>, 2> tangents_of(std::size_t v, const Coordinates& coordinates, const Positions& rest,
                                                   const Ring& ring, const glm::dvec3& normal,
                                                   const StandIns& stand_ins) {
  std::array<std::vector<Coordinate>, 2> out = {coordinates[v], coordinates[v]};
  for (std::vector<Coordinate>& tangent : out)
    for (Coordinate& c : tangent) c.q = glm::dvec4(0);
  if (normal == glm::dvec3(0)) return out;
  const glm::dvec3 first = perpendicular(normal);
  const glm::dvec3 axes[2] = {first, glm::cross(normal, first)};
  glm::dvec3 mean(0);
  double areas = 0;
  for (const auto& [k, l] : ring) {
    const glm::dvec3 doubled = glm::cross(rest[k] - rest[v], rest[l] - rest[v]);
    mean += doubled;
    areas += glm::length(doubled);
  }
  const double area = glm::length(mean);
  glm::dvec3 lacks[2] = {axes[0], axes[1]};
  const auto add = [&](std::uint32_t k, const glm::dvec3& across) {
    const std::vector<Coordinate> q = stand_ins.seen(coordinates[k]);
    for (std::size_t a = 0; a < 2; ++a) {
      const double factor = glm::dot(across, glm::cross(mean, axes[a])) / (area * area);
      lacks[a] -= (rest[k] - rest[v]) * factor;
      for (std::size_t j = 0; j < q.size(); ++j) out[a][j].q += (q[j].q - coordinates[v][j].q) * factor;
    }
  };
  for (const auto& [k, l] : ring) {
    if (!(area > kFlat * areas)) break;
    add(k, rest[l] - rest[v]);
    add(l, rest[v] - rest[k]);
  }
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t j = 0; j < out[a].size(); ++j) out[a][j].q += glm::dvec4(lacks[a] * coordinates[v][j].q.w, 0);
  return out;
}

}  // namespace

TangentCoordinates tangent_coordinates(const Coordinates& coordinates, const SkinnedMesh& mesh,
                                       const std::vector<glm::dvec3>& normals, const std::vector<Helper>& helpers) {
  const Positions& rest = mesh.positions;
  const std::vector<std::uint32_t>& indices = mesh.indices;
  std::vector<Ring> rings(rest.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t first = i - i % 3;
    rings[indices[i]].push_back({indices[first + (i + 1) % 3], indices[first + (i + 2) % 3]});
  }
  TangentCoordinates out;
  for (std::size_t v = 0; v < rest.size(); ++v)
    out.push_back(
        tangents_of(v, coordinates, rest, rings[v], normals[v], StandIns(coordinates[v], helpers, mesh.joint_count)));
  return out;
}

std::vector<glm::dvec3> surface_normals(const TangentCoordinates& tangents, const Pose& pose) {
  std::vector<glm::dvec3> out;
  for (const std::array<std::vector<Coordinate>, 2>& of_vertex : tangents) {
    glm::dvec3 t[2] = {glm::dvec3(0), glm::dvec3(0)};
    for (std::size_t a = 0; a < 2; ++a)
      for (const Coordinate& c : of_vertex[a]) t[a] += pose[c.joint] * c.q;
    glm::dvec3 n = glm::cross(t[0], t[1]);
    if (!of_vertex[0].empty() && glm::determinant(linear_of(pose[of_vertex[0].back().joint])) < 0) n = -n;
    const double length = glm::length(n);
    out.push_back(length > 0 ? n / length : glm::dvec3(0));
  }
  return out;
}

}  // namespace marrow::deform
