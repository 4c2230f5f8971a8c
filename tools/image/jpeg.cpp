#include "image/jpeg.h"

#include <cstdlib>

#include "common/failure.h"

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace marrow::tools {

std::vector<std::byte> encode_jpeg(const Image& image, int quality) {
  std::vector<std::byte> out;
  const auto append = [](void* to, void* data, int size) {
    const auto* const bytes = static_cast<const std::byte*>(data);
    auto& all = *static_cast<std::vector<std::byte>*>(to);
    all.insert(all.end(), bytes, bytes + size);
  };
  if (stbi_write_jpg_to_func(append, &out, image.width, image.height, 3, image.rgb.data(), quality) == 0)
    throw Failure(Exit::internal, "JPEG", "", "the encoder fails", "please report this");
  return out;
}

}  // namespace marrow::tools
