// What the eye sees of a surface that moves: how it is folded at its edges, and how much faster it goes from one frame
// to the next than the joints under it.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "compare/contestants.h"
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

// Of each deformer, the truth behind them: deform::largest_jump() in three frames at 60 a second, metres, around some
// of the moments that the first round holds out, those in which plain skinning is farthest off. None: no clip says what
// is between, or a deformer is not finite there.
std::vector<std::optional<double>> largest_jumps(const Study& study, const std::vector<Trained>& deformers,
                                                 const deform::Deformer& truth,
                                                 const std::vector<double>& plain_error_of_pose);

}  // namespace marrow::tools
