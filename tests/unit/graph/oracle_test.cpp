// Animators against an oracle that shares nothing with them, on random graphs.
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>

#include "unit/graph/graph_rig.h"
#include "unit/graph/oracle.h"
#include "unit/graph/oracle_random.h"

namespace marrow::test {
namespace {

using oracle::Chance;

std::size_t from_environment(const char* name, std::size_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? static_cast<std::size_t>(std::atoll(text)) : otherwise;
}

// Rotations of the bones of a pose.
oracle::Pose rotations(const GraphRig& rig, Span<const SoaTransform> local) {
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

  // "" or what is not the same.
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
      if (state_of(rig.animator, find_graph_node(rig.file, rig.graph, name.c_str()), &has) == kNoIndex) continue;
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

  Chance chance_;
  oracle::Pose rest_, reference_;
  std::vector<std::string> machines_;
  GraphPlace place_;
  oracle::Rigid twin_place_;
};

// What graphs have in common.
struct Sum {
  std::size_t graphs = 0, wrong = 0, updates = 0, poses = 0, events = 0, switches = 0;
  double root = 0, turn = 0, place = 0, pose = 0, seconds = 0;

  void add(const Pair& pair) {
    updates += pair.updates;
    poses += pair.poses;
    events += pair.events;
    switches += static_cast<std::size_t>(pair.twin.switches);
    root = std::max(root, pair.worst_root);
    turn = std::max(turn, pair.worst_turn);
    place = std::max(place, pair.worst_place);
    pose = std::max(pose, pair.worst_pose);
    seconds = std::max(seconds, pair.worst_seconds);
  }
  void print() const {
    std::printf("%zu graphs, %zu of them not the same; %zu updates, %zu poses, %zu events, %zu switches\n", graphs,
                wrong, updates, poses, events, switches);
    std::printf("worst: root %.3g m and %.3g rad a step, %.3g m in all; pose %.3g rad; a state's seconds %.3g\n", root,
                turn, place, pose, seconds);
  }
};

// A minute of each graph. MARROW_ORACLE_GRAPHS: how many, from number MARROW_ORACLE_FIRST on.
void agree(bool calm) {
  Sum sum;
  sum.graphs = from_environment("MARROW_ORACLE_GRAPHS", 30);
  const std::size_t first = from_environment("MARROW_ORACLE_FIRST", 1);
  for (std::size_t g = first; g < first + sum.graphs; ++g) {
    const std::string text = oracle::random_graph(g, 1 + static_cast<int>(g % 4), calm);
    Pair pair(text, static_cast<std::uint32_t>(g));
    const std::string wrong = pair.play(60, calm);
    EXPECT_EQ(wrong, "") << "graph " << g << (sum.graphs == 1 ? ":\n" + text : "");
    sum.wrong += wrong.empty() ? 0 : 1;
    sum.add(pair);
  }
  sum.print();
  EXPECT_GT(sum.events, 20 * sum.graphs);
  EXPECT_GT(sum.poses, 20 * sum.graphs);
}

TEST(Oracle, AgreesOnCalmGraphs) {
  agree(true);
}
TEST(Oracle, AgreesOnRandomGraphs) {
  agree(false);
}

// Numbers that no game should set, and steps of any length.
float any_number(Chance& chance) {
  static const float kOdd[] = {0,
                               -0.0f,
                               1e30f,
                               -1e30f,
                               1e-30f,
                               std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity(),
                               -std::numeric_limits<float>::infinity()};
  return chance.is(0.3) ? kOdd[chance.below(8)] : static_cast<float>(chance.number(-5, 5));
}
float any_step(Chance& chance) {
  static const float kOdd[] = {
      0, 1e6f, 1e-30f, 86400, -1, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  return chance.is(0.2) ? kOdd[chance.below(7)] : static_cast<float>(chance.number(0, 0.2));
}
bool is_finite(const RigidStep& step) {
  for (const float x : step.rotation)
    if (!std::isfinite(x)) return false;
  for (const float x : step.translation)
    if (!std::isfinite(x)) return false;
  return true;
}
bool is_finite(Span<const SoaTransform> pose) {
  for (const SoaTransform& group : pose) {
    float all[sizeof(SoaTransform) / sizeof(float)];
    std::memcpy(all, &group, sizeof(group));
    for (const float x : all)
      if (!std::isfinite(x)) return false;
  }
  return true;
}
void set_anything(GraphRig& rig, Chance& chance) {
  for (std::uint32_t p = 0; p < rig.graph.parameters.size; ++p) {
    if (!chance.is(0.2)) continue;
    const float value = any_number(chance);
    switch (rig.graph.parameters[p].kind) {
      case ParameterKind::number:
        ASSERT_EQ(marrow::set_number(rig.animator, p, value), std::isnan(value) ? Status::bad_argument : Status::ok);
        break;
      case ParameterKind::flag:
        ASSERT_EQ(marrow::set_flag(rig.animator, p, value > 0), Status::ok);
        break;
      case ParameterKind::trigger:
        ASSERT_EQ(marrow::fire(rig.animator, p), Status::ok);
        break;
    }
  }
}

// MARROW_ORACLE_ODD: how many graphs.
TEST(Oracle, OddInputsGiveNumbers) {
  const std::size_t graphs = from_environment("MARROW_ORACLE_ODD", 100);
  std::size_t updates = 0, refused = 0;
  for (std::size_t g = 1; g <= graphs; ++g) {
    Chance chance(g);
    GraphRig rig(oracle::random_graph(1000 + g, 1 + static_cast<int>(g % 5)));
    rig.step(0);
    for (int frame = 0; frame < 40; ++frame, ++updates) {
      set_anything(rig, chance);
      const float dt_s = any_step(chance);
      const bool is_good = std::isfinite(dt_s) && dt_s >= 0;
      AnimatorStep step;
      const Status status = update_animator(rig.animator, dt_s, step);
      refused += status == Status::ok ? 0 : 1;
      ASSERT_EQ(status, is_good ? Status::ok : Status::bad_argument) << "graph " << g << ", step " << dt_s;
      ASSERT_TRUE(is_finite(step.root)) << "graph " << g << ", step " << dt_s;
      ASSERT_EQ(sample_character(rig.character, rig.animator), Status::ok) << "graph " << g << ", step " << dt_s;
      ASSERT_TRUE(is_finite(rig.character.skeletons[0].pose.local)) << "graph " << g << ", step " << dt_s;
    }
  }
  std::printf("%zu graphs, %zu updates, %zu of them refused\n", graphs, updates, refused);
  EXPECT_GT(refused, 0u);
}

}  // namespace
}  // namespace marrow::test
