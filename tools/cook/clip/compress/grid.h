// When the frames of a coded clip are.
#pragma once

#include <vector>

#include "cook/scene/built.h"

namespace marrow::cook {

struct Grid {
  float start_s, end_s;
  std::size_t intervals;
  std::vector<float> times_s;  // intervals + 1; none: even steps

  // Moments are kMoments an interval.
  double exact_time_of(std::size_t moment) const;
};

// A STEP track that changes cannot be blended between frames. Exporters write STEP for what is constant but for the
// rounding of floats.
bool jumps(const BuiltClip& clip, const Track& track);

// Grids worth trying, coarse to fine: the keys' own, on even steps or not, which lose nothing of LINEAR tracks; or even
// steps that come close enough to curves. None if nothing is to be coded.
std::vector<Grid> grids(const BuiltClip& clip);

}  // namespace marrow::cook
