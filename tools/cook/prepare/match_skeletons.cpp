#include "cook/prepare/match_skeletons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/distinct.h"
#include "common/failure.h"
#include "cook/gltf/read.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_skeletons.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

constexpr float kAlike = 1e-5f;  // of 1 and of the value: exporters print few digits

bool alike(const glm::vec4& a, const glm::vec4& b) {
  for (int c = 0; c < 4; ++c)
    if (!(std::fabs(a[c] - b[c]) <= kAlike * (1 + std::fabs(a[c])))) return false;
  return true;
}

// Keys that all say the same, and tangents of 0.
bool holds_still(const RawChannel& channel) {
  const bool cubic = channel.interpolation == RawInterpolation::cubic_spline;
  const glm::vec4 still = channel.values[cubic ? 1 : 0];
  for (std::size_t i = 0; i < channel.values.size(); ++i)
    if (!alike(channel.values[i], cubic && i % 3 != 1 ? glm::vec4(0) : still)) return false;
  return true;
}

glm::vec4 rest_of(const Transform& t, RawPath path) {
  if (path == RawPath::translation) return {t.translation, 0};
  if (path == RawPath::scale) return {t.scale, 0};
  return glm::vec4(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w);
}

bool same_rest(const Transform& a, const Transform& b, RawPath path) {
  const glm::vec4 x = rest_of(a, path), y = rest_of(b, path);
  return alike(x, y) || (path == RawPath::rotation && alike(x, -y));
}

class Matching {
 public:
  Matching(const Character& character, RawScene scene, Notes& notes)
      : character_(character), notes_(notes), scene_(std::move(scene)) {}

  void match_names();
  void check_moved();
  void drop_strangers();
  void hold_others();
  Matched take() { return {std::move(scene_), std::move(out_)}; }

 private:
  std::string name_of(int node) const {
    const std::string& name = scene_.nodes[static_cast<std::size_t>(node)].name;
    return name.empty() ? "nodes[" + std::to_string(node) + ']' : '"' + name + '"';
  }
  bool is_joint(int node) const { return out_.joint_of_node[static_cast<std::size_t>(node)] != kNone; }
  [[noreturn]] void fail(int node, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::invalid, scene_.source, "/nodes/" + std::to_string(node), rule, advice);
  }
  void check_place(int node) const;
  void hold_others(RawClip& clip, int skeleton);

  const Character& character_;
  Notes& notes_;
  RawScene scene_;
  BuiltScene out_;
  std::map<std::pair<int, int>, int> node_of_;  // a skeleton's joint
  std::set<int> others_;                        // nodes that stand otherwise
};

void Matching::match_names() {
  const std::map<std::string, NearestJoint> joints = joints_by_name(character_);
  out_.joint_of_node.assign(scene_.nodes.size(), kNone);
  out_.nearest.assign(scene_.nodes.size(), {});
  for (std::size_t n = 0; n < scene_.nodes.size(); ++n) {
    const auto found = scene_.nodes[n].in_scene ? joints.find(scene_.nodes[n].name) : joints.end();
    if (found == joints.end() || scene_.nodes[n].name.empty()) continue;
    out_.nearest[n] = found->second;
    out_.joint_of_node[n] = found->second.joint;
    node_of_.try_emplace({found->second.skeleton, found->second.joint}, static_cast<int>(n));
  }
  out_.skeletons = character_.skeletons;
}

// A node that a clip moves: one of its name on both sides, and below the same joint.
void Matching::check_place(int node) const {
  const NearestJoint& at = out_.nearest[static_cast<std::size_t>(node)];
  const BuiltSkeleton& skeleton = character_.skeletons[static_cast<std::size_t>(at.skeleton)];
  const auto joint = static_cast<std::size_t>(at.joint);
  const std::string& name = skeleton.joint_names[joint];
  const bool twice = std::ranges::count(skeleton.joint_names, name) > 1;
  if (twice || node_of_.at({at.skeleton, at.joint}) != node)
    fail(node, "a name that is not unique",
         name_of(node) + " is found twice in " + (twice ? character_.file : "this file") + "; rename one");
  if (skeleton.parents[joint] == kNoParent) return;
  const int parent = scene_.nodes[static_cast<std::size_t>(node)].parent;
  if (parent != kNone && out_.nearest[static_cast<std::size_t>(parent)].skeleton == at.skeleton &&
      out_.joint_of_node[static_cast<std::size_t>(parent)] == skeleton.parents[joint])
    return;
  fail(node, "another parent",
       name_of(node) + " is a child of \"" + skeleton.joint_names[skeleton.parents[joint]] + "\" in " +
           character_.file + "; export from the same skeleton");
}

