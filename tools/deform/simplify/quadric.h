// Sums of squared distances from planes and points.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace marrow::deform {

struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  glm::dvec3 b{0};
  double c = 0;

  // `weight` times the squared distance from the plane through `point` with this unit normal.
  void add_plane(const glm::dvec3& n, const glm::dvec3& point, double weight) {
    const double d = -glm::dot(n, point);
    xx += weight * n.x * n.x;
    xy += weight * n.x * n.y;
    xz += weight * n.x * n.z;
    yy += weight * n.y * n.y;
    yz += weight * n.y * n.z;
    zz += weight * n.z * n.z;
    b += n * (weight * d);
    c += weight * d * d;
  }
  void add_point(const glm::dvec3& p, double weight) {
    xx += weight;
    yy += weight;
    zz += weight;
    b -= p * weight;
    c += weight * glm::dot(p, p);
  }
  Quadric& operator+=(const Quadric& o) {
    xx += o.xx;
    xy += o.xy;
    xz += o.xz;
    yy += o.yy;
    yz += o.yz;
    zz += o.zz;
    b += o.b;
    c += o.c;
    return *this;
  }
  double at(const glm::dvec3& p) const {
    return xx * p.x * p.x + yy * p.y * p.y + zz * p.z * p.z +
           2 * (xy * p.x * p.y + xz * p.x * p.z + yz * p.y * p.z + glm::dot(b, p)) + c;
  }
};

}  // namespace marrow::deform
