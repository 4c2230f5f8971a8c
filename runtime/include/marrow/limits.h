// Joint limits: how far a joint may turn from its parent, and the nearest rotation where it has turned farther.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// Rotations no farther outside than this keep their bits.
inline constexpr float kLimitTolerance_rad = 1e-5f;
// The widest swing of a cone: 170°.
inline constexpr float kWidestSwing_rad = 2.9670597f;

// A limit as people think of it.
struct LimitDescription {
  LimitKind kind = LimitKind::none;  // its shape
  AxisOrder order = AxisOrder::xyz;  // of euler
  float zero[4] = {0, 0, 0, 1};      // the local rotation where all angles are 0: most often the joint's rest
  float axis[3] = {1, 0, 0};         // the limit's x in the joint's axes: a hinge's axis, or what a cone points along
  float across[3] = {0, 1, 0};       // its y, made perpendicular to x
  // hinge: the first is the angle. Cone: the first is the twist; of the second and third, swings about y and z, `most`
  // is the half-width, and `least` its negative. Euler: the three angles.
  float least_rad[3] = {0, 0, 0};
  float most_rad[3] = {0, 0, 0};  // as least_rad
  RateLimit rate = {0, 0};        // 0: none
};

// Angles least_rad … most_rad; all of them if that is a turn or more.
// Precondition: -2π ≤ least_rad ≤ most_rad ≤ 2π. Off by at most 1e-6 rad; the same bits everywhere.
MARROW_API AngleRange angle_range(float least_rad, float most_rad);

// `out` is written only on success.
// Errors: bad_argument if a number is not finite, an axis or `zero` has no length, `across` is along `axis`, least is
// above most, an angle is beyond ±2π, a swing not in 0 … kWidestSwing_rad or not symmetric, the second angle of an
// euler limit beyond ±π/2, a rate not in 0 … 1e18, or a kind or order is none of the above.
MARROW_API Status make_limit(const LimitDescription& description, std::uint16_t joint, JointLimit& out);

// local: in, a rotation x y z w; out, one inside the limit, in the same hemisphere and of unit length.
//
// What is inside, or outside by no more than kLimitTolerance_rad, keeps its bits, so a second call changes nothing.
// What comes out is inside within the same tolerance.
//
// Outside it is the nearest rotation for a hinge; for a cone the nearest swing, and of the twists the nearest with it;
// for euler boxes one round of exact searches along each angle from the clamped angles. docs/ik/limits.md has how near
// that is. The nearest rotation jumps where one side of the range is as far as the other. So that the result moves
// continuously, over the last quarter of the way from the limit to there it moves through the middle of the range: of a
// turn about an axis to the angle opposite the middle, of a swing to 180°, where in its place the twist is lost; and of
// euler angles to ±90° of the second, where the third and the first are one. Distances are as tangents of a quarter of
// the angle. A range of all angles is a circle, to which nothing leads continuously: it jumps at a swing of 180°, and
// an euler limit whose second angle reaches ±90° jumps there, by no more than twice what the rotation is outside.
//
// Errors: bad_argument if the rotation has no length or is not finite; nothing is written.
// Cost: 5 to 15 products of quaternions and a few square roots, inside 3; no trigonometry. Thread-safe.
MARROW_API Status clamp_rotation(const JointLimit& limit, float (&local)[4]);

// By how many radians clamp_rotation() would turn the rotation; 0 for what keeps its bits, and for what it refuses.
MARROW_API float limit_excess(const JointLimit& limit, const float (&local)[4]);

// clamp_rotation() for each limit's joint; all other joints keep their bits, and so do rotations that are not finite.
// local: of a skeleton that has all the joints. Errors: bad_argument if it has not; nothing is written.
// Cost: clamp_rotation() a limit. Thread-safe on different poses.
MARROW_API Status limit_pose(Span<const JointLimit> limits, Span<SoaTransform> local);

// The limit of a joint, or null. Precondition: the limits' joints ascend, as in a Skeleton. Cost: a binary search.
MARROW_API const JointLimit* find_limit(Span<const JointLimit> limits, std::uint32_t joint);

// Limits over time. What follows a target with limited speed and acceleration: plain numbers, one for each rotation or
// point that follows. A new one and one whose numbers no call has left begin anew: the next call takes its target as it
// is, at rest.
struct RotationFollower {
  float rotation[4] = {};  // where it is: x y z w
  float target[4] = {};    // of the last call
  float velocity[3] = {};  // radians a second, about the parent's axes
  float frame_s = 0;       // of the last call
  std::uint32_t mode = 0;  // follow_rotation()'s own
};
// A point that follows another.
struct PointFollower {
  float point[3] = {};     // where it is, metres
  float target[3] = {};    // of the last call
  float velocity[3] = {};  // metres a second
  float frame_s = 0;       // of the last call
  std::uint32_t mode = 0;  // follow_point()'s own
};

// Moves `state` for dt_s towards a target that went straight from where it was in the last call to `target`; the result
// is state.rotation or state.point.
//
// A follower that is on its target stays on it, to the bit, as long as the target keeps within the limits. Else it goes
// the quickest way there that they allow, and brakes in time: towards a target at rest it neither passes it nor swings
// about it, unless it is too fast already or comes from aside. Braking uses nine tenths of the acceleration; the last
// part, of 0.9 acceleration / 120² s⁻², is approached as exp(-120 t / s). Without a limit of acceleration it goes with
// the speed until it is there; without any limit it is on its target.
// Rotations go the shorter way round, along the great circle if they come from rest. Where their target passes aside
// they may exceed the acceleration by a few hundredths.
//
// The path is the same at any frame rate but for how its target is sampled: time goes in even steps of at most 1/960 s,
// each with constant acceleration. At rates that divide 960 Hz paths to a target at rest agree to rounding, at others
// from 15 to 240 Hz within the larger of 1e-4 rad (m) and 0.1 % of the way; moving targets: docs/ik/limits.md.
//
// dt_s of 0 changes nothing; what is above 0.25 s counts as 0.25 s, and less than a nanosecond as that. So all that a
// follower keeps is finite.
// Errors: bad_argument if a number is not finite, dt_s or a limit below 0, a limit from 1e18 on, a target from 1e15 m
// on, the target's quaternion has no length; nothing is written. Cost: on the target, a comparison and a logarithm of a
// quaternion; else a square root or two each step. No trigonometry of a library; the same bits everywhere. Thread-safe
// on different states.
MARROW_API Status follow_rotation(RotationFollower& state, const float (&target)[4], float dt_s,
                                  const RateLimit& limit);
MARROW_API Status follow_point(PointFollower& state, const float (&target)[3], float dt_s, const RateLimit& limit);

// follow_rotation() for the joints whose limit has a rate: in, the pose's rotations are the targets; out, what follows.
// All others keep their bits. To stay inside the limits call limit_pose() before, for the targets, and after, for the
// way there may lead outside.
// states: one a limit. Errors: bad_argument if there are too few, a joint is beyond the pose, or dt_s is below 0 or not
// finite; nothing is written. Joints whose rotation is not finite keep it.
MARROW_API Status follow_pose(Span<const JointLimit> limits, Span<RotationFollower> states, float dt_s,
                              Span<SoaTransform> local);

}  // namespace marrow
