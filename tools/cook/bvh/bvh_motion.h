// The second part of a BVH file: a number a channel and frame, which become keys.
#pragma once

#include "cook/bvh/bvh_hierarchy.h"
#include "cook/bvh/bvh_words.h"
#include "cook/scene/raw.h"

namespace marrow::cook::bvh {

// A rotation of every joint that has channels, and a translation of those with positions, at every frame, linear.
// Rotations are composed in the channels' order, each about the axes that those before it have turned; a position takes
// the place of the OFFSET. Throws tools::Failure: invalid; unsupported for clips of more than a day.
RawClip read_motion(Words& words, const BvhHierarchy& hierarchy, const gltf::Report& report);

}  // namespace marrow::cook::bvh
