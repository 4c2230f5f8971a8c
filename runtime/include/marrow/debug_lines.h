// Lines that show what a frame came to: joints, limits, goals, springs, bounds. For a game's own debug view, which
// draws them as it draws any lines; a game that calls none of these links none of it.
//
//   once          lines in DebugLines::room
//   every frame   DebugLines::count = DebugLines::left_out = 0; then joint_lines(), limit_lines(), …
//
// All lines are in model space, metres. Each call appends. A line without room is left out and counted, and so is one
// with a number that is not finite. No allocation; thread-safe on different lines. Cost: a few products a line.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/ik_solve.h"
#include "marrow/springs.h"

namespace marrow {

// Of bones. As bytes R, G, B, A in memory, here and below: what GL_UNSIGNED_BYTE × 4 reads.
inline constexpr std::uint8_t kBoneColour[4] = {255, 255, 255, 255};
// Of the axes x, y and z.
inline constexpr std::uint8_t kAxisColours[3][4] = {{230, 60, 60, 255}, {70, 200, 70, 255}, {80, 120, 255, 255}};
inline constexpr std::uint8_t kInsideColour[4] = {70, 200, 70, 255};      // of a limit, and of a goal that is reached
inline constexpr std::uint8_t kOutsideColour[4] = {230, 60, 60, 255};     // beyond a limit, and the way to a goal
inline constexpr std::uint8_t kSpringColour[4] = {255, 190, 60, 255};     // bones of spring chains
inline constexpr std::uint8_t kColliderColour[4] = {190, 120, 255, 255};  // what springs stay out of
inline constexpr std::uint8_t kBoundsColour[4] = {120, 220, 230, 255};    // boxes and spheres

// A line to draw; model space.
struct DebugLine {
  float from[3] = {0, 0, 0}, to[3] = {0, 0, 0};   // its ends, metres
  std::uint8_t colour[4] = {255, 255, 255, 255};  // r g b a
};
static_assert(sizeof(DebugLine) == 28);

// Room for lines in the caller's memory. The calls below append to it.
struct DebugLines {
  Span<DebugLine> room = {};  // the caller's
  std::size_t count = 0;      // of lines that are there, from the front
  std::size_t left_out = 0;   // for which there was no room
};

// A line from each joint's parent to the joint, and the joint's axes x, y, z in red, green, blue: `axis_m` long
// whatever its scale; 0: none. model_from_joint: at least skeleton.joint_count. At most 4 lines a joint.
// Errors, of all that follow: bad_argument if a span is too short, a joint is not in the skeleton, or a length is below
// 0 or not finite; nothing is appended.
MARROW_API Status joint_lines(const Skeleton& skeleton, Span<const Affine> model_from_joint, float axis_m,
                              DebugLines& lines);

// What each limit lets the joint do, about the joint, `size_m` large. local: the pose that model_from_joint is of.
// A hinge: the arc along which its y moves. A cone: the rim along which its x moves at most, and four spokes. Euler
// angles: three arcs in the colours of their axes, each with the other angles at the middle. Then where the joint is
// now, in green inside the limit and red outside of it. Limits that is_valid() refuses are passed over. At most 51
// lines a limit.
MARROW_API Status limit_lines(const Skeleton& skeleton, Span<const JointLimit> limits, Span<const SoaTransform> local,
                              Span<const Affine> model_from_joint, float size_m, DebugLines& lines);

// A cross at each goal's position, or, where its rotation counts, the axes it asks for; and a line to it from the point
// of the joint that is to be there. Green within `tolerance_m`, else red. At most 4 lines a goal.
MARROW_API Status goal_lines(const Skeleton& skeleton, Span<const IkGoal> goals, Span<const Affine> model_from_joint,
                             float size_m, float tolerance_m, DebugLines& lines);

// The bones of each chain, and its tip. model_from_joint: after simulate_springs(). At most a line a joint.
MARROW_API Status spring_lines(const Skeleton& skeleton, Span<const SpringChain> chains,
                               Span<const Affine> model_from_joint, DebugLines& lines);

// Each collider as great circles about its ends, and lines between them: 48 lines a sphere, 100 a capsule.
MARROW_API Status collider_lines(const Skeleton& skeleton, Span<const SpringCollider> colliders,
                                 Span<const Affine> model_from_joint, DebugLines& lines);

// The box's edges and the sphere's three great circles: 60 lines; none if it is empty.
MARROW_API Status bounds_lines(const Bounds& bounds, DebugLines& lines);

}  // namespace marrow
