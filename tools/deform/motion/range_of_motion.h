// Poses of one joint at a time, as far as joints turn and farther than clips show.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// Of all joints whether they turn along with one: itself and those below it. parents: of each joint its parent, or
// below 0.
std::vector<char> turned_along(std::uint32_t joint, const std::vector<int>& parents);

// The bind pose but for joints that turn along, about `centre`.
Pose turned(const std::vector<char>& turns, const glm::dvec3& centre, const glm::dmat3& turn);

enum class MotionKind { twist, bend, other_bend };  // about the bone, about two axes across it
const char* name_of(MotionKind kind);               // "twist", "bend", "other bend"

// A joint, and all below it, turned from the bind pose.
struct MotionPose {
  std::uint32_t joint = 0;
  MotionKind kind = MotionKind::twist;  // as it was meant; limits may have tilted the axis
  double angle_rad = 0;                 // either sign
  glm::dvec3 axis{0}, centre{0};        // what it turns about: unit, and a point of it; bind frame
  // Of all joints which turn along; poses of one joint share it.
  std::shared_ptr<const std::vector<char>> turns;

  // The identity for joints that stay. 96 bytes a joint, so it is made when asked for.
  Pose pose() const;
};

// A joint that has no poses, or none of a kind.
struct LeftOut {
  enum class Why {
    no_vertices,      // none follow it or what is below it
    moves_as_one,     // what follows it hangs on nothing else: the surface stays as it is
    not_finite,       // its place in the bind pose is not
    no_axis,          // children, vertices and parent are all where it is
    limits,           // forbid all turns
    limits_of_twist,  // forbid twists
    limits_of_bends,  // forbid bends
  };
  std::uint32_t joint = 0;
  Why why = Why::no_vertices;
};
// "no vertex follows it", and the like.
const char* text_of(LeftOut::Why why);

struct MotionOptions {
  double twist_rad = 170 * std::numbers::pi / 180;
  double bend_rad = 130 * std::numbers::pi / 180;
  std::uint32_t steps = 2;  // to there, each way
  // The turn next to `turn` that a joint may make from the bind pose; both about its place, in the bind frame. Empty:
  // any.
  std::function<glm::dquat(std::uint32_t joint, const glm::dquat& turn)> nearest_allowed;
};

struct RangeOfMotion {
  std::vector<MotionPose> poses;  // by ascending joint, of a joint by kind
  std::vector<LeftOut> left_out;  // by ascending joint
};

// Turns each joint about its bone and about two axes across. A bone goes to the mean of its children; that of a joint
// without any, or with all in one place, to the mean of its vertices, and if they are there too, on from its parent.
// The bend's axis is across the bone and the axis of the bind frame that is least along it.
//
// Joints that only move what hangs on them alone, the root say, have no poses: nothing is deformed. With limits, poses
// nearer than 5° to the bind pose or to another of the joint are left out, and those whose axis limits tilt by more
// than 60°.
// parents: of each joint its parent, or below 0. centres: where joints are in the bind pose.
// The same bits everywhere. Cost: joints times vertices.
RangeOfMotion range_of_motion(const SkinnedMesh& mesh, const std::vector<int>& parents,
                              const std::vector<glm::dvec3>& centres, const MotionOptions& options = {});

// Of each vertex how much of it follows the joints that turn: 0 … 1.
std::vector<double> turned_shares(const SkinnedMesh& mesh, const std::vector<char>& turns);

}  // namespace marrow::deform
