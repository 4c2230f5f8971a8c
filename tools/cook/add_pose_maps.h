// Maps by which a game puts poses of other rigs onto the skeletons of a scene.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of options.pose_maps, in their order, each called as its rig's file. Notes what make_pose_map() does, at the file.
// Throws tools::Failure as reading those files and make_pose_map(); usage where two are called alike.
std::vector<BuiltPoseMap> make_pose_maps(const Character& character, const CookOptions& options, Notes& notes);

}  // namespace marrow::cook
