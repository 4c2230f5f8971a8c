// Poses between frames that are evenly apart, joint by joint.
#pragma once

#include <vector>

#include "deform/motion/between_frames.h"
#include "marrow/pose.h"

namespace marrow::deform {

// As between_frames() of each joint's translation, rotation and scale; frames: at least one, all as long.
std::vector<SoaTransform> between_poses(BetweenFrames kind, const std::vector<std::vector<SoaTransform>>& frames,
                                        double at);

}  // namespace marrow::deform
