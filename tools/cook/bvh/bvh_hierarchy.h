// The first part of a BVH file: joints, where they rest, and what of them moves.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/bvh/bvh_words.h"

namespace marrow::cook::bvh {

// One number a frame.
struct BvhChannel {
  bool is_rotation = false;  // degrees about the axis; else a place along it
  int axis = 0;              // x, y, z
};

struct BvhJoint {
  std::string name;
  int parent = -1;  // index, always less than the joint's own
  bool is_end = false;
  glm::dvec3 offset{0};              // from the parent, at rest
  std::vector<BvhChannel> channels;  // at most 6, each once, in the file's order
};

struct BvhHierarchy {
  std::vector<BvhJoint> joints;             // in the file's order; End Sites among them, called NAME_end
  std::vector<std::size_t> channel_joints;  // joints with channels, in the order of their numbers in a frame
  std::size_t channel_count = 0;
};

// Reads up to the word MOTION. Throws tools::Failure: invalid; unsupported for too many joints.
BvhHierarchy read_hierarchy(Words& words, gltf::Report& report);

}  // namespace marrow::cook::bvh
