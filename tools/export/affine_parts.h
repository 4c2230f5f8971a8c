// Affine maps as glTF's nodes can hold them: translation, rotation and scale, which have no shear.
#pragma once

#include <cstring>
#include <vector>

#include "glb/glb.h"
#include "marrow/pose.h"

namespace marrow::tools {

inline bool same(const Affine& a, const Affine& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

struct Parts {
  double translation[3] = {0, 0, 0};
  double rotation[4] = {0, 0, 0, 1};  // x, y, z, w; unit
  double scale[3] = {1, 1, 1};
};

// One or, for a map with shear, two nodes, the outer first, whose product is `map` within float rounding: the singular
// value decomposition, U S Vᵀ, by one-sided Jacobi rotations (Hestenes 1958). Empty for the identity.
std::vector<Parts> parts_of(const Affine& map);

// Puts what is not the default into a node.
void set_parts(Json& node, const Parts& parts);

}  // namespace marrow::tools
