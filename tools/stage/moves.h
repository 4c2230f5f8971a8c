// What a hand on the picture does: it moves the camera, and drags goals.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "render/camera.h"

namespace marrow::tools {

// dx, dy: of the hand, points to the right and down.
void turn_orbit(Orbit& orbit, float dx, float dy);
// steps: of a wheel, towards the target. radius: of what stands there.
void zoom_orbit(Orbit& orbit, float steps, float radius);
// How far a place is before the camera.
float depth_of(const Orbit& orbit, glm::vec3 place);
// How far what is so far before the camera goes with the hand, in the plane of the picture. height: of the picture,
// points.
glm::vec3 dragged_by(const Orbit& orbit, float dx, float dy, float height, float depth);

// A goal as ReachArguments has it, "hand=0.4,1.1,0.3", and its parts.
std::string goal_text(const std::string& joint, glm::vec3 point);
std::string goal_name(const std::string& goal);
glm::vec3 goal_point(const std::string& goal);

}  // namespace marrow::tools
