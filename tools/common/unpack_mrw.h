// A packed file in memory to one that load() reads.
#pragma once

#include <span>
#include <string>

#include "common/aligned_bytes.h"

namespace marrow::tools {

// `packed`: what is_packed() says yes to. Throws Failure (invalid, unsupported) with the offset and the rule.
AlignedBytes unpacked(std::span<const std::byte> packed, const std::string& path);

}  // namespace marrow::tools
