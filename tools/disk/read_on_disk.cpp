#include "disk/read_on_disk.h"

#include "cook/bvh/read_bvh.h"
#include "cook/read_inputs.h"
#include "disk/disk_files.h"

namespace marrow::cook {

RawScene read_gltf(const std::string& path, const ReadOptions& options) {
  tools::DiskFiles files;
  return read_gltf(path, files, options);
}

RawScene read_bvh(const std::string& path) {
  tools::DiskFiles files;
  return read_bvh(path, files);
}

RawScene read_source(const std::string& path, const CookOptions& options) {
  tools::DiskFiles files;
  return read_source(path, files, options.source);
}

}  // namespace marrow::cook
