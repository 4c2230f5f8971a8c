// The golden file of format version 1, embedded in the test binary; see golden/README.md.
#pragma once

#include <cstddef>

#include "support/aligned.h"

namespace marrow::embedded {
extern const unsigned char tiny_v1[];
extern const unsigned long long tiny_v1_size;
}  // namespace marrow::embedded

namespace marrow::test {

// A copy that a test may damage.
inline AlignedBlock golden_copy() {
  return AlignedBlock(embedded::tiny_v1, static_cast<std::size_t>(embedded::tiny_v1_size));
}

}  // namespace marrow::test
