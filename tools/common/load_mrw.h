// A cooked file from disk to a validated view, as every sub-command but `cook` begins.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/aligned_bytes.h"
#include "marrow/file.h"

namespace marrow::tools {

struct LoadedFile {
  AlignedBytes bytes;
  File file;  // a view of `bytes`; stays valid when the struct is moved
  // The sections as they stand on the disk: of a packed file its records. In the order of file.sections().
  std::vector<File::Section> stored;
  std::size_t stored_bytes = 0;
};

// Throws Failure: io if it cannot be read, invalid or unsupported with the offset and the rule if it cannot be used.
LoadedFile load_mrw(const std::string& path);
// The same of bytes that are in memory already. path: for messages.
LoadedFile load_mrw(const std::string& path, AlignedBytes file_bytes);

// What its bytes are spent on.
struct Spent {
  const char* on;  // "geometry", "skeletons", "clips", "graphs", "images", "names_and_structure"
  std::size_t bytes = 0;
};

// As they are stored: of a packed file its records. Everything is counted once.
std::vector<Spent> spent_bytes(const LoadedFile& loaded);

}  // namespace marrow::tools
