#include "cook/skeleton/build_springs.h"

#include <glm/mat3x3.hpp>

#include "cook/scene/matrices.h"

namespace marrow::cook {
namespace {

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
    out.joints.back().joint = static_cast<std::uint16_t>(joint_of_node[static_cast<std::size_t>(raw.nodes[i])]);
  }
}

}  // namespace

std::vector<BuiltSprings> build_springs(const RawScene& scene, const BuiltScene& built, Notes& notes) {
  std::vector<BuiltSprings> out(built.skeletons.size());
  const auto nearest = [&](int node) -> const NearestJoint& { return built.nearest[static_cast<std::size_t>(node)]; };
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
    BuiltSprings& of = out[static_cast<std::size_t>(on.skeleton)];
    bit[c] = std::uint64_t{1} << of.colliders.size();
    of.colliders.push_back(build_collider(raw, on));
  }
  for (const RawSpring& raw : scene.springs) {
    const int skeleton = nearest(raw.nodes.front()).skeleton;
    std::uint64_t colliders = 0;
    for (std::size_t c = 0; c < scene.colliders.size(); ++c)
      if ((raw.colliders >> c & 1) != 0 && nearest(scene.colliders[c].node).skeleton == skeleton) colliders |= bit[c];
    add_chain(raw, built.joint_of_node, colliders, out[static_cast<std::size_t>(skeleton)]);
  }
  return out;
}

void set_springs(const RawScene& scene, BuiltScene& built, Notes& notes) {
  std::vector<BuiltSprings> springs = build_springs(scene, built, notes);
  for (std::size_t s = 0; s < springs.size(); ++s) built.skeletons[s].springs = std::move(springs[s]);
}

}  // namespace marrow::cook
