// Skeletons for tests of roles: made of a few numbers, or those of real models.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/roles/build_roles.h"
#include "cook/skeleton/build_skeletons.h"

namespace marrow::cook {

using RoleTable = std::map<std::string, std::string>;  // role → names of its joints, with "," between them

struct BodyJoint {
  std::string name, parent;  // of a root empty
  glm::dvec3 place;          // of the scene
};

inline std::vector<std::string> tokens(const std::string& text, const std::string& between) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(between, at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + between.size();
  }
  return out;
}

// "tail < Hips 0 0.95 -0.1; tip < tail 0 0.9 -0.2": names, parents (none: "Hips 0 1 0") and places.
inline std::vector<BodyJoint> joints_of_text(const std::string& text) {
  std::vector<BodyJoint> out;
  for (const std::string& one : tokens(text, "; ")) {
    std::size_t end = one.size();
    BodyJoint& joint = out.emplace_back();
    for (const int axis : {2, 1, 0}) {
      const std::size_t begin = one.rfind(' ', end - 1);
      joint.place[axis] = std::stod(one.substr(begin + 1));
      end = begin;
    }
    const std::size_t below = one.find(" < ");
    joint.name = one.substr(0, std::min(below, end));
    if (below < end) joint.parent = one.substr(below + 3, end - below - 3);
  }
  return out;
}

// "hips=pelvis tail=tail_1,tail_2".
inline RoleTable roles_of_text(const std::string& text) {
  RoleTable out;
  for (const std::string& one : tokens(text, " ")) out[one.substr(0, one.find('='))] = one.substr(one.find('=') + 1);
  return out;
}

// Any order in which parents come first; unturned joints. Each is a node of the scene, moved by the game.
inline RawScene scene_of(const std::vector<BodyJoint>& joints) {
  RawScene scene;
  scene.source = "body";
  std::map<std::string, int> node;
  for (const BodyJoint& j : joints) {
    RawNode& raw = scene.nodes.emplace_back();
    raw.name = j.name;
    raw.moved_by_game = true;
    raw.translation = j.place;
    if (!j.parent.empty()) {
      raw.parent = node.at(j.parent);
      for (const BodyJoint& p : joints)
        if (p.name == j.parent) raw.translation = j.place - p.place;
    }
    node[j.name] = static_cast<int>(scene.nodes.size()) - 1;
  }
  return scene;
}

inline RoleTable table_of(const BuiltSkeleton& skeleton, const BuiltRoles& roles) {
  RoleTable out;
  for (const JointRole& r : roles.roles) {
    std::string& names = out[role_name(r.role)];
    names += (names.empty() ? "" : ",") + skeleton.joint_names[r.joint];
  }
  return out;
}

struct FoundRoles {
  RoleTable table;
  BuiltSkeleton skeleton;
  BuiltRoles roles;
  std::vector<RawWarning> warnings;

  bool has_pair(const std::string& left, const std::string& right) const {
    for (const JointPair& p : roles.pairs)
      if (skeleton.joint_names[p.left] == left && skeleton.joint_names[p.right] == right) return true;
    return false;
  }
};

inline FoundRoles find_roles_of(const RawScene& scene, const std::vector<RoleRule>& rules = {}) {
  const BuiltScene built = build_skeletons(scene);
  Notes notes;
  FoundRoles out;
  out.roles = build_roles(scene, built, {}, rules, notes).at(0);
  out.skeleton = built.skeletons.at(0);
  out.table = table_of(out.skeleton, out.roles);
  out.warnings = notes.warnings;
  return out;
}

}  // namespace marrow::cook
