// Bounds as packed files hold them; runtime/unpack/clip/bounds_record.h reads them.
#pragma once

#include <cstddef>
#include <vector>

#include "cook/write/measure_bounds.h"

namespace marrow::cook {

std::vector<std::byte> pack_bounds(const MeasuredBounds& bounds);

}  // namespace marrow::cook
