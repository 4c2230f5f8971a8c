// Where a ray meets a surface.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace marrow::tools {

struct Ray {
  glm::vec3 from{0};
  glm::vec3 along{0, 0, -1};  // unit
};

// From the near plane on. at: -1 … 1 each way, to the right and up.
Ray ray_through(const glm::mat4& clip_from_model, glm::vec2 at);

struct SurfaceHit {
  std::uint32_t triangle = 0;
  glm::vec3 place{0};
  glm::vec3 normal{0};  // unit, on the ray's side
};

// The first triangle that the ray meets, from either side (Möller and Trumbore, "Fast, minimum storage ray/triangle
// intersection", 1997). corners: three of `positions` a triangle. Cost: all triangles.
std::optional<SurfaceHit> first_hit(const Ray& ray, std::span<const glm::vec3> positions,
                                    std::span<const std::uint32_t> corners);

}  // namespace marrow::tools
