#include "disk/cook_on_disk.h"

#include <utility>

#include "cook/read_inputs.h"
#include "disk/disk_files.h"
#include "disk/thread_pool.h"

namespace marrow::cook {

RawScene read_rig(const std::string& path) {
  tools::DiskFiles files;
  return read_rig(path, files);
}

Character read_character(const std::string& path) {
  tools::DiskFiles files;
  std::vector<Read> reads;
  return read_character(path, {files, &tools::all_cores(), {}, nullptr}, reads);
}

Result cook_file(const std::string& path, const CookOptions& options) {
  tools::DiskFiles files;
  return cook_source(path, options, {files, &tools::all_cores(), {}, nullptr});
}

Result cook_scene(RawScene scene, const CookOptions& options) {
  tools::DiskFiles files;
  return cook_scene(std::move(scene), options, {files, &tools::all_cores(), {}, nullptr});
}

CookOptions with_named_files(CookOptions options) {
  tools::DiskFiles files;
  std::vector<Read> reads;
  read_named_files(options, files, reads);
  return options;
}

}  // namespace marrow::cook
