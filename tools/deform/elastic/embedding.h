// A mesh's vertices in an elastic body.
#pragma once

#include <cstdint>
#include <vector>

#include "deform/elastic/rounds.h"
#include "deform/surface.h"

namespace marrow::deform {

// A vertex goes with the corners round it, by how each is moved, turned and stretched: v' = Σ φ (x + F (v - p)), φ
// quadratic B-splines, over the corners of its own cell and of those that touch it and hang together with it. What is
// thin goes with the joints and with how far the corners are from where joints have them.
class Embedding {
 public:
  // Refers to both.
  Embedding(const Body& body, const SkinnedMesh& mesh);

  // Of each vertex how much of it goes with the joints alone: 1 where there is no body, or where another surface in its
  // cell follows other joints and the body is between both: clothes over skin. Smooth over the surface.
  const std::vector<double>& rig_shares() const { return rig_; }

  // From now on these vertices go with the joints alone, and those round them partly, without a seam.
  void leave_to_rig(const std::vector<char>& vertices);

  // All in the lattice's places. by_rig: where joints alone take a vertex.
  template <class ByRig>
  glm::dvec3 place_of(std::size_t v, const Shape& shape, const Carried& carried, const ByRig& by_rig) const {
    if (rig_[v] >= 1) return by_rig();
    glm::dvec3 whole(0), moved(0);
    double sum = 0;
    const glm::dvec3 p = body_.lattice.to_lattice(mesh_.positions[v]);
    for_each_near(v, [&](std::uint32_t n, double share) {
      const glm::dvec3 x = place(shape.places[n]), from = p - glm::dvec3(body_.lattice.nodes[n]);
      whole += (x + place(shape.gradients[n][0]) * from.x + place(shape.gradients[n][1]) * from.y +
                place(shape.gradients[n][2]) * from.z) *
               share;
      moved += (x - carried.places[n]) * share;
      sum += share;
    });
    const double rig = rig_[v], thin = (1 - rig) * thin_[v];
    glm::dvec3 out = whole * ((1 - rig - thin) / sum);
    if (rig + thin > 0) out += by_rig() * (rig + thin) + moved * (thin / sum);
    return out;
  }

 private:
  struct Near {
    std::uint32_t node;
    std::uint8_t x, y, z;  // of its place, less that of the vertex's cell, and 1 more: 0 … 3
  };
  static glm::dvec3 place(const Four& f) {
    return {static_cast<double>(f.v[0]), static_cast<double>(f.v[1]), static_cast<double>(f.v[2])};
  }

  // Calls each(node, share) for those whose share is above 0.
  template <class Each>
  void for_each_near(std::size_t v, const Each& each) const {
    const std::uint32_t c = body_.lattice.cell_of[v];
    const glm::dvec3 t = body_.lattice.to_lattice(mesh_.positions[v]) - glm::dvec3(body_.lattice.cells[c].at);
    double spline[3][4];
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 4; ++i) spline[axis][i] = quadratic(t[axis] + 1 - i);
    for (std::size_t i = first_[c]; i < first_[c + 1]; ++i) {
      const Near& near = near_[i];
      const double share = spline[0][near.x] * spline[1][near.y] * spline[2][near.z];
      if (share > 0) each(near.node, share);
    }
  }
  static double quadratic(double t);
  void find_near(std::uint32_t cell, const std::vector<char>& has_vertex);
  void find_shares();

  const Body& body_;
  const SkinnedMesh& mesh_;
  std::vector<std::size_t> first_;  // of a cell's near nodes, and the end
  std::vector<Near> near_;
  std::vector<double> rig_, thin_;  // of a vertex
};

}  // namespace marrow::deform
