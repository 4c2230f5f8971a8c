// What `marrow view` reckons beside its window: frames, angles, chains, squares of the ground, files that change.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "commands/view/files/watch.h"
#include "commands/view/overlay/strokes.h"
#include "commands/view/stage/record.h"
#include "commands/view/stage/rig.h"
#include "commands/view/stage/timeline.h"

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
  const std::uint16_t parents[] = {kNoParent, 0, 0, 1, 2, 3};
  Skeleton skeleton;
  skeleton.joint_count = 6;
  skeleton.parents = parents;
  EXPECT_EQ(chain_below(skeleton, 0), (std::vector<std::uint16_t>{0, 1, 3, 5}));
  EXPECT_EQ(chain_below(skeleton, 2), (std::vector<std::uint16_t>{2, 4}));
  EXPECT_EQ(chain_below(skeleton, 5), (std::vector<std::uint16_t>{5}));
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
