// What a vertex lacks after skinning, as what it lacks before; and the principal components of that.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// The matrix that linear blend skinning takes a vertex through.
Matrix blended(const std::vector<Influence>& influences, const Pose& pose);

// What `m` turns into `missing`, in bind space. None if it has next to no volume: nothing would bring a vertex there.
std::optional<glm::dvec3> correction(const Matrix& m, const glm::dvec3& missing);

struct PrincipalFields {
  std::vector<Positions> fields;                 // orthogonal, of length 1 over all vertices; the first ones say most
  std::vector<std::vector<double>> coordinates;  // an example: how much of each field
};

// Without a mean: no displacement is an example, too. examples: as many vertices in each. At most `most` fields, fewer
// where the rest is rounding. On all cores; O(examples² · vertices).
PrincipalFields principal_fields(const std::vector<Positions>& examples, std::size_t most);

// Σ_v a_v · b_v.
double dot(const Positions& a, const Positions& b);

}  // namespace marrow::deform
