// An animator and the oracle of one graph, played side by side.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "unit/graph/graph_rig.h"
#include "unit/graph/oracle.h"
#include "unit/graph/oracle_random.h"

namespace marrow::test {

// Rotations of the bones of a pose.
inline oracle::Pose rotations(const GraphRig& rig, Span<const SoaTransform> local) {
  oracle::Pose out;
  for (const cook::RawRigBone& bone : kGraphBones) {
    const std::uint32_t joint = rig.file.find_joint(rig.character.skeletons[0].pose.skeleton, bone.name.c_str());
    JointTransform t;
    EXPECT_EQ(get_joint(local, joint, t), Status::ok);
    const auto d = [&](int i) { return static_cast<double>(t.rotation[i]); };
    out.emplace_back(d(3), d(0), d(1), d(2));
  }
  return out;
}

// What both have done, compared.
class Pair {
 public:
  Pair(const std::string& text, std::uint32_t seed)
      : rig(text, options(seed)), twin(oracle::read(text), seed), chance_(seed) {
    rest_ = rotations(rig, rig.character.skeletons[0].pose.local);
    reference_ = clip(oracle::clips().size() - 1, 0);
    for (const oracle::Node& n : twin.graph().nodes)
      if (n.kind == oracle::Kind::machine && !n.name.empty()) machines_.push_back(n.name);
  }

  // The same of inputs as a text: "dt 0.1", "set speed 2", "fire jump", "flag armed 1", with spaces between.
  std::string run(const std::string& script) {
    std::istringstream in(script);
    std::string what, name;
    double value = 1;
    for (int frame = 0; in >> what;) {
      if (what != "dt") in >> name;
      if (what != "fire") in >> value;
      if (what != "dt") {
        set({twin.graph().parameter(name), value});
        continue;
      }
      const double dt_s = static_cast<double>(static_cast<float>(value));
      const AnimatorStep step = rig.step(dt_s);
      twin.update(dt_s);
      const std::string wrong = compare(step, 7 * frame++);
      if (!wrong.empty()) return wrong + " at update " + std::to_string(frame);
    }
    return "";
  }
  // "" or what is not the same in so many seconds of random inputs.
  std::string play(double seconds, bool calm) {
    static const double kUsual[] = {1.0 / 60, 1.0 / 30, 1.0 / 144, 0.0123};
    const double usual = kUsual[chance_.below(4)];
    double t = 0;
    for (int frame = 0; t < seconds; ++frame) {
      double dt_s = usual * chance_.number(0.99, 1);  // no time comes twice
      const double which = chance_.number();
      if (which < 0.04)
        dt_s = calm ? 0.001 : 0;
      else if (which < 0.1)
        dt_s = chance_.number(0, calm ? 0.02 : 0.05);
      else if (which < 0.13 && !calm)
        dt_s = chance_.number(0.05, 0.3);
      dt_s = static_cast<double>(static_cast<float>(dt_s));
      for (const oracle::Input& input : oracle::random_inputs(twin.graph(), chance_, dt_s)) set(input);
      const AnimatorStep step = rig.step(dt_s);
      twin.update(dt_s);
      t += dt_s;
      ++updates;
      const std::string wrong = compare(step, frame);
      if (!wrong.empty())
        return wrong + " at update " + std::to_string(frame) + ", " + std::to_string(t) + " s, dt " +
               std::to_string(dt_s) + (twin.at_limit ? " (eight switches)" : "");
    }
    return "";
  }

  GraphRig rig;
  oracle::Animator twin;
  std::size_t updates = 0, poses = 0, events = 0;
  double worst_root = 0, worst_turn = 0, worst_place = 0, worst_pose = 0, worst_seconds = 0;

