// Whether a clip may move a skeleton.
#pragma once

#include "marrow/file.h"

namespace marrow {

// Its tracks are of joints that there are. Whether they mean these joints, bind_clips() knows.
inline bool fits(const Clip& clip, const Skeleton& skeleton) {
  for (const Track& track : clip.tracks)
    if (track.joint >= skeleton.joint_count) return false;
  return clip.coded.frame_count == 0 || clip.joint_count == skeleton.joint_count;
}

}  // namespace marrow
