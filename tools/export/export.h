// `marrow export`: a cooked file back to plain glTF 2.0, so that nobody is locked in.
#pragma once

#include <string>
#include <vector>

#include "marrow/file.h"
#include "terminal/warnings.h"

namespace marrow::tools {

struct Exported {
  std::string glb;
  std::vector<Warning> warnings;  // what glTF could not take, without rules
};

// The GLB container of everything that `file` holds; the same bytes for the same file. `name` is the file's, for
// messages. Throws Failure (unsupported) where glTF has no words for what a damaged or hand-made file holds.
Exported export_file(const File& file, const std::string& name);

}  // namespace marrow::tools
