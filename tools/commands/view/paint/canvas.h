// What is painted: the vertices of a file's meshes in full, those at one place as one, with their weights.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"
#include "deform/surface.h"
#include "marrow/file.h"

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

}  // namespace marrow::tools
