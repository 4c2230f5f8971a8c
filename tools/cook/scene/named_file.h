// Files that the options name: graphs, maps, templates, masks, motions.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "common/aligned_bytes.h"
#include "common/failure.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// What a file of more bytes is refused with.
struct LargestFile {
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
  std::string advice;
  std::string rule = "too large";
  tools::Exit exit = tools::Exit::usage;
};

// The whole file, which is added to `reads`. Throws tools::Failure: `largest`, or as tools::read_file().
tools::AlignedBytes read_named_file(const std::string& path, const LargestFile& largest, std::vector<RawRead>& reads);

}  // namespace marrow::cook
