// A contact sheet: a character by plain skinning, by animation space, and how far these are apart: from near by where
// plain skinning is worst, and as a whole at four moments of that clip.
#pragma once

#include <string>

#include "commands/demo/plain_skin.h"
#include "commands/demo/timings.h"
#include "commands/demo/worst_place.h"
#include "image/image.h"
#include "render/gl.h"
#include "render/textures.h"

namespace marrow::tools {

// Who is shown. title: what the file is called.
struct Subject {
  const File& file;
  PlainSkin& plain;
  const Textures& textures;
  std::string title;
  Timings timings;
};

struct Sheet {
  Image image;
  float largest_m = 0;  // between the two at the moments shown, scene units
};

// Its name, or as --clip takes one without a name: its number.
std::string name_of_clip(const File& file, std::uint32_t clip);

// All clips of the name of the worst place's play, one a skeleton. Without a clip the rest pose is shown from four
// sides.
Sheet make_sheet(const Gl& gl, const Subject& subject, const WorstPlace& worst);

}  // namespace marrow::tools
