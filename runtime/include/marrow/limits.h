// Joint limits: how far a joint may turn against its parent, and the nearest rotation within that.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// Rotations that exceed a limit by no more than this keep their bits.
inline constexpr float kLimitTolerance_rad = 1e-5f;
// The widest swing of a cone: 170°.
inline constexpr float kWidestSwing_rad = 2.9670597f;

// A limit as people describe it, by angles.
struct LimitDescription {
  LimitKind kind = LimitKind::none;  // its shape
  AxisOrder order = AxisOrder::xyz;  // of a euler limit
  float zero[4] = {0, 0, 0, 1};      // the local rotation at which all angles are 0: most often the joint's rest
  float axis[3] = {1, 0, 0};         // the limit's x in the joint's axes: a hinge's axis, a cone's middle
  float across[3] = {0, 1, 0};       // the limit's y; made perpendicular to x
  // Hinge: [0] is the angle. Cone: [0] is the twist; [1] and [2] are swings about y and z, for which least_rad must be
  // -most_rad. Euler: the three angles.
  float least_rad[3] = {0, 0, 0};
  float most_rad[3] = {0, 0, 0};  // as least_rad
  RateLimit rate = {0, 0};        // 0: none
};

// The range of angles least_rad … most_rad; all angles if that is a turn or more.
// Precondition: -2π ≤ least_rad ≤ most_rad ≤ 2π. Off by at most 1e-6 rad; the same bits everywhere.
MARROW_API AngleRange angle_range(float least_rad, float most_rad);

// `out` is written only on success.
// Errors: bad_argument if a number is not finite, an axis or `zero` has no length, `across` is along `axis`, least is
// above most, an angle is beyond ±2π, a swing not in 0 … kWidestSwing_rad or not symmetric, the second angle of an
// euler limit beyond ±π/2, a rate not in 0 … 1e18, or a kind or order is no value of its enum.
MARROW_API Status make_limit(const LimitDescription& description, std::uint16_t joint, JointLimit& out);

// local: in, a rotation x y z w; out, one inside the limit, in the same hemisphere and of unit length.
//
// A rotation that is inside, or outside by no more than kLimitTolerance_rad, keeps its bits, so a second call changes
// nothing. The result is inside within the same tolerance.
//
// The result depends on the kind. Hinge: the nearest rotation. Cone: the nearest swing, with the nearest twist for that
// swing. Euler: the clamped angles, improved by one round of exact searches along each angle; docs/ik/limits.md says
// how near that is.
//
// The nearest rotation jumps half way round, where both ends of the range are equally far. To avoid the jump, the
// result moves from the range's end to its middle over the last quarter of the way from that end to that point. For a
// turn about an axis that point is the angle opposite the middle. For a swing it is 180°, where the twist is undefined.
// For euler angles it is ±90° of the second angle, where the first and the third turn about the same axis. Distances
// are measured as tangents of a quarter of the angle. Two jumps remain. A range of all angles has no middle: its result
// jumps at a swing of 180°. A euler limit whose second angle may be ±90° jumps there, by no more than twice the angle
// by which the rotation is outside.
//
// Errors: bad_argument if the rotation has no length or is not finite; nothing is written.
// Cost: 5 to 15 products of quaternions and a few square roots; 3 products for a rotation that is inside. No
// trigonometry. Thread-safe.
MARROW_API Status clamp_rotation(const JointLimit& limit, float (&local)[4]);

// The angle by which clamp_rotation() would turn the rotation, in radians; 0 if the rotation would keep its bits or be
// refused.
MARROW_API float limit_excess(const JointLimit& limit, const float (&local)[4]);

// Does clamp_rotation() for the joint of each limit. All other joints keep their bits, and so do rotations that are not
// finite. local: of a skeleton that has all those joints. Errors: bad_argument if not; nothing is written.
// Cost: clamp_rotation() a limit. Thread-safe on different poses.
MARROW_API Status limit_pose(Span<const JointLimit> limits, Span<SoaTransform> local);

// The limit of a joint, or null. Precondition: the limits' joints ascend, as in a Skeleton. Cost: a binary search.
MARROW_API const JointLimit* find_limit(Span<const JointLimit> limits, std::uint32_t joint);

// A rotation that follows a target with limited speed and acceleration: plain numbers. The next call puts a new
// follower on its target, at rest. It does the same with one that holds numbers out of range, which no call can have
// stored.
struct RotationFollower {
  float rotation[4] = {};  // x y z w
  float target[4] = {};    // of the last call
  float velocity[3] = {};  // radians a second, about the parent's axes
  float frame_s = 0;       // of the last call
  std::uint32_t mode = 0;  // follow_rotation()'s own
};
// A point that follows another likewise.
struct PointFollower {
  float point[3] = {};     // metres
  float target[3] = {};    // of the last call
  float velocity[3] = {};  // metres a second
  float frame_s = 0;       // of the last call
  std::uint32_t mode = 0;  // follow_point()'s own
};

// Moves `state` on by dt_s. The target is taken to move in a straight line during that time, from the last call's
// target to `target`. The result is state.rotation or state.point.
//
// A follower on its target stays on it, to the bit, as long as the target keeps within the limits. Otherwise it takes
// the quickest way that the limits allow, and brakes in time: it does not overshoot a target at rest, unless it was too
// fast already or moved sideways. It brakes at 0.9 of the acceleration; within 0.9 acceleration / (120 s⁻¹)² of the
// target the distance falls as exp(-120 s⁻¹ · time) instead. Without a limit of acceleration it moves at the speed
// limit until it is there; without any limit it is always on its target. Rotations go the shorter way round, from rest
// along the great circle. While their target passes by sideways, rotations may exceed the acceleration by a few per
// cent.
//
// The path does not depend on the frame rate, except for how that samples the target: time advances in even steps of at
// most 1/960 s with constant acceleration. At rates that divide 960 Hz, paths to a target at rest agree to rounding; at
// others from 15 to 240 Hz, within the larger of 1e-4 rad (m) and 0.1 % of the way. Moving targets: docs/ik/limits.md.
//
// dt_s of 0 changes nothing. More than 0.25 s counts as 0.25 s, and less than a nanosecond as a nanosecond: so a
// follower's numbers stay finite.
// Errors: bad_argument if a number is not finite, dt_s or a limit is below 0, a limit is 1e18 or more, a target is 1e15
// m away or more, or the target's quaternion has no length; nothing is written. Cost: on the target, a comparison and a
// logarithm of a quaternion; else a square root or two each step. No trigonometry of a library; the same bits
// everywhere. Thread-safe on different states.
MARROW_API Status follow_rotation(RotationFollower& state, const float (&target)[4], float dt_s,
                                  const RateLimit& limit);
MARROW_API Status follow_point(PointFollower& state, const float (&target)[3], float dt_s, const RateLimit& limit);

// Does follow_rotation() for each joint whose limit has a rate: the pose's rotation is the target, and is replaced by
// the follower's. All other joints keep their bits. To stay inside the limits, call limit_pose() before, for the
// targets, and again after, since the way to a target may lead outside.
// states: one a limit. Errors: bad_argument if there are too few, a joint is not in the pose, or dt_s is below 0 or not
// finite; nothing is written. A rotation that is not finite stays as it is.
MARROW_API Status follow_pose(Span<const JointLimit> limits, Span<RotationFollower> states, float dt_s,
                              Span<SoaTransform> local);

}  // namespace marrow
