// Clips apart from their character, on the command line: made, shown, played, and refused where they do not fit.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

std::string dance_gltf() {
  return in_golden("dance.gltf");
}

class CliClipPack : public ::testing::Test {
 protected:
  std::string in(const std::string& name) const { return folder_ / name; }
  void run(const std::vector<std::string>& arguments) const {
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << arguments[0] << " " << arguments[1] << "\n" << ran.err;
  }
  // The one line that is said, without the warnings.
  std::string complaint(const std::vector<std::string>& arguments, int code) const {
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, code) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.complaints().size(), 1u) << ran.err;
    return ran.complaints().empty() ? "" : ran.complaints()[0];
  }
  TemporaryFolder folder_;
};

TEST_F(CliClipPack, PlaysAsTheClipsCookedWithTheirCharacter) {
  run({"sample", "-o", in("newt.glb")});
  run({"cook", in("newt.glb"), "-o", in("newt.mrw")});
  run({"cook", in("newt.glb"), "-o", in("pack.mrw"), "--clips-only", "--skeleton", in("newt.mrw")});
  const std::string pack = read_text(in("pack.mrw"));
  EXPECT_LT(pack.size(), read_text(in("newt.mrw")).size());
  const auto whole_info = nlohmann::json::parse(run_marrow({"info", in("newt.mrw"), "--json"}).out);
  const auto info = nlohmann::json::parse(run_marrow({"info", in("pack.mrw"), "--json"}).out);
  EXPECT_TRUE(info.at("skeletons").empty());
  EXPECT_TRUE(info.at("meshes").empty());
  EXPECT_EQ(info.at("references").at(0).at("hash"), whole_info.at("skeletons").at(0).at("hash"));
  EXPECT_EQ(info.at("references").at(0).at("joint_list"), whole_info.at("skeletons").at(0).at("joint_list"));
  auto clips = info.at("clips"), whole_clips = whole_info.at("clips");
  for (const auto& clip : clips) EXPECT_TRUE(clip.at("bounds").empty()) << "a pack has no meshes that could reach";
  for (auto* list : {&clips, &whole_clips})
    for (auto& clip : *list) {
      clip.erase("bytes");  // fewer in a packed file
      clip.erase("bounds");
    }
  EXPECT_EQ(clips, whole_clips);
  std::size_t compared = 0;
  for (const auto& clip : info.at("clips")) {
    const auto name = clip.at("name").get<std::string>();
    run({"pose", in("newt.mrw"), "--clip", name, "--time", "0.37", "-o", in("a.bin")});
    run({"pose", in("newt.mrw"), "--clips", in("pack.mrw"), "--clip", name, "--time", "0.37", "-o", in("b.bin")});
    const std::string own = read_text(in("a.bin"));
    EXPECT_GT(own.size(), 1000u);
    EXPECT_TRUE(own == read_text(in("b.bin"))) << name;
    ++compared;
  }
  EXPECT_GE(compared, 3u);
  EXPECT_NE(run_marrow({"info", in("pack.mrw")}).out.find("clip pack for skeleton"), std::string::npos);
#ifdef MARROW_HAS_GLES
  const std::vector<std::string> render = {"--clip", "0", "--time", "0.2", "--size", "64x64"};
  std::vector<std::string> own = {"render", in("newt.mrw"), "-o", in("a.png")};
  std::vector<std::string> apart = {"render", in("newt.mrw"), "-o", in("b.png"), "--clips", in("pack.mrw")};
  for (std::vector<std::string>* arguments : {&own, &apart}) {
    arguments->insert(arguments->end(), render.begin(), render.end());
    run(*arguments);
  }
  EXPECT_TRUE(read_text(in("a.png")) == read_text(in("b.png")));
#endif
}

TEST_F(CliClipPack, WhereVerticesDoNotCountTheFilesOwnJointsDoAsWell) {
  run({"cook", tiny_gltf(), "-o", in("arm.mrw")});
  run({"cook", tiny_gltf(), "-o", in("own.mrw"), "--clips-only", "--clip-shell", "3cm"});
  run({"cook", tiny_gltf(), "-o", in("onto.mrw"), "--clips-only", "--clip-shell", "3cm", "--skeleton", in("arm.mrw")});
  EXPECT_TRUE(read_text(in("onto.mrw")) == read_text(in("own.mrw")));
}

