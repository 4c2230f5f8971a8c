// Where a picture is taken from: a view that holds a whole performance in the frame.
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace marrow::tools {

// An axis-aligned box; empty while min > max.
struct Box {
  glm::vec3 min{1e30f};
  glm::vec3 max{-1e30f};

  void add(glm::vec3 p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  bool empty() const { return min.x > max.x; }
  glm::vec3 centre() const { return 0.5f * (min + max); }
  float radius() const { return 0.5f * glm::length(max - min); }
};

struct Camera {
  glm::vec3 position{0};  // model space
  glm::mat4 clip_from_model{1};
};

// A three-quarter view from the front (+Z) and a little above that frames all points, as large as the margins allow.
// points: model space; not empty. aspect: width / height. margin: share of the frame left free on every side.
// turn_rad: how far the camera has walked round the character. Lengths do not matter: near and far planes follow the
// points.
Camera frame_points(std::span<const glm::vec3> points, float aspect, float margin, float turn_rad = 0);

// Where a camera is that walks round a point, and looks at it.
struct Orbit {
  glm::vec3 target{0};  // model space
  float yaw = 0.56f;    // radians from +Z towards +X
  float pitch = 0.21f;  // radians above the horizon
  float distance = 1;
};

// As frame_points(), from the side that the orbit's yaw and pitch say. The rest of it does not count.
Camera frame_points_from(const Orbit& side, std::span<const glm::vec3> points, float aspect, float margin);

// The orbit on which frame_points_from()'s camera is.
Orbit orbit_round(std::span<const glm::vec3> points, float aspect, float margin, const Orbit& side = {});
// radius: of what stands round the target; near and far planes follow it.
Camera camera_on(const Orbit& orbit, float aspect, float radius);
// To the right and up in the picture, unit, model space.
glm::vec3 right_of(const Orbit& orbit);
glm::vec3 up_of(const Orbit& orbit);
// Height of what a camera sees at its target, a unit of distance away.
float view_height();

// The same camera moved.
Camera moved(const Camera& camera, glm::vec3 by);

// The same camera after a walk round the vertical axis through `centre`, looking at it from another side.
Camera turned(const Camera& camera, glm::vec3 centre, float turn_rad);

// Seen along -direction by a light far away: maps the box, grown by `margin` times its radius, to clip space.
// extent: width of the view and depth of its range, scene units.
struct LightView {
  glm::mat4 clip_from_model{1};
  glm::vec2 extent{1};
};
LightView frame_box(const Box& box, glm::vec3 direction, float margin);

}  // namespace marrow::tools
