// The checks of a mesh before it is prepared.
#pragma once

#include "core/check.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {

// Checks that the mesh has vertices, joints and a finite box, and animation-space tangents for all of it or for none.
BadCall check_mesh(const Mesh& mesh, const PrepareOptions& options);

}  // namespace marrow::gles3
