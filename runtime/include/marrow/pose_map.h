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

// One local rotation of the rig, on the way from one of its joints to another.
struct RigStep {
  std::uint16_t joint = 0;    // of the rig
  std::uint8_t inverse = 0;   // 1: the way leads up, so its inverse counts
  std::uint8_t mirrored = 0;  // 1: its y and z are negated; one of the two joints is in a mirrored space
};
static_assert(sizeof(RigStep) == 4);

// How a joint turns: its local rotation is before · Π steps · after. before and after are what the rest poses of both
// rigs differ by. Of a joint that is between several of the rig there is one for each. Their weighted sum is
// normalised; each is added in the hemisphere of the sum.
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
  Span<const MappedTurn> turns = {};    // ascending by joint
  Span<const MappedPlace> places = {};  // ascending strictly by joint: the hips, and what is above them
  Span<const RigStep> steps = {};       // those of the turns, then those of the places
};

// Puts a pose of the rig onto the skeleton. Joints that the map does not name are at rest below their parents. Bones of
// pairs point the same way as the rig's; hips go as far as its do, in lengths of the legs. Feet slide and sink as far
// as the bodies differ: call place_feet() after it.
//
// rig: at least soa_count(map.rig_joint_count), rotations of about unit length. out: at least skeleton.soa_size(); it
// gets rotations of unit length, and does not overlap `rig`. Scales of the rig move places, and nothing else.
// Errors: bad_argument if a span is too short, the map names a joint that one of the two has not, its steps are not as
// many as it says, a rotation of `rig` is not finite or its squared length not 0.5 … 4.1, or a place comes out beyond
// 1e12. Nothing is written then.
// Cost: 75 instructions a joint on x86-64. No allocation. Thread-safe on different outputs.
MARROW_API Status retarget_pose(const PoseMap& map, Span<const SoaTransform> rig, const Skeleton& skeleton,
                                Span<SoaTransform> out);

}  // namespace marrow
