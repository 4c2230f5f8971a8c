// Splits a file into its JSON text and the binary chunk that a .glb carries.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "cook/gltf/document/findings.h"

namespace marrow::cook::gltf {

// Of UTF-8. Not glTF's, but written by editors; glTF 2.0 lets readers skip it (section 2.7, a note).
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Views into the file's bytes.
struct Container {
  bool binary = false;  // a .glb
  std::string_view json;
  std::size_t json_offset = 0;  // of `json` in the file
  bool has_bin = false;         // a BIN chunk is there; it may be empty
  std::span<const std::byte> bin;
};

// glTF 2.0, section 4.4: header, chunk order, alignment and lengths. Bytes after the declared end are dropped with a
// warning; everything else that is off is refused at its offset.
Container split_container(std::span<const std::byte> file, Report& report);

}  // namespace marrow::cook::gltf
