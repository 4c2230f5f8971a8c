#include "render/overlay/mark.h"

#include <algorithm>
#include <cmath>

#include <glm/vec4.hpp>

namespace marrow::tools {
namespace {

constexpr Rgb kMarkColour = {255, 166, 43};
constexpr float kMarkRadius = 7;  // pixels
constexpr int kMarkReach = 9;     // of the edge

}  // namespace

void draw_mark(Image& image, const Camera& camera, const std::array<float, 3>& point) {
  const glm::vec4 clip = camera.clip_from_model * glm::vec4(point[0], point[1], point[2], 1);
  if (!(clip.w > 0)) return;
  const float x = (0.5f + 0.5f * clip.x / clip.w) * static_cast<float>(image.width);
  const float y = (0.5f - 0.5f * clip.y / clip.w) * static_cast<float>(image.height);
  if (!(std::fabs(x) < 1e5f && std::fabs(y) < 1e5f)) return;
  for (int dy = -kMarkReach; dy <= kMarkReach; ++dy) {
    for (int dx = -kMarkReach; dx <= kMarkReach; ++dx) {
      const int px = static_cast<int>(std::floor(x)) + dx, py = static_cast<int>(std::floor(y)) + dy;
      const float distance = std::hypot(static_cast<float>(px) + 0.5f - x, static_cast<float>(py) + 0.5f - y);
      blend(image, px, py, kMarkColour, std::clamp(1.8f - std::fabs(distance - kMarkRadius), 0.0f, 1.0f));
    }
  }
}

}  // namespace marrow::tools