void Matching::check_moved() {
  std::vector<int> strangers;
  for (const RawClip& clip : scene_.clips)
    for (const RawChannel& channel : clip.channels) {
      if (!scene_.nodes[static_cast<std::size_t>(channel.node)].in_scene) continue;
      if (is_joint(channel.node)) {
        check_place(channel.node);
      } else if (!holds_still(channel)) {
        strangers.push_back(channel.node);
      }
    }
  if (strangers.empty()) return;
  tools::make_distinct(strangers);
  std::vector<std::string> joints, moved, there;
  for (const BuiltSkeleton& skeleton : character_.skeletons)
    for (const std::string& joint : skeleton.joint_names) {
      joints.push_back(joint);
      there.push_back('"' + tools::printable(joint) + '"');
    }
  for (const int node : strangers) {
    const std::string meant = tools::did_you_mean(scene_.nodes[static_cast<std::size_t>(node)].name, joints);
    moved.push_back(tools::printable(name_of(node)) + (meant.empty() ? "" : " (" + meant + ")"));
  }
  fail(strangers.front(), "no such joint in " + character_.file,
       "clips move " + tools::listed(moved) + "; name them as the character's joints before you export, which are " +
           tools::listed(there));
}

void Matching::drop_strangers() {
  std::set<int> still;
  for (RawClip& clip : scene_.clips)
    std::erase_if(clip.channels, [&](const RawChannel& channel) {
      const bool stranger = !is_joint(channel.node);
      if (stranger && scene_.nodes[static_cast<std::size_t>(channel.node)].in_scene) still.insert(channel.node);
      return stranger;
    });
  for (const int node : still)
    notes_.warnings.push_back({"/nodes/" + std::to_string(node), "no-such-joint",
                               name_of(node) + " is no joint of " + character_.file + "; it does not move, left out"});
  std::erase_if(scene_.clips, [&](const RawClip& clip) {
    const bool empty = clip.channels.empty() && clip.scalars.empty();
    if (empty)
      notes_.warnings.push_back(
          {"/animations", "clip-dropped", '"' + clip.name + "\" moves no joint of the character"});
    return empty;
  });
}

void Matching::hold_others(RawClip& clip, int skeleton) {
  std::set<std::pair<int, RawPath>> moved;
  for (const RawChannel& channel : clip.channels) moved.insert({channel.node, channel.path});
  const std::vector<Transform> rest = rest_transforms(character_.skeletons[static_cast<std::size_t>(skeleton)]);
  for (std::size_t j = 0; j < rest.size(); ++j) {
    const auto found = node_of_.find({skeleton, static_cast<int>(j)});
    if (found == node_of_.end()) continue;
    const RawNode& node = scene_.nodes[static_cast<std::size_t>(found->second)];
    const Transform there{node.translation, node.rotation, node.scale};
    for (const RawPath path : {RawPath::translation, RawPath::rotation, RawPath::scale}) {
      if (moved.contains({found->second, path}) || same_rest(rest[j], there, path)) continue;
      clip.channels.push_back({found->second, path, RawInterpolation::linear, {0.0f}, {rest_of(there, path)}});
      others_.insert(found->second);
    }
  }
}

void Matching::hold_others() {
  for (RawClip& clip : scene_.clips) {
    std::set<int> skeletons;
    for (const RawChannel& channel : clip.channels)
      skeletons.insert(out_.nearest[static_cast<std::size_t>(channel.node)].skeleton);
    for (const int skeleton : skeletons) hold_others(clip, skeleton);
  }
  if (!others_.empty())
    notes_.warnings.push_back({"/nodes/" + std::to_string(*others_.begin()), "rest-pose-differs",
                               std::to_string(others_.size()) + " joints that clips leave alone do not stand as in " +
                                   character_.file + "; the clips hold them where this file has them"});
}

}  // namespace

Character view_character(const std::string& path, const File& file) {
  Character out;
  out.file = path;
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) {
    const Skeleton s = file.skeleton(i);
    BuiltSkeleton& built = out.skeletons.emplace_back();
    built.name = s.name;
    for (std::uint32_t j = 0; j < s.joint_count; ++j) built.joint_names.emplace_back(file.text(s.names[j]));
    built.parents.assign(s.parents, s.parents + s.joint_count);
    built.scene_from_root.assign(s.scene_from_root, s.scene_from_root + s.root_count);
    built.rest.assign(s.rest, s.rest + s.soa_size());
  }
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i)
    for (std::uint32_t level = 0; level <= file.mesh(i).lods.size; ++level) out.meshes.push_back(file.mesh(i, level));
  return out;
}

void expect_skeletons(const Character& character) {
  if (character.skeletons.empty())
    throw tools::Failure(tools::Exit::invalid, character.file, "", "no skeleton",
                         "name the character's file, not a clip pack");
}

std::map<std::string, NearestJoint> joints_by_name(const Character& character) {
  std::map<std::string, NearestJoint> out;
  for (std::size_t s = 0; s < character.skeletons.size(); ++s)
    for (std::size_t j = 0; j < character.skeletons[s].joint_names.size(); ++j)
      out.try_emplace(character.skeletons[s].joint_names[j],
                      NearestJoint{static_cast<int>(s), static_cast<int>(j), glm::dmat4(1.0)});
  return out;
}

Matched match_skeletons(const Character& character, RawScene scene, Notes& notes) {
  expect_skeletons(character);
  Matching matching(character, std::move(scene), notes);
  matching.match_names();
  matching.check_moved();
  matching.drop_strangers();
  matching.hold_others();
  return matching.take();
}

}  // namespace marrow::cook
