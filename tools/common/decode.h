// PNG and JPEG files, which nobody vouches for → pixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "marrow/span.h"

namespace marrow::tools {

inline constexpr int kLargestImageSide = 8192;

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // top row first, as the file has them: colour profiles are ignored (glTF 2.0, 3.9.1)
};

// Throws Failure (invalid), which names `file` and `where`, for anything that is no PNG or JPEG, damaged, or larger
// than kLargestImageSide either way.
Pixels decode_image(Span<const std::byte> bytes, const std::string& file, const std::string& where);

}  // namespace marrow::tools
