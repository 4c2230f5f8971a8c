// A small character with clips of known motion, and graphs bound to it.
#pragma once

#include <cmath>
#include <cstring>
#include <deque>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "cook/graph/build_graph.h"
#include "cook/write/write_scene.h"
#include "disk/cook_on_disk.h"
#include "marrow/owned.h"
#include "unit/cook/retarget/raw_rig.h"

namespace marrow::test {

inline const std::vector<cook::RawRigBone> kGraphBones = {
    {"hips", -1, {0, 1, 0}},  {"spine", 0, {0, 1.2, 0}},      {"chest", 1, {0, 1.4, 0}},
    {"head", 2, {0, 1.7, 0}}, {"left_arm", 2, {0.3, 1.4, 0}}, {"right_arm", 2, {-0.3, 1.4, 0}}};

// A clip of this file, as the cooker would have measured it.
struct GraphClipMade {
  const char* name;
  float duration_s, way_m, turn_rad;  // of the root: straight ahead (z), about y
  std::vector<double> marks;
  std::vector<std::pair<const char*, double>> events;
};
inline const std::vector<GraphClipMade> kGraphClips = {
    {"idle", 2.0f, 0, 0, {}, {{"breath", 0.5}}},
    {"walk", 1.0f, 1.2f, 0, {0, 0.5}, {{"left", 0}, {"right", 0.5}}},
    {"run", 0.6f, 2.4f, 0, {0.05, 0.35}, {{"left", 0.05}, {"right", 0.35}}},
    {"turn", 1.5f, 1.0f, 1.5f, {0, 0.8}, {{"left", 0}, {"right", 0.8}}},
    {"attack", 0.8f, 0.3f, 0, {}, {{"begin", 0}, {"hit", 0.3}, {"end", 0.8}}},
    {"jump", 1.0f, 0, 0, {}, {{"leave", 0.1}, {"land", 0.9}}},
    {"lean", 1.0f, 0, 0, {}, {}}};

// The scene: rotations of all joints, other ones in each clip, a loop each; keys 30 a second.
inline cook::RawScene graph_scene() {
  cook::RawScene out = cook::raw_rig(kGraphBones, 2);
  for (std::size_t c = 0; c < kGraphClips.size(); ++c) {
    cook::RawClip& clip = out.clips.emplace_back();
    clip.name = kGraphClips[c].name;
    const int keys = static_cast<int>(std::lround(30 * kGraphClips[c].duration_s)) + 1;
    for (int n = 1; n <= static_cast<int>(kGraphBones.size()); ++n) {
      cook::RawChannel turn{n, cook::RawPath::rotation, cook::RawInterpolation::linear, {}, {}};
      for (int k = 0; k < keys; ++k) {
        const double share = static_cast<double>(k) / (keys - 1);
        const double angle =
            0.4 * std::sin(6.283185307179586 * share + static_cast<double>(c)) + 0.1 * static_cast<double>(c);
        const glm::dquat q = out.nodes[static_cast<std::size_t>(n)].rotation *
                             glm::angleAxis(angle, glm::normalize(glm::dvec3(n, 1 + static_cast<double>(c), 2)));
        turn.times_s.push_back(static_cast<float>(share) * kGraphClips[c].duration_s);
        turn.values.emplace_back(q.x, q.y, q.z, q.w);
      }
      clip.channels.push_back(turn);
    }
  }
  return out;
}

inline cook::CookOptions graph_options(const std::vector<GraphClipMade>& clips) {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.clips.raw = true;
  for (const GraphClipMade& made : clips) {
    for (const auto& [name, time_s] : made.events) {
      cook::EventRule rule;
      rule.clips = made.name;
      rule.event.name = name;
      rule.event.from = rule.event.until = {time_s, false};
      options.motion.events.push_back(rule);
    }
    if (made.marks.empty()) continue;
    cook::PhaseRule rule;
    rule.clips = made.name;
    for (const double mark : made.marks) rule.marks.push_back({mark, false});
    options.motion.phases.push_back(rule);
  }
  return options;
}

// What a file is made of.
struct GraphRigMade {
  std::vector<GraphClipMade> clips;
  cook::RawScene scene;
  cook::CookOptions options;
};
inline GraphRigMade small_rig() {
  GraphRigMade out{kGraphClips, graph_scene(), graph_options(kGraphClips)};
  out.options.clips.additive = {{"lean", "first", {}}};
  return out;
}

// The file, with its clips' roots and speeds in place of what feet would say.
class GraphFile {
 public:
  explicit GraphFile(std::vector<std::pair<std::string, std::string>> graphs = {},
                     const GraphRigMade& made = small_rig()) {
    cook::Notes notes;
    cook::BuiltScene built = cook::build_scene(made.scene, made.options, notes);
    for (const auto& [name, text] : graphs)
      built.graphs.push_back(cook::build_graph(cook::parse_graph(name, text), notes));
    warnings = notes.warnings;
    const std::vector<std::byte> bytes = cook::write_scene(built, "rig").bytes;
    EXPECT_EQ(make_owned(Span<const std::byte>(bytes.data(), bytes.size()), file), Status::ok) << file.error.rule;
    all.assign(file.animations.all.begin(), file.animations.all.end());
    for (Animation& a : all)
      for (const GraphClipMade& clip : made.clips)
        if (a.name == std::string(clip.name)) set_root(clip, a.motion);
    animations = {all};
  }

