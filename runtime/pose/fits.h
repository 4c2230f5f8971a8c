// Whether a clip may move a skeleton.
#pragma once

#include "marrow/file.h"

namespace marrow {

// Checks that every track's joint exists. Whether it is the right joint is checked by bind_clips().
inline bool fits(const Clip& clip, const Skeleton& skeleton) {
  for (const Track& track : clip.tracks)
    if (track.joint >= skeleton.joint_count) return false;
  return clip.coded.frame_count == 0 || clip.joint_count == skeleton.joint_count;
}

}  // namespace marrow
