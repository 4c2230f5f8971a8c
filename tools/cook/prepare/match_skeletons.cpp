#include "cook/prepare/match_skeletons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "common/distinct.h"
#include "common/failure.h"
#include "cook/gltf/read.h"
#include "cook/prepare/idle_motion.h"
#include "cook/scene/matrices.h"
#include "cook/scene/morphed_meshes.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_skeletons.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

constexpr double kSameScale = 1e-5;
constexpr float kPrinted = 1e-5f;  // of 1 and of the value: exporters print few digits

bool alike(const glm::vec4& a, const glm::vec4& b) {
  for (int c = 0; c < 4; ++c)
    if (!(std::fabs(a[c] - b[c]) <= kPrinted * (1 + std::fabs(a[c])))) return false;
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

// How long each axis of a map's space is.
glm::dvec3 scale_of(const glm::dmat4& map) {
  return {glm::length(glm::dvec3(map[0])), glm::length(glm::dvec3(map[1])), glm::length(glm::dvec3(map[2]))};
}

std::string words_of(const glm::dvec3& scale) {
  const bool even = glm::all(glm::lessThan(glm::abs(scale - scale.x), glm::dvec3(kSameScale * scale.x)));
  return even ? fmt::format("{:.4g}", scale.x) : fmt::format("{:.4g} x {:.4g} x {:.4g}", scale.x, scale.y, scale.z);
}

// Of what stands above each joint at rest.
std::vector<glm::dvec3> scales_above(const BuiltSkeleton& skeleton) {
  const std::vector<Transform> rest = rest_transforms(skeleton);
  std::vector<glm::dmat4> model_from_joint;
  std::vector<glm::dvec3> out;
  for (std::size_t j = 0; j < rest.size(); ++j) {
    const glm::dmat4 above = skeleton.parents[j] == kNoJoint ? to_matrix(skeleton.model_from_root[j])
                                                             : model_from_joint[skeleton.parents[j]];
    out.push_back(scale_of(above));
    model_from_joint.push_back(above * matrix_of(rest[j]));
  }
  return out;
}

class Matching {
 public:
  Matching(const Character& character, RawScene scene, const std::vector<std::string>& keep, Notes& notes)
      : character_(character), notes_(notes), scene_(std::move(scene)), carries_(carrying_nodes(scene_, keep)) {}

  void match_names();
  void check_moved();
  void drop_strangers();
  void bring_to_scale();
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
  std::vector<double> factors() const;
  double factor_at(int node, const glm::dvec3& here, const glm::dvec3& there) const;
  void check_unit() const;
  void hold_others(RawClip& clip, int skeleton);

  const Character& character_;
  Notes& notes_;
  RawScene scene_;
  std::vector<char> carries_;  // a node
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
  for (BuiltSkeleton& skeleton : out_.skeletons) skeleton.node_of_joint.assign(skeleton.joint_names.size(), kNone);
  for (const auto& [at, node] : node_of_)
    out_.skeletons[static_cast<std::size_t>(at.first)].node_of_joint[static_cast<std::size_t>(at.second)] = node;
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
  if (skeleton.parents[joint] == kNoJoint) return;
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
      } else if (!holds_still(channel) && carries_[static_cast<std::size_t>(channel.node)] != 0) {
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
                               name_of(node) + " is no joint of " + character_.file +
                                   "; it does not move, or carries nothing, and is left out"});
  std::erase_if(scene_.clips, [&](const RawClip& clip) {
    const bool empty = clip.channels.empty() && clip.scalars.empty();
    if (empty)
      notes_.warnings.push_back(
          {"/animations", "clip-dropped", '"' + clip.name + "\" moves no joint of the character"});
    return empty;
  });
}

// What a translation here is times, to go as far in the scene below the character's scale.
double Matching::factor_at(int node, const glm::dvec3& here, const glm::dvec3& there) const {
  const glm::dvec3 least = glm::min(here, there);
  if (!(std::min({least.x, least.y, least.z}) > 0)) return 1;  // flat: no ratio says what it should be
  const glm::dvec3 ratio = here / there;
  if (glm::any(glm::greaterThan(glm::abs(ratio - ratio.x), glm::dvec3(kSameScale * ratio.x))))
    fail(node, "another scale above the joints",
         name_of(node) + " stands below a scale of " + words_of(here) + " here and of " + words_of(there) + " in " +
             character_.file + "; apply the scale of the armature before export");
  return std::fabs(ratio.x - 1) <= kSameScale ? 1.0 : ratio.x;
}

