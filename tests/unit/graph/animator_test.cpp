// Animators against what the page on graphs says, worked out by hand.
#include <algorithm>
#include <map>

#include "marrow/curve.h"
#include "support/allocations.h"
#include "unit/graph/graph_rig.h"

namespace marrow::test {
namespace {

constexpr const char* kMove = R"(
output = "move"
[parameters]
speed = { type = "number", range = [0, 6], half_life = 0.08 }
[node.move]
type = "space"
by = "speed"
points = [ { at = 0, pose = "idle" }, { pose = "walk" }, { pose = "run" } ]
match_speed = true
sync = true
)";

TEST(Animator, GoesAsFarAsItsSpeedSays) {
  for (const int hz : {15, 30, 60, 144}) {
    GraphRig rig(kMove);
    GraphPlace place;
    double value = 0, way = 0;
    for (int frame = 0; frame < 10 * hz; ++frame) {
      // Another speed every second; the half-life's way in closed form, a frame after the other.
      const double target = frame / hz % 2 == 0 ? 3.5 : 0.7, dt = 1.0 / hz;
      rig.set_number("speed", static_cast<float>(target));
      place.move(rig.step(static_cast<float>(dt)).root);
      if (frame == 0) value = target;
      const double left = std::exp2(-dt / 0.08);
      way += target * dt + (value - target) * (1 - left) * 0.08 / std::log(2.0);
      value = target + (value - target) * left;
    }
    EXPECT_NEAR(place.at.z, way, 2e-5) << hz;
  }
}

TEST(Animator, IsWhereItIsAtAnyFrameRate) {
  const std::string text = std::string(R"(
output = "body"
[parameters]
speed = { type = "number", range = [0, 6], half_life = 0.2 }
bend = { type = "number", range = [0, 1], half_life = 0.3 }
go = { type = "flag" }
hit = { type = "trigger", hold = 0.1 }
[node.gaits]
type = "space"
by = "speed"
points = [ { pose = "walk" }, { pose = "run" } ]
match_speed = true
sync = true
[node.ways]
type = "space"
by = "bend"
points = [ { at = 0, pose = "walk" }, { at = 1, pose = "turn" } ]
sync = true
[node.body]
type = "machine"
start = "still"
state.still = { pose = "idle" }
state.straight = { pose = "gaits" }
state.curve = { pose = "ways" }
state.blow = { pose = "attack" }
transition = [
  { from = "still", to = "straight", when = "go", fade = 0.3 },
  { from = "straight", to = "curve", after = 1.7, fade = 0.4, enter = "same_phase" },
  { from = "curve", to = "straight", after = 2.1, fade = 0.25, enter = "same_phase" },
  { from = ["curve", "straight"], to = "blow", when = "hit", fade = 0.15 },
  { from = "blow", to = "straight", at_end = 0.2, fade = 0.2 },
]
)");
  std::map<int, glm::dvec3> ends;
  std::map<int, std::map<std::string, int>> heard;
  for (const int hz : {15, 30, 60, 144, 960}) {
    GraphRig rig(text);
    GraphPlace place;
    for (int frame = 0; frame < 60 * hz; ++frame) {
      const int third = frame * 3 / hz;
      const bool is_new = frame == 0 || third != (frame - 1) * 3 / hz;  // inputs change at thirds of a second
      if (is_new) {
        rig.set_flag("go", true);
        rig.set_number("speed", static_cast<float>(third % 7) * 0.9f);
        rig.set_number("bend", static_cast<float>(third % 5) * 0.25f);
        if (third % 17 == 11) rig.fire("hit");
      }
      const AnimatorStep step = rig.step(1.0 / hz);
      place.move(step.root);
      for (const AnimatorEvent& e : step.events) heard[hz][e.name] += static_cast<int>(e.count);
    }
    ends[hz] = place.at;
  }
  for (const auto& [hz, at] : ends) {
    std::printf("%4d Hz: %.6f %.6f, off by %.3f mm; left %d, right %d, hit %d\n", hz, at.x, at.z,
                1000 * glm::length(at - ends[960]), heard[hz]["left"], heard[hz]["right"], heard[hz]["hit"]);
  }
  for (const auto& [hz, at] : ends) {
    EXPECT_EQ(heard[hz], heard[960]) << hz;
    EXPECT_LT(glm::length(at - ends[60]), hz == 960 ? 2e-4 : 1e-4) << hz;
  }
}

constexpr const char* kMachine = R"(
output = "strike"
[parameters]
jump = { type = "trigger", hold = 0.15 }
blow = { type = "trigger" }
stand = { type = "flag" }
armed = { type = "flag" }
[node.body]
type = "machine"
start = "walks"
state.walks = { pose = "walk" }
state.stands = { pose = "idle" }
state.jumps = { pose = "jump" }
transition = [
  { from = "walks", to = "jumps", when = "jump", fade = 0.2, kind = "inertial" },
  { from = "jumps", to = "walks", at_end = 0.1, fade = 0.1 },
  { from = "walks", to = "stands", when = "stand", fade = 0.3 },
  { from = "stands", to = "walks", when = "not stand", fade = 0.3 },
]
[node.guard]
type = "layer"
base = "body"
pose = "run"
mask = { joint = "chest", falloff = 1 }
weight = "armed"
fade = 0.2
[node.strike]
type = "one_shot"
base = "guard"
pose = "attack"
when = "blow"
mask = { joint = "spine" }
fade_in = 0.2
fade_out = 0.2
)";

