#include "cook/skeleton/build_limits.h"

#include "common/failure.h"
#include "marrow/limits.h"

namespace marrow::cook {
namespace {

JointLimit build_limit(const RawScene& scene, const BuiltSkeleton& skeleton, std::size_t joint) {
  const auto node = static_cast<std::size_t>(skeleton.node_of_joint[joint]);
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

}  // namespace

std::vector<std::vector<JointLimit>> build_limits(const RawScene& scene, const BuiltScene& built, Notes& notes) {
  std::vector<std::vector<JointLimit>> out;
  for (const BuiltSkeleton& skeleton : built.skeletons) {
    std::vector<JointLimit>& limits = out.emplace_back();
    for (std::size_t j = 0; j < skeleton.node_of_joint.size(); ++j)
      if (const int node = skeleton.node_of_joint[j];
          node != kNone && scene.nodes[static_cast<std::size_t>(node)].limit)
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

}  // namespace marrow::cook
