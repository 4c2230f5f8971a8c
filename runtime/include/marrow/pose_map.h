// Poses of another rig put onto a skeleton, frame by frame: motion capture as it comes in, a pose from a network,
// another character's. The cooker makes the map (--pose-map); it says which joints turn as which.
//
//   const PoseMap map = file.pose_map(file.find_pose_map("mocap"));
//   retarget_pose(map, captured, skeleton, local);
#pragma once

#include <cstdint>

#include "marrow/api.h"
#include "marrow/pose.h"
#include "marrow/skeleton.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

// How four consecutive joints turn, one lane a joint, as in SoaTransform: a joint's local rotation is before · r ·
// after, with r the local rotation of one joint of the rig. before and after are what the rest poses of both rigs
// differ by.
struct MappedGroup {
  float before[4][4];           // unit quaternions x, y, z, w
  float after[4][4];            // likewise
  std::uint16_t rig_joints[4];  // kNoJoint: r is the identity, so that the rotation never changes
};
static_assert(sizeof(MappedGroup) == 136);

// One local rotation of the rig, on the way from one of its joints to another.
struct RigStep {
  std::uint16_t joint = 0;    // of the rig
  std::uint8_t inverse = 0;   // not 0: the way leads up, so its inverse counts
  std::uint8_t mirrored = 0;  // not 0: its y and z are negated; one of the two joints is in a mirrored space
};
static_assert(sizeof(RigStep) == 4);

// How a joint turns that takes more than that, in place of its group's lane: before · Π steps · after. Of a joint that
// is between several of the rig there is one for each. Their weighted sum is normalised; each is added in the
// hemisphere of the sum.
struct MappedTurn {
  std::uint16_t joint = 0;         // of the skeleton
  std::uint16_t step_count = 0;    // the next of PoseMap::steps
  float weight = 1;                // 1e-6 … 1
  float before[4] = {0, 0, 0, 1};  // unit quaternion x, y, z, w
  float after[4] = {0, 0, 0, 1};   // likewise
};
static_assert(sizeof(MappedTurn) == 40);

// Where a joint goes: its local translation is parent_from_rig · p. p is where the last step's joint is, in the space
// above the first one's.
struct MappedPlace {
  std::uint16_t joint = 0;       // of the skeleton
  std::uint16_t step_count = 1;  // the next of PoseMap::steps, ≥ 1, each a child of the one before
  float parent_from_rig[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};  // affine map, as Affine
};
static_assert(sizeof(MappedPlace) == 52);

// How a skeleton of the file takes poses of another rig; see File::pose_map.
struct PoseMap {
  const char* name = "";                // of the rig's file; never null
  std::uint32_t skeleton = 0;           // which skeleton of the file
  std::uint32_t rig_joint_count = 0;    // of the rig
  std::uint64_t rig_hash = 0;           // skeleton_hash() of the rig, cooked; says whether poses are of the right one
  Span<const MappedGroup> groups = {};  // of all joints
  Span<const MappedTurn> turns = {};    // ascending by joint
  Span<const MappedPlace> places = {};  // ascending strictly by joint: the hips, and what is above them
  Span<const RigStep> steps = {};       // those of the turns, then those of the places
};

// Puts a pose of the rig onto the skeleton. Joints that nothing turns are at rest below their parents. Bones of pairs
// point the same way as the rig's; hips go as far as its do, in lengths of the legs. Feet slide and sink as far as the
// bodies differ: call place_feet() after it.
//
// rig: at least soa_count(map.rig_joint_count). out: at least skeleton.soa_size(); it gets rotations of unit length,
// and does not overlap `rig`. Scales of the rig move places, and nothing else. A joint whose place would not be finite,
// or beyond 1e12, is where it is at rest. Errors: bad_argument if a span is too short, the map is of fewer joints than
// the skeleton or names one that there is not, its steps are not as many as it says, or a rotation of `rig` is not
// finite or its squared length not 0.5 … 4.1. Nothing is written then. Cost: 66 instructions a joint on x86-64, and 125
// a turn beside the groups. No allocation. Thread-safe on different outputs.
MARROW_API Status retarget_pose(const PoseMap& map, Span<const SoaTransform> rig, const Skeleton& skeleton,
                                Span<SoaTransform> out);

}  // namespace marrow
