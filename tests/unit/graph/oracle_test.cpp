// Animators against an oracle that shares nothing with them, on random graphs.
#include <algorithm>
#include <cstdlib>
#include <limits>

#include "unit/graph/oracle_pair.h"

namespace marrow::test {
namespace {

using oracle::Chance;

std::size_t from_environment(const char* name, std::size_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? static_cast<std::size_t>(std::atoll(text)) : otherwise;
}

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
// Several switches in a step, triggers that hold nothing, updates of 0 s, nodes that several show.
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
