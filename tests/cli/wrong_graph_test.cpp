// What `marrow cook --graph` says of wrong graphs, and that nothing is written then.
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(CliGraph, OfAWrongGraphNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string graph = folder / "hero.anim.toml", out = folder / "hero.mrw";
  const auto cook = [&](const std::string& text) {
    std::ofstream(graph) << text;
    return run_marrow({"cook", in_golden("tiny.gltf"), "--mesh-codec", "none", "--graph", graph, "-o", out});
  };
  const std::string right =
      "output = 'move'\n[parameters]\nspeed = { type = 'number', range = [0, 1] }\n[node.move]\n"
      "type = 'space'\nby = 'speed'\npoints = [ { at = 0, pose = 'point' }, { pose = 'wave' } ]\n";
  struct Wrong {
    const char *part, *instead, *says;
  };
  const Wrong wrong[] = {
      {"output = 'move'", "output = 'move", "hero.anim.toml: 1:15: no TOML"},
      {"'number'", "'numbr'", "hero.anim.toml: 3:18: there is no type \"numbr\": did you mean \"number\"?"},
      {"by = 'speed'", "by = 'sped'", "hero.anim.toml: 6:6: there is no parameter \"sped\": did you mean \"speed\"?"},
      {"'point'", "'move'", "hero.anim.toml: 7:29: \"move\" is made of itself"},
      {"at = 0", "at = 1e300", "hero.anim.toml: 7:19: \"at\" must be a number"}};
  for (const Wrong& w : wrong) {
    std::string text = right;
    text.replace(text.find(w.part), std::string(w.part).size(), w.instead);
    const Ran ran = cook(text);
    EXPECT_EQ(ran.code, kUsage) << w.says;
    ASSERT_EQ(ran.complaints().size(), 1u) << ran.err;
    EXPECT_NE(ran.complaints()[0].find(w.says), std::string::npos) << ran.err;
    EXPECT_EQ(folder.listing(), std::vector<std::string>{"hero.anim.toml"}) << w.says;
  }
  const Ran ran = cook(right);
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string before = contents(out);
  EXPECT_EQ(cook("output = 1\n").code, kUsage);
  EXPECT_EQ(contents(out), before);
  EXPECT_EQ(folder.listing(), (std::vector<std::string>{"hero.anim.toml", "hero.mrw"}));
}

// It may come from a clip pack, or be a typo.
TEST(CliGraph, AMissingClipIsAWarning) {
  const TemporaryFolder folder;
  const std::string graph = folder / "hero.anim.toml";
  std::ofstream(graph) << "output = 'waev'\n";
  const Ran ran =
      run_marrow({"cook", in_golden("tiny.gltf"), "--mesh-codec", "none", "--graph", graph, "-o", folder / "hero.mrw"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("no clip here is called \"waev\": did you mean \"wave\"?"), std::string::npos) << ran.err;
}

// "wave" goes 0.4 m/s, "point" stays where it is: a space that asks it for its speed has it at 0.
TEST(CliGraph, AClipWithoutASpeedIsAWarning) {
  const TemporaryFolder folder;
  const std::string graph = folder / "hero.anim.toml";
  std::ofstream(graph)
      << "output = 'm'\n[parameters]\nv = { type = 'number', range = [0, 1] }\n[node.m]\ntype = 'space'\n"
         "by = 'v'\npoints = [ { pose = 'wave' }, { pose = 'point' }, { at = 1, pose = 'point' } ]\n";
  const Ran ran =
      run_marrow({"cook", in_golden("tiny.gltf"), "--mesh-codec", "none", "--graph", graph, "-o", folder / "hero.mrw"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("no-speed: \"point\" moves at 0 m/s"), std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("no-speed: \"wave\""), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace marrow::test
