// How far a clip is from its source between frames, if it is played from so many a second.
#pragma once

#include <vector>

#include "commands/compare/study.h"
#include "deform/motion/between_frames.h"

namespace marrow::tools {

inline constexpr double kLeastFrames_hz = 1, kMostFrames_hz = 240;

// Of all clips of the mesh's skeleton. Lengths in metres: where SSD puts vertices, from where it puts them in the
// source's pose at that moment.
struct FramesRow {
  double hz = 0;
  deform::BetweenFrames kind = deform::BetweenFrames::linear;
  std::size_t frames = 0;
  double rms = 0, most = 0;
};

// For each rate a row a kind. Frames are evenly apart, both ends of a clip among them, at least `hz` a second. Looked
// at is a quarter, a half and three quarters of the way between two; of long clips some of the intervals, evenly. None
// if no clip moves the skeleton. On all cores; the same result on every run.
std::vector<FramesRow> study_frames(const Study& study, const std::vector<double>& rates_hz);

}  // namespace marrow::tools
