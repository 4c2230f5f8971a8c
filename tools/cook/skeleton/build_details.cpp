#include "cook/skeleton/build_details.h"

#include <glm/mat3x3.hpp>

#include "common/failure.h"
#include "cook/scene/matrices.h"
#include "marrow/limits.h"
#include "text/pattern.h"

namespace marrow::cook {
namespace {

JointLimit build_limit(const RawScene& scene, const BuiltSkeleton& skeleton, std::size_t joint) {
  const auto node = to_index(skeleton.node_of_joint[joint]);
  const RawLimit& raw = *scene.nodes[node].limit;
  LimitDescription d = raw.description;
  if (!raw.zero_is_given)
    for (std::size_t i = 0; i < 4; ++i) d.zero[i] = skeleton.rest[joint / 4].rotation[i][joint % 4];
  JointLimit limit{};
  if (make_limit(d, static_cast<std::uint16_t>(joint), limit) != Status::ok)
    throw tools::Failure(tools::Exit::internal, scene.source,
                         "/nodes/" + std::to_string(node) + "/extras/marrow/limits", "joint-limit",
                         "the limit was read but cannot be made");
  return limit;
}

void set(float (&to)[3], const glm::dvec3& from) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

SpringCollider build_collider(const RawCollider& raw, const NearestJoint& nearest) {
  SpringCollider out;
  out.joint = static_cast<std::uint16_t>(nearest.joint);
  set(out.from, glm::dvec3(nearest.joint_from_node * glm::dvec4(raw.from, 1)));
  set(out.to, glm::dvec3(nearest.joint_from_node * glm::dvec4(raw.to, 1)));
  out.radius_m = static_cast<float>(raw.radius_m * largest_stretch(glm::dmat3(nearest.joint_from_node)));
  return out;
}

void add_chain(const RawSpring& raw, const std::vector<int>& joint_of_node, std::uint64_t colliders,
               BuiltSprings& out) {
  format::SpringRecord record{};
  record.colliders = colliders;
  record.first_joint = static_cast<std::uint32_t>(out.joints.size());
  record.joint_count = static_cast<std::uint32_t>(raw.nodes.size());
  set(record.tip, raw.tip);
  out.chains.push_back(record);
  for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
    out.joints.push_back(raw.settings[i]);
    out.joints.back().joint = static_cast<std::uint16_t>(joint_of_node[to_index(raw.nodes[i])]);
  }
}

BuiltNode build_node(const RawNode& raw, const NearestJoint& nearest) {
  BuiltNode node;
  node.name = raw.name;
  if (nearest.skeleton != kNone) node.skeleton = static_cast<std::uint32_t>(nearest.skeleton);
  if (nearest.joint != kNone) node.joint = static_cast<std::uint16_t>(nearest.joint);
  node.joint_from_node = to_affine(nearest.joint_from_node);
  node.properties = raw.extras;
  return node;
}

}  // namespace

std::vector<std::vector<JointLimit>> build_limits(const RawScene& scene, const BuiltScene& built, Notes& notes) {
  std::vector<std::vector<JointLimit>> out;
  for (const BuiltSkeleton& skeleton : built.skeletons) {
    std::vector<JointLimit>& limits = out.emplace_back();
    for (std::size_t j = 0; j < skeleton.node_of_joint.size(); ++j)
      if (const int node = skeleton.node_of_joint[j]; node != kNone && scene.nodes[to_index(node)].limit)
        limits.push_back(build_limit(scene, skeleton, j));
  }
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    if (scene.nodes[n].limit && built.joint_of_node[n] == kNone)
      notes.warnings.push_back({"/nodes/" + std::to_string(n) + "/extras/marrow/limits", "limit-without-joint",
                                "the node is no joint: no skin names it and no clip moves it"});
  return out;
}

void set_limits(const RawScene& scene, BuiltScene& built, Notes& notes) {
  std::vector<std::vector<JointLimit>> limits = build_limits(scene, built, notes);
  for (std::size_t s = 0; s < limits.size(); ++s) built.skeletons[s].limits = std::move(limits[s]);
}

std::vector<BuiltSprings> build_springs(const RawScene& scene, const BuiltScene& built, Notes& notes) {
  std::vector<BuiltSprings> out(built.skeletons.size());
  const auto nearest = [&](int node) -> const NearestJoint& { return built.nearest[to_index(node)]; };
  // Which bit a collider has in its own skeleton.
  std::vector<std::uint64_t> bit(scene.colliders.size(), 0);
  for (std::size_t c = 0; c < scene.colliders.size(); ++c) {
    const RawCollider& raw = scene.colliders[c];
    const NearestJoint& on = nearest(raw.node);
    if (on.joint == kNone) {
      notes.warnings.push_back({"/nodes/" + std::to_string(raw.node), "collider-without-joint",
                                "a collider hangs on this node, which hangs on no joint; it is left out"});
      continue;
    }
    BuiltSprings& of = out[to_index(on.skeleton)];
    bit[c] = std::uint64_t{1} << of.colliders.size();
    of.colliders.push_back(build_collider(raw, on));
  }
  for (const RawSpring& raw : scene.springs) {
    const int skeleton = nearest(raw.nodes.front()).skeleton;
    std::uint64_t colliders = 0;
    for (std::size_t c = 0; c < scene.colliders.size(); ++c)
      if ((raw.colliders >> c & 1) != 0 && nearest(scene.colliders[c].node).skeleton == skeleton) colliders |= bit[c];
    add_chain(raw, built.joint_of_node, colliders, out[to_index(skeleton)]);
  }
  return out;
}

void set_springs(const RawScene& scene, BuiltScene& built, Notes& notes) {
  std::vector<BuiltSprings> springs = build_springs(scene, built, notes);
  for (std::size_t s = 0; s < springs.size(); ++s) built.skeletons[s].springs = std::move(springs[s]);
}

BuiltNodes build_nodes(const RawScene& scene, const BuiltScene& built, const std::vector<std::string>& keep,
                       Notes& notes) {
  BuiltNodes out;
  for (const std::string& glob : keep) out.kept.push_back({glob, {}});
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const RawNode& raw = scene.nodes[n];
    if (raw.name.empty() || !raw.in_scene) continue;
    bool kept = raw.kept;
    for (Kept& rule : out.kept) {
      if (!tools::fits(rule.glob, raw.name)) continue;
      rule.nodes.push_back(raw.name);
      kept = true;
    }
    if (!kept) continue;
    if (raw.dropped_extras > 0)
      notes.warnings.push_back({"/nodes/" + std::to_string(n) + "/extras", "extras-dropped",
                                std::to_string(raw.dropped_extras) +
                                    " values are left out: nulls, infinite numbers, or texts with a zero character"});
    out.nodes.push_back(build_node(raw, built.nearest[n]));
  }
  for (const Kept& rule : out.kept)
    if (rule.nodes.empty())
      notes.warnings.push_back({"/nodes", "keep-fits-nothing", "no node of the scene is called \"" + rule.glob + "\""});
  return out;
}
}  // namespace marrow::cook
