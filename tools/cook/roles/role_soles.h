// Where feet stand at rest.
#pragma once

#include <vector>

#include "cook/roles/role_body.h"
#include "marrow/file.h"

namespace marrow::cook {

// For each joint 1 if a vertex of one of the meshes, which are of the body, follows it.
std::vector<char> carried_by(const std::vector<Mesh>& meshes, std::size_t joint_count);

// Ascending by joint: of the feet, and of hands that reach the ground. A sole is as low as the lowest vertex that
// follows the foot more than anything else, below the ball, which is where the toes' joint is, or else in the middle of
// what touches the ground. Without vertices it is as low as the lowest joint. After all roles.
std::vector<JointSole> find_soles_of_roles(const Body& body, const std::vector<Mesh>& meshes);

}  // namespace marrow::cook
