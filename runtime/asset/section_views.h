// Sections of a file as the runtime reads them.
#pragma once

#include <cstddef>

#include "marrow/file.h"

namespace marrow {

// section: a whole GEOM section, accepted by load() or made by the cooker, on a 16-byte boundary; the view points into
// it.
Geometry view_geometry(const std::byte* section);

}  // namespace marrow
