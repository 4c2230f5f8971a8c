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

// Clips of a file itself or of a clip pack, and which skeletons of the file they move.
struct ExportedClips {
  struct One {
    std::uint32_t clip = 0, skeleton = 0;
  };
  File from;
  std::vector<One> clips;  // ascending
};
ExportedClips all_clips(const File& file);

// The GLB container of everything that `file` holds, with these clips; the same bytes for the same file. `name` is the
// file's, for messages. Throws Failure (unsupported) where glTF has no words for what a damaged or hand-made file
// holds.
Exported export_file(const File& file, const std::string& name, const ExportedClips& clips);
inline Exported export_file(const File& file, const std::string& name) {
  return export_file(file, name, all_clips(file));
}

}  // namespace marrow::tools
