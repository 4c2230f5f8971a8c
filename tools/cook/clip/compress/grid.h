// When the frames of a coded clip are.
#pragma once

#include <set>
#include <vector>

#include "cook/clip/measure/source_curves.h"

namespace marrow::cook {

struct Grid {
  float start_s, end_s;
  std::size_t intervals;
  std::vector<float> times_s;  // intervals + 1; none: even steps

  // Moments are kMoments an interval.
  double exact_time_of(std::size_t moment) const;
};

// The times of the keys that are to be coded.
std::set<float> key_times(const BuiltClip& clip);

// Grids worth trying: of LINEAR tracks the keys' own, on even steps but for the rounding of their times, then where
// they are, which loses nothing; of curves even steps that come close enough, coarse to fine. None if nothing is to be
// coded.
std::vector<Grid> grids(const BuiltClip& clip);

}  // namespace marrow::cook
