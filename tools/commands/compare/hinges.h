// A mesh's edges, and how it is folded there.
#pragma once

#include <utility>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::tools {

// Two triangles at an edge.
using Hinge = std::pair<std::uint32_t, std::uint32_t>;

struct Shape {
  explicit Shape(const deform::SkinnedMesh& mesh);

  // Between the normals of a hinge's triangles, radians; 0 where one has no area.
  std::vector<double> angles(const deform::Positions& positions) const;

  // By how much the hinge that is folded most beyond the bind pose is, radians; 0: none is.
  double sharpest_rad(const deform::Positions& positions) const;

  const deform::SkinnedMesh& mesh;
  std::vector<Hinge> hinges;
  std::vector<glm::dvec3> bind_normals;  // a vertex
  std::vector<double> bind_angles;       // a hinge

 private:
  std::vector<glm::dvec3> normals(const deform::Positions& positions) const;  // a triangle; 0: it has no area

  std::vector<std::pair<double, double>> bind_turns_;  // cosines and sines of bind_angles
};

}  // namespace marrow::tools
