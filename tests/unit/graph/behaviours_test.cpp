// The graphs of docs/cooking/behaviours.md that move a body: what they are asked, and what comes of it by hand.
#include <algorithm>

#include "examples/behaviours/game.h"
#include "unit/graph/behaviour_rig.h"

namespace marrow::test {
namespace {

TEST(Behaviours, IdleVariants) {
  Behaviour b("idle", "body",
              with_walking({{{"idle_look", 3.0f, 0, 0, {}, {}}, {{"head", 30, 30}}},
                            {{"idle_stretch", 4.0f, 0, 0, {}, {}}, {{"spine", -20, -20}}},
                            {{"idle_scratch", 2.5f, 0, 0, {}, {}}, {{"right_lower_arm", 90, 90}}}}));
  // Marsaglia's xorshift32 from 1: 270369, 67634689, 2647435461, which are 0, 1 and 0 by 3. A variant ends 0.4 s
  // before its clip.
  b.play(6.2);
  EXPECT_NEAR(b.bend("head"), 15, 0.01);  // in the middle of its fade
  b.play(7);
  EXPECT_NEAR(b.bend("head"), 30, 0.01);
  b.play(16);
  EXPECT_NEAR(b.bend("spine"), -20, 0.01);
  b.play(25);
  expect_changes(b, {{0, "calm"}, {6, "looks"}, {8.6, "calm"}, {14.6, "stretches"}, {18.2, "calm"}, {24.2, "looks"}});
  // A step ends it at once.
  b.set_number("speed", 1);
  b.play(26);
  b.set_number("speed", 0);
  b.play(27);
  ASSERT_EQ(b.changes.size(), 8u);
  EXPECT_EQ(b.changes[6].state, "moves");
  EXPECT_NEAR(b.changes[6].time_s, 25, 1e-4);
  EXPECT_EQ(b.changes[7].state, "calm");
  // 1 s of the walk with the fade in, whose mean is half of 0.2 s, and out, half of 0.3 s.
  EXPECT_NEAR(b.place.at.z, 1.2 * (1 - 0.1 + 0.15), 1e-4);
}

const float kQuarter = 1.5707963f, kHalf = 3.1415927f;
std::vector<BehaviourClip> turns() {
  return with_walking({{{"turn_left_90", 0.9f, 0, kQuarter, {}, {}}, {{"spine", 20, 20}}},
                       {{"turn_right_90", 0.9f, 0, -kQuarter, {}, {}}, {{"spine", -20, -20}}},
                       {{"turn_left_180", 1.4f, 0, kHalf, {}, {}}, {{"spine", 40, 40}}}});
}

// Where it looks at the end, and through which state.
void expect_turn(double x, double z, const char* state, double lasts_s, double heading_deg) {
  Behaviour b("turn", "body", turns());
  b.each = [&](const AnimatorStep&) {
    b.set_number("turn", game::degrees_to(b.world_from_model, static_cast<float>(x), static_cast<float>(z)));
  };
  b.play(0.1);
  b.play(0.6);
  const double bend = std::string(state) == "about" ? 40 : std::string(state) == "left" ? 20 : -20;
  EXPECT_NEAR(b.bend("spine"), bend, 0.01);  // 0.15 s of fade are over
  b.play(4);
  const double asked_s = 1.0 / 60;  // the first frame told how far it is
  expect_changes(b, {{0, "stands"}, {asked_s, state}, {asked_s + lasts_s, "stands"}});
  EXPECT_NEAR(std::remainder(b.heading_deg() - heading_deg, 360), 0, 0.01);
  EXPECT_NEAR(glm::length(b.place.at), 0, 1e-5);
  EXPECT_NEAR(b.bend("spine"), 0, 0.01);
}

// A fade that is inertial shows the clip as a whole, so its turn is whole as well.
TEST(Behaviours, TurnsInPlace) {
  expect_turn(10, -1.763, "left", 0.9, 90);     // 100 degrees to the left
  expect_turn(-10, 0, "right", 0.9, -90);       // 90 to the right
  expect_turn(1.763, -10, "about", 1.4, 180);   // 170 to the left
  expect_turn(-1.763, -10, "about", 1.4, 180);  // 170 to the right
  Behaviour b("turn", "body", turns());         // not for 50 degrees
  b.set_number("turn", 50);
  b.play(3);
  EXPECT_EQ(b.heading_deg(), 0);
}

std::vector<BehaviourClip> jumps() {
  return with_walking({{{"jump_start", 0.5f, 0, 0, {}, {{"leave", 0.1}}}, {{"spine", -10, -10}}},
                       {{"jump_loop", 0.8f, 0, 0, {}, {}}, {{"spine", -20, -20}}},
                       {{"land_soft", 0.6f, 0, 0, {}, {{"land", 0}}}, {{"spine", 20, 20}}},
                       {{"land_hard", 1.2f, 0, 0, {}, {{"crash", 0}}}, {{"spine", 60, 60}}}});
}

TEST(Behaviours, JumpsAndLandsByHeight) {
  for (const double height_m : {1.0, 5.0}) {
    Behaviour b("jump", "body", jumps());
    float highest_m = 0;
    // Up by 1 m in 0.4 s, down to -(height - 1) by 1.4 s.
    const auto flight = [&](double t, bool grounded) {
      const double height = t < 0.4 ? t / 0.4 : 1 - height_m * (t - 0.4);
      b.set_number("fallen", game::metres_fallen(highest_m, static_cast<float>(height), false));
      b.set_flag("grounded", grounded);
    };
    b.play(1);
    b.fire("jump");
    b.play(1 + 1.0 / 60);
    for (double t = 1.0 / 60; t < 1.4 - 1e-6; t += 1.0 / 60) {
      flight(t, false);
      b.play(1 + t + 1.0 / 60);
    }
    const double landed_s = b.time_s;
    flight(1.4, true);
    b.play(landed_s + 0.05);
    EXPECT_NEAR(b.bend("spine"), height_m < 3 ? 20 : 60, 0.01);  // the fade is over
    b.play(4);
    const double lasts_s = height_m < 3 ? 0.6 - 0.15 : 1.2 - 0.25;
    expect_changes(b, {{0, "ground"},
                       {1, "rise"},
                       {1.4, "fall"},
                       {landed_s, height_m < 3 ? "soft" : "hard"},
                       {landed_s + lasts_s, "ground"}});
    EXPECT_EQ(b.heard_count("leave"), 1);
    EXPECT_EQ(b.heard_count("land"), height_m < 3 ? 1 : 0);
    EXPECT_EQ(b.heard_count("crash"), height_m < 3 ? 0 : 1);
    EXPECT_NEAR(b.bend("spine"), 0, 0.01);
  }
}

// Off an edge the walk goes on for 0.1 s, in which it may still jump; a bump of the ground shows nothing.
TEST(Behaviours, JumpsFromBeyondTheEdge) {
  Behaviour b("jump", "body", jumps());
  b.set_number("speed", 1.2);
  b.play(1);
  b.set_flag("grounded", false);
  b.play(1.05);
  b.set_flag("grounded", true);
  b.play(2);
  EXPECT_NEAR(b.place.at.z, 2.4, 1e-4);  // nothing began anew
  EXPECT_EQ(b.heard_count("left_foot"), 3);
  EXPECT_EQ(b.heard_count("right_foot"), 2);
  b.set_flag("grounded", false);
  b.play(2.05);
  b.fire("jump");
  b.play(2.1);
  b.set_flag("grounded", true);  // it has not left the ground: too early to land
  b.play(2.12);
  b.set_flag("grounded", false);
  b.play(2.2);
  expect_changes(b, {{0, "ground"}, {1, "edge"}, {1.05, "ground"}, {2, "edge"}, {2.05, "rise"}});
  // Without a jump it falls.
  Behaviour c("jump", "body", jumps());
  c.play(1);
  c.set_flag("grounded", false);
  c.play(2);
  expect_changes(c, {{0, "ground"}, {1, "edge"}, {1.1, "fall"}});
}

// A jump that is pressed 0.1 s before it lands waits; one that is pressed 0.2 s before does not.
TEST(Behaviours, JumpsAgainWhenItLands) {
  for (const double early_s : {0.1, 0.2}) {
    Behaviour b("jump", "body", jumps());
    b.set_flag("grounded", false);
    b.play(1 - early_s);
    b.fire("jump");
    b.play(1);
    b.set_flag("grounded", true);
    b.play(1.05);
    expect_changes(b, {{0, "edge"}, {0.1, "fall"}, {1, early_s < 0.15 ? "rise" : "soft"}});
  }
}

TEST(Behaviours, RunsOutOfASoftLanding) {
  Behaviour b("jump", "body", jumps());
  b.set_flag("grounded", false);
  b.play(1);
  b.set_number("fallen", 1);
  b.set_flag("grounded", true);
  b.set_number("speed", 4);
  b.play(2);
  expect_changes(b, {{0, "edge"}, {0.1, "fall"}, {1, "soft"}, {1.1, "ground"}});
}

std::vector<BehaviourClip> starts() {
  return with_walking({{{"walk_start", 1.0f, 0.6f, 0, {0, 0.5}, {{"left_foot", 0.5}}}, {{"spine", 10, 10}}},
                       {{"walk_stop_left", 0.8f, 0.3f, 0, {}, {}}, {{"spine", 20, 20}}},
                       {{"walk_stop_right", 0.8f, 0.3f, 0, {}, {}}, {{"spine", 30, 30}}}});
}

// It walks at 1.2 m/s from 0.9 s on, in the phase that the first step has then: 0.9. So feet come down at 1.0 (left),
// 1.5 (right), 2.0 …, and the one before the stop says which clip stops.
TEST(Behaviours, StartsAndStopsOnAFoot) {
  for (const bool left : {true, false}) {
    Behaviour b("start_stop", "body", starts());
    const std::uint32_t flag = b.parameter("left");
    b.each = [&](const AnimatorStep& step) { game::hear_feet(step, b.animator, flag); };
    b.play(1);
    b.set_number("speed", 1.2);
    b.play(1.5);
    EXPECT_NEAR(b.bend("spine"), 10, 0.01);
    const double stop_s = left ? 4.45 : 4.95;
    b.play(stop_s);
    b.set_number("speed", 0);
    b.play(stop_s + 0.3);
    EXPECT_NEAR(b.bend("spine"), left ? 20 : 30, 0.01);
    b.play(7);
    const char* const stop = left ? "stop_left" : "stop_right";
    expect_changes(b, {{0, "stands"}, {1, "starts"}, {1.9, "moves"}, {stop_s, stop}, {stop_s + 0.65, "stands"}});
    // 0.6 m/s for 0.9 s and half of the fade; the walk for the rest; 0.375 m/s for 0.65 s and half of 0.15 s.
    const double way = 0.6 * 0.95 + 1.2 * (stop_s - 1.9 - 0.05) + 0.375 * (0.65 + 0.075);
    EXPECT_NEAR(b.place.at.z, way, 2e-3);
    EXPECT_EQ(b.heard_count("right_foot"), left ? 2 : 3);
  }
}

// Idle is as long as its contact, which is met as it begins; the walk's contacts end.
TEST(Behaviours, StepsAreFeetThatComeDown) {
  GraphRigMade made = behaviour_rig(starts(), {});
  for (const auto& [clip, text] : {std::pair("idle", "left_foot@0..2"), std::pair("walk", "left_foot@0.2..0.7")}) {
    cook::EventRule rule;
    rule.clips = clip;
    ASSERT_TRUE(tools::read_event(text, rule.event));
    made.options.motion.events.push_back(rule);
  }
  Behaviour b("start_stop", "body", made);
  int steps = 0;
  b.each = [&](const AnimatorStep& step) {
    steps += static_cast<int>(std::ranges::count_if(step.events, game::is_step));
  };
  b.play(5);
  EXPECT_EQ(b.heard_count("left_foot"), 1);
  EXPECT_EQ(steps, 0);
  b.set_number("speed", 1.2);
  b.play(5.95);
  steps = 0;
  b.play(6.95);  // a round of the walk
  EXPECT_EQ(steps, 3);
}

TEST(Behaviours, SprintsOutOfItsFirstStep) {
  Behaviour b("start_stop", "body", starts());
  b.set_number("speed", 4);
  b.play(1);
  expect_changes(b, {{0, "starts"}, {0.3, "moves"}});
}

TEST(Behaviours, Swims) {
  Behaviour b("swim", "body",
              with_walking({{{"swim_idle", 2.0f, 0, 0, {}, {}}, {{"spine", 10, 10}}},
                            {{"swim", 1.0f, 0.8f, 0, {}, {{"stroke", 0.25}}}, {{"spine", 50, 50}}},
                            {{"dive_idle", 2.0f, 0, 0, {}, {}}, {{"spine", 20, 20}}},
                            {{"dive", 1.0f, 1.5f, 0, {}, {}}, {{"spine", 60, 60}}},
                            {{"dive_up", 1.0f, 1.5f, 0, {}, {}}, {{"spine", 40, 40}}},
                            {{"dive_down", 1.0f, 1.5f, 0, {}, {}}, {{"spine", 80, 80}}}}));
  b.set_number("speed", 0.4);
  b.play(1);
  b.set_number("depth", 1.2);  // it wades
  b.play(2);
  b.set_number("depth", 1.35);
  b.play(3);
  b.set_number("depth", 1.2);  // a wave
  b.play(4);
  EXPECT_NEAR(b.place.at.z, 1.6, 1e-3);  // 0.4 m/s on foot and in water
  // A cycle of (1 - w) 2 s + w 1 s goes w 0.8 m: 0.4 m/s with w = 2/3. So it takes 4/3 s, and a stroke comes after 1/4.
  EXPECT_NEAR(b.bend("spine"), mixed_deg(10, 50, 2.0 / 3), 0.02);
  EXPECT_EQ(b.heard_count("stroke"), 2);
  b.set_flag("dives", true);
  b.set_number("speed", 2);
  b.set_number("slope", -30);
  b.play(8);
  EXPECT_NEAR(b.bend("spine"), mixed_deg(60, 80, 0.5), 0.02);
  b.set_number("speed", 0);
  b.play(12);
  EXPECT_NEAR(b.bend("spine"), 20, 0.02);
  b.set_flag("dives", false);
  b.play(13);
  b.set_number("depth", 1);
  b.play(14);
  expect_changes(b, {{0, "ground"}, {2, "floats"}, {4, "dives"}, {12, "floats"}, {13, "ground"}});
}

}  // namespace
}  // namespace marrow::test
