// What the vertices of a mesh follow, before palettes and quantisation.
#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "cook/scene/raw.h"
#include "cook/scene/residual_source.h"
#include "deform/fit/multi_weight.h"
#include "deform/fit/pose_space.h"
#include "deform/helpers/helpers.h"
#include "deform/pose_metric.h"

namespace marrow::cook {

struct BoundInfluence {
  std::uint32_t joint;     // of the skin; from RawSkin::joints.size() on helpers
  double weight;           // of SSD: a helper's is that of its two joints, by its share
  glm::dvec4 residual{0};  // of animation space: (d, δ)
};
using BoundVertex = std::vector<BoundInfluence>;  // by ascending joint; weights sum to 1, δ to 0

// Multi-weights and pose space, of vertices that move alike; joints as in BoundInfluence.
struct BoundDeformers {
  std::vector<std::vector<std::uint32_t>> vertex_of;  // for each primitive and its vertices which of those
  std::uint32_t root = 0;                             // whose frame multi-weights are meant in
  deform::MultiWeights multi_weights;                 // empty: none
  deform::PoseSpace pose_space;                       // without examples: none
};

// A mesh bound to a skin: all its primitives, since they may share vertices where they touch.
struct SkinBinding {
  std::vector<std::vector<BoundVertex>> primitives;  // vertex by vertex
  // Of each primitive that one palette is too small for, for each triangle which part it goes to; of others nothing.
  std::vector<std::vector<std::uint32_t>> part_of;
  std::vector<deform::Helper> helpers;
  // How finely residuals are to be stored; 0: there are none.
  double residual_step_m = 0;
  double residual_weight_step = 0;
  ResidualSource residual_source = {};
  BoundDeformers deformers;
  int report = kNone;  // index into BuiltScene::learnt
};

// Weights as the file has them: joints named twice merged, zeros dropped, the largest kept, normalised in double
// precision. Notes what it mends.
SkinBinding bind_to_skin(const RawMesh& mesh, Notes& notes);

// A bound vertex as coordinates of animation space.
std::vector<deform::Coordinate> coordinates_of(const BoundVertex& vertex, const glm::dvec3& position);

// The vertex on at most `most` joints. Both animation space and linear blend skinning take it as close to where they
// took it before as so many joints allow, and to the same place in the bind pose.
BoundVertex with_fewer_joints(const deform::PoseMetric& metric, const BoundVertex& vertex, const glm::dvec3& position,
                              bool has_residual, std::size_t most);

}  // namespace marrow::cook
