// Posing the newt: turns in model axes, limbs by direction, feet by where they stand, curves that loop.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>
#include <vector>

#include "newt_skeleton.h"

namespace marrow::sample {

struct Pose {
  Pose();
  // Turn of each joint against its parent, in the axes of model space as if the parent were at rest.
  std::array<glm::quat, kJointCount> turn;
  std::array<glm::vec3, kJointCount> scale;
  glm::vec3 hips{0};           // shift of the pelvis
  glm::quat gaze{1, 0, 0, 0};  // turn of both eyes
  // Where all of it has gone to since the clip's beginning: carries the pelvis, with all that is posed above.
  glm::vec3 way{0};
  float heading = 0;  // degrees to its left, about the origin
};

// From one pose to another; what has been gone is `a`'s.
Pose mix(const Pose& a, const Pose& b, float share);

// Degrees about X (nods forward), Y (to the creature's left) and Z (leans to its right); roll first, then nod, then
// turn.
glm::quat turned(float x, float y, float z);

// Adds a turn to a joint.
void bend(Pose& pose, int joint, float x, float y = 0, float z = 0);

// Turns a joint about its own bone, by degrees.
void twist(Pose& pose, int joint, float degrees);

// Aims an arm: the upper arm along `along`, the elbow flexed by `flex` degrees so that the forearm goes towards
// `towards`. Directions are in the chest's axes and for the left arm; the right one mirrors them.
void aim_arm(Pose& pose, int side, glm::vec3 along, glm::vec3 towards, float flex);

// How a foot stands: the shift of its ground point, and its pitch in degrees (toes up positive; about the heel when
// positive, about the ball of the foot, with the toes flat, when negative).
struct Stand {
  glm::vec3 shift{0};
  float pitch = 0;
  float yaw = 0;
};

// Puts a foot where `stand` says, by bending hip and knee; the knee points towards `knee`. The hips must be posed.
void plant_foot(Pose& pose, int side, const Stand& stand, glm::vec3 knee);

// A periodic curve over phase 0..1 through (phase, value) points; flat where the points turn around, so it never
// overshoots. The first point is at 0 and stands for 1 as well.
float curve(const std::vector<std::pair<float, float>>& points, float phase);
glm::vec3 curve(const std::vector<std::pair<float, glm::vec3>>& points, float phase);

// The same of what happens once: it holds still before the first point and behind the last one.
float passage(const std::vector<std::pair<float, float>>& points, float at);
glm::vec3 passage(const std::vector<std::pair<float, glm::vec3>>& points, float at);

}  // namespace marrow::sample
