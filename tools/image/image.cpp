#include "image/image.h"

#include <algorithm>
#include <cmath>

namespace marrow::tools {

Image::Image(int w, int h, Rgb fill)
    : width(w), height(h), rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = fill[i % 3];
}

void paste(Image& to, const Image& from, int x, int y) {
  const int first = std::max(0, -x);
  const int last = std::min(from.width, to.width - x);
  if (first >= last) return;
  for (int row = std::max(0, -y); row < std::min(from.height, to.height - y); ++row) {
    std::copy_n(from.pixel(first, row), 3 * (last - first), to.pixel(x + first, y + row));
  }
}

void blend(Image& image, int x, int y, Rgb colour, float coverage) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* p = image.pixel(x, y);
  const float a = std::clamp(coverage, 0.0f, 1.0f);
  for (std::size_t c = 0; c < 3; ++c) {
    const float mixed = static_cast<float>(p[c]) * (1 - a) + static_cast<float>(colour[c]) * a;
    p[c] = static_cast<std::uint8_t>(std::lround(mixed));
  }
}

}  // namespace marrow::tools