  OwnedFile file;
  std::vector<Animation> all;
  Animations animations;
  std::vector<cook::RawWarning> warnings;

 private:
  void set_root(const GraphClipMade& made, ClipMotion& motion) {
    motion.speed_m_s = made.way_m / made.duration_s;
    if (made.way_m == 0 && made.turn_rad == 0) return;
    std::vector<RootKey>& keys = roots_.emplace_back();
    // An arc, or straight on.
    const int count = made.turn_rad == 0 ? 1 : 96;
    for (int i = 0; i <= count; ++i) {
      const float share = static_cast<float>(i) / static_cast<float>(count), angle = share * made.turn_rad;
      RootKey key{
          share * made.duration_s, {0, std::sin(angle / 2), 0, std::cos(angle / 2)}, {0, 0, share * made.way_m}};
      if (made.turn_rad != 0) {
        const float radius_m = made.way_m / made.turn_rad;
        key.translation[0] = radius_m * (1 - std::cos(angle));
        key.translation[2] = radius_m * std::sin(angle);
      }
      keys.push_back(key);
    }
    motion.root = {keys.data(), keys.size()};
  }
  std::deque<std::vector<RootKey>> roots_;
};

// A graph of the rig, and an animator of it.
class GraphRig : public GraphFile {
 public:
  explicit GraphRig(const std::string& text, AnimatorOptions with = {}, const GraphRigMade& made = small_rig())
      : GraphFile({{"test.anim.toml", text}}, made), options(with) {
    EXPECT_EQ(file.graph(0, graph), Status::ok);
    memory = OwnedBlock(graph_binding_bytes(graph, file));
    GraphMisfit misfit;
    EXPECT_EQ(bind_graph(file, graph, file, {&animations, 1}, memory.span(), binding, &misfit), Status::ok)
        << misfit.rule << " " << misfit.name;
    EXPECT_EQ(make_owned(file, {.layers = kMaxGraphPoses, .skin = false}, character), Status::ok);
    make(animator, animator_memory);
  }
  void make(Animator& out, OwnedBlock& block) {
    block = OwnedBlock(animator_bytes(binding, options));
    EXPECT_EQ(make_animator(binding, options, block.span(), out), Status::ok);
  }
  std::uint32_t parameter(const char* name) const { return find_parameter(binding, name); }
  void set_number(const char* name, double value) {
    EXPECT_EQ(marrow::set_number(animator, parameter(name), static_cast<float>(value)), Status::ok) << name;
  }
  void set_flag(const char* name, bool value) {
    EXPECT_EQ(marrow::set_flag(animator, parameter(name), value), Status::ok) << name;
  }
  void fire(const char* name) { EXPECT_EQ(marrow::fire(animator, parameter(name)), Status::ok) << name; }
  AnimatorStep step(double dt_s) {
    AnimatorStep out;
    EXPECT_EQ(update_animator(animator, static_cast<float>(dt_s), out), Status::ok);
    return out;
  }
  std::string state(const char* node) const {
    const std::uint32_t n = find_graph_node(binding, node), s = state_of(animator, n);
    if (s == kNoIndex) return "";
    return file.text(graph.states[graph.machines[graph.nodes[n].record].first_state + s].name);
  }

  AnimatorOptions options;
  Graph graph;
  GraphBinding binding;
  OwnedBlock memory, animator_memory;
  Animator animator;
  OwnedCharacter character;
};

// Where a character is, in doubles.
struct GraphPlace {
  glm::dquat turn{1, 0, 0, 0};
  glm::dvec3 at{0};
  void move(const RigidStep& step) {
    at += turn * glm::dvec3(step.translation[0], step.translation[1], step.translation[2]);
    turn = glm::normalize(turn * glm::dquat(step.rotation[3], step.rotation[0], step.rotation[1], step.rotation[2]));
  }
};

}  // namespace marrow::test
