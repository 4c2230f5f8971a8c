// Pictures as JPEG files, for pages that must stay small.
#pragma once

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace marrow::tools {

// quality: 1 … 100; up to 90 colours are kept at half the resolution. The same bytes for the same picture. Throws
// Failure (internal) if the encoder fails.
std::vector<std::byte> encode_jpeg(const Image& image, int quality);

}  // namespace marrow::tools
