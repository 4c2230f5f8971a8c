// Other rigs on the command line: maps of joints that are wrong, and pose maps in the file.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

class CliRigMaps : public ::testing::Test {
 protected:
  std::string in(const std::string& name) const { return folder_ / name; }
  Ran run(const std::vector<std::string>& arguments, int code = 0) const {
    Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, code) << arguments[0] << " " << arguments[1] << "\n" << ran.err;
    return ran;
  }
  nlohmann::json info(const std::string& file) const {
    return nlohmann::json::parse(run({"info", in(file), "--json"}).out);
  }
  std::string body_ = in_golden("roles.gltf");
  TemporaryFolder folder_;
};

struct WrongMap {
  const char *text, *where, *words;
};
constexpr WrongMap kWrong[] = {
    {"[joints]\nspine = \"spine\"\nspin = \"head\"\n", "3:8", "no joint \"spin\""},
    {"[joints]\nspine = \"spin\"\n", "2:9", "no joint \"spin\""},
    {"[joints]\nspine = [\"spine\", \"had\", 0.5]\n", "2:9", "no joint \"had\""},
    {"[joints]\nspine = [\"spine\", \"head\", 2]\n", "2:9", "a share that is not from 0 to 1"},
    {"[joints]\nspine = \"spine\"\nspine = \"head\"\n", "3:9", "no TOML"},
    {"[joints]\nspine = \"head\"\n\nhead = \"spine\"\n", "4:8", "\"head\" hangs below \"spine\", but \"spine\" above"},
    {"[joints]\nspine = \n", "2:9", "no TOML"},
    {"no map at all", "1:4", "no TOML"},
    {"[joints]\n", "1:1", "a map of no joints"},
    {"[joint]\nspine = \"spine\"\n", "1:2", "unknown setting \"joint\""},
};

TEST_F(CliRigMaps, WrongOnesAreLocatedAndNothingIsWritten) {
  for (const char* const option : {"--retarget", "--pose-map"})
    for (const WrongMap& wrong : kWrong) {
      write_text(in("map.toml"), wrong.text);
      const Ran ran = run({"cook", body_, option, body_ + "=" + in("map.toml"), "-o", in("out.mrw")}, kUsage);
      ASSERT_EQ(ran.complaints().size(), 1u) << ran.err;
      const std::string line = ran.complaints()[0];
      EXPECT_NE(line.find(in("map.toml") + ": " + wrong.where + ": "), std::string::npos) << wrong.where << "\n"
                                                                                          << line;
      EXPECT_NE(line.find(wrong.words), std::string::npos) << wrong.words << "\n" << line;
      EXPECT_EQ(folder_.listing(), std::vector<std::string>{"map.toml"});
    }
}

TEST_F(CliRigMaps, FilesThatThereAreNotAndOthersAreSaid) {
  write_text(in("bad.glb"), "this is no glTF");
  for (const char* const option : {"--retarget", "--pose-map"}) {
    const auto complaint = [&](const std::string& value, int code) {
      const Ran ran = run({"cook", body_, option, value, "-o", in("out.mrw")}, code);
      return ran.complaints().empty() ? std::string() : ran.complaints()[0];
    };
    EXPECT_NE(complaint(in("none.glb"), kIo).find("none.glb"), std::string::npos);
    EXPECT_NE(complaint(body_ + "=" + in("none.toml"), kIo).find("none.toml"), std::string::npos);
    EXPECT_NE(complaint(in("bad.glb"), kInvalid).find("bad.glb"), std::string::npos);
    EXPECT_NE(complaint(body_ + "=", kUsage).find("names no file or no map"), std::string::npos);
    EXPECT_NE(complaint(in_golden("tiny.gltf"), kInvalid).find("no joint is called as in"), std::string::npos);
  }
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"bad.glb"});
}

// The map says of which skeleton it is, however the rig is given.
TEST_F(CliRigMaps, PoseMapsKnowTheirRig) {
  run({"sample", "-o", in("newt.glb")});
  run({"cook", in("newt.glb"), "-o", in("newt.mrw")});
  run({"cook", in_source("tests/fuzz/seeds/walk.bvh"), "-o", in("walk.mrw")});
  run({"cook", body_, "-o", in("hero.mrw"), "--pose-map", in("newt.glb"), "--pose-map",
       in_source("tests/fuzz/seeds/walk.bvh")});
  run({"cook", body_, "-o", in("other.mrw"), "--pose-map", in("newt.mrw"), "--pose-map", in("walk.mrw")});
  const nlohmann::json hero = info("hero.mrw"), other = info("other.mrw");
  ASSERT_EQ(hero.at("pose_maps").size(), 2u);
  EXPECT_EQ(hero.at("pose_maps").at(0).at("name"), "newt");
  for (const nlohmann::json& file : {hero, other}) {
    EXPECT_EQ(file.at("pose_maps").at(0).at("rig_hash"), info("newt.mrw").at("skeletons").at(0).at("hash"));
    EXPECT_GE(file.at("pose_maps").at(0).at("joints"), 10);
    EXPECT_EQ(file.at("pose_maps").at(1).at("rig_hash"), info("walk.mrw").at("skeletons").at(0).at("hash"));
  }
  const std::string said = run({"info", in("hero.mrw")}).out;
  EXPECT_NE(said.find("pose map \"newt\""), std::string::npos) << said;
  EXPECT_NE(said.find("joints turn as those of a rig of"), std::string::npos) << said;
}

TEST_F(CliRigMaps, SettingsAndTheCacheKnowPoseMaps) {
  write_text(in("hero.gltf"), read_text(body_));
  write_text(in("map.toml"), "[joints]\nspine = \"spine\"\n");
  write_text(in("marrow.toml"), "pose-map = ['" + in("hero.gltf") + "=" + in("map.toml") + "']\n");
  const std::vector<std::string> cook = {"cook", in("hero.gltf"), "-o", in("hero.mrw"), "--cache", in("cache")};
  run(cook);
  EXPECT_EQ(info("hero.mrw").at("pose_maps").at(0).at("joints"), 1);
  write_text(in("map.toml"), "[joints]\nspine = \"spine\"\nhead = \"head\"\n");
  run(cook);
  EXPECT_EQ(info("hero.mrw").at("pose_maps").at(0).at("joints"), 2) << "the map is part of the key";
}

TEST_F(CliRigMaps, WhatHasNoPoseMapsRefusesThem) {
  run({"cook", body_, "-o", in("body.mrw")});
  const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> all = {"cook", body_, "-o", in("out.mrw"), "--pose-map", body_};
    all.insert(all.end(), more.begin(), more.end());
    EXPECT_NE(run(all, kUsage).err.find(words), std::string::npos) << words;
  };
  refused({"--clips-only"}, "--pose-map for a clip pack");
  refused({"--pose-map", body_}, "a second time");
  write_text(in("roles.gltf"), read_text(body_));
  refused({"--pose-map", in("roles.gltf")}, "a second rig called \"roles\"");
  EXPECT_EQ(folder_.listing(), (std::vector<std::string>{"body.mrw", "roles.gltf"}));
}

}  // namespace
}  // namespace marrow::test
