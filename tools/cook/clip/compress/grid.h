// When the frames of a coded clip are.
#pragma once

#include <set>
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

// A STEP track that changes cannot be blended between frames, nor can one with different keys at one time, but for the
// rounding of floats. Exporters write STEP for what is constant but for that.
bool jumps(const BuiltClip& clip, const Track& track);

// The times of the keys that are to be coded.
std::set<float> key_times(const BuiltClip& clip);

// Grids worth trying: of LINEAR tracks the keys' own, on even steps but for the rounding of their times, then where
// they are, which loses nothing; of curves even steps that come close enough, coarse to fine. None if nothing is to be
// coded.
std::vector<Grid> grids(const BuiltClip& clip);

}  // namespace marrow::cook
