// The demo's movie: the sample's story, drawn; and a sheet of the clips that it is made of.
#pragma once

#include <string>

#include "image/image.h"
#include "marrow/file.h"
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

// Precondition: `file` is the sample, cooked.
Image make_moves_sheet(const Gl& gl, const File& file);

}  // namespace marrow::tools
