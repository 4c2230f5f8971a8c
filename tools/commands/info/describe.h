// A cooked file in words and numbers.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "common/load_mrw.h"

namespace marrow::tools {

// What `marrow info --json` prints: bytes, totals, sections, skeletons, meshes, clips.
nlohmann::ordered_json describe(const std::string& path, const LoadedFile& loaded);

// What a glTF file spends on the same: {"bytes", "geometry", "skeletons", "clips", "structure", "images", "mesh_bytes":
// {name: bytes}, "clip_bytes": {name: bytes}}. Data that several share counts for the first. Throws Failure: io if it
// cannot be read, invalid if it is no glTF.
nlohmann::ordered_json describe_source(const std::string& path);

}  // namespace marrow::tools
