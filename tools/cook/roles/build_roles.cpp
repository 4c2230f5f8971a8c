#include "cook/roles/build_roles.h"

#include <algorithm>

#include "cook/roles/find_by_shape.h"
#include "cook/roles/find_fingers.h"
#include "cook/roles/find_limbs.h"
#include "cook/roles/find_pairs.h"
#include "cook/roles/find_trunk.h"
#include "cook/roles/given_roles.h"
#include "cook/roles/role_soles.h"

namespace marrow::cook {
namespace {

// Roles with a side, which is then in doubt.
void take_sides(Body& body, const Doubt& doubt) {
  doubt(body.joint_of(Role::left_upper_arm), "by its name it is on the other side than the leg of that name");
  for (std::size_t r = 1; r < kRoleCount; ++r)
    if (const auto role = static_cast<Role>(r); other_side(role) != role) body.take(role);
}

void find_roles(Body& body, const Doubt& doubt) {
  find_limbs(body, doubt);
  find_by_shape(body);
  if (sides_are_crossed(body)) take_sides(body, doubt);
  find_trunk(body, doubt);
  find_fingers(body);
}

BuiltRoles roles_in(const Body& body, const std::vector<Mesh>& meshes) {
  BuiltRoles out;
  for (std::size_t j = 0; j < body.size(); ++j)
    if (const Role role = body.role(static_cast<int>(j)); role != Role::none)
      out.roles.push_back({static_cast<std::uint16_t>(j), role, 0});
  if (out.roles.empty()) return out;
  out.pairs = find_pairs(body);
  out.soles = find_soles_of_roles(body, meshes);
  return out;
}

BuiltRoles build_roles_of(const RawScene& scene, const BuiltSkeleton& skeleton, const std::vector<Mesh>& meshes,
                          const std::vector<RoleRule>& rules, Notes& notes) {
  Body body = body_of(skeleton);
  if (!meshes.empty()) body.carries = carried_by(meshes, body.size());
  const auto is_ruled = [&](const std::string& name) {
    return std::ranges::any_of(rules, [&](const RoleRule& r) { return r.joint == name; });
  };
  std::size_t doubted = 0;
  const Doubt doubt = [&](int joint, const std::string& why) {
    const std::string& name = body.names[to_index(joint)];
    const int node = skeleton.node_of_joint[to_index(joint)];
    if (node == kNone || is_ruled(name)) return;
    ++doubted;
    notes.warnings.push_back(
        {"/nodes/" + std::to_string(node), "role-in-doubt",
         "\"" + name + "\" gets no role: " + why + "; [roles] in marrow.toml, or --roles, says what it is"});
  };
  if (give_avatar_roles(scene, skeleton, body)) {
    int root = body.joint_of(Role::hips);
    while (body.parent(root) != kNone) root = body.parent(root);
    body.give(Role::root, root);
  } else {
    find_roles(body, doubt);
  }
  give_ruled_roles(rules, body);
  BuiltRoles out = roles_in(body, meshes);
  out.doubted = doubted;
  return out;
}

}  // namespace

std::vector<BuiltRoles> build_roles(const RawScene& scene, const BuiltScene& built, const std::vector<Mesh>& meshes,
                                    const std::vector<RoleRule>& rules, Notes& notes) {
  check_rules_of_roles(rules, built.skeletons);
  std::vector<BuiltRoles> out;
  for (std::size_t s = 0; s < built.skeletons.size(); ++s) {
    std::vector<Mesh> own;
    for (const Mesh& mesh : meshes)
      if (mesh.skeleton == s) own.push_back(mesh);
    out.push_back(build_roles_of(scene, built.skeletons[s], own, rules, notes));
  }
  return out;
}

void find_roles(const RawScene& scene, const std::vector<Mesh>& meshes, const std::vector<RoleRule>& rules,
                BuiltScene& built, Notes& notes) {
  std::vector<BuiltRoles> roles = build_roles(scene, built, meshes, rules, notes);
  for (std::size_t s = 0; s < roles.size(); ++s) built.skeletons[s].roles = std::move(roles[s]);
}

}  // namespace marrow::cook
