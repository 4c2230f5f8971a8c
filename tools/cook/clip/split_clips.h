// A clip of the source becomes one a skeleton that it moves.
#pragma once

#include <cstdint>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// What a clip of the source moves in one skeleton.
struct ClipPart {
  std::uint32_t skeleton;
  std::size_t source;  // which clip of the scene
  RawClip clip;
  float duration_s;  // of the whole clip, so that its parts stay in step
};

// At least one part a clip, in the order of clips, in each of skeletons. built: its skeletons.
std::vector<ClipPart> split_clips(const RawScene& scene, const BuiltScene& built);

}  // namespace marrow::cook