TEST(Animator, TriggersWaitAndDie) {
  GraphRig rig(kMachine);
  rig.set_flag("stand", true);
  rig.step(0.1);
  EXPECT_EQ(rig.state("body"), "stands");
  rig.fire("jump");  // from "stands" nothing takes it
  rig.step(0.1);
  EXPECT_EQ(value_of(rig.animator, rig.parameter("stand")), 1.0f);
  EXPECT_EQ(value_of(rig.animator, rig.parameter("jump")), 1.0f);
  rig.set_flag("stand", false);
  rig.step(0.04);  // back to "walks", and 0.1 s later the trigger is still there
  EXPECT_EQ(rig.state("body"), "jumps");
  // The jump lasts 1 s, less 0.1 s; it began at the begin of the last step.
  rig.step(0.85);
  EXPECT_EQ(rig.state("body"), "jumps");
  rig.step(0.02);
  EXPECT_EQ(rig.state("body"), "walks");
  float seconds = 0;
  EXPECT_EQ(state_of(rig.animator, find_graph_node(rig.binding, "body"), &seconds), 0u);
  EXPECT_NEAR(seconds, 0.01, 1e-6);

  rig.set_flag("stand", true);
  rig.step(0.1);
  rig.fire("jump");
  rig.step(0.2);  // longer than it waits
  EXPECT_EQ(value_of(rig.animator, rig.parameter("jump")), 0.0f);
  EXPECT_EQ(value_of(rig.animator, 99), 0.0f);
  rig.set_flag("stand", false);
  rig.step(0.04);
  EXPECT_EQ(rig.state("body"), "walks");
}

TEST(Animator, BlowIsHeardAndEnds) {
  for (const double dt : {1.0 / 240, 1.0 / 60, 0.11, 0.5}) {
    GraphRig rig(kMachine);
    rig.step(0);
    rig.fire("blow");
    std::map<std::string, int> heard;
    double t = 0;
    for (; t < 2.2; t += dt) {
      const AnimatorStep step = rig.step(dt);
      for (const AnimatorEvent& e : step.events) ++heard[e.name];
      EXPECT_EQ(rig.state("strike"), t + dt < 0.6 - 1e-6 ? "on" : "off") << t;
    }
    EXPECT_EQ(heard["hit"], 1) << dt;
    EXPECT_EQ(heard["begin"], 1) << dt;
    EXPECT_EQ(heard["end"], 0) << dt;  // it fades out 0.2 s before
  }
}

