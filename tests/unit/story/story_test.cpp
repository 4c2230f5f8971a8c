// What the demo's movie shows: the newt's story, looked at joint by joint and vertex by vertex.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "common/load_mrw.h"
#include "disk/cook_on_disk.h"
#include "disk/files.h"
#include "pose/evaluate.h"
#include "story/story.h"
#include "support/places.h"

namespace marrow::tools {
namespace {

class StoryTest : public ::testing::Test {
 protected:
  struct Told {
    LoadedFile newt;
    Story story;
  };
  static const Told& told() {
    static const Told* const kTold = [] {
      auto* const out = new Told;
      cook::CookOptions options;
      options.mesh.codec = cook::MeshCodec::none;
      options.clips.raw = true;
      const std::string path = ::testing::TempDir() + "story_newt.mrw";
      write_file_atomically(path, cook::cook_file(test::newt_glb(), options).file);
      out->newt = load_mrw(path);
      out->story = tell_story(cook_story(path));
      return out;
    }();
    return *kTold;
  }
  static const Story& story() { return told().story; }

  static std::size_t joint(const std::string& name) {
    const Skeleton skeleton = told().newt.file.skeleton(0);
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j)
      if (told().newt.file.text(skeleton.names[j]) == name) return j;
    ADD_FAILURE() << name;
    return 0;
  }
  static glm::vec3 place(const StoryStep& step, std::size_t of) {
    const Affine& m = step.world_from_joint[of];
    return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
  }
  static float level(const glm::vec3& a, const glm::vec3& b) { return std::hypot(a.x - b.x, a.z - b.z); }
};

TEST_F(StoryTest, HappensInItsOrder) {
  const char* const expected[] = {"stand", "turn_left", "stand", "start", "move",  "jump",       "air",
                                  "land",  "move",      "hit",   "stop",  "stand", "turn_right", "stand"};
  std::vector<std::string> met;
  for (const Happening& h : story().happenings) met.push_back(h.what);
  EXPECT_EQ(met, std::vector<std::string>(std::begin(expected), std::end(expected)));
  EXPECT_GT(story().steps.size(), 12u * kStoryFps);
  EXPECT_LT(story().steps.size(), 16u * kStoryFps);
}

TEST_F(StoryTest, WalksAFigureEightBackToWhereItBegan) {
  const StoryStep &first = story().steps.front(), &last = story().steps.back();
  EXPECT_LT(glm::distance(first.root, last.root), 0.005f);
  EXPECT_LT(std::fabs(first.heading_rad - last.heading_rad), 0.02f);
  // Shown again and again it does not jump.
  float jump = 0;
  for (std::size_t j = 0; j < first.world_from_joint.size(); ++j)
    jump = std::max(jump, glm::distance(place(first, j), place(last, j)));
  EXPECT_LT(jump, 0.03f);
  // It turns to the one side as far as to the other, three quarters of a round at least each; both lobes reach as far.
  float left = 0, right = 0, most = 0, least = 0, fastest = 0;
  std::size_t in_the_middle = 0;
  bool was_there = false;
  for (std::size_t i = 1; i < story().steps.size(); ++i) {
    const StoryStep &now = story().steps[i], &before = story().steps[i - 1];
    const float turn = std::remainder(now.heading_rad - before.heading_rad, 6.2831853f);
    (turn > 0 ? left : right) += std::fabs(turn);
    most = std::max(most, now.root.x);
    least = std::min(least, now.root.x);
    fastest = std::max(fastest, level(now.root, before.root) * kStoryFps);
    const bool is_there = std::hypot(now.root.x, now.root.z) < 0.2f;
    in_the_middle += is_there && !was_there ? 1 : 0;
    was_there = is_there;
  }
  EXPECT_NEAR(left, right, 0.3f);
  EXPECT_GT(left, 4.7f);
  EXPECT_GT(most, 1.6f);
  EXPECT_LT(least, -1.6f);
  EXPECT_EQ(in_the_middle, 2u);
  EXPECT_GT(fastest, 1.4f);
  EXPECT_LT(fastest, 2.0f);
}

// Where a foot has come down it stays until it is lifted, though the newt turns and changes its gait meanwhile.
TEST_F(StoryTest, FeetStandOnTheirPrints) {
  const std::size_t toes[] = {joint("toes.L"), joint("toes.R")}, ankles[] = {joint("foot.L"), joint("foot.R")};
  float off = 0, turned = 0, flattest = 0;
  std::size_t stood = 0;
  for (const Print& print : story().prints) {
    ASSERT_LT(print.from, print.until);
    float lowest = 1;
    for (std::size_t i = print.from; i < print.until; ++i, ++stood) {
      const glm::vec3 ball = place(story().steps[i], toes[print.foot]),
                      ankle = place(story().steps[i], ankles[print.foot]);
      off = std::max(off, level(ball, print.at));
      lowest = std::min(lowest, ball.y);
      if (ankle.y > 0.1f) continue;  // its heel is up
      const float heading = std::atan2(ball.x - ankle.x, ball.z - ankle.z);
      turned = std::max(turned, std::fabs(std::remainder(heading - print.heading_rad, 6.2831853f)));
    }
    flattest = std::max(flattest, lowest);
  }
  EXPECT_LE(off, 0.005f);
  EXPECT_LE(turned, 0.05f);
  EXPECT_LE(flattest, 0.033f);  // the joint is 30 mm above a standing foot's sole
  EXPECT_GE(story().prints.size(), 30u);
}

// A foot that is down is on a print, but for the moment in which it comes down or leaves.
TEST_F(StoryTest, FeetThatAreDownHavePrints) {
  const std::size_t toes[] = {joint("toes.L"), joint("toes.R")};
  std::size_t longest = 0;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    std::size_t here = 0;
    for (std::size_t i = 0; i < story().steps.size(); ++i) {
      const bool on_print = std::ranges::any_of(
          story().prints, [&](const Print& print) { return print.foot == foot && print.from <= i && i < print.until; });
      here = !on_print && place(story().steps[i], toes[foot]).y < 0.04f ? here + 1 : 0;
      longest = std::max(longest, here);
    }
  }
  EXPECT_LE(longest, 3u);
}