TEST_F(CliClipPack, WhatDoesNotFitIsSaidByJoint) {
  run({"cook", tiny_gltf(), "-o", in("arm.mrw")});
  run({"cook", dance_gltf(), "-o", in("dance.mrw"), "--clips-only"});
  const std::string line =
      complaint({"pose", in("arm.mrw"), "--clips", in("dance.mrw"), "--clip", "0", "-o", in("p.bin")}, 3);
  for (const char* word : {"dance.mrw", "arm.mrw", "\"joint3\" is missing", "\"elbow\" is not in the pack"})
    EXPECT_NE(line.find(word), std::string::npos) << line;
  EXPECT_EQ(folder_.listing(), (std::vector<std::string>{"arm.mrw", "dance.mrw"})) << "no output";

  // The same arm with its wrist a little further out.
  std::string longer = read_text(tiny_gltf());
  const std::string wrist = R"("wrist", "children": [5], "translation": [0, 1, 0])";
  ASSERT_NE(longer.find(wrist), std::string::npos);
  longer.replace(longer.find(wrist), wrist.size(), R"("wrist", "children": [5], "translation": [0, 1.5, 0])");
  write_text(in("longer.gltf"), longer);
  run({"cook", in("longer.gltf"), "-o", in("longer.mrw"), "--clips-only"});
  const std::string other =
      complaint({"pose", in("arm.mrw"), "--clips", in("longer.mrw"), "--clip", "wave", "-o", in("p.bin")}, 3);
  EXPECT_NE(other.find("\"wrist\" has another rest pose"), std::string::npos) << other;
  EXPECT_EQ(other.find("elbow"), std::string::npos) << other;
  // Made for the arm it fits.
  run({"cook", in("longer.gltf"), "-o", in("longer.mrw"), "--clips-only", "--skeleton", in("arm.mrw")});
  run({"pose", in("arm.mrw"), "--clips", in("longer.mrw"), "--clip", "wave", "-o", in("p.bin")});
}

TEST_F(CliClipPack, NodesThatTheCharacterLacksAreNamed) {
  run({"cook", tiny_gltf(), "-o", in("arm.mrw")});
  const std::string line =
      complaint({"cook", dance_gltf(), "-o", in("dance.mrw"), "--clips-only", "--skeleton", in("arm.mrw")}, 3);
  for (const char* word : {"dance.gltf: /nodes/", "arm.mrw", "\"joint3\""})
    EXPECT_NE(line.find(word), std::string::npos) << line;
}

TEST_F(CliClipPack, WrongCallsSayWhatToDo) {
  run({"cook", tiny_gltf(), "-o", in("arm.mrw")});
  run({"cook", tiny_gltf(), "-o", in("pack.mrw"), "--clips-only"});
  const std::string out = in("p.bin");
  // Keys as they are: what the character's meshes let keys be rounded by is known by --skeleton alone.
  run({"cook", tiny_gltf(), "-o", in("raw.mrw"), "--clips-only", "--clip-codec", "raw"});
  run({"cook", tiny_gltf(), "-o", in("onto_gltf.mrw"), "--clips-only", "--clip-codec", "raw", "--skeleton",
       tiny_gltf()});
  EXPECT_EQ(read_text(in("onto_gltf.mrw")), read_text(in("raw.mrw"))) << "a character need not be cooked yet";
  EXPECT_NE(complaint({"pose", in("pack.mrw"), "-o", out}, 3).find("--clips"), std::string::npos);
  EXPECT_NE(complaint({"pose", in("arm.mrw"), "--clips", in("pack.mrw"), "-o", out}, 1).find("--clip"),
            std::string::npos);
  EXPECT_NE(
      complaint({"pose", in("arm.mrw"), "--clips", in("arm.mrw"), "--clip", "wave", "-o", out}, 3).find("--clips-only"),
      std::string::npos);
  EXPECT_NE(complaint({"pose", in("arm.mrw"), "--clips", in("pack.mrw"), "--clip", "fly", "-o", out}, 1).find("wave"),
            std::string::npos);
  complaint({"cook", tiny_gltf(), "-o", in("bad.mrw"), "--clips-only", "--skeleton", in("pack.mrw")}, 3);
  complaint({"pose", in("arm.mrw"), "--clips", in("none.mrw"), "--clip", "wave", "-o", out}, 2);
}

TEST_F(CliClipPack, AFileWithoutMeshesIsCookedAndSaysSo) {
  write_text(in("rig.gltf"), R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"name":"hips","children":[1]},{"name":"spine"}],"skins":[{"joints":[0,1]}]})");
  const Ran ran = run_marrow({"cook", in("rig.gltf"), "-o", in("rig.mrw")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("--clips-only"), std::string::npos) << ran.err;
  const auto info = nlohmann::json::parse(run_marrow({"info", in("rig.mrw"), "--json"}).out);
  EXPECT_EQ(info.at("skeletons").at(0).at("joints"), 2);
  EXPECT_NE(complaint({"cook", in("rig.gltf"), "-o", in("pack.mrw"), "--clips-only"}, 3).find("/animations"),
            std::string::npos);
}

}  // namespace
}  // namespace marrow::test
