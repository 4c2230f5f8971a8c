#include "commands/view/paint/ray.h"

#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace marrow::tools {

Ray ray_through(const glm::mat4& clip_from_model, glm::vec2 at) {
  const glm::mat4 model_from_clip = glm::inverse(clip_from_model);
  const auto place = [&](float depth) {
    const glm::vec4 p = model_from_clip * glm::vec4(at, depth, 1);
    return glm::vec3(p) / p.w;
  };
  const glm::vec3 from = place(-1);
  return {from, glm::normalize(place(0.5f) - from)};
}

std::optional<SurfaceHit> first_hit(const Ray& ray, std::span<const glm::vec3> positions,
                                    std::span<const std::uint32_t> corners) {
  float nearest = std::numeric_limits<float>::infinity();
  SurfaceHit hit;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const glm::vec3 &a = positions[corners[i]], ab = positions[corners[i + 1]] - a, ac = positions[corners[i + 2]] - a;
    const glm::vec3 p = glm::cross(ray.along, ac);
    const float determinant = glm::dot(ab, p);
    if (determinant == 0) continue;
    const float inverse = 1 / determinant;
    const glm::vec3 to = ray.from - a;
    const float u = glm::dot(to, p) * inverse;
    if (!(u >= 0 && u <= 1)) continue;
    const glm::vec3 q = glm::cross(to, ab);
    const float v = glm::dot(ray.along, q) * inverse, distance = glm::dot(ac, q) * inverse;
    if (!(v >= 0 && u + v <= 1 && distance >= 0 && distance < nearest)) continue;
    nearest = distance;
    hit.triangle = static_cast<std::uint32_t>(i / 3);
    hit.place = ray.from + distance * ray.along;
    const glm::vec3 normal = glm::normalize(glm::cross(ab, ac));
    hit.normal = glm::dot(normal, ray.along) > 0 ? -normal : normal;
  }
  if (nearest == std::numeric_limits<float>::infinity()) return std::nullopt;
  return hit;
}

}  // namespace marrow::tools
