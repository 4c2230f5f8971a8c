// Artists' files of this machine.
#pragma once

#include <string>

#include "cook/gltf/read.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

RawScene read_gltf(const std::string& path, const ReadOptions& options = {});
RawScene read_bvh(const std::string& path);

}  // namespace marrow::cook
