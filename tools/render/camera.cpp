#include "render/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace marrow::tools {
namespace {

constexpr float kFieldOfView = 0.47f;  // radians, vertical: a portrait lens

// The camera's distance along one axis: every point p must satisfy |p.side - at| ≤ slope · (distance - p.depth).
struct Fit {
  float high = -1e30f;
  float low = -1e30f;
  void add(float side, float depth, float slope) {
    high = std::max(high, side + slope * depth);
    low = std::max(low, -side + slope * depth);
  }
  float at() const { return 0.5f * (high - low); }
  float distance(float slope) const { return 0.5f * (high + low) / slope; }
};

// From the target to the camera.
glm::vec3 back_of(const Orbit& orbit) {
  return {std::sin(orbit.yaw) * std::cos(orbit.pitch), std::sin(orbit.pitch),
          std::cos(orbit.yaw) * std::cos(orbit.pitch)};
}

}  // namespace

glm::vec3 right_of(const Orbit& orbit) {
  return glm::normalize(glm::cross(glm::vec3(0, 1, 0), back_of(orbit)));
}

glm::vec3 up_of(const Orbit& orbit) {
  return glm::cross(back_of(orbit), right_of(orbit));
}

float view_height() {
  return 2 * std::tan(0.5f * kFieldOfView);
}

Orbit orbit_round(std::span<const glm::vec3> points, float aspect, float margin, const Orbit& side) {
  Box box;
  for (const glm::vec3& p : points) box.add(p);
  Orbit orbit = side;
  const glm::vec3 from_centre = frame_points_from(side, points, aspect, margin).position - box.centre();
  orbit.distance = glm::dot(from_centre, back_of(orbit));
  // On the camera's axis, as far away as the box's centre.
  orbit.target = box.centre() + from_centre - orbit.distance * back_of(orbit);
  return orbit;
}

Camera camera_on(const Orbit& orbit, float aspect, float radius) {
  Camera camera;
  camera.position = orbit.target + orbit.distance * back_of(orbit);
  const float near_plane = std::max(orbit.distance - 4 * radius, 0.01f * std::min(radius, orbit.distance));
  camera.clip_from_model = glm::perspective(kFieldOfView, aspect, near_plane, orbit.distance + 40 * radius) *
                           glm::lookAt(camera.position, orbit.target, glm::vec3(0, 1, 0));
  return camera;
}

Camera frame_points(std::span<const glm::vec3> points, float aspect, float margin, float turn_rad) {
  Orbit side;
  side.yaw += turn_rad;
  return frame_points_from(side, points, aspect, margin);
}

Camera frame_points_from(const Orbit& side, std::span<const glm::vec3> points, float aspect, float margin) {
  const glm::vec3 back = back_of(side), right = right_of(side), up = up_of(side);
  const float tangent_y = std::tan(0.5f * kFieldOfView);
  const float slope_y = tangent_y * (1 - 2 * margin);
  const float slope_x = tangent_y * aspect * (1 - 2 * margin);
  Fit x, y;
  float nearest = -1e30f;
  Box box;
  for (const glm::vec3& p : points) {
    const float depth = glm::dot(p, back);
    x.add(glm::dot(p, right), depth, slope_x);
    y.add(glm::dot(p, up), depth, slope_y);
    nearest = std::max(nearest, depth);
    box.add(p);
  }
  const float radius = std::max(box.radius(), 1e-20f);
  // A flat or tiny thing must not pull the lens into itself.
  const float distance = std::max({x.distance(slope_x), y.distance(slope_y), nearest + 0.5f * radius});
  Camera camera;
  camera.position = right * x.at() + up * y.at() + back * distance;
  const float near_plane = std::max(0.5f * (distance - nearest), 1e-3f * radius);
  const float far_plane = 2 * (distance - glm::dot(box.centre(), back)) + 20 * radius;
  camera.clip_from_model = glm::perspective(kFieldOfView, aspect, near_plane, far_plane) *
                           glm::lookAt(camera.position, camera.position - back, glm::vec3(0, 1, 0));
  return camera;
}

Camera moved(const Camera& camera, glm::vec3 by) {
  Camera out = camera;
  out.position += by;
  out.clip_from_model = camera.clip_from_model * glm::translate(glm::mat4(1), -by);
  return out;
}

Camera turned(const Camera& camera, glm::vec3 centre, float turn_rad) {
  const glm::mat4 turn = glm::translate(glm::mat4(1), centre) *
                         glm::rotate(glm::mat4(1), turn_rad, glm::vec3(0, 1, 0)) *
                         glm::translate(glm::mat4(1), -centre);
  Camera out;
  out.position = glm::vec3(turn * glm::vec4(camera.position, 1));
  out.clip_from_model = camera.clip_from_model * glm::inverse(turn);
  return out;
}

LightView frame_box(const Box& box, glm::vec3 direction, float margin) {
  const glm::vec3 centre = box.centre();
  const float radius = std::max(box.radius(), 1e-20f) * (1 + margin);
  const glm::vec3 up = std::abs(direction.y) > 0.99f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  const glm::mat4 view = glm::lookAt(centre + direction * (2 * radius), centre, up);
  LightView out;
  out.clip_from_model = glm::ortho(-radius, radius, -radius, radius, radius, 3 * radius) * view;
  out.extent = {2 * radius, 2 * radius};
  return out;
}

}  // namespace marrow::tools
