// VRM's spring parameters as ours, docs/ik/springs.md has the derivation.
#pragma once

#include <glm/vec3.hpp>

#include "marrow/file.h"

namespace marrow::cook::gltf {

struct VrmSpring {
  double stiffness = 1, gravity_power = 0, drag_force = 0.5, hit_radius = 0;
  glm::dvec3 gravity_direction{0, -1, 0};  // scene; unit, as VRM has it
};

// bone_m: the bone's length at rest, above 0. direction: where it points at rest, scene, unit.
SpringJoint spring_settings(const VrmSpring& vrm, double bone_m, const glm::dvec3& direction);

}  // namespace marrow::cook::gltf
