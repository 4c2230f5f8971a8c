// What `marrow view` reckons beside its window: frames, angles, chains, squares of the ground, files that change.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "commands/view/changed_files.h"
#include "commands/view/opening.h"
#include "marrow/limits.h"
#include "stage/among_figures.h"
#include "stage/moves.h"
#include "stage/recording.h"
#include "stage/rigging.h"
#include "support/places.h"

namespace marrow::tools {
namespace {

TEST(Timeline, CountsFramesFromZero) {
  EXPECT_EQ(last_frame(1.2f, 30), 36);
  EXPECT_EQ(last_frame(0, 30), 0);
  EXPECT_EQ(last_frame(0.99f, 24), 23) << "frame 24 would begin at 1 s";
  EXPECT_EQ(frame_at(0.5, 30), 15);
  EXPECT_DOUBLE_EQ(time_of_frame(15, 1.2f, 30), 0.5);
  EXPECT_DOUBLE_EQ(stepped(0.5, 1, 1.2f, 30), 16.0 / 30);
  EXPECT_DOUBLE_EQ(stepped(0, -1, 1, 30), 1) << "from the first to the last";
  EXPECT_DOUBLE_EQ(stepped(1, 1, 1, 30), 0);
}

// A quarter about x, then 30° about z, by hand: q = q_z · q_x.
TEST(Angles, AreOfTurnsAboutTheParentsAxes) {
  const float h = std::sqrt(0.5f), c = std::cos(0.2617993878f), s = std::sin(0.2617993878f);
  const float both[4] = {c * h, s * h, s * h, c * h};
  const glm::vec3 angles = angles_deg(both);
  EXPECT_NEAR(angles.x, 90, 1e-3f);
  EXPECT_NEAR(angles.y, 0, 1e-3f);
  EXPECT_NEAR(angles.z, 30, 1e-3f);
  const float about_y[4] = {0, std::sin(0.5f), 0, std::cos(0.5f)};
  EXPECT_NEAR(angles_deg(about_y).y, 57.29578f, 1e-3f);
}

TEST(Chain, GoesDownByFirstChildren) {
  const std::uint16_t parents[] = {kNoJoint, 0, 0, 1, 2, 3};
  Skeleton skeleton;
  skeleton.joint_count = 6;
  skeleton.parents = parents;
  EXPECT_EQ(chain_below(skeleton, 0), (std::vector<std::uint16_t>{0, 1, 3, 5}));
  EXPECT_EQ(chain_below(skeleton, 2), (std::vector<std::uint16_t>{2, 4}));
  EXPECT_EQ(chain_below(skeleton, 5), (std::vector<std::uint16_t>{5}));
}

TEST(Rig, HoldsWeightsOfTargetsByHand) {
  const Source source = open_source(test::in_golden("face.gltf"));
  EXPECT_TRUE(source.cooked_here);
  Character character(source.loaded.file);
  Rig rig(source.loaded.file);
  Settings settings;
  settings.weights = {{1, 0.4f}, {3, 2.0f}};
  rig.prepare(settings, {}, 0);
  character.set_weigh([&](std::uint32_t mesh, Span<float> weights) { rig.weigh(mesh, weights); });
  character.pose({}, 0);
  // The others as the file has them.
  EXPECT_EQ(std::vector<float>(character.weights(0).begin(), character.weights(0).end()),
            (std::vector<float>{0.5f, 0.4f}));
  EXPECT_EQ(std::vector<float>(character.weights(1).begin(), character.weights(1).end()),
            (std::vector<float>{0.25f, 2.0f}));
}

// Poses `clip` at its end; what the rig leaves of it.
std::vector<SoaTransform> ridden(const File& file, Rig& rig, const char* clip) {
  Character character(file);
  std::vector<SoaTransform> out;
  character.set_change([&](std::uint32_t skeleton, const Pose& pose) {
    rig.change(skeleton, pose);
    if (skeleton == 0) out.assign(pose.local.begin(), pose.local.end());
  });
  const Play play = play_together(file, file.find_clip(clip));
  character.pose(play, play.duration_s);
  return out;
}

TEST(Rig, KeepsLimitsWhereItIsAsked) {
  const Source source = open_source(test::in_golden("limits.gltf"));
  const Skeleton skeleton = source.loaded.file.skeleton(0);
  ASSERT_GE(skeleton.limits.size, 3u);
  Rig rig(source.loaded.file);
  float most[2] = {0, 0};
  for (const bool limited : {false, true}) {
    Settings settings;
    settings.limits = limited;
    rig.prepare(settings, {}, 0);
    const std::vector<SoaTransform> local = ridden(source.loaded.file, rig, "bend");
    for (const JointLimit& limit : skeleton.limits) {
      JointTransform t;
      ASSERT_EQ(get_joint(local, limit.joint, t), Status::ok);
      most[limited] = std::max(most[limited], limit_excess(limit, t.rotation));
    }
  }
  EXPECT_GT(most[false], 0.1f);
  EXPECT_LT(most[true], 1e-4f);
}

// The arm lies along -x; its weight takes the wrist down.
TEST(Rig, SpringsHangDownBelowAJoint) {
  const Source source = open_source(test::in_golden("tiny.gltf"));
  const File& file = source.loaded.file;
  Character character(file);
  Rig rig(file);
  character.set_change([&](std::uint32_t skeleton, const Pose& pose) { rig.change(skeleton, pose); });
  const NamedJoint joints[] = {{"arm", 0, 0}, {"forearm", 0, 1}, {"hand", 0, 2}};
  Settings settings;
  rig.prepare(settings, joints, 0);
  character.pose({}, 0);
  const float before_m = character.model_from_joint(0)[2].rows[1][3];
  settings.springs = true;
  settings.spring.frequency_hz = 0.5f;
  for (int frame = 0; frame < 120; ++frame) {
    rig.prepare(settings, joints, 1.0f / 60);
    character.pose({}, 0);
  }
  EXPECT_TRUE(rig.trouble().empty()) << rig.trouble();
  EXPECT_LT(character.model_from_joint(0)[2].rows[1][3], before_m - 0.5f);
  // The last joint of a chain has no bone.
  settings.joint = 2;
  rig.prepare(settings, joints, 1.0f / 60);
  EXPECT_FALSE(rig.trouble().empty());
}

// By hand: from 2 m away, a picture of 100 points shows 2 tan(0.235) · 2 m, so that much is a hundredth of it a point;
// what is half as far away goes half as far.
TEST(Moves, WhatIsDraggedStaysBelowTheHand) {
  const Orbit orbit{{0, 1, 0}, 0, 0, 2};  // from +Z
  EXPECT_NEAR(depth_of(orbit, {0.3f, 1.2f, 0}), 2, 1e-5);
  EXPECT_NEAR(depth_of(orbit, {0, 0, 1}), 1, 1e-5);
  const float point_m = 2 * std::tan(0.235f) * 2 / 100;
  const glm::vec3 far = dragged_by(orbit, 10, -5, 100, 2), near = dragged_by(orbit, 10, -5, 100, 1);
  EXPECT_NEAR(far.x, 10 * point_m, 1e-6);
  EXPECT_NEAR(far.y, 5 * point_m, 1e-6);
  EXPECT_NEAR(far.z, 0, 1e-6);
  EXPECT_NEAR(near.x, 5 * point_m, 1e-6);
}

// The arm lies along -x: a quarter turn about z takes the hand from there down to -y, about the shoulder.
TEST(Rig, TurnsAJointByHand) {
  const Source source = open_source(test::in_golden("tiny.gltf"));
  const File& file = source.loaded.file;
  Character character(file);
  Rig rig(file);
  character.set_change([&](std::uint32_t skeleton, const Pose& pose) { rig.change(skeleton, pose); });
  const NamedJoint joints[] = {{"arm", 0, 0}, {"forearm", 0, 1}, {"hand", 0, 2}};
  const auto hand = [&](const Settings& settings) {
    rig.prepare(settings, joints, 0);
    character.pose({}, 0);
    const auto places = character.model_from_joint(0);
    return glm::vec3(places[2].rows[0][3] - places[1].rows[0][3], places[2].rows[1][3] - places[1].rows[1][3],
                     places[2].rows[2][3] - places[1].rows[2][3]);
  };
  Settings settings;
  const glm::vec3 before = hand(settings);
  settings.turns = {{1, {0, 0, 90}}};
  const glm::vec3 after = hand(settings);
  EXPECT_NEAR(after.x, -before.y, 1e-5);
  EXPECT_NEAR(after.y, before.x, 1e-5);
  EXPECT_NEAR(after.z, before.z, 1e-5);
  EXPECT_GT(glm::length(before), 0.1f);
}

TEST(Curves, FollowAJointOverTheClip) {
  const Source source = open_source(test::in_golden("limits.gltf"));
  const File& file = source.loaded.file;
  const JointCurves curves = record_joint(file, play_together(file, file.find_clip("bend")), 0, 1, 9);
  ASSERT_EQ(curves.places.size(), 9u);
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_EQ(curves.rotation_deg[axis].size(), 9u);
    for (std::size_t i = 1; i < 9; ++i)
      EXPECT_LT(std::abs(curves.rotation_deg[axis][i] - curves.rotation_deg[axis][i - 1]), 180) << axis << ' ' << i;
    for (const float scale : curves.scale[axis]) EXPECT_NEAR(scale, 1, 1e-5f);
  }
  // The knee's place below the hip stays what the source says.
  for (const float y : curves.translation[1]) EXPECT_NEAR(y, -0.5f, 1e-4f);
}

TEST(Grid, HasSquaresOfPowersOfTen) {
  EXPECT_FLOAT_EQ(grid_square(1.0f), 0.1f) << "a person";
  EXPECT_FLOAT_EQ(grid_square(5.0f), 1.0f) << "a house";
  EXPECT_FLOAT_EQ(grid_square(0.05f), 0.01f) << "a mouse";
}

class WatchTest : public ::testing::Test {
 protected:
  WatchTest() : path_(std::filesystem::temp_directory_path() / ("marrow_watch_" + std::to_string(::getpid()))) {
    write("one");
  }
  ~WatchTest() override { std::filesystem::remove(path_); }
  void write(const char* text) { std::ofstream(path_) << text; }

  std::filesystem::path path_;
};

TEST_F(WatchTest, SaysOnceThatAFileHasChangedAndIsStill) {
  Watch watch;
  // The file was there long before.
  std::filesystem::last_write_time(path_, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  watch.set({path_.string()}, Watch::now());
  EXPECT_FALSE(watch.changed());
  write("more than one");
  EXPECT_FALSE(watch.changed()) << "it may still be written";
  EXPECT_TRUE(watch.changed());
  EXPECT_FALSE(watch.changed());
  std::filesystem::remove(path_);
  EXPECT_FALSE(watch.changed());
  EXPECT_TRUE(watch.changed()) << "it is gone";
}

TEST_F(WatchTest, SeesWhatWasWrittenWhileItWasRead) {
  Watch watch;
  std::timespec before = Watch::now();
  before.tv_sec -= 2;
  watch.set({path_.string()}, before);
  EXPECT_FALSE(watch.changed());
  EXPECT_TRUE(watch.changed());
  // What comes from the future does not change for ever.
  std::filesystem::last_write_time(path_, std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  watch.set({path_.string()}, before);
  EXPECT_FALSE(watch.changed());
  EXPECT_FALSE(watch.changed());
}

}  // namespace
}  // namespace marrow::tools
