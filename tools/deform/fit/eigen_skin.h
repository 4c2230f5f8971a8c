// EigenSkin: Kry, James, Pai, "EigenSkin: real time large deformation character skinning in hardware", SCA 2002.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "deform/fit/fit.h"
#include "deform/skinned_mesh.h"

namespace marrow::deform {

// What a joint's turn does to the vertices round it.
struct EigenJoint {
  std::uint32_t joint;
  std::vector<std::uint32_t> support;  // vertices, ascending
  std::vector<Positions> fields;       // u_n: a displacement for each vertex of the support, bind space
  // Turns of the joint, as local_rotations() has them, and for each c_kn of the fields.
  std::vector<glm::dquat> examples;
  std::vector<std::vector<double>> coefficients;
  double sigma = 1;
};

// v' = SSD(v + Σ_j Σ_n α_jn(q_j) u_jn), for each vertex over the joints j whose support it is of
//   α_n(q) = (1 - φ(q, 1)) Σ_k φ(q, q_k) c_kn
//   φ(a, b) = exp(-D(a, b) / 2σ²), D(a, b) = 1 - (a · b)² = sin²(half the angle between a and b)
// So the joint's turn in the bind pose is one more example, without displacement.
struct EigenSkin {
  std::vector<int> parents;  // a joint: another one of the mesh, -1: none; its rotation then does not count
  std::vector<EigenJoint> joints;
};

Deformer eigen_skin(const SkinnedMesh& mesh, const EigenSkin& skin);

struct EigenSkinOptions {
  std::size_t most_fields = 4;     // a joint
  std::size_t most_examples = 16;  // a joint
  double ridge = 1e-6;             // beside φ(k, k) = 1
  // How far a vertex of the support is displaced at least in some example, in diagonals.
  double least_displacement = 1e-4;
  // σ as multiples of the mean distance from an example to the next. Taken is what leaves least, each example left out
  // in turn.
  std::vector<double> widths = {1, 0.5, 2, 4};
  // How much the fields of joints alone count where they are fitted to poses, as a share of the mean square of their
  // coefficients there; infinity: they stay.
  double together = 1e-2;
};

// As in the paper each joint is turned alone, from the bind pose, and what SSD misses there is taken to bind space; its
// principal components are the fields. How far joints are turned is taken from `poses`: of what a joint does there
// those turns that are farthest from each other. A joint has no fields where they would not beat SSD in examples left
// out. Not of the paper is a last step: where joints that turn together share vertices, what they miss alone does not
// add up, so the fields are fitted to `poses` by least squares, a vertex at a time. Coefficients stay.
//
// Poses in which the truth is not finite say nothing. centres: where joints are in the bind pose. On all cores; the
// same result on every run. Memory: 24 bytes · vertices · poses.
EigenSkin fit_eigen_skin(const SkinnedMesh& mesh, const std::vector<int>& parents,
                         const std::vector<glm::dvec3>& centres, const std::vector<TrainingPose>& poses,
                         const Deformer& truth, const EigenSkinOptions& options = {});

// The mean over vertices of how many displacements they have. Each is three numbers and three multiply-adds.
double displacements_per_vertex(const SkinnedMesh& mesh, const EigenSkin& skin);

}  // namespace marrow::deform