// Of each node, decided where its joints begin.
std::vector<double> Matching::factors() const {
  std::vector<std::vector<glm::dvec3>> there;
  for (const BuiltSkeleton& skeleton : character_.skeletons) there.push_back(scales_above(skeleton));
  std::vector<glm::dmat4> model_from_node(scene_.nodes.size());
  std::vector<double> out(scene_.nodes.size(), 1);
  for (const std::size_t n : parents_first(scene_)) {
    const int parent = scene_.nodes[n].parent;
    const glm::dmat4 above = parent == kNone ? glm::dmat4(1.0) : model_from_node[to_index(parent)];
    model_from_node[n] = above * local_matrix(scene_.nodes[n]);
    const NearestJoint& at = out_.nearest[n];
    if (at.joint == kNone || node_of_.at({at.skeleton, at.joint}) != static_cast<int>(n)) continue;
    const bool begins = parent == kNone || out_.nearest[to_index(parent)].skeleton != at.skeleton;
    out[n] = begins ? factor_at(static_cast<int>(n), scale_of(above), there[to_index(at.skeleton)][to_index(at.joint)])
                    : out[to_index(parent)];
  }
  return out;
}

// Where no scale above the joints says so, their distances do.
void Matching::check_unit() const {
  constexpr double kMost = 10;
  std::vector<double> ratios;
  int first = kNone;
  for (const auto& [joint, node] : node_of_) {
    const BuiltSkeleton& skeleton = character_.skeletons[to_index(joint.first)];
    const auto j = static_cast<std::size_t>(joint.second);
    if (skeleton.parents[j] == kNoJoint) continue;
    const auto& t = skeleton.rest[j / 4].translation;
    const double there = glm::length(glm::dvec3(t[0][j % 4], t[1][j % 4], t[2][j % 4]));
    const double here = glm::length(scene_.nodes[to_index(node)].translation);
    if (!(there > 0) || !(here > 0)) continue;
    if (first == kNone) first = node;
    ratios.push_back(here / there);
  }
  if (ratios.empty()) return;
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
  const double median = ratios[ratios.size() / 2];
  if (median > kMost || median < 1 / kMost)
    fail(first, "another unit",
         fmt::format("joints are {:.3g} times as far from their parents as in {}; export both in one unit", median,
                     character_.file));
}

void Matching::bring_to_scale() {
  const std::vector<double> factor = factors();
  for (std::size_t n = 0; n < factor.size(); ++n) scene_.nodes[n].translation *= factor[n];
  for (RawClip& clip : scene_.clips)
    for (RawChannel& channel : clip.channels)
      if (channel.path == RawPath::translation && factor[to_index(channel.node)] != 1)
        for (glm::vec4& value : channel.values) value = glm::vec4(glm::dvec4(value) * factor[to_index(channel.node)]);
  const auto other = std::ranges::find_if(factor, [](double f) { return f != 1; });
  if (other != factor.end())
    notes_.warnings.push_back({"/nodes/" + std::to_string(other - factor.begin()), "unit-differs",
                               fmt::format("joints stand below {:.4g} times the scale of {}; translations are brought "
                                           "to the character's",
                                           *other, character_.file)});
  check_unit();
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
    built.model_from_root.assign(s.model_from_root, s.model_from_root + s.root_count);
    built.rest.assign(s.rest, s.rest + s.soa_size());
    const Roles roles = file.roles(i);
    built.roles = {{roles.roles.begin(), roles.roles.end()},
                   {roles.pairs.begin(), roles.pairs.end()},
                   {roles.soles.begin(), roles.soles.end()}};
  }
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i)
    for (std::uint32_t level = 0; level <= file.mesh(i).lods.size; ++level) out.meshes.push_back(file.mesh(i, level));
  out.morphed = morphed_meshes(file);
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

Matched match_skeletons(const Character& character, RawScene scene, const std::vector<std::string>& keep,
                        Notes& notes) {
  expect_skeletons(character);
  Matching matching(character, std::move(scene), keep, notes);
  matching.match_names();
  matching.check_moved();
  matching.drop_strangers();
  matching.bring_to_scale();
  matching.hold_others();
  return matching.take();
}

}  // namespace marrow::cook
