// Meshes whose vertices are made of another's by fixed shares: what simplification and subdivision make. Whatever is
// linear in vertices, such as animation-space coordinates, follows exactly, in every pose.
#pragma once

#include <cstdint>
#include <vector>

#include "deform/animation_space.h"

namespace marrow::deform {

struct Share {
  std::uint32_t vertex;
  double share;
};
using Combination = std::vector<Share>;  // by ascending vertex; shares sum to 1

// (1 - t) a + t b.
Combination blend(const Combination& a, const Combination& b, double t);

template <class T>
T combined(const Combination& shares, const std::vector<T>& values) {
  T out = values[shares.front().vertex] * shares.front().share;
  for (std::size_t i = 1; i < shares.size(); ++i) out = out + values[shares[i].vertex] * shares[i].share;
  return out;
}

// Over all joints of what it is made of, by ascending joint.
std::vector<Coordinate> combined(const Combination& shares, const Coordinates& coordinates);

}  // namespace marrow::deform
