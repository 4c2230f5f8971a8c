// The joints of a character as a file has them, with their limits and springs.
#pragma once

#include "marrow/api.h"
#include "marrow/pose.h"
#include "marrow/span.h"

namespace marrow {

// Limits that every valid file keeps, so that a caller can bound its memory by them.
inline constexpr std::uint32_t kMaxJoints = 32767;
// No joint: in Skeleton::parents a root.
inline constexpr std::uint16_t kNoJoint = 0xFFFF;

// The shape of a JointLimit: which rotations it allows.
enum class LimitKind : std::uint8_t {
  none,   // turns freely; for joints that have a rate limit alone
  hinge,  // about one axis, between two angles: knees, elbows, fingers
  cone,   // swing inside an elliptic cone, twist between two angles: necks, shoulders, hips
  euler,  // three angles about three axes, each within its own range: for rigs with Euler-angle limits
};

// The order of the product, first letter first: xyz is Rx · Ry · Rz. Applied to a vector, z comes first.
enum class AxisOrder : std::uint8_t { xyz, xzy, yxz, yzx, zxy, zyx };

// Angles from middle - half_width to middle + half_width, both as the tangent of a quarter of the angle, so that a
// clamp needs no trigonometry: half an angle has the sine 2 t / (1 + t²) and the cosine (1 - t²) / (1 + t²). See
// angle_range() in limits.h.
struct AngleRange {
  float middle = 0;      // -1 … 1: -180° … 180°
  float half_width = 0;  // 0 … 1; 1: any angle
};

// The highest speed and acceleration; 0: no limit. In radians for rotations, in metres for points.
struct RateLimit {
  float speed = 0;         // rad/s or m/s
  float acceleration = 0;  // rad/s² or m/s²
};

// How far and how fast a joint may turn, as it lies in a cooked file; make one with make_limit(), see limits.h.
//
// The limit has axes of its own, fixed to the joint. At the joint's zero rotation they coincide with axes fixed to the
// parent. In them a local rotation q (parent_from_joint) is
//   t = limit_from_parent · q · joint_from_limit,   limit_from_parent = (zero · joint_from_limit)⁻¹
// so that t is the identity where q = zero. Angles are positive by the right hand: about x from y to z.
//
// hinge: t is a turn about x, by an angle in angles[0].
// cone: t = swing · twist, the twist, about x, first. The twist is an angle in angles[0]. The swing turns by θ about a
//   unit axis in the y-z plane. The point (y, z) = tan(θ / 4) · axis lies in the ellipse with the half axes
//   angles[1].half_width and angles[2].half_width. So angles[1] holds the widest swing about y alone, angles[2] the
//   widest about z alone. Below 90° this is within 2.3° of an ellipse in the angles themselves.
// euler: t is the product of three turns about x, y and z in the order `order`; angles[0] is the first factor's. The
//   second angle is within ±90°, so that each rotation has one set of angles (at ±90° many).
//
// At a swing of 180° the twist is undefined: the smallest step leads to any twist. See clamp_rotation().
struct JointLimit {
  std::uint16_t joint = 0;                    // of the skeleton
  LimitKind kind = LimitKind::none;           // which of the shapes above
  AxisOrder order = AxisOrder::xyz;           // of euler; else xyz
  float limit_from_parent[4] = {0, 0, 0, 1};  // unit quaternion
  float joint_from_limit[4] = {0, 0, 0, 1};   // unit quaternion
  AngleRange angles[3] = {};  // of a cone the middles of the second and third are 0; of a hinge both are 0
  RateLimit rate = {};        // of the local rotation, see follow_pose()
};
static_assert(sizeof(JointLimit) == 68);

// Whether a limit keeps these rules. Limits from make_limit() and load() do.
MARROW_API bool is_valid(const JointLimit& limit);

// A joint that swings. Its bone goes from the joint to the next joint of its chain. See springs.h.
struct SpringJoint {
  std::uint16_t joint = 0;      // of the skeleton
  std::uint16_t most_pull = 0;  // 1/s², torque over inertia: the spring turns its bone no harder; 0: without a limit
  float frequency_hz = 2.0f;    // 0 … 15: of small swings about the animated direction, undamped and without gravity
  float damping_ratio = 0.5f;   // 0 … 1.5: 0 swings for ever, 1 comes to rest soonest without passing
  float gravity = 1.0f;         // -10 … 10, times SpringFrame::gravity
  float drag = 0.0f;            // 0 … 50 1/s: how strongly air slows the bone's end, and wind carries it
  float radius_m = 0.0f;        // ≥ 0: of a sphere about the bone's end, which stays out of colliders; world
  float weight = 1.0f;          // 0 … 1: how much of the swing is shown; the swing itself goes on at 0, too
};
static_assert(sizeof(SpringJoint) == 28);

// A chain of joints, each a descendant of the one before it. A joint belongs to at most one chain.
struct SpringChain {
  Span<const SpringJoint> joints = {};  // from the chain's root to its end
  float tip[3] = {0, 0, 0};  // end of the last joint's bone, in that joint's space; 0: that joint only ends the chain
  std::uint64_t colliders = ~std::uint64_t{0};  // bit i, lowest first: the chain stays out of SpringFrame::colliders[i]
};

// A capsule that moves with a joint; a sphere where both ends are one point. Its radius is scaled by the largest of the
// scales along the joint's axes.
struct SpringCollider {
  std::uint16_t joint = 0;  // the joint that it moves with
  std::uint16_t reserved = 0;
  float from[3] = {0, 0, 0}, to[3] = {0, 0, 0};  // in the joint's space
  float radius_m = 0.1f;                         // in the joint's space
};
static_assert(sizeof(SpringCollider) == 32);

inline constexpr std::size_t kMaxSpringColliders = 64;  // as many as SpringChain::colliders has bits

// The joints of one character or prop, which its meshes and clips share: a forest in breadth-first order, so a parent
// comes before its children and the roots come first.
struct Skeleton {
  const char* name = "";                    // as the source calls it; never null
  std::uint32_t joint_count = 0;            // 1 … kMaxJoints
  std::uint32_t root_count = 0;             // joints 0 … root_count-1 have no parent joint
  const Affine* model_from_root = nullptr;  // root_count; the transform above each root, which never changes
  const SoaTransform* rest = nullptr;       // soa_count(joint_count); the pose of joints that a clip leaves alone
  const std::uint16_t* parents = nullptr;   // joint_count; kNoJoint for roots
  const std::uint32_t* names = nullptr;     // joint_count; see File::text
  Span<const JointLimit> limits = {};       // the asset's own limits, ascending by joint

  // How many groups of four joints a local pose has.
  std::size_t soa_size() const { return soa_count(joint_count); }
};

// The skeleton that clips of a clip pack were made for; a pack holds references instead of skeletons. See clip_pack.h.
struct SkeletonReference {
  const char* name = "";                       // the skeleton's
  std::uint32_t joint_count = 0;               // the skeleton's
  std::uint64_t hash = 0;                      // skeleton_hash() of the skeleton
  const std::uint32_t* names = nullptr;        // joint_count; see File::text
  const std::uint32_t* rest_hashes = nullptr;  // joint_count; of each joint's rest pose
  const std::uint16_t* parents = nullptr;      // joint_count; kNoJoint for roots
};

}  // namespace marrow
