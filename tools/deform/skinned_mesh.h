// A skinned mesh and its poses in double precision, as the offline deformers and fits take them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

namespace marrow::deform {

struct Influence {
  std::uint32_t joint;
  double weight;
};

// In the bind pose. Vertices that coincide and move alike are one; so seams in normals and UVs do not matter here.
struct SkinnedMesh {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> indices;              // 3 a triangle
  std::vector<std::vector<Influence>> influences;  // a vertex: by ascending joint; weights ≥ 0 that sum to 1
  std::uint32_t joint_count = 0;
};

// A pose: for each joint M_j = W_j B_j⁻¹, which takes the bind pose to where the joint is now.
using Matrix = glm::dmat4x3;
using Pose = std::vector<Matrix>;
using Positions = std::vector<glm::dvec3>;
// Poses of three frames, one after the other.
using FramesInARow = std::array<Pose, 3>;

// Where a deformer puts the vertices in a pose. Thread-safe; `out` is resized.
using Deformer = std::function<void(const Pose& pose, Positions& out)>;

// 0 for a joint that is not among them.
double weight_of(std::uint32_t joint, const std::vector<Influence>& influences);

inline glm::dmat3 linear_of(const Matrix& m) {
  return glm::dmat3(m[0], m[1], m[2]);
}

inline glm::dvec3 transform(const Matrix& m, const glm::dvec3& v) {
  return m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3];
}

bool is_finite(const Positions& positions);
// By the squares of a matrix: also false where those overflow.
bool is_finite(const Matrix& m);
bool is_finite(const Pose& pose);

// Length of the diagonal of the bind pose's box.
double diagonal(const SkinnedMesh& mesh);

}  // namespace marrow::deform
