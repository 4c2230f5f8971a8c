// A figure eight on the ground, by the way along it.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace marrow::tools {

// Bernoulli's lemniscate: it begins at its crossing, leads towards +X and +Z into the lobe at +X, back through the
// crossing, and round the lobe at -X.
class Eight {
 public:
  // reach: from the crossing to the end of a lobe, metres.
  explicit Eight(float reach);

  float length() const { return ways_.back(); }
  // x and z at a way from its beginning, taken round and round; and a unit vector along it there.
  glm::vec2 at(float way) const;
  glm::vec2 along(float way) const;
  // The way of the place nearest to a point, of those that are at most half a metre from a way.
  float nearest(glm::vec2 point, float way) const;

 private:
  float reach_;
  std::vector<float> ways_;  // of places evenly spaced in the curve's parameter
};

}  // namespace marrow::tools
