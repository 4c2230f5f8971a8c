// Sections and codecs of cooked files in words, for reports.
#pragma once

#include <cstdint>
#include <string>

#include "unpack/packed.h"

namespace marrow::tools {

// "GEOM".
inline std::string section_name(std::uint32_t type) {
  std::string name;
  for (int i = 0; i < 4; ++i) name += static_cast<char>(type >> (8 * i) & 0xFF);
  return name;
}

// Of a geometry's record; "none" for what is not packed.
inline const char* mesh_codec_name(std::uint32_t codec) {
  return codec == packed::kDraco ? "draco" : codec == packed::kMeshopt ? "meshopt" : "none";
}

}  // namespace marrow::tools
