// What a deformer writes of a mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "marrow/skin.h"
#include "support/double_math.h"

namespace marrow::test {

struct Skinned {
  std::vector<float> positions, normals, tangents;
  explicit Skinned(std::size_t slots) : positions(slots * 3), normals(slots * 3), tangents(slots * 4) {}
  SkinOutput output(NormalTransform transform = NormalTransform::inverse_transpose) {
    return {positions, normals, tangents, transform};
  }
  static Vec3 three(const std::vector<float>& v, std::size_t slot, std::size_t stride = 3) {
    return {static_cast<double>(v[slot * stride]), static_cast<double>(v[slot * stride + 1]),
            static_cast<double>(v[slot * stride + 2])};
  }
};

}  // namespace marrow::test
