// The graphs of docs/cooking/behaviours.md about hits, aims, mounts, doors and falls; and that the page has them all.
#include <filesystem>

#include "examples/behaviours/game.h"
#include "unit/graph/behaviour_rig.h"

namespace marrow::test {
namespace {

TEST(Behaviours, IsHitFromAnySide) {
  const std::vector<BehaviourClip> clips =
      with_walking({{{"hit_front", 0.8f, 0.5f, 0, {}, {{"ouch", 0}}}, {{"head", 10, 50}, {"left_upper_leg", 0, 40}}},
                    {{"hit_left", 0.8f, 0, 0, {}, {}}, {{"head", 0, 80}}},
                    {{"hit_right", 0.8f, 0, 0, {}, {}}, {{"head", 0, -80}}},
                    {{"hit_back", 0.8f, 0, 0, {}, {}}, {{"head", 0, -40}}}});
  const std::pair<double, const char*> sides[] = {{0, "front"},  {-45, "front"}, {45, "front"},  {46, "left"},
                                                  {135, "left"}, {-46, "right"}, {-90, "right"}, {136, "back"},
                                                  {180, "back"}, {-136, "back"}, {-180, "back"}};
  for (const auto& [side, state] : sides) {
    Behaviour b("hit", "blow", clips, {{"hit_*", "idle", {}}});
    b.set_number("speed", 1.2);
    b.play(1);
    b.set_number("side", side);
    b.fire("hit");
    b.play(1.4);
    // Half of the clip is over, and so is the fade: the change from idle, on the walk.
    const double change = std::string(state) == "front"   ? 30
                          : std::string(state) == "left"  ? 40
                          : std::string(state) == "right" ? -40
                                                          : -20;
    EXPECT_NEAR(b.bend("head"), change, 0.02) << side;
    EXPECT_NEAR(b.bend("left_upper_leg"), 10, 0.02);  // outside the mask
    b.play(3);
    expect_changes(b, {{0, "none"}, {1, state}, {1.6, "none"}});
    EXPECT_NEAR(b.bend("head"), 0, 0.02);
    EXPECT_NEAR(b.place.at.z, 3.6, 1e-4);  // a change moves nobody
    EXPECT_EQ(b.heard_count("ouch"), std::string(state) == "front" ? 1 : 0);
    EXPECT_EQ(b.heard_count("left_foot"), 4);  // at 0, 1, 2, 3 s
  }
  // A second blow, from the same side, while the first one is shown.
  Behaviour b("hit", "blow", clips, {{"hit_*", "idle", {}}});
  b.play(1);
  for (const double at_s : {1.3, 1.6}) {
    b.fire("hit");
    b.play(at_s);
  }
  EXPECT_NEAR(b.bend("head"), 25, 0.02);
  b.play(3);
  expect_changes(b, {{0, "none"}, {1, "front"}, {1.3, "front"}, {1.9, "none"}});
}

// spine_deg: of the walk below.
void expect_aim(double spine_deg) {
  std::vector<BehaviourClip> clips = with_walking({{{"aim", 0.1f, 0, 0, {}, {}}, {{"right_lower_arm", 60, 60}}}});
  const std::pair<const char*, double> directions[] = {
      {"aim_left", 40},    {"aim_right", -40},    {"aim_up", 20},        {"aim_down", -20},
      {"aim_left_up", 60}, {"aim_right_up", -20}, {"aim_left_down", 20}, {"aim_right_down", -60}};
  for (const auto& [name, deg] : directions)
    clips.push_back({{name, 0.1f, 0, 0, {}, {}}, {{"head", deg, deg}, {"right_lower_arm", 60, 60}}});
  for (BehaviourClip& clip : clips)
    if (clip.made.name == std::string("walk")) clip.bends.push_back({"spine", spine_deg, spine_deg});
  Behaviour b("aim", "", clips, {{"aim*", "aim", {}}});
  const Pose& pose = b.character.skeletons[0].pose;
  ASSERT_EQ(pose_character(b.character, {}), Status::ok);
  const Affine level = pose.model_from_joint[b.file.find_joint(pose.skeleton, "head")];
  b.set_number("speed", 1.2);
  b.play(1);
  EXPECT_NEAR(b.bend("right_lower_arm"), 0, 0.01);
  b.set_flag("aiming", true);
  b.play(1.1);  // half of the layer's 0.2 s, and the arm is all within the mask
  if (spine_deg == 0) EXPECT_NEAR(b.bend("right_lower_arm"), mixed_deg(0, 60, 0.5), 0.02);
  b.play(3);
  EXPECT_NEAR(b.bend("right_lower_arm"), 60, 0.02);
  EXPECT_NEAR(b.bend("spine"), spine_deg, 0.02);
  for (int r = 0; r < 3; ++r)  // the head is level all the same
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(pose.model_from_joint[b.file.find_joint(pose.skeleton, "head")].rows[r][c], level.rows[r][c], 1e-4);
  const std::pair<std::pair<double, double>, double> wanted[] = {
      {{0, 0}, 0},       {{80, 0}, 40},  {{-80, 0}, -40},  {{0, 50}, 20},
      {{0, -50}, -20},   {{80, 50}, 60}, {{-80, 50}, -20}, {{80, -50}, 20},
      {{-80, -50}, -60}, {{40, 0}, 20},  {{0, -25}, -10},  {{80, 25}, mixed_deg(40, 60, 0.5)}};
  for (const auto& [at, deg] : wanted) {
    b.set_number("yaw", at.first);
    b.set_number("pitch", at.second);
    b.play(b.time_s + 2);
    EXPECT_NEAR(b.bend("head"), deg, 0.02) << at.first << " " << at.second;
    EXPECT_NEAR(b.bend("right_lower_arm"), 60, 0.02);
    EXPECT_NEAR(b.bend("left_upper_leg"), 10, 0.02);
  }
  EXPECT_NEAR(b.place.at.z, 1.2 * b.time_s, 1e-3);
  b.set_flag("aiming", false);
  b.play(b.time_s + 1);
  EXPECT_NEAR(b.bend("head"), 0, 0.01);
  EXPECT_NEAR(b.bend("right_lower_arm"), 0, 0.01);
}
TEST(Behaviours, AimsOverAnything) {
  expect_aim(0);
  expect_aim(20);
}

// Mount and rider are asked in one frame, and go by clips of one length: so they are in step for good.
TEST(Behaviours, RidesInStepWithTheMount) {
  Behaviour rider("ride", "body",
                  with_walking({{{"mount", 1.5f, 0, 0, {}, {{"seated", 1.2}}}, {{"spine", 50, 50}}},
                                {{"dismount", 1.0f, 0, 0, {}, {}}, {{"spine", -50, -50}}},
                                {{"ride_idle", 2.0f, 0, 0, {}, {}}, {{"head", -10, 10}}},
                                {{"ride_walk", 1.1f, 1.6f, 0, {0, 0.5}, {}}, {{"head", -20, 20}}},
                                {{"ride_gallop", 0.5f, 4.0f, 0, {0, 0.2}, {}}, {{"head", -30, 30}}}}));
  Behaviour horse("mount", "body",
                  {{{"graze", 3.0f, 0, 0, {}, {}}, {{"head", 60, 60}}},
                   {{"be_mounted", 1.5f, 0, 0, {}, {}}, {}},
                   {{"idle", 2.0f, 0, 0, {}, {}}, {{"head", -10, 10}}},
                   {{"walk", 1.1f, 1.6f, 0, {0, 0.5}, {}}, {{"head", -20, 20}}},
                   {{"gallop", 0.5f, 4.0f, 0, {0, 0.2}, {}}, {{"head", -30, 30}}}});
  const std::uint32_t saddle = horse.file.find_joint(horse.character.skeletons[0].pose.skeleton, "spine");
  const auto both = [&](double until_s, double dt_s, bool in_step) {
    while (rider.time_s < until_s - 1e-9) {
      rider.frame(dt_s);
      horse.frame(dt_s);
      if (in_step) EXPECT_EQ(rider.bend("head"), horse.bend("head")) << rider.time_s;
      const Affine world_from_rider = game::seat(horse.world_from_model, horse.character.skeletons[0].pose, saddle);
      EXPECT_NEAR(world_from_rider.rows[2][3],
                  static_cast<double>(horse.world_from_model.rows[2][3]) +
                      static_cast<double>(horse.character.skeletons[0].pose.model_from_joint[saddle].rows[2][3]),
                  1e-4);
    }
  };
  both(0.7, 1.0 / 60, false);
  rider.fire("mount");
  horse.fire("mount");
  both(1.9, 0.05, false);
  EXPECT_NEAR(rider.bend("spine"), 50, 0.01);
  both(2.7, 0.05, false);  // the fades into the saddle are over: 0.7 + 1.5 + 0.2 = 2.4
  std::uint32_t chance = 1;
  for (int i = 0; i < 20; ++i) {
    chance = chance * 1664525u + 1013904223u;
    for (Behaviour* of : {&rider, &horse}) of->set_number("speed", (chance >> 16) % 12);
    both(rider.time_s + 1, i % 2 == 0 ? 1.0 / 60 : 1.0 / 24, true);
  }
  EXPECT_NEAR(rider.place.at.z, horse.place.at.z, 1e-6);
  EXPECT_GT(rider.place.at.z, 50);
  for (Behaviour* of : {&rider, &horse}) of->set_number("speed", 0);
  both(rider.time_s + 1, 1.0 / 60, true);
  const double left_s = rider.time_s;
  for (Behaviour* of : {&rider, &horse}) of->fire("leave");
  both(left_s + 2, 1.0 / 60, false);
  expect_changes(rider, {{0, "walks"}, {0.7, "mounts"}, {2.2, "rides"}, {left_s, "leaves"}, {left_s + 0.8, "walks"}});
  expect_changes(horse, {{0, "free"}, {0.7, "mounted"}, {2.2, "ridden"}, {left_s, "free"}});
  EXPECT_EQ(rider.heard_count("seated"), 1);
}

TEST(Behaviours, OpensADoor) {
  for (const bool pushes : {true, false}) {
    std::vector<BehaviourClip> clips =
        with_walking({{{"door_push", 1.5f, 0.5f, 0, {}, {{"open", 0.6}}}, {{"spine", 10, 10}}},
                      {{"door_pull", 1.5f, -0.3f, 0, {}, {{"open", 0.8}}}, {{"spine", -10, -10}}}});
    GraphRigMade made = behaviour_rig(clips, {});
    cook::EventRule rule;
    rule.clips = "door_*";
    ASSERT_TRUE(tools::read_event("reach@0.3..0.9", rule.event));
    made.options.motion.events.push_back(rule);
    Behaviour b("door", "body", made);
    b.set_number("speed", 1.2);
    b.set_flag("pushes", pushes);
    b.play(1);
    b.fire("open");  // it waits until the character stands
    b.play(1.2);
    b.set_number("speed", 0);
    game::Door door;
    double opened_s = 0, at_handle_s = 0;
    const Pose& pose = b.character.skeletons[0].pose;
    const auto joint = [&](const char* name) { return b.file.find_joint(pose.skeleton, name); };
    const TwoBoneLimb arm{joint("right_upper_arm"), joint("right_lower_arm"), joint("right_hand")};
    const float handle[3] = {-0.25f, 1.2f, 0.25f};  // 0.32 m from the shoulder, which reaches 0.5 m
    b.each = [&](const AnimatorStep& step) {
      const bool was_open = door.is_open;
      game::hear_door(step, 1.0f / 60, door);
      if (door.is_open && !was_open) opened_s = b.time_s;
    };
    while (b.time_s < 4 - 1e-9) {
      b.frame(1.0 / 60);
      game::reach_handle(pose, arm, door, handle);
      const Affine& hand = pose.model_from_joint[arm.end];
      if (door.weight == 1) {
        at_handle_s += 1.0 / 60;
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(hand.rows[i][3], handle[i], 1e-4) << b.time_s;
      }
    }
    // The clip begins at 1.2 s; the hand is there for 0.6 s, but for 1/8 s to go and a frame that it is told in.
    EXPECT_NEAR(opened_s, 1.2 + (pushes ? 0.6 : 0.8), 1.01 / 60);
    EXPECT_NEAR(at_handle_s, 0.6 - 0.125, 2.01 / 60);
    EXPECT_EQ(door.weight, 0);
    expect_changes(b, {{0, "moves"}, {1.2, pushes ? "pushes" : "pulls"}, {2.45, "moves"}});
    // 1.2 m/s on foot; the clip's speed for 1.25 s and half of the fade.
    EXPECT_NEAR(b.place.at.z, 1.44 + (pushes ? 0.5 : -0.3) / 1.5 * (1.25 + 0.125), 1e-4);
  }
  // It does not wait for ever.
  Behaviour b("door", "body",
              with_walking({{{"door_push", 1.5f, 0, 0, {}, {}}, {}}, {{"door_pull", 1.5f, 0, 0, {}, {}}, {}}}));
  b.set_number("speed", 1.2);
  b.play(1);
  b.fire("open");
  b.play(1.6);
  b.set_number("speed", 0);
  b.play(3);
  expect_changes(b, {{0, "moves"}});
}

TEST(Behaviours, FallsAndGetsUp) {
  for (const bool face_up : {true, false}) {
    Behaviour b("ragdoll", "body",
                with_walking({{{"get_up_back", 1.5f, 0, 0, {}, {{"stands", 1.2}}}, {{"spine", 30, 0}}},
                              {{"get_up_front", 1.0f, 0, 0, {}, {{"stands", 0.7}}}, {{"spine", -30, 0}}}}));
    const Skeleton& skeleton = b.character.skeletons[0].pose.skeleton;
    b.physics.assign(skeleton.rest, skeleton.rest + skeleton.soa_size());
    const std::uint32_t spine = b.file.find_joint(skeleton, "spine");
    // What physics makes of the spine, in degrees.
    const auto fall = [&](double deg) {
      JointTransform at;
      ASSERT_EQ(get_joint({skeleton.rest, skeleton.soa_size()}, spine, at), Status::ok);
      const glm::dquat rest(static_cast<double>(at.rotation[3]), static_cast<double>(at.rotation[0]),
                            static_cast<double>(at.rotation[1]), static_cast<double>(at.rotation[2]));
      const glm::dquat q = rest * glm::angleAxis(glm::radians(deg), glm::dvec3(1, 0, 0));
      const double values[4] = {q.x, q.y, q.z, q.w};
      for (int i = 0; i < 4; ++i) at.rotation[i] = static_cast<float>(values[i]);
      ASSERT_EQ(set_joint({b.physics.data(), b.physics.size()}, spine, at), Status::ok);
    };
    b.set_number("speed", 1.2);
    b.play(1);
    b.set_flag("limp", true);
    double deg = 0;
    for (int i = 0; i < 60; ++i) {
      deg = std::min(90.0, 3.0 * i);
      fall(deg);
      b.frame(1.0 / 60);
      EXPECT_NEAR(b.bend("spine"), deg, 0.01) << i;  // as it is given, from the first frame on
    }
    EXPECT_NEAR(b.place.at.z, 1.2, 1e-4);  // physics moves it, nothing else does
    b.set_flag("face_up", face_up);
    b.set_flag("limp", false);
    b.set_number("speed", 0);
    double before = 90;
    for (int i = 0; i < 24; ++i) {
      b.frame(1.0 / 60);
      EXPECT_LT(std::abs(b.bend("spine") - before), 12)
          << i;  // 120 or 60 degrees in 24 frames, the fastest in the middle
      before = b.bend("spine");
      if (i == 0) EXPECT_NEAR(before, 90, 2);  // it goes on from where it lay
    }
    b.play(2.5);
    // 0.5 s into the clip the fade is over.
    EXPECT_NEAR(b.bend("spine"), face_up ? 30 * (1 - 0.5 / 1.5) : -30 * (1 - 0.5), 0.02);
    b.play(5);
    const double lasts_s = (face_up ? 1.5 : 1.0) - 0.2;
    expect_changes(b, {{0, "stands"}, {1, "lies"}, {2, face_up ? "from_back" : "from_front"}, {2 + lasts_s, "stands"}});
    EXPECT_EQ(b.heard_count("stands"), 1);
  }
}

// Each graph is at most 40 lines long, and the page shows all of it; so is the one of the page on graphs.
TEST(Behaviours, StandInThePages) {
  const auto read = [](const std::string& path) {
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string pages = read(in_source("docs/cooking/behaviours.md")) + read(in_source("docs/cooking/graphs.md"));
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(in_source("tests/examples/behaviours"))) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    const std::string text = read(entry.path().string());
    EXPECT_NE(pages.find("```toml\n" + text + "```"), std::string::npos) << entry.path();
    if (entry.path().filename() != "hero.anim.toml") EXPECT_LE(std::ranges::count(text, '\n'), 40) << entry.path();
    cook::Notes notes;
    const cook::BuiltGraph built = cook::build_graph(cook::parse_graph(entry.path().string(), text), notes);
    EXPECT_TRUE(notes.warnings.empty()) << notes.warnings[0].text;
    EXPECT_FALSE(built.nodes.empty());
  }
  EXPECT_EQ(count, 12);
}

}  // namespace
}  // namespace marrow::test
