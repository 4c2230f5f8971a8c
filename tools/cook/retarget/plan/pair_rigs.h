// Which joint of a skeleton turns as which of another rig: by roles, then by names, or as a map says.
#pragma once

#include <string>
#include <vector>

#include "cook/retarget/plan/take.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// For each of `joints` the index of its counterpart in `others`; kNone: it has none. Joints of exactly the same name
// are pairs; of those that are left, joints whose names differ only in case, blanks, "_", "." and what stands before
// the last colon: "mixamorig:Left_Arm" and "leftarm". A name that several joints of one side have pairs nothing.
std::vector<int> pair_joints(const std::vector<std::string>& joints, const std::vector<std::string>& others);

// A line of a map: a joint, and what it turns as. See read_retarget_map().
struct MappedJoint {
  std::string joint, source;
  std::string other;  // empty: `source` alone
  double share = 0;   // of `other`
  std::string where;  // in the file
};

struct RetargetMap {
  std::string file;
  std::vector<MappedJoint> joints;
};

// For each joint of `target` its counterpart in `source`: a joint, or a place between two. Joints of the same role are
// pairs. Spines, necks and tails are paired as wholes: first joint with first, last with last, and those between by
// their number. Other joints are pairs if they are called alike (pair_joints()) and hang below a pair.
std::vector<Counterpart> pair_rigs(const BuiltSkeleton& target, const BuiltSkeleton& source);

// The pairs that a map names, and no others. Throws tools::Failure (usage) at the line of a joint that does not exist,
// that two lines name, or whose counterpart hangs above that of a joint above it.
std::vector<Counterpart> map_rigs(const BuiltSkeleton& target, const BuiltSkeleton& source, const RetargetMap& map,
                                  const std::string& target_file, const std::string& source_file);

// The joint with a role; kNone: none has it.
int joint_with(const BuiltSkeleton& skeleton, Role role);

// spine: from below the hips to the last joint with a role of the spine. neck: from below that to above the head. Empty
// where roles do not say.
struct TrunkJoints {
  std::vector<int> spine, neck;
};
TrunkJoints trunk_of(const BuiltSkeleton& skeleton);

}  // namespace marrow::cook
