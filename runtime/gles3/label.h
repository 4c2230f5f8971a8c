// Names of GL objects, for RenderDoc and drivers' tools, where the context takes them.
#pragma once

#include <initializer_list>

#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {

// Bytes of one piece of a label and of all of it; each driver that takes labels takes 255.
inline constexpr std::size_t kMostLabelPiece = 96;
inline constexpr std::size_t kMostLabel = 192;

// How much of a piece is shown: whole characters of UTF-8.
inline std::size_t label_piece_bytes(const char* piece, std::size_t room) {
  const std::size_t most = room < kMostLabelPiece ? room : kMostLabelPiece;
  std::size_t bytes = 0;
  while (bytes < most && piece[bytes] != '\0') ++bytes;
  while (bytes > 0 && (static_cast<unsigned char>(piece[bytes]) & 0xC0u) == 0x80) --bytes;
  return bytes;
}

// The pieces after each other. Does nothing for name 0; GL wants the object to have been bound once.
inline void label(const Api& api, GlEnum kind, std::uint32_t name, std::initializer_list<const char*> pieces) {
  if (api.ObjectLabel == nullptr || name == 0) return;
  char text[kMostLabel];
  std::size_t size = 0;
  for (const char* const piece : pieces) {
    const std::size_t bytes = label_piece_bytes(piece, sizeof(text) - size);
    for (std::size_t i = 0; i < bytes; ++i) text[size + i] = piece[i];
    size += bytes;
  }
  api.ObjectLabel(kind, name, static_cast<int>(size), text);
}

// What a mesh's labels begin with.
inline const char* label_of(const Mesh& mesh) {
  return mesh.name != nullptr && mesh.name[0] != '\0' ? mesh.name : "mesh";
}

}  // namespace marrow::gles3
