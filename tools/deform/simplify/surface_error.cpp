#include "deform/simplify/surface_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <glm/geometric.hpp>

#include "common/parallel.h"

namespace marrow::deform {
namespace {

constexpr std::size_t kPairs = 256;

// Vertices far apart in order, and so mostly on the surface.
std::vector<double> lengths(const Positions& at) {
  std::vector<double> out;
  const std::size_t n = at.size();
  for (std::size_t i = 0; i < kPairs; ++i) {
    const std::size_t a = i * n / kPairs, b = (a + n / 2 + i * i) % n;
    out.push_back(glm::length(at[a] - at[b]));
  }
  return out;
}

double squared_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

}  // namespace

std::vector<Representative> representative_poses(const Deformer& deformer, const std::vector<Pose>& poses,
                                                 std::size_t first, std::size_t most) {
  std::vector<std::vector<double>> shapes(poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    Positions at;
    deformer(poses[i], at);
    if (!at.empty()) shapes[i] = lengths(at);
  });
  std::vector<Representative> out;
  std::vector<double> nearest(poses.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> of(poses.size(), 0);
  for (std::size_t next = first; out.size() < most;) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double d = squared_difference(shapes[i], shapes[next]);
      if (!(d < nearest[i])) continue;
      nearest[i] = d;
      of[i] = out.size();
    }
    out.push_back({next, 0});
    next = poses.size();
    double farthest = 0;
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (std::isfinite(nearest[i]) && nearest[i] > farthest) farthest = nearest[next = i];
    if (next == poses.size()) break;
  }
  for (std::size_t i = 0; i < poses.size(); ++i) out[of[i]].weight += 1.0 / static_cast<double>(poses.size());
  return out;
}

namespace {

// A triangle seen from a point, in all shapes at once: nothing but scalar products counts.
struct Products {
  double ab_ab = 0, ab_ac = 0, ac_ac = 0, ab_ap = 0, ac_ap = 0, ap_ap = 0;
};

Products products(const std::uint32_t (&p)[3], std::size_t point, const std::vector<Shape>& shapes,
                  const std::vector<Shape>& simpler) {
  Products out;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Positions& at = simpler[k].positions;
    const glm::dvec3 ab = at[p[1]] - at[p[0]], ac = at[p[2]] - at[p[0]], ap = shapes[k].positions[point] - at[p[0]];
    const double w = shapes[k].weight;
    out.ab_ab += w * glm::dot(ab, ab);
    out.ab_ac += w * glm::dot(ab, ac);
    out.ac_ac += w * glm::dot(ac, ac);
    out.ab_ap += w * glm::dot(ab, ap);
    out.ac_ap += w * glm::dot(ac, ap);
    out.ap_ap += w * glm::dot(ap, ap);
  }
  return out;
}

struct Nearest {
  double squared = std::numeric_limits<double>::infinity();
  double b = 0, c = 0;  // shares of the second and the third corner
};

void take(const Products& p, double b, double c, Nearest& best) {
  const double squared =
      p.ap_ap - 2 * (b * p.ab_ap + c * p.ac_ap) + b * b * p.ab_ab + 2 * b * c * p.ab_ac + c * c * p.ac_ac;
  if (squared < best.squared) best = {squared, b, c};
}

double along(double product, double squared_length) {
  return squared_length > 0 ? std::clamp(product / squared_length, 0.0, 1.0) : 0.0;
}

// Inside, or else on one of the sides.
Nearest nearest_on(const Products& p) {
  Nearest best;
  const double det = p.ab_ab * p.ac_ac - p.ab_ac * p.ab_ac;
  if (det > 1e-12 * p.ab_ab * p.ac_ac) {
    const double b = (p.ac_ac * p.ab_ap - p.ab_ac * p.ac_ap) / det, c = (p.ab_ab * p.ac_ap - p.ab_ac * p.ab_ap) / det;
    if (b >= 0 && c >= 0 && b + c <= 1) {
      take(p, b, c, best);
      return best;
    }
  }
  take(p, along(p.ab_ap, p.ab_ab), 0, best);
  take(p, 0, along(p.ac_ap, p.ac_ac), best);
  const double bc_bc = p.ab_ab + p.ac_ac - 2 * p.ab_ac, bc_bp = p.ac_ap - p.ab_ap - p.ab_ac + p.ab_ab;
  const double t = along(bc_bp, bc_bc);
  take(p, 1 - t, t, best);
  return best;
}

}  // namespace

std::vector<Anchor> anchor(const SimplerSurface& surface, const std::vector<Shape>& shapes,
                           const std::vector<Shape>& simpler) {
  std::vector<std::vector<std::uint32_t>> around(simpler.front().positions.size());
  const auto point = [&](std::size_t corner) { return surface.point_of[surface.indices[corner]]; };
  for (std::uint32_t i = 0; i < surface.indices.size(); ++i) around[point(i)].push_back(i / 3);
  std::vector<Anchor> out(surface.home.size());
  tools::for_each_in_parallel(out.size(), [&](std::size_t p) {
    if (surface.home[p] == kNoHome) return;
    std::set<std::uint32_t> near;
    for (const std::uint32_t t : around[surface.home[p]])
      for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<std::uint32_t>& of = around[point(3 * t + c)];
        near.insert(of.begin(), of.end());
      }
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : near) {
      const std::uint32_t corners[3] = {point(3 * t), point(3 * t + 1), point(3 * t + 2)};
      const Nearest found = nearest_on(products(corners, p, shapes, simpler));
      if (!(found.squared < least)) continue;
      least = found.squared;
      out[p] = {{corners[0], corners[1], corners[2]}, {1 - found.b - found.c, found.b, found.c}};
    }
  });
  return out;
}

SurfaceError surface_error(const Deformer& source, const Deformer& simpler, const std::vector<Anchor>& anchors,
                           const std::vector<std::uint32_t>& home, const std::vector<Pose>& poses) {
  struct Sum {
    double squares = 0, worst = 0;
    std::size_t count = 0;
  };
  std::vector<Sum> sums(poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) {
    Positions full, less;
    source(poses[i], full);
    simpler(poses[i], less);
    Sum sum;
    for (std::size_t p = 0; p < anchors.size(); ++p) {
      if (home[p] == kNoHome) continue;
      glm::dvec3 off = full[p];
      for (std::size_t c = 0; c < 3; ++c) off -= less[anchors[p].points[c]] * anchors[p].shares[c];
      const double squared = glm::dot(off, off);
      if (!std::isfinite(squared)) return;
      sum.squares += squared;
      sum.worst = std::max(sum.worst, squared);
      ++sum.count;
    }
    sums[i] = sum;
  });
  SurfaceError out;
  double squares = 0;
  std::size_t count = 0;
  for (const Sum& s : sums) {
    squares += s.squares;
    count += s.count;
    out.worst = std::max(out.worst, s.worst);
  }
  out.rms = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
  out.worst = std::sqrt(out.worst);
  return out;
}

}  // namespace marrow::deform
