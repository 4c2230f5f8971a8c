// Which joint of a skeleton turns as which of another rig: by roles, then by names, or as a map says.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cook/retarget/plan/take.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// For each of `joints` the index of its counterpart in `others`; kNone: none. First those of exactly the same name,
// then of those that are left the ones that are called alike: "mixamorig:Left_Arm" is "leftarm" too, for what stands
// before the last colon, case, blanks, "_" and "." do not count. Names that several have on one side pair nothing.
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

// Of each joint of `target` a joint of `source`, or two of which it is between. Both skeletons have roles where any are
// known. Joints of the same role are pairs. Spines, necks and tails are pairs as wholes: their first joints, their last
// ones, and those between by their number. Of the others those are pairs that are called alike (pair_joints()) and hang
// below a pair.
std::vector<Counterpart> pair_rigs(const BuiltSkeleton& target, const BuiltSkeleton& source);

// As a map says, and nothing else. Throws tools::Failure (usage) at the line of a joint that there is not, or that two
// lines name, or that hangs on one that turns as something below what it turns as. `file`: of the source.
std::vector<Counterpart> map_rigs(const BuiltSkeleton& target, const BuiltSkeleton& source, const RetargetMap& map,
                                  const std::string& target_file, const std::string& source_file);

// The joint with a role; kNone: none has it.
int joint_with(const BuiltSkeleton& skeleton, Role role);

// From below the hips to the last joint that has a role of the spine; and from below that to above the head. Empty
// where roles do not say.
struct TrunkJoints {
  std::vector<int> spine, neck;
};
TrunkJoints trunk_of(const BuiltSkeleton& skeleton);

}  // namespace marrow::cook
