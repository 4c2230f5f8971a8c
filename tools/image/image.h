// Pictures in memory: sRGB pixels, as PNG files hold them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace marrow::tools {

using Rgb = std::array<std::uint8_t, 3>;

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // top row first, 3 bytes a pixel, sRGB

  Image() = default;
  Image(int w, int h, Rgb fill = {0, 0, 0});
  std::uint8_t* pixel(int x, int y) {
    return rgb.data() +
           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  const std::uint8_t* pixel(int x, int y) const { return const_cast<Image*>(this)->pixel(x, y); }
};

// Copies `from` with its top left corner at x, y; what sticks out is cut.
void paste(Image& to, const Image& from, int x, int y);

// Blends `colour` over a pixel; coverage 0 … 1. Outside the picture nothing happens.
void blend(Image& image, int x, int y, Rgb colour, float coverage);

// The same bytes for the same picture. Throws Failure (internal) if the encoder fails.
std::vector<std::byte> encode_png(const Image& image);

// By a temporary file that is renamed. Throws Failure (io).
void write_png(const std::string& path, const Image& image);

}  // namespace marrow::tools
