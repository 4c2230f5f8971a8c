// Weighted pose-space deformation: Lewis, Cordner, Fong, "Pose space deformation", SIGGRAPH 2000; distances weighted a
// vertex as in Kurihara and Miyata, "Modeling deformable human hands from medical images", SCA 2004.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "deform/fit/fit.h"
#include "deform/skinned_mesh.h"

namespace marrow::deform {

struct PoseSpaceExample {
  std::vector<glm::dquat> rotations;  // a joint: local_rotations() of the example's pose
  Positions deltas;                   // a vertex: d_k, bind space
};

// v' = SSD(v + (1 - φ(pose, bind)) Σ_k φ(pose, k) d_k), for each vertex
//   φ(a, b) = exp(-Σ_j w_j D_j(a, b) / 2σ²)
//   D_j(a, b) = 1 - (q_a · q_b)² = sin²(half the angle between the joint's local rotations in a and b)
// The factor makes the bind pose one more example, without correction and without deltas. It is 0 there of second
// order, as is what SSD misses: to first order all deformers agree.
struct PoseSpace {
  std::vector<int> parents;  // a joint: another one of the mesh, -1: none; its rotation then does not count
  double sigma = 1;
  std::vector<PoseSpaceExample> examples;
};

Deformer pose_space(const SkinnedMesh& mesh, const PoseSpace& space);

struct PoseSpaceOptions {
  std::size_t most_examples = 8;
  double ridge = 1e-4;  // beside φ(k, k) = 1
  // The ridge of a vertex grows until no delta is longer, in diagonals: where little weight is on what turns, all
  // examples look alike, and exact deltas would be long and cancel. Eight examples this long fit in 16 bits with steps
  // that keep vertices within one of 14 bits on the mesh's longest side; longer ones miss less and are rounded more.
  double most_delta = 0.14;
  // σ as multiples of the mean distance of vertices from an example to the next; tried by cross-validation, with one
  // fold the first is taken.
  std::vector<double> widths = {1, 0.5, 2, 4};
  Progress progress = {};  // of parts that cross-validation leaves out
};

struct PoseSpaceFit {
  PoseSpace space;                  // without examples where they would not beat SSD
  std::vector<std::size_t> chosen;  // which of the poses are examples, in the order of choice
  FitQuality quality;               // by cross-validation; the reference is SSD
};

// Examples are those of the poses where most is missing, one after the other, each time after all before it have been
// interpolated. What is missing goes to bind space by the inverse of the vertex's blended matrix; where that has next
// to no volume, the example says nothing about the vertex. On all cores; the same result on every run. Memory: 24 bytes
// · vertices · poses.
PoseSpaceFit fit_pose_space(const SkinnedMesh& mesh, const std::vector<int>& parents, std::vector<TrainingPose> poses,
                            const Deformer& truth, const PoseSpaceOptions& options = {});

}  // namespace marrow::deform
