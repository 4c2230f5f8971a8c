// What the eye finds wrong with a posed surface, whatever any truth says: folds, bends, creases, jumps.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

struct Folds {
  // Triangles that face against where they would, had each turned as its corners' weights have it: by the blend of
  // quaternions. None do in the bind pose.
  std::size_t flipped = 0;
  // Where weights blend: by how much the angles between neighbouring triangles are not the bind pose's, the root of the
  // mean square by length of the edge; and of those edges' length the share that turns by more than 60°.
  double bend_rad = 0;
  double creased = 0;
};

class FoldMeter {
 public:
  // Refers to `mesh`. Weights blend at an edge if no joint has 99 % of the corners of its two triangles.
  explicit FoldMeter(const SkinnedMesh& mesh);

  // Where each triangle faces if it turns as its corners' weights have it, times its doubled area; 0: nothing says.
  // pose: of the mesh's joints. What follows takes it or the pose itself. All is thread-safe.
  std::vector<glm::dvec3> facing(const Pose& pose) const;

  // Where positions are not finite nothing can be said: all is 0.
  Folds of(const std::vector<glm::dvec3>& facing, const Positions& positions) const;
  Folds of(const Pose& pose, const Positions& positions) const { return of(facing(pose), positions); }

  // Of each joint the flipped triangles that follow it most.
  std::vector<std::size_t> flipped_by_joint(const std::vector<glm::dvec3>& facing, const Positions& positions) const;

  // Adds what vertices see of it: 1 to each corner of a flipped triangle, and of an edge (turn / 60°)² to its ends and
  // the two corners opposite.
  void add_at_vertices(const Pose& pose, const Positions& positions, std::vector<double>& sums) const;

 private:
  struct Edge {
    std::array<std::uint32_t, 4> corners;  // of the edge, then opposite in the first and in the second triangle
    double length, angle_rad;              // in the bind pose
  };
  template <class Each>
  void for_each_flipped(const std::vector<glm::dvec3>& facing, const Positions& positions, const Each& each) const;
  double turned_rad(const Edge& edge, const Positions& positions) const;

  const SkinnedMesh& mesh_;
  std::vector<std::vector<Influence>> weights_;  // of a triangle: the mean of its corners'
  std::vector<Edge> edges_;
  double length_ = 0;  // of all
};

// How much faster a vertex goes from one frame to the next, seen from the joint that it follows most: the largest
// |a - 2 b + c| of what the inverse of that joint's matrix makes of its positions, lengths of the bind pose. What a
// joint carries along is still, however fast the joint is. Vertices without a joint, or whose joint's matrix has no
// inverse, do not count.
double largest_jump(const SkinnedMesh& mesh, const FramesInARow& poses, const std::array<Positions, 3>& at);

}  // namespace marrow::deform
