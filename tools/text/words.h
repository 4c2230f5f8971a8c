// The words by which reports and descriptions call what a file holds.
#pragma once

#include <cstddef>

#include "marrow/file.h"

namespace marrow::tools {

inline const char* word(AlphaMode mode) {
  constexpr const char* kWords[] = {"opaque", "mask", "blend"};
  return kWords[static_cast<std::size_t>(mode)];
}

inline const char* word(TextureRole role) {
  constexpr const char* kWords[] = {"base colour", "metallic-roughness", "normal",
                                    "occlusion",   "emissive",           "specular-glossiness"};
  return kWords[static_cast<std::size_t>(role)];
}

inline const char* word(ImageFormat format) {
  constexpr const char* kWords[] = {"unknown", "png", "jpeg", "webp", "ktx2", "dds"};
  return kWords[static_cast<std::size_t>(format)];
}

}  // namespace marrow::tools
