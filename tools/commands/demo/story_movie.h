// The demo's movie: the sample's story, drawn.
#pragma once

#include <string>

#include "render/gl.h"

namespace marrow::tools {

struct StoryMovie {
  std::string path;
  std::size_t frames = 0;
  double duration_s = 0;
};

// character: the sample, cooked; its clips are cooked beside it. Draws into its folder: newt-moves.webp by ffmpeg, or
// without one newt-moves.png, a larger file. Throws Failure.
StoryMovie shoot_story(const Gl& gl, const std::string& character);

}  // namespace marrow::tools
