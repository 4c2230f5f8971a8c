#include "commands/compare/thesis/tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/elementary.h"

namespace marrow::tools {
namespace {

constexpr std::uint32_t kRound = 20;

// As far as there are four joints, those within 1.5 of it.
std::vector<deform::Influence> influences_at(double x, std::uint32_t joints) {
  std::vector<deform::Influence> out;
  double sum = 0;
  for (std::uint32_t j = 0; j < joints; ++j) {
    const double near = std::max(0.0, 1.5 - std::abs(x - 0.5 - j));
    if (near <= 0) continue;
    out.push_back({j, near * near});
    sum += near * near;
  }
  for (deform::Influence& i : out) i.weight /= sum;
  return out;
}

glm::dquat angle_axis(double angle_rad, const glm::dvec3& axis) {
  return {cosine(angle_rad / 2), axis * sine(angle_rad / 2)};
}
glm::dquat turn_of(double bend_rad, double twist_rad) {
  return angle_axis(bend_rad, {0, 0, 1}) * angle_axis(twist_rad, {1, 0, 0});
}

}  // namespace

Tube::Tube(const ThesisSize& size) {
  deform::SkinnedMesh& mesh = source.mesh;
  const std::uint32_t along = size.vertices / kRound;
  mesh.joint_count = size.joints;
  for (std::uint32_t j = 0; j < size.joints; ++j) {
    source.parents.push_back(static_cast<int>(j) - 1);
    source.centres.emplace_back(j, 0, 0);
  }
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t k = 0; k < kRound; ++k) {
      const double x = static_cast<double>(i) / along * size.joints, angle = 2 * std::numbers::pi * k / kRound;
      mesh.positions.emplace_back(x, 0.3 * cosine(angle), 0.3 * sine(angle));
      mesh.influences.push_back(influences_at(x, size.joints));
    }
  const auto at = [](std::uint32_t i, std::uint32_t k) { return i * kRound + k % kRound; };
  for (std::uint32_t i = 0; i + 1 < along; ++i)
    for (std::uint32_t k = 0; k < kRound; ++k)
      mesh.indices.insert(mesh.indices.end(),
                          {at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i + 1, k)});
}

deform::Pose Tube::pose(double bend_rad, double twist_rad) const {
  const glm::dmat3 linear = glm::mat3_cast(turn_of(bend_rad, twist_rad));
  deform::Pose out;
  for (std::uint32_t j = 0; j < source.mesh.joint_count; ++j) {
    const deform::Matrix about(linear[0], linear[1], linear[2], source.centres[j] - linear * source.centres[j]);
    out.push_back(j == 0 ? about : deform::Matrix(glm::dmat4(out.back()) * glm::dmat4(about)));
  }
  return out;
}

cook::RawScene Tube::scene() const {
  cook::RawScene out;
  out.source = "tube";
  cook::RawSkin skin;
  const glm::vec4 turned = [] {
    const glm::dquat q = turn_of(0.7, 0.3);
    return glm::vec4(q.x, q.y, q.z, q.w);
  }();
  cook::RawClip clip;
  clip.name = "bend";
  for (std::size_t j = 0; j < source.centres.size(); ++j) {
    cook::RawNode& node = out.nodes.emplace_back();
    node.name = "joint" + std::to_string(j);
    node.parent = source.parents[j];
    if (j > 0) node.translation = {1, 0, 0};
    skin.joints.push_back(static_cast<int>(j));
    skin.inverse_bind.emplace_back(1.0);
    skin.inverse_bind.back()[3] = glm::dvec4(-source.centres[j], 1);
    clip.channels.push_back({static_cast<int>(j),
                             cook::RawPath::rotation,
                             cook::RawInterpolation::linear,
                             {0, 1, 2},
                             {{0, 0, 0, 1}, turned, {0, 0, 0, 1}}});
  }
  out.nodes.emplace_back().name = "tube";
  cook::RawPrimitive primitive;
  primitive.pointer = "/meshes/0/primitives/0";
  primitive.indices = source.mesh.indices;
  for (std::size_t v = 0; v < source.mesh.positions.size(); ++v) {
    primitive.positions.emplace_back(source.mesh.positions[v]);
    std::vector<cook::RawInfluence>& to = primitive.influences.emplace_back();
    for (const deform::Influence& i : source.mesh.influences[v]) to.push_back({i.joint, static_cast<float>(i.weight)});
  }
  out.meshes.push_back({"tube", {}, {std::move(primitive)}});
  out.skins.push_back(std::move(skin));
  out.instances.push_back({static_cast<int>(out.nodes.size()) - 1, 0, 0, {}, cook::kNone});
  out.clips.push_back(std::move(clip));
  return out;
}

}  // namespace marrow::tools
