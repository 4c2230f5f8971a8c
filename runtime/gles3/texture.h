// Textures that shaders fetch numbers from.
#pragma once

#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {

// One 2D texture without mipmaps or filter, its texels undefined; `format` and `type` are what goes with
// `internal_format`. Leaves it bound to the active unit.
inline std::uint32_t make_texture(const Api& api, GlEnum internal_format, GlEnum format, GlEnum type,
                                  std::uint32_t width, std::uint32_t height) {
  std::uint32_t texture = 0;
  api.GenTextures(1, &texture);
  api.BindTexture(kGlTexture2d, texture);
  api.TexParameteri(kGlTexture2d, kGlTextureMinFilter, kGlNearest);
  api.TexParameteri(kGlTexture2d, kGlTextureMagFilter, kGlNearest);
  api.TexImage2D(kGlTexture2d, 0, static_cast<int>(internal_format), static_cast<int>(width), static_cast<int>(height),
                 0, format, type, nullptr);
  return texture;
}

}  // namespace marrow::gles3
