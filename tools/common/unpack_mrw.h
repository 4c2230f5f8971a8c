// A packed file in memory to one that load() reads.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/aligned_bytes.h"
#include "marrow/file.h"

namespace marrow::tools {

// `packed`: what is_packed() says yes to. Throws Failure (invalid, unsupported) with the offset and the rule.
AlignedBytes unpacked(std::span<const std::byte> packed, const std::string& path);

// Where the records of a packed file stand; of one that has been unpacked.
std::vector<File::Section> records_of(std::span<const std::byte> packed);

}  // namespace marrow::tools
