#include "deform/branch.h"

namespace marrow::deform {

std::vector<char> turned_along(std::uint32_t joint, const std::vector<int>& parents) {
  std::vector<char> out(parents.size(), 0);
  for (std::size_t j = 0; j < parents.size(); ++j) {
    std::size_t up = j;
    while (up != joint && parents[up] >= 0) up = static_cast<std::size_t>(parents[up]);
    out[j] = up == joint;
  }
  return out;
}

Pose turned(const std::vector<char>& turns, const glm::dvec3& centre, const glm::dmat3& turn) {
  Pose out(turns.size(), Matrix(1.0));
  for (std::size_t j = 0; j < out.size(); ++j)
    if (turns[j] != 0) out[j] = {turn[0], turn[1], turn[2], centre - turn * centre};
  return out;
}

}  // namespace marrow::deform
