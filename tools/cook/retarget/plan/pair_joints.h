// Which joint of a character is which of another skeleton, by their names.
#pragma once

#include <string>
#include <vector>

namespace marrow::cook {

// For each of `joints` the index of its counterpart in `others`; kNone: none. First those of exactly the same name,
// then of those that are left the ones that are called alike: "mixamorig:Left_Arm" is "leftarm" too, for what stands
// before the last colon, case, blanks, "_" and "." do not count. Names that several have on one side pair nothing.
std::vector<int> pair_joints(const std::vector<std::string>& joints, const std::vector<std::string>& others);

}  // namespace marrow::cook
