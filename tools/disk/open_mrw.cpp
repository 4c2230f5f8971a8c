#include "common/load_mrw.h"
#include "disk/files.h"

namespace marrow::tools {

LoadedFile load_mrw(const std::string& path) {
  return load_mrw(path, read_file(path));
}

}  // namespace marrow::tools
