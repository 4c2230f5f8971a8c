// Stage 3½, feet on the ground: soles follow rays, planted feet stay where they are, the pelvis gives way.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// A leg. Other joints may lie between these: a hind leg of three bones is hip, knee and paw, and what is between keeps
// its angle.
struct Foot {
  std::uint32_t hip = 0, knee = 0, ankle = 0;  // joints of the skeleton
  float sole[3] = {0, 0, 0};       // what stands on the ground, in the ankle's space: below the ball of the foot, say
  float bend_axis[3] = {0, 0, 0};  // of the knee; see TwoBone
  float weight = 1.0f;             // 0 … 1
};

// Two legs or more. The clips have been made for level ground, through the scene's origin.
struct Feet {
  Span<const Foot> feet = {};       // two or more
  std::uint32_t pelvis = kNoJoint;  // moved up and down, with all that hangs on it, the hips too; none: stays
  float lower_m = 0.5f;             // ≥ 0: by how much at most it goes down, or up; world
  float reach = 0.99f;     // 0 … 1: it goes down, too, where a leg would be longer than this share of its bones
  float slope_rad = 0.6f;  // 0 … 1.5: by how much at most a foot leans with the ground
  float ease_s = 0.25f;    // > 0: the time in which all but 2 % of a step in the ground, or of a release, is over
};

// What the game knows of a foot in this frame; world.
struct FootGround {
  bool hit = false;             // false: as if the ground were level at the height of the scene's origin
  float point[3] = {0, 0, 0};   // of a ray along `up` through foot_sole(), or anywhere on the plane that it hit
  float normal[3] = {0, 1, 0};  // of any length; steeper than 80°: no hit
  bool planted = false;         // the sole stays at its place until this is false again
};

// The motion of one foot: plain numbers. A new one and one whose numbers are out of hand begin where the animation has
// the foot. World; on a moving platform, let the world be the platform.
struct FootMotion {
  float place[3] = {};                            // of the sole, as shown last
  float offset[3] = {}, offset_speed[3] = {};     // of the sole from its target
  float lean[3] = {}, lean_speed[3] = {};         // of the ground's normal that the foot leans by from the ground's own
  float point[3] = {}, normal[3] = {};            // the ground, last
  float heading[3] = {};                          // level: of the ankle's axis `axis` when it was planted
  float turn[4] = {};                             // about up, from the animated to the planted heading
  float turn_share = 0, turn_share_speed = 0;     // how much of it is left
  std::uint8_t axis = 0, planted = 0, begun = 0;  // whether it is planted, and was begun
  std::uint8_t hit = 0;                           // whether its ray found ground
  std::uint8_t reached = 0;                       // whether the leg was long enough
};

// What place_feet() is told of a frame.
struct FeetFrame {
  float dt_s = 0;  // since the last frame
  // Where the character stands: a turn, one scale above 0, a shift.
  Affine world_from_scene = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  float up[3] = {0, 1, 0};  // a unit vector; world
  bool teleported = false;  // feet begin anew, none is planted where it was
  float weight = 1.0f;      // 0 … 1, times each foot's; the motion goes on
};

// Where a ray for a foot is to go through: its sole as animated, in the world.
// Errors: bad_argument if the span is too short, there is no such joint, or the place is not finite or beyond 1e6.
MARROW_API Status foot_sole(const Foot& foot, const Affine& world_from_scene, Span<const Affine> scene_from_joint,
                            float (&sole_world)[3]);

// Places the feet: turns hips, knees and ankles, shifts the pelvis, and brings the matrices of what hangs below up to
// date. Call it after local_to_model(), and cast the rays before it, from the same pose.
//
// local, scene_from_joint: the animated pose, at least skeleton.soa_size() and joint_count. ground, motion: one a foot.
//
// The sole's target is its animated place, lifted by the height of the ground's plane there; the foot leans with the
// plane about its sole. What is planted keeps its place across `up`, and its heading; along `up` it moves as animated,
// so that a heel can rise. A step in the ground (another plane than in the last frame), and on release the way to the
// target, are an offset from the target that dies away as a critically damped spring at rest does, with the speed
// that it had: exact whatever the frame rate, and without a jump in place or speed. The pelvis moves by the lowest
// sole's ground, and as much further down as the legs need to reach. Ankles keep their animated attitude but for lean
// and heading. See docs/ik/feet.md.
//
// Errors: bad_argument if a span is too short, joints are not as they should be, or a number is not finite, out of its
// range or beyond 1e6; nothing is written.
// Cost: local_to_model_below() of the pelvis, if that moves, of each hip and each ankle; one solve_two_bone() a foot,
// up to three where joints are scaled unevenly: 6700 instructions a foot on x86-64, the skeleton having 27 joints. No
// allocation; thread-safe on different motions and poses.
MARROW_API Status place_feet(const Skeleton& skeleton, const Feet& feet, const FeetFrame& frame,
                             Span<const FootGround> ground, Span<FootMotion> motion, Span<SoaTransform> local,
                             Span<Affine> scene_from_joint);

}  // namespace marrow
