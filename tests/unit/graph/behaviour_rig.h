// A body whose clips bend joints by known angles about their own x, and the graphs of tests/examples/behaviours on it.
#pragma once

#include <fstream>
#include <functional>
#include <iterator>

#include "support/places.h"
#include "unit/graph/graph_rig.h"

namespace marrow::test {

// Without feet, so that the cooker finds no contacts beside those that clips are given.
inline const std::vector<cook::RawRigBone> kBehaviourBones = {
    {"hips", -1, {0, 1, 0}},
    {"spine", 0, {0, 1.1, 0}},
    {"chest", 1, {0, 1.3, 0}},
    {"neck", 2, {0, 1.5, 0}},
    {"head", 3, {0, 1.6, 0}},
    {"left_upper_arm", 2, {0.2, 1.4, 0}},
    {"left_lower_arm", 5, {0.45, 1.4, 0}},
    {"left_hand", 6, {0.7, 1.4, 0}},
    {"right_upper_arm", 2, {-0.2, 1.4, 0}},
    {"right_lower_arm", 8, {-0.45, 1.4, 0}},
    {"right_hand", 9, {-0.7, 1.4, 0}},
    {"left_upper_leg", 0, {0.1, 0.95, 0}},
    {"left_lower_leg", 11, {0.1, 0.5, 0.02}},
    {"right_upper_leg", 0, {-0.1, 0.95, 0}},
    {"right_lower_leg", 13, {-0.1, 0.5, 0.02}},
};

// A joint's angle over a clip, evenly.
struct Bend {
  const char* joint;
  double from_deg, to_deg;
};
struct BehaviourClip {
  GraphClipMade made;
  std::vector<Bend> bends;
};

inline cook::RawClip bending_clip(const cook::RawScene& scene, const BehaviourClip& clip) {
  cook::RawClip out;
  out.name = clip.made.name;
  std::vector<Bend> bends = clip.bends;
  bends.push_back({"hips", 0, 0});  // it has a duration whatever else
  const int keys = static_cast<int>(std::lround(60 * clip.made.duration_s)) + 1;
  for (const Bend& bend : bends) {
    std::size_t node = 1;
    while (node < scene.nodes.size() && scene.nodes[node].name != bend.joint) ++node;
    EXPECT_LT(node, scene.nodes.size()) << bend.joint;
    if (node == scene.nodes.size()) continue;
    cook::RawChannel turn{static_cast<int>(node), cook::RawPath::rotation, cook::RawInterpolation::linear, {}, {}};
    for (int k = 0; k < keys; ++k) {
      const double share = static_cast<double>(k) / (keys - 1);
      const double angle = glm::radians(bend.from_deg + (bend.to_deg - bend.from_deg) * share);
      const glm::dquat q = scene.nodes[node].rotation * glm::angleAxis(angle, glm::dvec3(1, 0, 0));
      turn.times_s.push_back(static_cast<float>(share) * clip.made.duration_s);
      turn.values.emplace_back(q.x, q.y, q.z, q.w);
    }
    out.channels.push_back(turn);
  }
  return out;
}

inline GraphRigMade behaviour_rig(const std::vector<BehaviourClip>& clips,
                                  const std::vector<cook::AdditiveRule>& additive) {
  GraphRigMade out;
  out.scene = cook::raw_rig(kBehaviourBones, 2);
  for (const BehaviourClip& clip : clips) {
    out.clips.push_back(clip.made);
    out.scene.clips.push_back(bending_clip(out.scene, clip));
  }
  out.options = graph_options(out.clips);
  out.options.clips.additive = additive;
  return out;
}

inline std::string behaviour_text(const std::string& name) {
  std::ifstream file(in_source("tests/examples/behaviours/" + name + ".anim.toml"));
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

// Degrees of a rotation that is blended from one by a share, as blend() does: components are mixed, then normalised.
// Both about one axis, so that quaternions are (sin a/2, cos a/2).
inline double mixed_deg(double from_deg, double to_deg, double share) {
  const double a = glm::radians(from_deg) / 2, b = glm::radians(to_deg) / 2;
  return glm::degrees(
      2 * std::atan2((1 - share) * std::sin(a) + share * std::sin(b), (1 - share) * std::cos(a) + share * std::cos(b)));
}
// How much of a state is shown `time_s` into its fade.
inline double fade_share(double time_s, double fade_s) {
  const double u = time_s / fade_s;
  return u >= 1 ? 1 : 3 * u * u - 2 * u * u * u;
}

// One of the graphs, played and watched.
class Behaviour : public GraphRig {
 public:
  struct Change {
    double time_s;
    std::string state;
  };
  struct Heard {
    double time_s;  // of the frame at whose end it was reported
    std::string name;
  };
  // machine: whose states are noted; empty: none's.
  Behaviour(const char* name, const char* machine, const GraphRigMade& made)
      : GraphRig(behaviour_text(name), {}, made), node_(find_graph_node(binding, machine)) {
    if (node_ < graph.nodes.size) first_state_ = graph.machines[graph.nodes[node_].record].first_state;
    for (const cook::RawWarning& w : warnings) EXPECT_NE(w.rule, "unused-node") << w.text;
  }
  Behaviour(const char* name, const char* machine, const std::vector<BehaviourClip>& clips,
            const std::vector<cook::AdditiveRule>& additive = {})
      : Behaviour(name, machine, behaviour_rig(clips, additive)) {}

  // Called after each update, before the pose.
  std::function<void(const AnimatorStep&)> each = [](const AnimatorStep&) {};
  std::vector<Change> changes;
  std::vector<Heard> heard;
  GraphPlace place;
  Affine world_from_model{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  double time_s = 0;
  int frames = 0;
  std::vector<SoaTransform> physics;

  void play(double until_s, double dt_s = 1.0 / 60) {
    while (time_s < until_s - 1e-9) frame(std::min(dt_s, until_s - time_s));
  }
  void frame(double dt_s) {
    const AnimatorStep out = step(dt_s);
    time_s += dt_s;
    ++frames;
    place.move(out.root);
    world_from_model = move_root(world_from_model, out.root);
    for (const AnimatorEvent& e : out.events)
      for (std::uint32_t n = 0; n < e.count; ++n) heard.push_back({time_s, e.name});
    note_state();
    each(out);
    const GivenPose given{{physics.data(), physics.size()}};
    ASSERT_EQ(pose_character(character, animator, {&given, 1}), Status::ok);
    ASSERT_TRUE(is_finite()) << time_s;
  }

  // Degrees by which a joint is bent about its own x, of its rest.
  double bend(const char* joint) const {
    const Skeleton& s = character.skeletons[0].pose.skeleton;
    const std::uint32_t j = file.find_joint(s, joint);
    JointTransform now, rest;
    EXPECT_EQ(get_joint(character.skeletons[0].pose.local, j, now), Status::ok) << joint;
    EXPECT_EQ(get_joint({s.rest, s.soa_size()}, j, rest), Status::ok) << joint;
    const auto quat = [](const float(&q)[4]) {
      return glm::dquat(static_cast<double>(q[3]), static_cast<double>(q[0]), static_cast<double>(q[1]),
                        static_cast<double>(q[2]));
    };
    glm::dquat off = glm::conjugate(quat(rest.rotation)) * quat(now.rotation);
    if (off.w < 0) off = -off;
    EXPECT_NEAR(off.y, 0, 2e-3) << joint;
    EXPECT_NEAR(off.z, 0, 2e-3) << joint;
    return glm::degrees(2 * std::atan2(off.x, off.w));
  }
  int heard_count(const std::string& name) const {
    return static_cast<int>(std::ranges::count(heard, name, &Heard::name));
  }
  // Degrees about y, from z to x.
  double heading_deg() const {
    const glm::dvec3 ahead = place.turn * glm::dvec3(0, 0, 1);
    return glm::degrees(std::atan2(ahead.x, ahead.z));
  }

 private:
  void note_state() {
    if (node_ >= graph.nodes.size) return;
    float seconds = 0;
    const std::uint32_t s = state_of(animator, node_, &seconds);
    if (s == kNoIndex) return;
    const std::string state = file.text(graph.states[first_state_ + s].name);
    const double since = time_s - static_cast<double>(seconds);
    if (changes.empty() || changes.back().state != state || changes.back().time_s < since - 1e-3)
      changes.push_back({since, state});
  }
  bool is_finite() const {
    for (const Affine& m : character.skeletons[0].pose.model_from_joint)
      for (const auto& row : m.rows)
        for (const float x : row)
          if (!std::isfinite(x)) return false;
    return true;
  }
  std::uint32_t node_, first_state_ = 0;
};

// The states that were entered, and when to a tenth of a millisecond.
inline void expect_changes(const Behaviour& b, const std::vector<Behaviour::Change>& wanted) {
  std::string all;
  for (const Behaviour::Change& c : b.changes) all += " " + std::to_string(c.time_s) + " " + c.state;
  ASSERT_EQ(b.changes.size(), wanted.size()) << all;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(b.changes[i].state, wanted[i].state) << all;
    EXPECT_NEAR(b.changes[i].time_s, wanted[i].time_s, 1e-4) << all;
  }
}

inline std::vector<BehaviourClip> with_walking(std::vector<BehaviourClip> clips) {
  clips.push_back({{"idle", 2.0f, 0, 0, {}, {}}, {}});
  clips.push_back(
      {{"walk", 1.0f, 1.2f, 0, {0, 0.5}, {{"left_foot", 0}, {"right_foot", 0.5}}}, {{"left_upper_leg", 10, 10}}});
  clips.push_back(
      {{"run", 0.6f, 2.4f, 0, {0, 0.3}, {{"left_foot", 0}, {"right_foot", 0.3}}}, {{"left_upper_leg", 30, 30}}});
  return clips;
}

}  // namespace marrow::test
