#include "cook/read_source.h"

#include "common/formats.h"
#include "cook/bvh/read_bvh.h"

namespace marrow::cook {

RawScene read_source(const std::string& path, const ReadOptions& options) {
  return tools::is_named_bvh(path) ? read_bvh(path) : read_gltf(path, options);
}

}  // namespace marrow::cook
