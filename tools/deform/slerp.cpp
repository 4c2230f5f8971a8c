#include "deform/slerp.h"

#include <limits>

#include "common/elementary.h"

namespace marrow::deform {

glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double share) {
  const double cosine = glm::dot(a, b);
  const glm::dquat nearer = cosine < 0 ? -b : b;
  const double size = cosine < 0 ? -cosine : cosine;
  if (size > 1 - std::numeric_limits<double>::epsilon()) return a * (1 - share) + nearer * share;
  const double angle = tools::arc_cosine(size);
  return (a * tools::sine((1 - share) * angle) + nearer * tools::sine(share * angle)) / tools::sine(angle);
}

}  // namespace marrow::deform
