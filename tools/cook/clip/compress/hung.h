// What hangs on the joints of a skeleton, and how far a pose that is not quite right takes it.
#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "cook/clip/compress/rig.h"
#include "marrow/file.h"

namespace marrow::cook {

// A mesh at one level of detail. With morph targets it is there twice, once with each vertex where the target that
// takes it farthest has it.
struct HungMesh {
  Mesh mesh;
  std::vector<float> coordinates;  // of animation space; empty for a lift, which is where linear blend skinning is
  std::vector<float> skin;         // of a morphed geometry, which points into it
  std::vector<double> strictness;  // a slot: 1 / (how far it may stray, scene units)²; of what fills up blocks 0
};

struct Hung {
  std::vector<HungMesh> meshes;
  std::size_t slots = 0;  // of all meshes and deformers
};

// meshes: of one skeleton, every level of detail of each; what they point into outlives what is returned. promise: says
// how far vertices may stray, each the mean of its joints by weight; gets the points and reaches of the joints.
Hung hang(const std::vector<Mesh>& meshes, const Rig& rig, Promise& promise);

// A kept node's place, in its joint's space.
void hang(std::size_t joint, const glm::dvec3& place, const Rig& rig, Promise& promise);

struct VertexError {
  double error_m = 0;
  double share = 0;  // of what is promised for the vertex
};

// The largest distance between the same vertices in two poses, by the runtime's own skinning: linear blend skinning,
// and whatever other deformer a mesh has data for.
class VertexErrors {
 public:
  explicit VertexErrors(const Hung& hung);
  void add(const std::vector<World>& source, const std::vector<World>& other, VertexError& worst);

 private:
  void skin(const HungMesh& hung, const std::vector<World>& pose, int deformer, std::vector<float>& out);

  const Hung& hung_;
  std::vector<Affine> joints_, palette_;
  std::vector<float> here_, there_, distances_;
};

}  // namespace marrow::cook
