// What is painted: the vertices of a file's meshes in full, those at one place as one, with their weights; where they
// are in a pose, and where a ray meets them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"
#include "deform/surface.h"
#include "marrow/file.h"
#include "pose/evaluate.h"

namespace marrow::tools {

// joint: of the skeleton.
using Influences = std::vector<deform::Influence>;

inline constexpr std::uint32_t kNoPlace = 0xFFFFFFFF;

// Meshes of one name on one skeleton: the primitives of a mesh of the source.
struct CanvasGroup {
  std::string name;
  std::uint32_t skeleton = 0;
  bool hangs = false;                               // on one joint as a whole: there is nothing to paint
  std::map<std::uint32_t, glm::mat4> inverse_bind;  // by joint of the skeleton, as far as the meshes have them
  std::set<std::uint32_t> joints;                   // of its skin; empty: not known

  bool may_follow(std::uint32_t joint) const { return joints.empty() || joints.contains(joint); }
};

struct Canvas {
  std::vector<CanvasGroup> groups;
  // A place:
  std::vector<std::uint32_t> group_of;
  std::vector<glm::vec3> bind;  // mesh space
  deform::Positions model;      // where the bind pose is in the scene
  std::vector<Influences> influences;
  std::vector<char> touched;                              // whether it is to be saved
  std::vector<std::vector<std::uint32_t>> place_of_slot;  // a mesh of the file
  std::vector<std::uint32_t> corners;                     // three places a triangle
  std::vector<deform::Surface> surface;                   // one, over all places; none before it is made
  bool has_helpers = false;                               // weights are not the artist's

  std::span<const std::uint32_t> neighbours(std::uint32_t place) const { return surface.front().neighbours(place); }
};

// rest: model_from_joint of each skeleton at rest. Of vertices at one place the first says the weights. Cost: n log n.
Canvas canvas_of(const File& file, std::span<const std::vector<Affine>> rest);

// The matrices of a group's bind pose, joint_from_mesh, for every joint of its skeleton. Of joints that its meshes do
// not follow they are as if the skeleton at rest were the bind pose. rest: of that skeleton.
std::vector<glm::mat4> bind_matrices(const CanvasGroup& group, std::span<const Affine> rest);

double weight_of(const Influences& influences, std::uint32_t joint);

// A canvas in a pose, by linear blend skinning with the weights that are painted.
struct PosedCanvas {
  std::vector<glm::vec3> places;    // model space
  std::vector<glm::mat4> matrices;  // a place: model_from_mesh
};

// binds: of each group, as bind_matrices() gives them. model_from_joint: of each skeleton.
void pose_canvas(const Canvas& canvas, std::span<const std::vector<glm::mat4>> binds,
                 std::span<const std::vector<Affine>> model_from_joint, PosedCanvas& out);

// Slots of a mesh of the file. As skin_ssd() does it, without tangents.
PosedMesh posed_mesh(const Mesh& mesh, std::span<const std::uint32_t> place_of_slot, const PosedCanvas& posed);

// Where a ray meets a surface.
struct Ray {
  glm::vec3 from{0};
  glm::vec3 along{0, 0, -1};  // unit
};

// From the near plane on. at: -1 … 1 each way, to the right and up.
Ray ray_through(const glm::mat4& clip_from_model, glm::vec2 at);

struct SurfaceHit {
  std::uint32_t triangle = 0;
  glm::vec3 place{0};
  glm::vec3 normal{0};  // unit, on the ray's side
};

// The first triangle that the ray meets, from either side (Möller and Trumbore, "Fast, minimum storage ray/triangle
// intersection", 1997). corners: three of `positions` a triangle. Cost: all triangles.
std::optional<SurfaceHit> first_hit(const Ray& ray, std::span<const glm::vec3> positions,
                                    std::span<const std::uint32_t> corners);

}  // namespace marrow::tools
