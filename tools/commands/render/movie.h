// `marrow render --movie`: the moments of a loop, and where its frames go.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/render/sitting.h"

namespace marrow::tools {

// A whole number of frames, evenly spaced: the moment after the last is the first again.
struct Movie {
  std::vector<Instant> instants;
  double duration_s = 0;
};

// What --fps, --turn and --time make of what takes so long, 0: nothing moves. goes_round: it ends as it began. Throws
// Failure (usage) if nothing would move, or too much.
Movie plan_movie(const RenderArguments& arguments, float duration_s, bool goes_round);

// Names of numbered frames: FOLDER/, or one number as in frame%04d.png.
struct FrameNames {
  std::string folder;  // to be made; may be empty
  std::string before, after;
  int digits = 4;

  std::string name(std::size_t frame) const;
};

// Nothing for the name of one file. Throws Failure (usage) for two numbers in one name.
std::optional<FrameNames> parse_frame_names(const std::string& output);

// Throws Failure (usage, io, unsupported) if this could not be written.
void expect_movie_output(const std::string& output);

// The --size that movies have by default: of those that are loaded whole to be shown, a quarter of a picture's pixels.
const char* default_movie_size(const std::string& output);

// The --size that frames for this output have: sides of videos are even, rounded up. Throws Failure (usage).
std::string movie_size(const std::string& output, const std::string& size);

// Throws Failure.
void shoot_movie(const RenderArguments& arguments, Sitting& sitting);

}  // namespace marrow::tools
