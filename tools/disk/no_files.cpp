// Where there are no files: in a browser, which hands over bytes.
#include "common/failure.h"
#include "disk/files.h"

namespace marrow::tools {

AlignedBytes read_file(const std::string& path) {
  throw Failure(Exit::io, path, "", "there are no files here", "hand over its bytes");
}

}  // namespace marrow::tools
