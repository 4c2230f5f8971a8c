// Reads an artist's file in either of the formats that the cooker knows: glTF, or BVH by its name.
#pragma once

#include <string>

#include "cook/gltf/read.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// read_bvh() of what is called so, else read_gltf(), as the options say. Throws as they do.
RawScene read_source(const std::string& path, const CookOptions& options);

}  // namespace marrow::cook
