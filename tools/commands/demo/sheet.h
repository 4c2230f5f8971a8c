// A contact sheet: six moments of a clip, skinned by SSD and by animation space, and where the two differ:
// over the whole figure, and from near by at the joint where they differ most.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "image/image.h"
#include "marrow/file.h"
#include "render/gl.h"
#include "render/textures.h"

namespace marrow::tools {

struct Sheet {
  Image image;
  float largest_m = 0;      // distance between SSD and AS over the moments shown, scene units
  std::string worst_joint;  // about which that is; empty if it is too small to be seen
};

// The clip that bends joints most, the one worth showing; nullopt if the file has none.
std::optional<std::uint32_t> liveliest_clip(const File& file);

// Its name, or as --clip takes one without a name: its number.
std::string name_of_clip(const File& file, std::uint32_t clip);

// title: what the file is called. All clips of the name of `clip` play, one a skeleton. Without a clip the rest pose is
// shown from six sides.
Sheet make_sheet(const Gl& gl, const File& file, const Textures& textures, std::optional<std::uint32_t> clip,
                 const std::string& title);

}  // namespace marrow::tools
