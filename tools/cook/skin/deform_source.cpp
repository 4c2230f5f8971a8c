#include "cook/skin/deform_source.h"

#include <map>
#include <tuple>

#include <glm/matrix.hpp>

#include "common/evenly.h"
#include "cook/scene/matrices.h"

namespace marrow::cook {
namespace {

constexpr double kShownRate_hz = 30;
constexpr std::size_t kMostShownPoses = 320;
constexpr std::size_t kMadeUpPoses = 40;

// Vertices are the same if they lie in one place and follow the same joints alike.
using Key = std::tuple<float, float, float, std::vector<std::pair<std::uint32_t, double>>>;

Key key_of(const glm::vec3& position, const BoundVertex& influences) {
  std::vector<std::pair<std::uint32_t, double>> follows;
  for (const BoundInfluence& i : influences) follows.emplace_back(i.joint, i.weight);
  return {position.x, position.y, position.z, std::move(follows)};
}

std::vector<int> nearest_above(const std::vector<std::uint16_t>& joints, const std::vector<std::uint16_t>& parents) {
  std::map<int, int> of_skin;
  for (std::size_t j = 0; j < joints.size(); ++j) of_skin.emplace(joints[j], static_cast<int>(j));
  std::vector<int> out;
  for (const std::uint16_t joint : joints) {
    std::uint16_t above = parents[joint];
    while (above != kNoJoint && !of_skin.contains(above)) above = parents[above];
    out.push_back(above == kNoJoint ? kNone : of_skin.at(above));
  }
  return out;
}

}  // namespace

WeldedMesh welded(const RawMesh& mesh, const RawSkin& skin, const SkinBinding& binding) {
  WeldedMesh out;
  out.mesh.joint_count = static_cast<std::uint32_t>(skin.joints.size());
  std::map<Key, std::uint32_t> known;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const RawPrimitive& primitive = mesh.primitives[p];
    std::vector<std::uint32_t>& vertex_of = out.vertex_of.emplace_back();
    for (std::size_t v = 0; v < binding.primitives[p].size(); ++v) {
      const BoundVertex& influences = binding.primitives[p][v];
      const auto [at, is_new] = known.try_emplace(key_of(primitive.positions[v], influences),
                                                  static_cast<std::uint32_t>(out.mesh.positions.size()));
      if (is_new) {
        out.mesh.positions.emplace_back(primitive.positions[v]);
        std::vector<deform::Influence>& to = out.mesh.influences.emplace_back();
        for (const BoundInfluence& i : influences) to.push_back({i.joint, i.weight});
      }
      vertex_of.push_back(at->second);
    }
    if (vertex_of.empty()) continue;  // not skinned
    for (const std::uint32_t i : primitive.indices) out.mesh.indices.push_back(vertex_of[i]);
  }
  return out;
}

DeformSource deform_source(const RawMesh& mesh, const RawSkin& skin, const SkinBinding& binding,
                           const BuiltScene& built) {
  DeformSource out;
  static_cast<WeldedMesh&>(out) = welded(mesh, skin, binding);
  out.inverse_bind = skin.inverse_bind;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    out.joints.push_back(static_cast<std::uint16_t>(built.joint_of_node[static_cast<std::size_t>(skin.joints[j])]));
    out.centres.emplace_back(glm::inverse(skin.inverse_bind[j])[3]);
  }
  out.skeleton = static_cast<std::uint32_t>(built.nearest[static_cast<std::size_t>(skin.joints.front())].skeleton);
  out.parents = nearest_above(out.joints, built.skeletons[out.skeleton].parents);
  return out;
}

deform::Pose deform_pose(const DeformSource& source, const BuiltSkeleton& skeleton,
                         const std::vector<SoaTransform>& local) {
  const std::vector<Affine> model_from_joint = model_pose(skeleton, local);
  deform::Pose out;
  for (std::size_t j = 0; j < source.joints.size(); ++j)
    out.emplace_back(to_matrix(model_from_joint[source.joints[j]]) * source.inverse_bind[j]);
  return out;
}

std::vector<deform::FramesInARow> frames_in_a_row(const DeformSource& source, const BuiltScene& built,
                                                  std::size_t most) {
  constexpr double kRate_hz = 60;
  constexpr std::size_t kMostFrames = 4096;  // of longer clips they are farther apart
  const std::vector<SampledPose> frames = clip_poses(built, source.skeleton, kRate_hz, kMostFrames);
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i + 2 < frames.size(); ++i)
    if (frames[i].clip == frames[i + 2].clip) begins.push_back(i);
  std::vector<deform::FramesInARow> out;
  for (const std::size_t begin : tools::evenly(begins, most)) {
    out.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      out.back()[k] = deform_pose(source, built.skeletons[source.skeleton], frames[begin + k].local);
  }
  return out;
}

std::vector<deform::Pose> poses_of_clips(const DeformSource& source, const SkinBinding& binding,
                                         const BuiltScene& built) {
  const BuiltSkeleton& skeleton = built.skeletons[source.skeleton];
  std::vector<SampledPose> sampled = clip_poses(built, source.skeleton, kShownRate_hz, kMostShownPoses);
  if (sampled.empty()) sampled = resampled_poses(skeleton, sampled, kMadeUpPoses);
  std::vector<deform::Pose> out(1, deform::Pose(source.joints.size(), deform::Matrix(1.0)));
  for (const SampledPose& pose : sampled) out.push_back(deform_pose(source, skeleton, pose.local));
  for (deform::Pose& pose : out) deform::append_helpers(binding.helpers, pose);
  return out;
}

}  // namespace marrow::cook
