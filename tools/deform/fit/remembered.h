// What a slow deformer has made is kept, for fits ask for the same poses again and again.
#pragma once

#include <cstddef>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

inline constexpr std::size_t kRememberedBytes = 48'000'000;

// The deformer, in single precision about the mean place. Copies share what they know. Thread-safe; what it gives does
// not depend on what it remembers. Beyond `most_bytes` nothing more is kept.
Deformer remembered(Deformer deformer, std::size_t most_bytes = kRememberedBytes);

}  // namespace marrow::deform
