// What whoever prepares a mesh asks of it first.
#pragma once

#include "core/check.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {

// Vertices, joints, a box that is finite, and tangents for all of them or none.
BadCall check_mesh(const Mesh& mesh, const PrepareOptions& options);

}  // namespace marrow::gles3
