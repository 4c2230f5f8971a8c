// The steps of import_vrm(), and what they share.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cook/gltf/import/import.h"

namespace marrow::cook::gltf {

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

// "vrm/humanoid" on humanoid bones, which become joints; "vrm/firstPerson" on nodes with meshes; "vrm/specVersion" and
// "vrm/meta/…" on the hips. All these nodes are kept. Fills in head, eyes and avatar.
void import_properties(VrmImport& vrm);
// "expression/NAME": additive clips of one key; and properties of the avatar, "vrm/expressions/NAME/…".
void import_expressions(VrmImport& vrm);
// Limits of the eyes' joints, and "vrm/lookAt/…" on the head.
void import_eyes(VrmImport& vrm);

// VRMC_springBone, or the secondaryAnimation of version 0.
void import_springs(VrmImport& vrm);

}  // namespace marrow::cook::gltf
