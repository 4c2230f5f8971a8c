// A contact sheet of inverse kinematics, on the sample: the walk on a slope as animated, with its feet on the ground,
// and with a hand on a point and the eyes on it, too.
#pragma once

#include "image/image.h"
#include "marrow/file.h"
#include "render/gl.h"

namespace marrow::tools {

// Precondition: `file` is the sample, cooked.
Image make_moves_sheet(const Gl& gl, const File& file);

}  // namespace marrow::tools
