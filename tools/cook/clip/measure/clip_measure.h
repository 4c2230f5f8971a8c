// How far what became of a clip takes joints and vertices from where the source has them.
#pragma once

#include <vector>

#include "cook/clip/measure/hung.h"
#include "cook/clip/measure/source_curves.h"

namespace marrow::cook {

// By the runtime's own decoder, in model space through the whole hierarchy.
class ClipMeasure {
 public:
  // What is given outlives this. channels: by which the clip weighs morph targets.
  ClipMeasure(const BuiltClip& clip, const BuiltClip& channels, const BuiltSkeleton& skeleton, const Rig& rig,
              const Hung& hung);

  // All moments at which it is looked at: these, ascending, and where the clip's curves and channels have keys; both
  // sides of what jumps.
  std::vector<float> moments(const std::vector<float>& of_grid) const;

  // At the moments, and nearer to those that are worst. The joints are looked at every time; the vertices too, or at
  // every few moments where that would be too many, as long as the joints keep the promise.
  ClipError measure(const BuiltClip& out, const std::vector<float>& moments, const Promise& promise) const;

 private:
  const BuiltClip& clip_;
  const BuiltClip& channels_;
  const BuiltSkeleton& skeleton_;
  const Rig& rig_;
  const Hung& hung_;
  SourceCurves curves_;
};

}  // namespace marrow::cook
