// Helpers: palette entries that blend those of two joints.
#pragma once

#include "marrow/file.h"

namespace marrow {

// Writes the entries of helpers behind those of the joints: see build_palette(). bind: one a joint. centres: three
// numbers a helper, or null.
void add_helpers(Span<const Helper> helpers, const float* centres, Span<const Affine> bind, Affine* palette);

}  // namespace marrow
