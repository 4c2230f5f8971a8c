// Where the bones of joints are.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cook/scene/raw.h"
#include "deform/weights/auto_weights.h"

namespace marrow::cook {

inline constexpr double kFarthestPlace = 1e29;  // of a coordinate: squares of it are finite

// For each node the nearest at or above it for which `known` is set; the topmost if it is set for none.
std::vector<std::size_t> nearest_known(const RawScene& scene, std::vector<char> known);

// model_from_node of every node, at rest.
std::vector<glm::dmat4> rest_of_nodes(const RawScene& scene);

// Bones of joints, each from a joint to the nearest joints below it. One without any reaches to its nodes' children
// that draw nothing; without those, half as far as its parent's bone does to it, straight on. space_from_joint: one a
// joint; joints whose matrix is not finite or cannot be inverted have no bones.
std::vector<deform::Bone> bones_of(const RawScene& scene, const std::vector<int>& joints,
                                   const std::vector<glm::dmat4>& space_from_joint);
bool is_usable(const glm::dmat4& matrix);

}  // namespace marrow::cook
