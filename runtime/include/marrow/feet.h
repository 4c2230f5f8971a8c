// Feet on the ground, for poses after local_to_model(). Soles stand where the game's rays hit, planted feet stay in
// place, and the pelvis moves so that the legs reach.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/local_to_model.h"
#include "marrow/roles.h"

namespace marrow {

// A leg. Other joints may lie between the three; those keep their local rotations. For a hind leg, which has three
// bones, set hip, knee and paw.
struct Foot {
  std::uint32_t hip = 0, knee = 0, ankle = 0;  // joints of the skeleton
  float sole[3] = {0, 0, 0};  // the point that stands on the ground, below the ball of the foot, say; ankle's space
  float bend_axis[3] = {0, 0, 0};  // of the knee; see TwoBone
  float weight = 1.0f;             // 0 … 1
};

// The legs of a character, whose clips are made for level ground through the model's origin.
struct Feet {
  Span<const Foot> feet = {};       // two or more
  std::uint32_t pelvis = kNoJoint;  // moves up and down with all below it, hips included; kNoJoint: no joint moves
  float lower_m = 0.5f;             // ≥ 0: the most that the pelvis moves from its animated place, down or up; world
  // 0 … 1: how long a leg may get, as a share of its bones, before the pelvis goes down for it.
  float leg_extension = 0.99f;
  float slope_rad = 0.6f;  // 0 … 1.5: the steepest slope that a foot follows
  float ease_s = 0.25f;    // > 0: time in which an offset, from a step in the ground or a release, falls to 2 %
};

// The ground under a foot in this frame, from the game; world.
struct FootGround {
  bool hit = false;             // false: as if the ground were level at the height of the model's origin
  float point[3] = {0, 0, 0};   // where a ray along `up` through foot_sole() hit, or any point of the plane that it hit
  float normal[3] = {0, 1, 0};  // of any length; steeper than 80°: no hit
  bool planted = false;         // the sole stays where it is for as long as this is true
};

// What place_feet() keeps of one foot from frame to frame. A new motion begins where the animation has the foot. So
// does one whose numbers are out of range. On a moving platform, use the platform's space as the world.
struct FootMotion {
  float place[3] = {};                   // of the sole, as shown last; world
  alignas(4) std::byte state[112] = {};  // place_feet()'s own
  bool reached = false;                  // whether the leg was long enough
};

// What place_feet() is told of a frame.
struct FeetFrame {
  float dt_s = 0;  // since the last frame
  // The character's placement: a rotation, one uniform scale above 0 and a translation.
  Affine world_from_model = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  float up[3] = {0, 1, 0};  // a unit vector; world
  bool teleported = false;  // feet begin anew, none is planted where it was
  float weight = 1.0f;      // 0 … 1, times each foot's; motions go on at 0 too
};

// The leg that stands with this role: left_foot or right_foot, or of an animal's front legs left_hand or right_hand.
// `out` keeps its bend_axis and its weight.
// Errors: bad_argument for another role; mismatch if a joint of the leg, or its sole, is not known. `out` is written
// only on success. Cost: a few looks at the roles; once a load. Thread-safe.
MARROW_API Status foot_of(const Roles& roles, Role role, Foot& out);

// The animated place of a foot's sole, in the world: the point for a ray to go through.
// Errors: bad_argument if the span is too short, there is no such joint, or the place is not finite or beyond 1e6.
MARROW_API Status foot_sole(const Foot& foot, const Affine& world_from_model, Span<const Affine> model_from_joint,
                            float (&sole_world)[3]);

// Places the feet: turns hips, knees and ankles, shifts the pelvis, and updates the matrices of what hangs below. Call
// it after local_to_model(), and cast the rays before it, from the same pose.
//
// pose: the animated one. ground, motion: one a foot.
//
// The sole's target is its animated place, lifted by the height of the ground's plane there above the level ground of
// the animation. The foot tilts with the plane, about its sole. A planted foot keeps its place across `up`, and its
// heading; along `up` it moves as animated, so that a heel can rise. When the ground's plane changes, or a foot is
// released, the target jumps but the sole does not: the difference becomes the sole's offset from the target. The
// offset goes on at the foot's speed, so that neither place nor speed jumps, and dies away as a critically damped
// spring does, exactly at any frame rate. The pelvis rises or sinks with the lowest sole, and sinks further if legs are
// too short. Ankles keep their animated orientation except for lean and heading. See docs/ik/feet.md.
//
// Errors: bad_argument if a span is too short, joints are not as they should be, or a number is not finite, out of its
// range or beyond 1e6; nothing is written.
// Cost: local_to_model_below() of the pelvis, if that moves, of each hip and each ankle; one solve_two_bone() a foot,
// up to three where joints are scaled unevenly: 6700 instructions a foot on x86-64, the skeleton having 27 joints. No
// allocation; thread-safe on different motions and poses.
MARROW_API Status place_feet(const Pose& pose, const Feet& feet, const FeetFrame& frame, Span<const FootGround> ground,
                             Span<FootMotion> motion);

}  // namespace marrow
