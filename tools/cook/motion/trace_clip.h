// Where feet and hips go in the course of a clip, and what of a foot may touch the ground.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "cook/clip/measure/rig.h"
#include "cook/scene/built.h"
#include "marrow/roles.h"

namespace marrow::cook {

// A point that follows one joint; in that joint's space.
struct FootPoint {
  std::uint16_t joint = 0;
  glm::dvec3 place{0};
};

// A foot, or a hand that is a front foot.
struct FootShape {
  Role role = Role::none;
  double leg_m = 0;               // from the top of the leg to the sole, at rest
  double rest_m = 0;              // the sole's height at rest
  FootPoint ball;                 // below the ball of the foot: JointSole::place
  std::vector<FootPoint> points;  // that may touch the ground
};

// Feet of a skeleton that have a sole and a leg. The points of a foot are the vertices of it and all below it that are
// farthest down, and down to each side; without vertices the ball, and the heel below the ankle. meshes: of the
// skeleton, as in build_roles().
std::vector<FootShape> find_foot_points(const BuiltSkeleton& skeleton, const std::vector<Mesh>& meshes);

// The lowest point of a foot at a moment, and the ball of the foot. Model space, metres and seconds.
struct LowPoint {
  glm::dvec3 place{0}, velocity{0}, ball{0}, ball_velocity{0};
};

// A foot, see FootShape.
struct FootTrace {
  Role role = Role::none;
  double leg_m = 0, rest_m = 0;
  std::vector<LowPoint> points;  // a frame
};

// A clip in frames that are evenly spaced; the first at its start, the last at its end.
struct ClipTrace {
  double frame_s = 0;            // 0: a clip that is too short or too long to be looked at
  std::size_t frames_a_key = 1;  // about as many as from key to key of the source
  std::vector<FootTrace> feet;
  std::vector<glm::dvec3> hips;       // a frame, model space; where there are no hips, of the first root
  std::vector<glm::dquat> hips_turn;  // a frame: since rest, model space

  std::size_t size() const { return hips.size(); }
  double duration_s() const { return frame_s * static_cast<double>(size() - 1); }
};

// On the ground.
inline glm::dvec3 level(const glm::dvec3& v) {
  return {v.x, 0, v.z};
}
// The mean of its legs' lengths; 1 m without legs.
double leg_of(const ClipTrace& trace);
// The turn about y in a rotation; the identity where it is upside down and there is none.
glm::dquat heading_of(const glm::dquat& turn);

// clip: of the skeleton, with its keys as the source has them. feet: of find_foot_points().
ClipTrace trace_clip(const BuiltClip& clip, const BuiltSkeleton& skeleton, const std::vector<FootShape>& feet);

}  // namespace marrow::cook
