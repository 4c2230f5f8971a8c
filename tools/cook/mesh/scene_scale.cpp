#include "cook/mesh/scene_scale.h"

#include <algorithm>

#include "cook/scene/matrices.h"
#include "cook/skin/deform_source.h"

namespace marrow::cook {

SceneScale::SceneScale(const std::vector<BuiltSkeleton>& skeletons, const RawScene& scene)
    : instances_(scene.meshes.size()) {
  for (const BuiltSkeleton& skeleton : skeletons) rest_.push_back(model_pose(skeleton, skeleton.rest));
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    instances_[static_cast<std::size_t>(scene.instances[i].mesh)].push_back(i);
}

double SceneScale::of_joint(int skeleton, int joint, const glm::dmat4& joint_from_mesh) const {
  const Affine& rest = rest_[static_cast<std::size_t>(skeleton)][static_cast<std::size_t>(joint)];
  return largest_stretch(glm::dmat3(to_matrix(rest) * joint_from_mesh));
}

double SceneScale::of(std::uint32_t skeleton, const std::vector<std::uint16_t>& joints,
                      const std::vector<Affine>& inverse_bind) const {
  double out = 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
    out = std::max(out, of_joint(static_cast<int>(skeleton), joints[i], to_matrix(inverse_bind[i])));
  return out;
}

std::vector<glm::dmat4> SceneScale::places(int skeleton, const Palette& palette) const {
  std::vector<glm::dmat4> out;
  for (std::size_t i = 0; i < palette.joints.size(); ++i)
    out.push_back(to_matrix(rest_[to_index(skeleton)][palette.joints[i]]) * to_matrix(palette.inverse_bind[i]));
  for (const Helper& helper : palette.helpers) {
    const auto share = static_cast<double>(helper.share);
    out.push_back(out[helper.first] * (1 - share) + out[helper.second] * share);
  }
  return out;
}

double SceneScale::of(const RawScene& scene, const BuiltScene& built, int mesh) const {
  double out = 0;
  const auto add = [&](int node, const glm::dmat4& node_from_mesh) {
    const NearestJoint& nearest = built.nearest[static_cast<std::size_t>(node)];
    if (nearest.joint == kNone) return;  // nothing hangs there
    out = std::max(out, of_joint(nearest.skeleton, nearest.joint, nearest.joint_from_node * node_from_mesh));
  };
  for (const std::size_t i : instances_[static_cast<std::size_t>(mesh)]) {
    const RawInstance& instance = scene.instances[i];
    if (instance.skin == kNone) {
      add(instance.node, glm::dmat4(1.0));
      continue;
    }
    const RawSkin& skin = scene.skins[static_cast<std::size_t>(instance.skin)];
    for (std::size_t j = 0; j < skin.joints.size(); ++j) add(skin.joints[j], skin.inverse_bind[j]);
  }
  return out;
}

}  // namespace marrow::cook