// Every vertex, at every third step: as the movie is drawn.
TEST_F(StoryTest, StaysAboveTheGroundAndOffTheStone) {
  const File& file = told().newt.file;
  Character newt(file);
  const StoryStep* shown = nullptr;
  newt.set_change([&](std::uint32_t, const Pose& pose) {
    std::ranges::copy(shown->world_from_joint, pose.model_from_joint.begin());
  });
  float lowest = 0, nearest = 1e9f, highest_sole = 0;
  PosedMesh posed;
  for (std::size_t i = 0; i < story().steps.size(); i += 3) {
    shown = &story().steps[i];
    newt.pose(Play{}, 0);
    float sole = 1e9f;
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
      newt.skin(m, Deformer::ssd, posed);
      for (std::size_t v = 0; v + 2 < posed.positions.size(); v += 3) {
        const glm::vec3 p{posed.positions[v], posed.positions[v + 1], posed.positions[v + 2]};
        sole = std::min(sole, p.y);
        const glm::vec3 d =
            (p - story().stone) / glm::vec3(story().stone_radius, story().stone_height, story().stone_radius);
        nearest = std::min(nearest, glm::length(d));
      }
    }
    lowest = std::min(lowest, sole);
    highest_sole = std::max(highest_sole, sole);
  }
  EXPECT_GE(lowest, -0.005f);
  EXPECT_GE(nearest, 1.0f);
  EXPECT_GT(highest_sole, story().stone_height);  // over the stone, all of it
}

}  // namespace
}  // namespace marrow::tools
