// Describes to the bound vertex array how to read the bound array buffer.
#pragma once

#include <cstdint>

#include "gles3/gl_constants.h"
#include "gles3/mesh/gpu_mesh.h"

namespace marrow::gles3 {

inline void attribute(const Api& api, std::uint32_t location, int size, GlEnum type, bool normalized,
                      std::uint32_t stride, std::uint32_t offset) {
  api.EnableVertexAttribArray(location);
  api.VertexAttribPointer(location, size, type, normalized ? 1 : 0, static_cast<int>(stride),
                          reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset)));
}

// Texture coordinates and colours, from a mesh's surface buffer.
inline void describe_looks(const Api& api, const VertexLayout& layout, std::uint8_t features) {
  const GlEnum uv = layout.uv_unorm ? kGlUnsignedShort : kGlFloat;
  if ((features & kUvs) != 0) attribute(api, kUvLocation, 2, uv, layout.uv_unorm, layout.surface_stride, layout.uv);
  if ((features & kColours) != 0)
    attribute(api, kColourLocation, 4, kGlUnsignedByte, true, layout.surface_stride, layout.colour);
}

}  // namespace marrow::gles3
