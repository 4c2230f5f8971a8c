// A few colours in place of many: what makes moving pictures small.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

namespace marrow::tools {

struct Palette {
  static constexpr std::size_t kMost = 255;

  // Those of a picture like these, where they are needed most. samples: one at least.
  static Palette of(std::span<const Image> samples);

  // The colour that stands for another at a pixel: the nearest, or the one beyond, in a pattern whose mean is the
  // other. The pattern stays where it is, so that what does not move does not flicker.
  std::size_t index(const std::uint8_t* colour, int x, int y) const;

  std::vector<Rgb> colours;  // 1 to kMost
};

}  // namespace marrow::tools
