// A graph in the window: its past, what it leaves on the ground, and its text on the disk.
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "commands/view/opening.h"
#include "stage/rehearsal.h"
#include "support/places.h"

namespace marrow::tools {
namespace {

constexpr float kFrame_s = 1.0f / 60;
constexpr const char* kText = R"(output = "body"
[parameters]
lean = { type = "number", range = [0, 1], half_life = 0.1 }
calm = { type = "flag" }
go = { type = "trigger" }
[node.moves]
type = "layer"
base = "walk"
pose = "reach"
weight = "lean"
[node.body]
type = "machine"
start = "moves"
state.moves = { pose = "moves" }
state.waits = { pose = "idle" }
transition = [
  { from = "moves", to = "waits", when = "go", fade = 0.5, kind = "inertial" },
  { from = "waits", to = "moves", when = "calm", fade = 0.3 },
]
)";

class RehearsalTest : public ::testing::Test {
 protected:
  static const Source& newt() {
    static const Source source = open_source(test::newt_glb(), "", Opens::models_by_graph);
    return source;
  }
  static const File& file() { return newt().loaded.file; }
  static std::unique_ptr<Rehearsal> made(const std::string& text) {
    return std::make_unique<Rehearsal>("newt.glb", file(), cook_graph_text("newt.anim.toml", text),
                                       std::vector<std::string>());
  }
  // All joints in the world.
  static std::vector<Affine> joints(const Character& character) {
    const std::span<const Affine> all = character.model_from_joint(0);
    return {all.begin(), all.end()};
  }
  static bool same(const std::vector<Affine>& a, const std::vector<Affine>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Affine)) == 0;
  }
  // Moves on by a frame, with what is set in frame `i`.
  static void play(Rehearsal& rehearsal, int i, Character& character) {
    if (i == 40) rehearsal.set(0, 1);
    if (i == 90) rehearsal.set(2, 1);
    if (i == 150) rehearsal.set(1, 1);
    rehearsal.move_on(kFrame_s);
    rehearsal.pose(character);
  }
  Character character_{file(), AsNormals::blended, 0, 8};
};

TEST_F(RehearsalTest, GoesBackAndOnToTheBit) {
  const auto rehearsal = made(kText);
  rehearsal->pose(character_);
  std::vector<std::vector<Affine>> was{joints(character_)};
  for (int i = 1; i <= 200; ++i) {
    play(*rehearsal, i, character_);
    was.push_back(joints(character_));
  }
  EXPECT_FALSE(same(was[95], was[94])) << "in the inertial fade";
  // Here and there, from the end: 95 and 100 stand in the inertial fade, 155 in the other.
  for (const std::size_t moment : {200u, 100u, 95u, 155u, 0u, 41u}) {
    rehearsal->go_to(moment);
    for (int twice = 0; twice < 2; ++twice) {
      rehearsal->pose(character_);
      EXPECT_TRUE(same(joints(character_), was[moment])) << moment;
    }
    EXPECT_EQ(rehearsal->count(), 201u);
  }
  rehearsal->go_to(95);
  for (int i = 96; i <= 200; ++i) {
    play(*rehearsal, i, character_);
    EXPECT_TRUE(same(joints(character_), was[static_cast<std::size_t>(i)])) << i;
  }
}

TEST_F(RehearsalTest, ForgetsWhatItMovesOnFrom) {
  const auto rehearsal = made(kText);
  for (int i = 1; i <= 120; ++i) play(*rehearsal, i, character_);
  const std::size_t steps = rehearsal->events().size(), prints = rehearsal->prints().size();
  EXPECT_GT(steps, 1u);
  rehearsal->step(-119);
  EXPECT_EQ(rehearsal->now(), 0u);
  EXPECT_EQ(rehearsal->events().size(), steps) << "it may go on again";
  // What is set in the past is there when one comes back.
  rehearsal->set(0, 0.5f);
  rehearsal->step(7);
  EXPECT_FLOAT_EQ(rehearsal->behaviour().wanted(0), 0);
  rehearsal->step(-7);
  EXPECT_FLOAT_EQ(rehearsal->behaviour().wanted(0), 0.5f);
  rehearsal->move_on(kFrame_s);
  rehearsal->pose(character_);
  EXPECT_EQ(rehearsal->count(), 2u);
  EXPECT_LT(rehearsal->events().size(), steps);
  EXPECT_LT(rehearsal->prints().size(), prints);
  EXPECT_EQ(rehearsal->way().size(), 2u);
}

