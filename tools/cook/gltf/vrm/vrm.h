// What VRM avatars say beyond glTF, versions 0 and 1, becomes Marrow's own: springs, limits of eyes, expressions as
// additive clips, properties of kept nodes.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cook/gltf/import/import.h"
#include "marrow/file.h"

namespace marrow::cook::gltf {

// scene: all else of it is imported. A reference to nothing is refused, unless a game can do without, which is a
// warning; a spring that makes no sense is left out with one.
void import_vrm(const Document& document, Budget& budget, Report& report, RawScene& scene);

// What the steps of import_vrm() share.
struct VrmImport {
  const Document& document;
  Budget& budget;
  Report& report;
  RawScene& scene;
  bool is_0 = false;  // VRM, not VRMC_vrm
  Json vrm;           // of whichever there is; an object
  std::string where;  // it stands
  std::vector<glm::dmat4> model_from_node;
  int head = kNone;              // humanoid bones
  int eyes[2] = {kNone, kNone};  // left, right
  int avatar = kNone;            // the node with what is said of all: the hips
};

// A member, or what is empty.
const Json& member_or_empty(const Json& object, const char* name);
double number_or(const Json& object, const char* name, double fallback);
std::string text_or(const Json& object, const char* name, const std::string& fallback);
// An array of three, or version 0's object of x, y and z.
glm::dvec3 vector_or(const Json& object, const char* name, const glm::dvec3& fallback);
// Whether a number names one of `count`.
bool names_one(const Json& number, std::size_t count);

// A step of import_vrm(): VRMC_springBone, or the secondaryAnimation of version 0.
void import_springs(VrmImport& vrm);

// VRM's spring parameters as ours; docs/ik/springs.md has the derivation.
struct VrmSpring {
  double stiffness = 1, gravity_power = 0, drag_force = 0.5, hit_radius = 0;
  glm::dvec3 gravity_direction{0, -1, 0};  // scene; unit, as VRM has it
};

// bone_m: the bone's length at rest, above 0. direction: where it points at rest, scene, unit.
SpringJoint spring_settings(const VrmSpring& vrm, double bone_m, const glm::dvec3& direction);

}  // namespace marrow::cook::gltf
