// Artists' files of this machine.
#pragma once

#include <string>

#include "cook/gltf/read.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

RawScene read_gltf(const std::string& path, const ReadOptions& options = {});
RawScene read_bvh(const std::string& path);
RawScene read_source(const std::string& path, const CookOptions& options);

}  // namespace marrow::cook
