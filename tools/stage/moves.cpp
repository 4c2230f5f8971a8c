#include "stage/moves.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace marrow::tools {
namespace {

constexpr float kTurn = 0.008f;                    // radians a point
constexpr float kZoom = 0.12f;                     // a step of the wheel
constexpr float kLowest = -0.6f, kHighest = 1.5f;  // radians above the horizon

}  // namespace

void turn_orbit(Orbit& orbit, float dx, float dy) {
  orbit.yaw = std::remainder(orbit.yaw - kTurn * dx, 6.2831853f);
  orbit.pitch = std::clamp(orbit.pitch + kTurn * dy, kLowest, kHighest);
}

void zoom_orbit(Orbit& orbit, float steps, float radius) {
  orbit.distance = std::clamp(orbit.distance * std::exp(-kZoom * steps), 0.02f * radius, 40 * radius);
}

float depth_of(const Orbit& orbit, glm::vec3 place) {
  const glm::vec3 back = glm::cross(right_of(orbit), up_of(orbit));
  return orbit.distance - glm::dot(place - orbit.target, back);
}

glm::vec3 dragged_by(const Orbit& orbit, float dx, float dy, float height, float depth) {
  const float unit = view_height() * depth / height;
  return unit * (dx * right_of(orbit) - dy * up_of(orbit));
}

std::string goal_text(const std::string& joint, glm::vec3 point) {
  return fmt::format("{}={:.6g},{:.6g},{:.6g}", joint, point.x, point.y, point.z);
}

std::string goal_name(const std::string& goal) {
  return goal.substr(0, goal.rfind('='));
}

glm::vec3 goal_point(const std::string& goal) {
  glm::vec3 p(0);
  const std::size_t equals = goal.rfind('=');
  if (equals != std::string::npos) std::sscanf(goal.c_str() + equals + 1, "%f,%f,%f", &p.x, &p.y, &p.z);
  return p;
}

}  // namespace marrow::tools
