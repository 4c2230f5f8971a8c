// What the newt does: one pose for every moment of every clip.
#pragma once

#include "acting/motion.h"

namespace marrow::sample {

// Each takes the phase of its loop, 0..1.
Pose walk_pose(float phase);
Pose twist_pose(float phase);
Pose reach_pose(float phase);
Pose idle_pose(float phase);

}  // namespace marrow::sample
