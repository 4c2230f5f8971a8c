// A clip of keys → the same clip in coded segments, within a promised error.
#pragma once

#include "cook/clip/measure/hung.h"
#include "cook/scene/cook_options.h"

namespace marrow::cook {

// Replaces the tracks of `clip` by coded ones where that keeps the promise and saves bytes; STEP tracks stay as they
// are. The promise is checked with the runtime's own decoder, in model space through the whole hierarchy, against the
// source curves at every frame, the quarters between, every key and both sides of what jumps, of joints' shells and of
// `hung`'s vertices; clip.error says the largest errors found. channels: by which the clip weighs morph targets; its
// own are none yet. Deterministic. Method: the cooker's own; the search for bit rates against the error of the whole
// hierarchy follows Frechette's "Compression by object-space error" in the Animation Compression Library.
void compress_clip(BuiltClip& clip, const BuiltSkeleton& skeleton, const Rig& rig, const Promise& promise,
                   const Hung& hung, Effort effort, const BuiltClip& channels = {});

}  // namespace marrow::cook
