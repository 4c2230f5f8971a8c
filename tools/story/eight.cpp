#include "story/eight.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::tools {
namespace {

constexpr std::size_t kPieces = 2048;
constexpr float kTurn = 6.2831853f;

// share: of the round.
glm::vec2 place(float reach, float share) {
  const float t = 0.25f * kTurn - kTurn * share, s = std::sin(t), c = std::cos(t);
  return reach / (1 + s * s) * glm::vec2(c, s * c);
}

}  // namespace

Eight::Eight(float reach) : reach_(reach), ways_(kPieces + 1, 0.0f) {
  for (std::size_t i = 1; i <= kPieces; ++i) {
    const auto share = [](std::size_t k) { return static_cast<float>(k) / kPieces; };
    ways_[i] = ways_[i - 1] + glm::distance(place(reach, share(i)), place(reach, share(i - 1)));
  }
}

glm::vec2 Eight::at(float way) const {
  way -= std::floor(way / length()) * length();
  const auto after = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(ways_, way) - ways_.begin(), 1, kPieces);
  const auto i = static_cast<std::size_t>(after) - 1;
  const float within = (way - ways_[i]) / (ways_[i + 1] - ways_[i]);
  return place(reach_, (static_cast<float>(i) + within) / kPieces);
}

glm::vec2 Eight::along(float way) const {
  constexpr float kStep = 0.005f;
  return glm::normalize(at(way + kStep) - at(way - kStep));
}

float Eight::nearest(glm::vec2 point, float way) const {
  constexpr float kFar = 0.5f, kStep = 0.002f;
  float best = way, least = glm::distance(at(way), point);
  for (float off = -kFar; off <= kFar; off += kStep)
    if (const float distance = glm::distance(at(way + off), point); distance < least)
      least = distance, best = way + off;
  return best;
}

}  // namespace marrow::tools
