#include "cook/retarget/mirror_clips.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/failure.h"
#include "cook/retarget/plan/retarget_plan.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

constexpr double kNearAxis = 0.98;  // of a cosine

// Of one skeleton: how a joint's keys become those of its mirror.
class Mirror {
 public:
  explicit Mirror(const BuiltSkeleton& skeleton)
      : joints_(lay_out(skeleton, std::vector<Counterpart>(skeleton.parents.size()))), other_(joints_.size(), kNone) {
    for (const JointPair& pair : skeleton.roles.pairs) {
      other_[pair.left] = pair.right;
      other_[pair.right] = pair.left;
    }
    find_plane(skeleton);
    for (std::size_t j = 0; j < other_.size(); ++j) {
      const int other = other_[j];
      if (other == kNone || to_index(other) < j) continue;
      if (hang_alike(j, to_index(other))) continue;
      other_[j] = other_[to_index(other)] = kNone;
    }
  }
  bool has_pairs() const { return has_pairs_; }

  // What moves as the joint, once mirrored: its mirror, or itself.
  std::size_t other(std::size_t joint) const { return other_[joint] == kNone ? joint : to_index(other_[joint]); }

  // A key of `from`, of other(from). is_tangent: of a cubic spline.
  glm::vec4 mirrored(RawPath path, const glm::vec4& key, std::size_t from, bool is_tangent) const {
    const RetargetJoint &source = joints_[from], &target = joints_[other(from)];
    if (path == RawPath::rotation) return turned(source, target, key);
    if (path == RawPath::scale) return scaled(source, target, key);
    const glm::dvec3 gone = glm::dvec3(key) - (is_tangent ? glm::dvec3(0) : source.rest.translation);
    const glm::dmat3 below = linear_above(target);
    glm::dvec3 moved(0);  // what is flat has no way to move
    if (glm::determinant(below) != 0) moved = glm::inverse(below) * (reflection_ * (linear_above(source) * gone));
    return {glm::vec3(moved + (is_tangent ? glm::dvec3(0) : target.rest.translation)), 0};
  }

 private:
  void find_plane(const BuiltSkeleton& skeleton) {
    glm::dvec3 across(0);
    for (const JointPair& pair : skeleton.roles.pairs) across += joints_[pair.left].place - joints_[pair.right].place;
    const double length = glm::length(across);
    has_pairs_ = length > 0;
    if (!has_pairs_) return;
    across /= length;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(across[axis]) > kNearAxis) {
        across = glm::dvec3(0);
        across[axis] = 1;
      }
    across_ = across;
    reflection_ = glm::dmat3(1.0) - 2.0 * glm::outerProduct(across, across);
  }

  // Their parents are each other's mirror, or the same.
  bool hang_alike(std::size_t a, std::size_t b) const {
    const int above = joints_[a].parent, other_above = joints_[b].parent;
    if (above == kNone || other_above == kNone) return above == other_above;
    return other(to_index(above)) == to_index(other_above);
  }

  glm::dquat reflected(const glm::dquat& q) const {
    const glm::dvec3 axis(q.x, q.y, q.z);
    const glm::dvec3 turned = 2 * glm::dot(axis, across_) * across_ - axis;
    return {q.w, turned};
  }
  glm::dquat turn_above(const RetargetJoint& joint) const {
    return joint.parent == kNone ? joint.turn_above : joints_[to_index(joint.parent)].turn;
  }
  // Linear in the key, so that tangents can be mirrored as well.
  glm::vec4 turned(const RetargetJoint& source, const RetargetJoint& target, const glm::vec4& key) const {
    glm::dquat q(double{key.w}, double{key.x}, double{key.y}, double{key.z});
    if (source.is_in_mirror) q = in_mirrored(q);
    const glm::dquat since_rest = turn_above(source) * q * glm::conjugate(source.turn);
    q = glm::conjugate(turn_above(target)) * reflected(since_rest) * target.turn;
    if (target.is_in_mirror) q = in_mirrored(q);
    return glm::vec4(glm::dvec4(q.x, q.y, q.z, q.w));
  }
  // Along the axes that lie most alike.
  glm::vec4 scaled(const RetargetJoint& source, const RetargetJoint& target, const glm::vec4& key) const {
    const glm::dmat3 to = glm::mat3_cast(glm::conjugate(target.turn)) * reflection_ * glm::mat3_cast(source.turn);
    glm::vec4 out = key;
    for (int row = 0; row < 3; ++row) {
      int most = 0;
      for (int column = 1; column < 3; ++column)
        if (std::abs(to[column][row]) > std::abs(to[most][row])) most = column;
      out[row] = key[most];
    }
    return out;
  }
  glm::dmat3 linear_above(const RetargetJoint& joint) const {
    return glm::dmat3(joint.parent == kNone ? joint.scene_above : joints_[to_index(joint.parent)].model_from_joint);
  }

  std::vector<RetargetJoint> joints_;
  std::vector<int> other_;
  glm::dvec3 across_{1, 0, 0};
  glm::dmat3 reflection_{1.0};
  bool has_pairs_ = false;
};

