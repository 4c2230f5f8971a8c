// Where the joints between knots go, and how all of them are moved to where they are better off.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "deform/rig/embed.h"

namespace marrow::deform {

// spheres: of the knots. A joint of a chain stands as far along the way through the room as in the template. In grid
// coordinates.
std::vector<glm::dvec3> place_joints(const Embedding& embedding, const std::vector<std::size_t>& spheres);

// Moves joints, each a little after the other, as long as it lowers the sum of how far bones are off the middle of
// the mesh, how far their lengths are from the template's proportions, how far sides are from one another's mirror
// images, and how far joints are from where they were.
void refine_joints(const Embedding& embedding, std::vector<glm::dvec3>& places);

}  // namespace marrow::deform
