// Counts calls of malloc and everything built on it, in this whole process.
#pragma once

#include <cstddef>

namespace marrow::test {

// Since the process began; starts to count at the first call.
std::size_t allocation_count();

}  // namespace marrow::test