TEST_F(RehearsalTest, KeepsSixHundredMoments) {
  const auto rehearsal = made(kText);
  rehearsal->pose(character_);
  for (int i = 1; i <= 700; ++i) {
    rehearsal->move_on(kFrame_s);
    rehearsal->pose(character_);
  }
  EXPECT_EQ(rehearsal->count(), 600u);
  EXPECT_NEAR(rehearsal->moment_s(0), 101.0 / 60, 1e-5);
  EXPECT_EQ(rehearsal->moment_at(0), 0u);
  EXPECT_EQ(rehearsal->moment_at(102.2 / 60), 1u);
  EXPECT_EQ(rehearsal->moment_at(99), 599u);
  EXPECT_GE(rehearsal->events().front().at_s, rehearsal->moment_s(0));
  const std::size_t longest = rehearsal->way().size();
  EXPECT_EQ(longest, 701u) << "the way is kept for a minute";
}

// Prints of one foot stand as far from each other as the clip goes in a round.
TEST_F(RehearsalTest, LeavesPrintsWhereFeetComeDown) {
  const auto rehearsal = made("output = \"walk\"\n");
  const Animation& walk = rehearsal->behaviour().binding().clips[0];
  const float round_m = walk.motion.speed_m_s * walk.duration_s;
  const int rounds = 4, frames = static_cast<int>(60 * rounds * walk.duration_s);
  for (int i = 0; i < frames; ++i) {
    rehearsal->move_on(kFrame_s);
    rehearsal->pose(character_);
  }
  std::vector<Rehearsal::Print> left;
  for (const Rehearsal::Print& print : rehearsal->prints())
    if (print.print.role == Role::left_foot) left.push_back(print);
  ASSERT_EQ(left.size(), static_cast<std::size_t>(rounds));
  for (std::size_t i = 1; i < left.size(); ++i)
    EXPECT_NEAR(glm::length(left[i].print.at - left[i - 1].print.at), round_m, 0.01f * round_m);
  const glm::vec3 way = rehearsal->way().back().at - rehearsal->way().front().at;
  EXPECT_NEAR(glm::length(way), round_m * rounds, 0.05f * round_m);
}

TEST_F(RehearsalTest, AnotherGraphTakesWhatIsSet) {
  const auto first = made(kText);
  for (int i = 1; i <= 60; ++i) play(*first, i, character_);
  first->set(1, 1);
  std::string text = kText;
  text.replace(text.find("lean = { type"), 13, "bow = { type");
  text.replace(text.find("weight = \"lean\""), 15, "weight = \"bow\"");
  text.insert(text.find("calm ="), "lean = { type = \"number\", range = [0, 0.25] }\n");
  const auto second = made(text);
  second->take(first->kept());
  EXPECT_EQ(second->behaviour().wanted(0), 0) << "bow is new";
  EXPECT_EQ(second->behaviour().wanted(1), 0.25f) << "within its range";
  EXPECT_EQ(second->behaviour().wanted(2), 1) << "calm";
  EXPECT_EQ(second->behaviour().world_from_model().rows[2][3], first->behaviour().world_from_model().rows[2][3]);
  EXPECT_GT(second->behaviour().world_from_model().rows[2][3], 0.1f) << "where it stood";
  // What has become another thing is not taken.
  text.replace(text.find("calm = { type = \"flag\""), 22, "calm = { type = \"trigger\"");
  const auto third = made(text);
  third->take(first->kept());
  EXPECT_EQ(third->behaviour().wanted(2), 0);
}

TEST(GraphOnDisk, IsReadAgainWhenItChanges) {
  const Source& newt = open_source(test::newt_glb(), "", Opens::models_by_graph);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("marrow_graph_text_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const std::string path = folder / "hero.anim.toml";
  const auto write = [&](const std::string& text) {
    std::ofstream(path + ".new") << text;
    std::filesystem::rename(path + ".new", path);
  };
  const auto polled = [&](GraphOnDisk& text) {
    std::optional<FoundGraph> found = text.poll(newt.path, newt.loaded.file);
    // It has to be as it was at the look before.
    return found ? std::move(found) : text.poll(newt.path, newt.loaded.file);
  };
  write("output = \"walk\"\n");
  GraphOnDisk text(path, true);
  EXPECT_STREQ(text.read(newt.path, newt.loaded.file).graph.name, "hero");
  // What was written in the same tick as it was read counts as changed.
  while (polled(text).has_value()) continue;
  write("output = \"idle\"\n");
  std::optional<FoundGraph> found = polled(text);
  ASSERT_TRUE(found.has_value());
  EXPECT_STREQ(found->file.text(found->graph.clips[0].name), "idle");
  write("output = \"idle\"\n[node.a]\ntype = \"clop\"\n");
  EXPECT_FALSE(polled(text).has_value());
  EXPECT_NE(text.error().find("hero.anim.toml: 3:8: "), std::string::npos) << text.error();
  write("output = \"twist\"\n");
  EXPECT_TRUE(polled(text).has_value());
  EXPECT_EQ(text.error(), "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace marrow::tools
