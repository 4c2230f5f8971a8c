// Motion capture on the command line: alone, onto a character, among other files, and refused.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

// The arm of tiny.gltf, called otherwise, and of twice its size.
constexpr const char* kArm = R"(HIERARCHY
ROOT cap:Shoulder
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT cap:Wrist
  {
    OFFSET 0 2 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT cap:Tail
    {
      OFFSET 0 2 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 0 1 0
      }
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.5
0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 90 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0
)";

class CliBvh : public ::testing::Test {
 protected:
  CliBvh() { write_text(in("walk.bvh"), kArm); }
  std::string in(const std::string& name) const { return folder_ / name; }
  static nlohmann::json described(const std::string& path) {
    return nlohmann::json::parse(run_marrow({"info", path, "--json"}).out);
  }
  // One line, with all of these texts in it, and no output.
  void expect_failure(const std::vector<std::string>& arguments, int code, const std::vector<std::string>& texts) {
    const std::vector<std::string> before = folder_.listing();
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, code) << ran.err;
    EXPECT_EQ(ran.complaints().size(), 1u) << ran.err;
    for (const std::string& text : texts) EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
    EXPECT_EQ(folder_.listing(), before);
  }
  TemporaryFolder folder_;
};

// Its root goes 0.3 m aside and 0.4 m ahead in a second; the other ends where it began.
TEST_F(CliBvh, InfoSaysHowFastAClipMoves) {
  std::string text = kArm;
  text.replace(text.rfind("\n0 0 0 "), 7, "\n0.3 0 0.4 ");
  write_text(in("gone.bvh"), text);
  for (const std::string name : {"walk", "gone"})
    ASSERT_EQ(run_marrow({"cook", in(name + ".bvh"), "-o", in(name + ".mrw")}).code, 0);
  EXPECT_NEAR(described(in("gone.mrw")).at("clips")[0].at("motion").at("speed_m_s").get<double>(), 0.5, 1e-3);
  EXPECT_TRUE(described(in("walk.mrw")).at("clips")[0].at("motion").at("speed_m_s").is_null());
  EXPECT_NE(run_marrow({"info", in("gone.mrw")}).out.find(", moves at 0.5 m/s"), std::string::npos);
  EXPECT_EQ(run_marrow({"info", in("walk.mrw")}).out.find("m/s"), std::string::npos);
}

TEST_F(CliBvh, AloneItIsASkeletonAndAClip) {
  const Ran ran = run_marrow({"cook", in("walk.bvh"), "-o", in("walk.mrw")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  const nlohmann::json info = described(in("walk.mrw"));
  ASSERT_EQ(info.at("skeletons").size(), 1u);
  EXPECT_EQ(info["skeletons"][0].at("joints"), 3);
  ASSERT_EQ(info.at("clips").size(), 1u);
  EXPECT_EQ(info["clips"][0].at("name"), "walk");
  EXPECT_EQ(info["clips"][0].at("duration_s"), 1.0);
}

TEST_F(CliBvh, OntoACharacterItIsAClipPack) {
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", in("arm.mrw")}).code, 0);
  const Ran ran = run_marrow({"cook", in("walk.bvh"), "--skeleton", in("arm.mrw"), "-o", in("walk.mrw")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("walk.bvh: HIERARCHY: warning: no-such-joint: 1 of 3 joints have no counterpart in"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("cap:Tail"), std::string::npos) << ran.err;
  const nlohmann::json info = described(in("walk.mrw"));
  EXPECT_TRUE(info.at("skeletons").empty());
  EXPECT_EQ(info.at("references").at(0).at("hash"), described(in("arm.mrw")).at("skeletons").at(0).at("hash"));
  EXPECT_EQ(run_marrow({"pose", in("arm.mrw"), "--clips", in("walk.mrw"), "--clip", "walk", "--time", "0.5", "-o",
                        in("arm.obj")})
                .code,
            0);
  // The character as glTF serves as well.
  EXPECT_EQ(run_marrow({"cook", in("walk.bvh"), "--skeleton", tiny_gltf(), "-o", in("same.mrw")}).code, 0);
  EXPECT_TRUE(read_text(in("walk.mrw")) == read_text(in("same.mrw")));
}

TEST_F(CliBvh, FoldersAndSettingsTakeIt) {
  std::filesystem::create_directory(in("takes"));
  std::filesystem::rename(in("walk.bvh"), in("takes/walk.bvh"));
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", in("arm.mrw")}).code, 0);
  EXPECT_EQ(run_marrow({"cook", in("takes"), "-o", in("out/")}).code, 0);
  EXPECT_EQ(described(in("out/walk.mrw")).at("skeletons").size(), 1u);
  write_text(in("takes/marrow.toml"), "[[file]]\nmatch = \"*.bvh\"\nskeleton = \"" + in("arm.mrw") + "\"\n");
  EXPECT_EQ(run_marrow({"cook", in("takes"), "-o", in("out/")}).code, 0);
  EXPECT_TRUE(described(in("out/walk.mrw")).at("skeletons").empty());
}

TEST_F(CliBvh, WhatDoesNotFitIsSaid) {
  expect_failure({"info", in("walk.bvh")}, kInvalid, {"walk.bvh: this is BVH, not a cooked file: cook it first"});
  expect_failure({"compare", in("walk.bvh"), "-o", in("x.html")}, kInvalid, {"motion capture (BVH)", "no mesh"});
  expect_failure({"cook", tiny_gltf(), "-o", in("x.bvh")}, kUsage, {"name ends with .mrw"});
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", in("arm.mrw")}).code, 0);
  std::string text = kArm;
  for (std::size_t at = 0; (at = text.find("cap:", at)) != std::string::npos;) text.replace(at, 4, "X_");
  write_text(in("x.bvh"), text);
  expect_failure({"cook", in("x.bvh"), "--skeleton", in("arm.mrw"), "-o", in("x.mrw")}, kInvalid,
                 {"x.bvh: HIERARCHY: no joint is called as in", "X_Shoulder", "shoulder"});
  write_text(in("x.bvh"), std::string(kArm).substr(0, std::string(kArm).find("End Site")));
  expect_failure({"cook", in("x.bvh"), "-o", in("x.mrw")}, kInvalid, {"x.bvh: line ", "the file ends too soon"});
}

}  // namespace
}  // namespace marrow::test
