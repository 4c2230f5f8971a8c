#include "cook/roles/given_roles.h"

#include <algorithm>

#include "common/failure.h"
#include "text/nearest.h"

namespace marrow::cook {
namespace {

// "leftUpperArm" → "left_upper_arm".
std::string with_underscores(const std::string& bone) {
  std::string out;
  for (const char c : bone) {
    if (c >= 'A' && c <= 'Z') {
      out += '_';
      out += static_cast<char>(c - 'A' + 'a');
    } else {
      out += c;
    }
  }
  return out;
}

const std::string* bone_of(const RawScene& scene, int node) {
  if (node == kNone) return nullptr;
  for (const RawProperty& p : scene.nodes[to_index(node)].extras)
    if (p.name == "vrm/humanoid" && p.type == PropertyType::text) return &p.text;
  return nullptr;
}

// VRM 0 calls the thumb's joints as those of other fingers.
std::string as_in_vrm_1(std::string bone) {
  for (const std::string side : {"left", "right"})
    if (bone.starts_with(side + "Thumb")) {
      if (bone.ends_with("Proximal")) return side + "ThumbMetacarpal";
      if (bone.ends_with("Intermediate")) return side + "ThumbProximal";
    }
  return bone;
}

int joint_called(const Body& body, const std::string& name) {
  const auto found = std::ranges::find(body.names, name);
  return found == body.names.end() ? kNone : static_cast<int>(found - body.names.begin());
}

void set_tail(Body& body, int first) {
  body.take(Role::tail);
  for (int j = first; j != kNone;) {
    body.set(Role::tail, j);
    const std::vector<int>& below = body.children[to_index(j)];
    j = below.size() == 1 ? below[0] : kNone;
  }
}

}  // namespace

bool give_avatar_roles(const RawScene& scene, const BuiltSkeleton& skeleton, Body& body) {
  std::vector<std::string> bones(body.size());
  bool is_0 = false;
  for (std::size_t j = 0; j < body.size(); ++j)
    if (const std::string* const bone = bone_of(scene, skeleton.node_of_joint[j])) {
      bones[j] = *bone;
      is_0 = is_0 || bone->ends_with("ThumbIntermediate");
    }
  if (std::ranges::find(bones, "hips") == bones.end()) return false;
  for (std::size_t j = 0; j < body.size(); ++j)
    if (const Role role = find_role(with_underscores(is_0 ? as_in_vrm_1(bones[j]) : bones[j]).c_str());
        role != Role::none && role != Role::root && role != Role::tail)
      body.give(role, static_cast<int>(j));
  return true;
}

void give_ruled_roles(const std::vector<RoleRule>& rules, Body& body) {
  for (const RoleRule& rule : rules) {
    if (rule.joint.empty()) {
      body.take(rule.role);
      continue;
    }
    const int joint = joint_called(body, rule.joint);
    if (joint == kNone) continue;
    if (rule.role == Role::tail)
      set_tail(body, joint);
    else
      body.set(rule.role, joint);
  }
}

void check_rules_of_roles(const std::vector<RoleRule>& rules, const std::vector<BuiltSkeleton>& skeletons) {
  std::vector<std::string> names;
  for (const BuiltSkeleton& s : skeletons) names.insert(names.end(), s.joint_names.begin(), s.joint_names.end());
  const auto is_there = [&](const RoleRule& rule) { return std::ranges::count(names, rule.joint) > 0; };
  const bool one_fits = std::ranges::any_of(rules, is_there);
  for (const RoleRule& rule : rules) {
    if (rule.joint.empty() || is_there(rule)) continue;
    if (!rule.origin.must_fit && !one_fits && tools::nearest_name(rule.joint, names).empty()) continue;
    throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                         "no joint \"" + rule.joint + "\" for " + role_name(rule.role),
                         tools::suggestion(rule.joint, names));
  }
}

}  // namespace marrow::cook
