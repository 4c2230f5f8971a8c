// Skeletons for tests of roles: made of a few numbers, or those of real models.
#pragma once

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
