// Maps of joints: what pairs them, what a map says, and what is wrong with one.
#include "cook/retarget/retarget.h"

#include "common/failure.h"
#include "cook/skeleton/build_skeletons.h"
#include "unit/cook/retarget/raw_rig.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

using tools::Exit;

BuiltSkeleton skeleton_of(const std::vector<std::pair<const char*, int>>& joints) {
  std::vector<RawRigBone> bones;
  for (const auto& [name, parent] : joints)
    bones.push_back({name, parent, {0.1 * static_cast<double>(bones.size()), 1, 0}});
  return build_skeletons(raw_rig(bones, 1)).skeletons.at(0);
}

const BuiltSkeleton& hero() {
  static const BuiltSkeleton out = skeleton_of({{"root", -1}, {"arm", 0}, {"hand", 1}, {"twin", 0}, {"twin", 1}});
  return out;
}
const BuiltSkeleton& other() {
  static const BuiltSkeleton out = skeleton_of({{"r", -1}, {"upper", 0}, {"end", 1}, {"two", 0}, {"two", 0}});
  return out;
}

std::vector<Counterpart> mapped(const std::string& lines) {
  return map_rigs(hero(), other(), parse_retarget_map("map.toml", "[joints]\n" + lines), "hero.glb", "walk.glb");
}

TEST(RetargetMap, SaysWhatTurnsAsWhat) {
  const std::vector<Counterpart> got = mapped("arm = \"upper\"\nroot = [\"r\", \"end\", 0.25]\n");
  ASSERT_EQ(got.size(), 5u);
  EXPECT_EQ(got[0].node, 0);
  EXPECT_EQ(other().joint_names[static_cast<std::size_t>(got[0].other)], "end");
  EXPECT_EQ(got[0].share, 0.25);
  EXPECT_EQ(other().joint_names[static_cast<std::size_t>(got[1].node)], "upper");
  EXPECT_FALSE(got[2].is_there());
}

TEST(RetargetMap, MistakesAreLocated) {
  expect_failure([] { mapped("arm = \"upper\"\narm = \"end\"\n"); }, Exit::usage, "3:7", "no TOML");
  expect_failure([] { mapped("amr = \"upper\"\n"); }, Exit::usage, "2:7", "no joint \"amr\" in hero.glb");
  expect_failure([] { mapped("arm = \"uper\"\n"); }, Exit::usage, "2:7", "no joint \"uper\" in walk.glb");
  expect_failure([] { mapped("twin = \"upper\"\n"); }, Exit::usage, "2:8", "several joints \"twin\" in hero.glb");
  expect_failure([] { mapped("arm = \"two\"\n"); }, Exit::usage, "2:7", "several joints \"two\" in walk.glb");
  // A circle: what hangs below turns as what is above.
  expect_failure([] { mapped("arm = \"end\"\nhand = \"upper\"\n"); }, Exit::usage, "3:8",
                 "\"hand\" hangs below \"arm\", but \"upper\" above \"end\"");
  expect_failure([] { mapped("arm = \"\"\n"); }, Exit::usage, "2:7", "turns as nothing");
  expect_failure([] { mapped("arm = 3\n"); }, Exit::usage, "2:7", "neither a name nor a list");
  expect_failure([] { mapped("arm = [\"upper\", \"end\"]\n"); }, Exit::usage, "2:7", "neither a name nor a list");
  expect_failure([] { mapped("arm = [\"upper\", \"end\", nan]\n"); }, Exit::usage, "2:7", "a share that is not");
  expect_failure([] { mapped(""); }, Exit::usage, "1:1", "a map of no joints");
  expect_failure([] { parse_retarget_map("map.toml", "[bones]\n"); }, Exit::usage, "1:2", "unknown setting");
  expect_failure([] { parse_retarget_map("map.toml", ""); }, Exit::usage, "", "no [joints]");
}

TEST(RetargetMap, WhatIsWrittenReadsTheSame) {
  Character character{"hero.glb", {hero()}};
  RigPairing pairing;
  pairing.rig_skeleton = other();
  pairing.rig_skeleton.joint_names[1] = "up \"per\" \\ \n";
  pairing.pairs.resize(5);
  pairing.pairs[1] = {1, kNone, 0};
  pairing.pairs[3] = {1, 4, 0.5};  // joints are numbered level by level
  RawScene source;
  source.source = "walk.glb";
  const std::string text = retarget_map_text(character, source, pairing);
  EXPECT_NE(text.find("# \"root\" = \"\"\n"), std::string::npos) << text;
  EXPECT_NE(text.find("# Of walk.glb nothing turns as:\n# \"r\"\n"), std::string::npos) << text;
  const std::vector<Counterpart> got =
      map_rigs(hero(), pairing.rig_skeleton, parse_retarget_map("map.toml", text), "hero.glb", "walk.glb");
  for (std::size_t j = 0; j < 5; ++j) {
    EXPECT_EQ(got[j].node, pairing.pairs[j].node);
    EXPECT_EQ(got[j].other, pairing.pairs[j].other);
    EXPECT_EQ(got[j].share, pairing.pairs[j].share);
  }
}

void give(BuiltSkeleton& skeleton, const std::vector<std::pair<std::string, Role>>& roles) {
  for (const auto& [name, role] : roles) {
    const auto joint = std::ranges::find(skeleton.joint_names, name) - skeleton.joint_names.begin();
    skeleton.roles.roles.push_back({static_cast<std::uint16_t>(joint), role, 0});
  }
}

std::string name_in(const BuiltSkeleton& skeleton, int joint) {
  return joint == kNone ? "" : skeleton.joint_names[static_cast<std::size_t>(joint)];
}

// Roles count before names; a spine of three goes onto one of two, first to first and last to last.
TEST(RetargetMap, PairsAreFoundByRolesThenNames) {
  BuiltSkeleton a = skeleton_of({{"pelvis", -1}, {"s1", 0}, {"s2", 1}, {"top", 2}, {"hat", 3}, {"left", 0}});
  BuiltSkeleton b = skeleton_of({{"hips", -1}, {"x1", 0}, {"x2", 1}, {"x3", 2}, {"head", 3}, {"hat", 4}, {"left", 4}});
  give(a, {{"pelvis", Role::hips}, {"s1", Role::spine}, {"s2", Role::chest}, {"top", Role::head}});
  give(b, {{"hips", Role::hips},
           {"x1", Role::spine},
           {"x2", Role::chest},
           {"x3", Role::upper_chest},
           {"head", Role::head}});
  const std::vector<Counterpart> got = pair_rigs(a, b);
  std::vector<std::string> names;
  for (std::size_t j = 0; j < got.size(); ++j) names.push_back(a.joint_names[j] + ":" + name_in(b, got[j].node));
  EXPECT_EQ(names, (std::vector<std::string>{"pelvis:hips", "s1:x1", "left:left", "s2:x3", "top:head", "hat:hat"}));
  const std::vector<Counterpart> back = pair_rigs(b, a);
  EXPECT_EQ(b.joint_names[2], "x2");
  EXPECT_EQ(name_in(a, back[2].node) + name_in(a, back[2].other), "s1s2");
  EXPECT_EQ(back[2].share, 0.5) << "the middle one is between the two";
}

}  // namespace
}  // namespace marrow::cook