 private:
  static AnimatorOptions options(std::uint32_t seed) {
    AnimatorOptions out;
    out.events = 1024;
    out.seed = seed;
    return out;
  }
  void set(const oracle::Input& input) {
    const oracle::Parameter& p = twin.graph().parameters[input.parameter];
    const char* name = p.name.c_str();
    switch (p.kind) {
      case oracle::ParameterKind::number:
        rig.set_number(name, input.value);
        twin.set_number(name, input.value);
        break;
      case oracle::ParameterKind::flag:
        rig.set_flag(name, input.value != 0);
        twin.set_flag(name, input.value != 0);
        break;
      case oracle::ParameterKind::trigger:
        rig.fire(name);
        twin.fire(name);
        break;
    }
  }
  oracle::Pose clip(std::size_t c, double time_s) {
    const Skeleton& skeleton = rig.character.skeletons[0].pose.skeleton;
    std::vector<SoaTransform> pose(skeleton.soa_size());
    const Clip made = rig.file.clip(rig.file.find_clip(oracle::clips()[c].name.c_str()));
    if (c + 1 < oracle::clips().size()) {
      EXPECT_EQ(sample(skeleton, made, static_cast<float>(time_s), pose), Status::ok);
      return rotations(rig, pose);
    }
    // An additive clip's change, over its first key.
    std::vector<AdditiveTransform> change(skeleton.soa_size());
    EXPECT_EQ(sample_additive(skeleton, made, static_cast<float>(time_s), change), Status::ok);
    for (std::size_t g = 0; g < pose.size(); ++g) pose[g] = change[g].change;
    oracle::Pose out = rotations(rig, pose);
    const cook::RawScene scene = graph_scene();
    for (std::size_t b = 0; b < out.size(); ++b) {
      const glm::dvec4& q = scene.clips[c].channels[b].values[0];
      out[b] = out[b] * glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]));
    }
    return out;
  }

  std::string compare(const AnimatorStep& step, int frame) {
    std::map<std::string, int> heard;
    for (const AnimatorEvent& e : step.events) heard[e.name] += static_cast<int>(e.count);
    if (heard != twin.events) return "events: " + shown(heard) + " instead of " + shown(twin.events);
    for (const auto& [name, count] : heard) events += static_cast<std::size_t>(count);
    for (const std::string& name : machines_) {
      double seconds = 0;
      const std::string state = twin.state(name, &seconds);
      if (rig.state(name.c_str()) != state) return name + " is in " + rig.state(name.c_str()) + " instead of " + state;
      float has = 0;
      if (state_of(rig.animator, find_graph_node(rig.binding, name.c_str()), &has) == kNoIndex) continue;
      worst_seconds = std::max(worst_seconds, std::abs(static_cast<double>(has) - seconds));
      if (std::abs(static_cast<double>(has) - seconds) > 1e-6 * std::max(1.0, seconds))
        return name + " lasts " + std::to_string(has) + " instead of " + std::to_string(seconds);
    }
    const std::string wrong = compare_root(step);
    return wrong.empty() ? compare_pose(frame) : wrong;
  }
  static std::string shown(const std::map<std::string, int>& events) {
    std::string out = "{";
    for (const auto& [name, count] : events) out += " " + name + " " + std::to_string(count);
    return out + " }";
  }
  static double angle(const glm::dquat& a, const glm::dquat& b) {
    const glm::dquat d = glm::conjugate(a) * b;
    return 2 * std::atan2(glm::length(glm::dvec3(d.x, d.y, d.z)), std::abs(d.w));
  }
  std::string compare_root(const AnimatorStep& step) {
    GraphPlace moved;
    moved.move(step.root);
    place_.move(step.root);
    twin_place_ = twin_place_ * twin.root;
    const double way = glm::length(moved.at - twin.root.way), turn = angle(moved.turn, twin.root.turn);
    worst_root = std::max(worst_root, way);
    worst_turn = std::max(worst_turn, turn);
    worst_place = std::max(worst_place, glm::length(place_.at - twin_place_.way));
    if (way > 1e-5 || turn > 1e-5 || worst_place > 1e-3) {
      char out[200];
      std::snprintf(out, sizeof(out), "root: off by %.3g m %.3g rad, in all %.3g m; %.6f %.6f instead of %.6f %.6f",
                    way, turn, worst_place, moved.at.x, moved.at.z, twin.root.way.x, twin.root.way.z);
      return out;
    }
    return "";
  }
  std::string compare_pose(int frame) {
    if (sample_character(rig.character, rig.animator) != Status::ok) return "no pose";
    if (frame % 7 != 0 || twin.inertial()) return "";
    ++poses;
    const oracle::Pose is = rotations(rig, rig.character.skeletons[0].pose.local);
    const oracle::Pose ought = twin.pose([&](std::size_t c, double t) { return clip(c, t); }, rest_, reference_);
    for (std::size_t b = 0; b < is.size(); ++b) {
      const double off = angle(is[b], ought[b]);
      worst_pose = std::max(worst_pose, off);
      if (off > 1e-5) return "pose: " + kGraphBones[b].name + " off by " + std::to_string(off);
    }
    return "";
  }

  oracle::Chance chance_;
  oracle::Pose rest_, reference_;
  std::vector<std::string> machines_;
  GraphPlace place_;
  oracle::Rigid twin_place_;
};

}  // namespace marrow::test