const RawClip& find_clip(const RawScene& scene, const MirrorRule& rule) {
  const RawClip* found = nullptr;
  std::vector<std::string> names;
  for (const RawClip& clip : scene.clips) {
    names.push_back(clip.name);
    if (clip.name != rule.of) continue;
    if (found != nullptr)
      throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                           "several clips \"" + tools::printable(rule.of) + "\"", "rename them before you export");
    found = &clip;
  }
  if (found == nullptr)
    throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                         "no clip \"" + tools::printable(rule.of) + "\" in " + scene.source,
                         tools::suggestion(rule.of, names));
  return *found;
}

bool has_clip(const RawScene& scene, const std::string& name) {
  return std::ranges::find(scene.clips, name, &RawClip::name) != scene.clips.end();
}

using NodeOfJoint = std::map<std::pair<std::size_t, std::size_t>, int>;  // of a skeleton's joint
NodeOfJoint nodes_of(const BuiltScene& built) {
  NodeOfJoint out;
  for (std::size_t n = 0; n < built.joint_of_node.size(); ++n)
    if (built.joint_of_node[n] != kNone)
      out.try_emplace({to_index(built.nearest[n].skeleton), to_index(built.joint_of_node[n])}, static_cast<int>(n));
  return out;
}

RawClip mirror_clip(const RawScene& scene, const RawClip& clip, const BuiltScene& built,
                    const std::vector<Mirror>& mirrors, const NodeOfJoint& nodes) {
  RawClip out = clip;
  std::erase_if(out.channels,
                [&](const RawChannel& channel) { return built.joint_of_node[to_index(channel.node)] == kNone; });
  for (RawChannel& channel : out.channels) {
    const auto s = to_index(built.nearest[to_index(channel.node)].skeleton);
    const std::size_t joint = to_index(built.joint_of_node[to_index(channel.node)]);
    const Mirror& mirror = mirrors[s];
    if (!mirror.has_pairs())
      throw tools::Failure(tools::Exit::invalid, scene.source, "/nodes/" + std::to_string(channel.node),
                           "no joints that mirror each other",
                           "\"" + clip.name +
                               "\" moves a skeleton without left and right; [roles] in marrow.toml "
                               "says which joints have roles");
    const bool cubic = channel.interpolation == RawInterpolation::cubic_spline;
    for (std::size_t i = 0; i < channel.values.size(); ++i)
      channel.values[i] = mirror.mirrored(channel.path, channel.values[i], joint, cubic && i % 3 != 1);
    const auto node = nodes.find({s, mirror.other(joint)});
    if (node == nodes.end())
      throw tools::Failure(tools::Exit::invalid, scene.source, "/nodes/" + std::to_string(channel.node), "no mirror",
                           "the joint on the other side is not in this file; export the whole skeleton");
    channel.node = node->second;
  }
  return out;
}

}  // namespace

RawScene with_mirrored_clips(RawScene scene, const BuiltScene& built, const std::vector<MirrorRule>& rules) {
  if (rules.empty()) return scene;
  std::vector<Mirror> mirrors;
  for (const BuiltSkeleton& skeleton : built.skeletons) mirrors.emplace_back(skeleton);
  const NodeOfJoint nodes = nodes_of(built);
  for (const MirrorRule& rule : rules) {
    if (!rule.origin.must_fit && !has_clip(scene, rule.of)) continue;
    const RawClip& clip = find_clip(scene, rule);
    if (has_clip(scene, rule.name))
      throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                           "there is a clip \"" + tools::printable(rule.name) + "\" already", "give another name");
    RawClip added = mirror_clip(scene, clip, built, mirrors, nodes);
    added.name = rule.name;
    scene.clips.push_back(std::move(added));
  }
  return scene;
}

}  // namespace marrow::cook
