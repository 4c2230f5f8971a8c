// What a vertex lacks after skinning, as what it lacks before.
#pragma once

#include <optional>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// The matrix that linear blend skinning takes a vertex through.
Matrix blended(const std::vector<Influence>& influences, const Pose& pose);

// What `m` turns into `missing`, in bind space. None if it has next to no volume: nothing would bring a vertex there.
std::optional<glm::dvec3> correction(const Matrix& m, const glm::dvec3& missing);

}  // namespace marrow::deform
