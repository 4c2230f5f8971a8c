// How a skeleton takes poses of another rig while a game runs: what retarget_pose() of marrow/pose_map.h reads.
#pragma once

#include "cook/retarget/retarget.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of the skeleton and the rig that pair_with() takes. Joints turn as retarget_clips() has them turn before it bends
// legs and arms. Hips and what is paired above them move from their places: the topmost as the rig's, scaled by the
// legs, from where both are at rest; the others below it, by as much as the rig's are off their rest pose. Of motion
// capture, and of a rig whose rest pose hangs from the ground as motion capture's does, the topmost is where the rig
// says, scaled. Without hips it is the topmost paired joint of a tree that has one alone.
//
// Throws tools::Failure: as pair_with(); invalid where a place comes out beyond 1e12; unsupported for roots of a rig
// that are turned otherwise and whose joints turn what hangs together, and for very many steps.
BuiltPoseMap make_pose_map(const Character& character, const RawScene& rig, const RetargetMap* map, Notes& notes);

}  // namespace marrow::cook