// The largest turn of a joint between two poses.
float apart(const CharacterSkeleton& s, const std::vector<SoaTransform>& before) {
  float most = 0;
  for (std::uint32_t j = 0; j < s.pose.skeleton.joint_count; ++j) {
    const std::uint32_t g = j / 4, l = j % 4;
    float dot = 0;
    for (int c = 0; c < 4; ++c) dot += s.pose.local[g].rotation[c][l] * before[g].rotation[c][l];
    most = std::max(most, 2 * std::acos(std::min(1.0f, std::abs(dot))));
  }
  return most;
}

// With dt so small that the clips' own turning is below 0.01 rad a frame.
TEST(Animator, FadesDoNotJump) {
  GraphRig rig(kMachine);
  std::vector<SoaTransform> before;
  float most = 0;
  std::uint32_t chance = 7;
  for (int frame = 0; frame < 20000; ++frame) {
    chance = chance * 1664525u + 1013904223u;
    const std::uint32_t dice = chance >> 16;
    if (dice % 40 == 0) rig.fire("jump");
    if (dice % 90 == 1) rig.fire("blow");
    if (dice % 50 == 2) rig.set_flag("stand", dice % 100 == 2);
    if (dice % 70 == 3) rig.set_flag("armed", dice % 140 == 3);
    rig.step(0.002);
    ASSERT_EQ(pose_character(rig.character, rig.animator), Status::ok);
    const CharacterSkeleton& s = rig.character.skeletons[0];
    if (!before.empty()) most = std::max(most, apart(s, before));
    before.assign(s.pose.local.begin(), s.pose.local.end());
  }
  std::printf("largest turn of a joint in 2 ms: %.4f rad\n", most);
  EXPECT_LT(most, 0.05f);
}

TEST(Animator, SnapshotsAreTakenBack) {
  GraphRig rig(kMachine);
  const auto play = [&](int frames, std::uint32_t seed, bool with_poses) {
    std::uint32_t chance = seed;
    for (int frame = 0; frame < frames; ++frame) {
      chance = chance * 1664525u + 1013904223u;
      if (chance >> 16 & 1) rig.fire(chance >> 17 & 1 ? "jump" : "blow");
      rig.set_flag("stand", (chance >> 18) % 3 == 0);
      rig.set_flag("armed", (chance >> 20) % 3 == 0);
      rig.step(0.016);
      if (with_poses) ASSERT_EQ(pose_character(rig.character, rig.animator), Status::ok);
    }
  };
  const auto bytes = [&] { return std::vector<std::byte>(rig.animator.state.begin(), rig.animator.state.end()); };
  play(200, 3, true);
  const std::vector<std::byte> snapshot = bytes();
  play(1000, 5, true);
  const std::vector<std::byte> later = bytes();
  ASSERT_EQ(restore_animator(rig.animator, {snapshot.data(), snapshot.size()}), Status::ok);
  play(1000, 5, false);
  EXPECT_EQ(bytes(), later);
  std::printf("state: %zu bytes for %zu nodes\n", later.size(), rig.graph.nodes.size);
  // Of another graph, and damaged.
  GraphRig other(kMove);
  EXPECT_EQ(restore_animator(other.animator, {snapshot.data(), snapshot.size()}), Status::bad_data);
  int refused = 0;
  for (std::size_t i = 0; i < snapshot.size(); ++i)
    for (const int bits : {0xFF, 0x7F, 0x80}) {
      std::vector<std::byte> damaged = snapshot;
      damaged[i] ^= static_cast<std::byte>(bits);
      if (restore_animator(rig.animator, {damaged.data(), damaged.size()}) != Status::ok) {
        ++refused;
        continue;
      }
      play(3, 1, true);
    }
  EXPECT_GT(refused, 100);
}

TEST(Animator, FramesDoNotAllocate) {
  GraphRig rig(kMachine);
  const std::size_t before = allocation_count();
  for (int frame = 0; frame < 200; ++frame) {
    if (frame % 37 == 0) rig.fire("blow");
    if (frame % 53 == 0) rig.fire("jump");
    AnimatorStep step;
    if (update_animator(rig.animator, 0.016f, step) != Status::ok) return;
    if (pose_character(rig.character, rig.animator) != Status::ok) return;
  }
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace marrow::test
