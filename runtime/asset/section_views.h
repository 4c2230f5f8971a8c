// Sections of a file as the runtime reads them.
#pragma once

#include <cstddef>

#include "asset/format.h"
#include "marrow/file.h"

namespace marrow {

// section: a whole GEOM section, accepted by load() or made by the cooker, on a 16-byte boundary; the view points into
// it.
Geometry view_geometry(const std::byte* section);

// header: of a whole MOTN section; the view points into it.
ClipMotion view_motion(const format::MotionHeader& header, float duration_s);

// What codes of a BNDS section stand for.
Bounds decode_bounds(const format::BoundsCodes& codes);

}  // namespace marrow
