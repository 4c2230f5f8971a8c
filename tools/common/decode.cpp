// PNG and JPEG files → pixels, by stb_image with only those two formats and limits of our own.
#include "common/decode.h"

#include <climits>
#include <cstdlib>
#include <memory>

#include "common/failure.h"

namespace {

// A compressed stream may promise gigabytes: nothing larger than 16 bits a channel of the largest image is handed out.
constexpr std::size_t kMostBytes = std::size_t{8} * 8192 * 8192 + 65536;

void* capped_malloc(std::size_t bytes) {
  return bytes > kMostBytes ? nullptr : std::malloc(bytes);
}

void* capped_realloc(void* old, std::size_t bytes) {
  return bytes > kMostBytes ? nullptr : std::realloc(old, bytes);
}

}  // namespace

#define STBI_MALLOC(bytes) capped_malloc(bytes)
#define STBI_REALLOC(old, bytes) capped_realloc(old, bytes)
#define STBI_FREE(old) std::free(old)
#define STBI_MAX_DIMENSIONS 8192
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace marrow::tools {

Pixels decode_image(Span<const std::byte> bytes, const std::string& file, const std::string& where) {
  Pixels out;
  int channels = 0;
  struct Free {
    void operator()(stbi_uc* p) const { std::free(p); }
  };
  std::unique_ptr<stbi_uc, Free> pixels;
  if (bytes.size <= INT_MAX)
    pixels.reset(stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data), static_cast<int>(bytes.size),
                                       &out.width, &out.height, &channels, 4));
  if (!pixels) {
    const char* const reason = bytes.size <= INT_MAX ? stbi_failure_reason() : "too large";
    throw Failure(Exit::invalid, file, where, std::string("no PNG or JPEG that can be decoded: ") + reason,
                  "export the image again, at most 8192 pixels each way");
  }
  const std::size_t size = std::size_t{4} * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
  out.rgba.assign(pixels.get(), pixels.get() + size);
  return out;
}

}  // namespace marrow::tools
