// In which steps packed files have the values of a track or channel.
#pragma once

#include "unpack/clip/list_codec.h"

namespace marrow::cook {

// The largest powers of two that all values are whole numbers of, or their bits if those take less. values: of the
// whole clip.
ListExponents choose_exponents(const ValueList& list, const float* values);

}  // namespace marrow::cook
