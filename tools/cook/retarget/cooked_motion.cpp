#include "cook/retarget/retarget.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/failure.h"
#include "common/hash.h"
#include "common/load_mrw.h"
#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "deform/rotations.h"
#include "marrow/sample.h"

namespace marrow::cook {
namespace {

constexpr double kKeysASecond = 60;
constexpr double kMostPoses = 1u << 22;  // of joints, in a clip

// What stands above a root; of what shears only the rotation and the lengths of its axes.
RawNode node_above(const Affine& model_from_root) {
  RawNode out;
  const glm::dmat4 m = to_matrix(model_from_root);
  glm::dmat3 linear(m);
  out.translation = glm::dvec3(m[3]);
  for (int axis = 0; axis < 3; ++axis) out.scale[axis] = glm::length(linear[axis]);
  if (glm::determinant(linear) < 0) {
    out.scale.x = -out.scale.x;
    linear[0] = -linear[0];
  }
  out.rotation = deform::quaternion_of(deform::rotation_of(linear));
  return out;
}

// Returns the node of each joint.
std::vector<int> add_joints(const BuiltSkeleton& skeleton, RawScene& scene) {
  std::vector<int> nodes;
  const std::vector<Transform> rest = rest_transforms(skeleton);
  for (std::size_t j = 0; j < rest.size(); ++j) {
    int parent = 0;
    if (skeleton.parents[j] == kNoJoint) {
      parent = static_cast<int>(scene.nodes.size());
      scene.nodes.push_back(node_above(skeleton.model_from_root[j]));
    } else {
      parent = nodes[skeleton.parents[j]];
    }
    nodes.push_back(static_cast<int>(scene.nodes.size()));
    RawNode& node = scene.nodes.emplace_back();
    node.name = skeleton.joint_names[j];
    node.parent = parent;
    node.translation = rest[j].translation;
    node.rotation = rest[j].rotation;
    node.scale = rest[j].scale;
  }
  RawSkin& skin = scene.skins.emplace_back();
  skin.joints = nodes;
  skin.inverse_bind.assign(nodes.size(), glm::dmat4(1.0));
  return nodes;
}

RawClip keys_of(const Skeleton& skeleton, const Clip& clip, const std::vector<int>& nodes, const std::string& path) {
  RawClip out;
  out.name = clip.name;
  const double length = double{clip.duration_s};
  const double most = std::max(1.0, kMostPoses / static_cast<double>(nodes.size()));
  const auto steps = static_cast<std::size_t>(std::ceil(std::min(length * kKeysASecond, most)));
  std::vector<float> times_s = {0};
  for (std::size_t i = 1; i <= steps; ++i) {
    const auto time_s = static_cast<float>(length * static_cast<double>(i) / static_cast<double>(steps));
    if (time_s > times_s.back()) times_s.push_back(time_s);
  }
  std::vector<std::vector<glm::vec4>> turns(nodes.size()), places(nodes.size());
  std::vector<SoaTransform> local(skeleton.soa_size());
  for (const float time_s : times_s) {
    if (sample(skeleton, clip, time_s, local) != Status::ok)
      throw tools::Failure(tools::Exit::invalid, path, "", "\"" + out.name + "\" cannot be sampled", "cook it again");
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const SoaTransform& four = local[j / 4];
      const std::size_t lane = j % 4;
      turns[j].emplace_back(four.rotation[0][lane], four.rotation[1][lane], four.rotation[2][lane],
                            four.rotation[3][lane]);
      places[j].emplace_back(four.translation[0][lane], four.translation[1][lane], four.translation[2][lane], 0.0F);
    }
  }
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    out.channels.push_back({nodes[j], RawPath::rotation, RawInterpolation::linear, times_s, std::move(turns[j])});
    out.channels.push_back({nodes[j], RawPath::translation, RawInterpolation::linear, times_s, std::move(places[j])});
  }
  return out;
}

}  // namespace

RawScene read_cooked_motion(const std::string& path, Files& files) {
  RawScene out;
  const std::vector<std::byte> bytes = files.read(path, kMostBytes);
  out.reads.push_back({files.full_name(path), bytes.size(), tools::hash_of(bytes)});
  out.source = path;
  out.source_bytes = bytes.size();
  const tools::LoadedFile loaded = tools::load_mrw(path, tools::AlignedBytes(std::span<const std::byte>(bytes)));
  const Character character = view_character(path, loaded.file);
  if (character.skeletons.empty())
    throw tools::Failure(tools::Exit::invalid, path, "", "no skeleton",
                         "a clip pack does not say how its joints rest; name the file that it was cooked from");
  std::vector<std::vector<int>> nodes;
  for (const BuiltSkeleton& skeleton : character.skeletons) nodes.push_back(add_joints(skeleton, out));
  for (std::uint32_t c = 0; c < loaded.file.clip_count(); ++c) {
    const Clip clip = loaded.file.clip(c);
    if (clip.skeleton >= nodes.size() || clip.additive) continue;
    out.clips.push_back(keys_of(loaded.file.skeleton(clip.skeleton), clip, nodes[clip.skeleton], path));
  }
  return out;
}

}  // namespace marrow::cook
