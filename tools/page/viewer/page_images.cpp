#include "page/viewer/page_images.h"

#include <cstdlib>
#include <cstring>

#include "wasm/throw.h"

extern "C" {
// The pixels of an image, 4 bytes each, at most `most` each way, in memory of take_memory(), and its size. Null: the
// page cannot show it.
MARROW_IMPORT("image") std::uint8_t* marrow_image(std::uint32_t index, int most, int* width, int* height);
}

namespace marrow::tools {

Pixels PageImages::pixels(std::uint32_t index, int most) {
  Pixels out;
  std::uint8_t* const rgba = marrow_image(index, most, &out.width, &out.height);
  if (rgba == nullptr) return {};
  out.rgba.assign(rgba,
                  rgba + std::size_t{4} * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  std::free(rgba);
  return out;
}

}  // namespace marrow::tools
