// Values and poses between frames that are evenly apart, by polynomials of the frames next to them.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "marrow/pose.h"
#include "text/choices.h"

namespace marrow::deform {

enum class BetweenFrames {
  linear,     // the line through both; of rotations the turn at a constant speed
  quadratic,  // the parabola through the frame before and both: what a player knows that looks one frame ahead
  cubic,      // between that parabola and the one through both and the next (Overhauser 1968; Catmull and Rom 1974)
};
inline constexpr tools::Named<BetweenFrames> kBetweenFrames[] = {
    {"linear", BetweenFrames::linear}, {"quadratic", BetweenFrames::quadratic}, {"cubic", BetweenFrames::cubic}};

// at: in frames, from 0 to the last. Every frame is met. Where a frame is wanting at an end the other parabola counts
// alone, and of two frames the line. frames: at least one.
glm::dvec3 between_frames(BetweenFrames kind, const std::vector<glm::dvec3>& frames, double at);
// Unit quaternions, whatever their signs; beside slerp their numbers are interpolated, and made a unit again.
glm::dquat between_frames(BetweenFrames kind, const std::vector<glm::dquat>& frames, double at);

// As between_frames() of each joint's translation, rotation and scale; frames: at least one, all as long.
std::vector<SoaTransform> between_poses(BetweenFrames kind, const std::vector<std::vector<SoaTransform>>& frames,
                                        double at);

}  // namespace marrow::deform
