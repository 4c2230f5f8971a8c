// `marrow cook --images` and `--keep`, and what `marrow info` says of them.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/cookings.h"
#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

// The golden file's source, in a folder where its picture may or may not be.
class Looks : public ::testing::Test {
 protected:
  Looks() {
    fs::create_directory(folder_ / "source");
    fs::copy_file(golden("looks.gltf"), folder_ / "source/looks.gltf");
  }
  static std::string golden(const std::string& name) { return in_golden(name); }
  void add_picture() const { fs::copy_file(golden("dot.png"), folder_ / "source/dot.png"); }
  Ran cook(std::vector<std::string> options) const {
    options.insert(options.begin(), {"cook", folder_ / "source/looks.gltf", "-o", folder_ / "out.mrw"});
    return run_marrow(options);
  }
  nlohmann::json info() const { return nlohmann::json::parse(run_marrow({"info", folder_ / "out.mrw", "--json"}).out); }
  bool cooked() const { return fs::exists(folder_ / "out.mrw"); }

  TemporaryFolder folder_;
};

TEST_F(Looks, ReferenceIsTheDefaultAndReadsNoPicture) {
  const Ran ran = cook({});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("images-by-name: 1 image stays in the source: 76 bytes; --images embed takes it along"),
            std::string::npos)
      << "one is a data URI: " << ran.err;
  const nlohmann::json r = info();
  ASSERT_EQ(r["images"].size(), 2u);
  EXPECT_EQ(r["images"][0]["name"], "corners");
  EXPECT_EQ(r["images"][1]["uri"], "dot.png");
  EXPECT_EQ(r["images"][1]["embedded_bytes"], 0);
  ASSERT_EQ(r["materials"].size(), 2u);
  EXPECT_EQ(r["materials"][0]["textures"][1]["role"], "normal");
  EXPECT_EQ(r["meshes"][2]["material"], "plain");
}

// By reference; the fallback lies inside the source, so that only a source beside the cooked file shows it.
TEST_F(Looks, WhatIsNotDecodedHasAFallbackAndGoesBackToGltf) {
  const std::string source = shining_gltf(folder_), mrw = folder_ / "shining.mrw", glb = folder_ / "back.glb";
  ASSERT_EQ(run_marrow({"cook", source, "-o", mrw}).code, 0);
  const nlohmann::json r = nlohmann::json::parse(run_marrow({"info", mrw, "--json"}).out);
  EXPECT_EQ(r["images"][1]["format"], "webp") << r["images"].dump();
  EXPECT_EQ(r["images"][1]["fallback"], 0);
  const std::string text = run_marrow({"info", mrw}).out;
  EXPECT_NE(text.find("unlit, emits 6 3 0"), std::string::npos) << text;
  EXPECT_NE(text.find(", fallback image 0\n"), std::string::npos) << text;

  ASSERT_EQ(run_marrow({"export", mrw, "-o", glb}).code, 0);
  ASSERT_EQ(run_marrow({"cook", glb, "-o", folder_ / "again.mrw"}).code, 0);
  const nlohmann::json again = nlohmann::json::parse(run_marrow({"info", folder_ / "again.mrw", "--json"}).out);
  EXPECT_EQ(again["materials"].back()["emissive"], nlohmann::json({6, 3, 0}));
  EXPECT_EQ(again["materials"].back()["unlit"], true);
  EXPECT_EQ(again["images"][0]["format"], "webp") << "its fallback was known by name alone";
#ifdef MARROW_HAS_GLES
  const Ran drawn = run_marrow({"render", mrw, "-o", folder_ / "shining.png", "--size", "64x64"});
  EXPECT_EQ(drawn.code, 0);
  EXPECT_EQ(drawn.err.find("small"), std::string::npos) << "the fallback is shown: " << drawn.err;
  fs::remove(source);
  const Ran bare = run_marrow({"render", mrw, "-o", folder_ / "bare.png", "--size", "64x64"});
  EXPECT_NE(bare.err.find("image 0 \"corners\": drawn without"), std::string::npos) << bare.err;
#endif
}

TEST_F(Looks, EmbedCarriesThePictures) {
  add_picture();
  const Ran ran = cook({"--images", "embed"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(info()["images"][1]["embedded_bytes"], fs::file_size(golden("dot.png")));
  const std::string file = read_text(folder_ / "out.mrw");
  EXPECT_NE(file.find(read_text(golden("dot.png"))), std::string::npos) << "as it is";
  const std::string text = run_marrow({"info", folder_ / "out.mrw"}).out;
  EXPECT_NE(text.find("material 0 \"painted\": mask, base colour image 0, normal image 1"), std::string::npos) << text;
  EXPECT_NE(text.find("image 0 \"corners\": png, 76 bytes"), std::string::npos) << text;
}

TEST_F(Looks, EmbedNeedsThePictures) {
  const Ran ran = cook({"--images", "embed"});
  EXPECT_EQ(ran.code, 2);
  ASSERT_EQ(ran.complaints().size(), 1u) << ran.err;
  EXPECT_NE(ran.err.find("/images/1/uri: no such file"), std::string::npos) << ran.err;
  EXPECT_FALSE(cooked());
}

// A link that leads out of the source's folder is as bad as a path that does.
TEST_F(Looks, EmbedDoesNotFollowLinksOut) {
  fs::create_symlink(golden("dot.png"), folder_ / "source/dot.png");
  const Ran ran = cook({"--images", "embed"});
  EXPECT_EQ(ran.code, 3);
  EXPECT_NE(ran.err.find("/images/1/uri: URI not allowed"), std::string::npos) << ran.err;
  EXPECT_FALSE(cooked());
}

TEST_F(Looks, NoneNamesNoPicture) {
  ASSERT_EQ(cook({"--images", "none"}).code, 0);
  EXPECT_TRUE(info()["images"].empty());
  EXPECT_EQ(info()["materials"].size(), 2u) << "mask and blend remain";
}

TEST_F(Looks, UnknownWordsAreUsageErrors) {
  EXPECT_EQ(cook({"--images", "inline"}).code, 1);
  EXPECT_EQ(cook({"--images"}).code, 1);
  EXPECT_EQ(cook({"--keep"}).code, 1);
  EXPECT_FALSE(cooked());
}

TEST_F(Looks, KeepIsRepeatable) {
  const Ran ran = cook({"--keep", "socket*", "--keep", "loc?tor", "--keep", "no such", "--report", folder_ / "r.json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("keep-fits-nothing"), std::string::npos);
  const nlohmann::json report = nlohmann::json::parse(read_text(folder_ / "r.json"));
  EXPECT_EQ(report["keep"][0]["nodes"][0], "socket.tip");
  EXPECT_EQ(report["keep"][1]["nodes"][0], "locator");
  EXPECT_TRUE(report["keep"][2]["nodes"].empty());
  const nlohmann::json r = info();
  ASSERT_EQ(r["nodes"].size(), 2u);
  EXPECT_EQ(r["nodes"][0]["joint_name"], "panel");
  EXPECT_EQ(r["nodes"][0]["properties"].size(), 5u);
  EXPECT_EQ(r["nodes"][1]["joint"], nullptr);
  const std::string text = run_marrow({"info", folder_ / "out.mrw"}).out;
  EXPECT_NE(text.find("node 0 \"socket.tip\": on joint \"panel\"\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  \"door/open\" = false\n"), std::string::npos) << text;
  EXPECT_NE(text.find("node 1 \"locator\": fixed in the scene\n"), std::string::npos) << text;
}

// Counted without decoding.
TEST(LooksLeftBehind, PaddingAloneIsNoBytes) {
  const TemporaryFolder folder;
  write_text(folder / "t.gltf", R"({"asset":{"version":"2.0"},"images":[{"uri":"data:image/png;base64,=="}],
    "textures":[{"source":0}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
    "scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"material":0,"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
    "uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const Ran ran = run_marrow({"cook", folder / "t.gltf", "-o", folder / "t.mrw"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("1 image stays in the source: 0 bytes;"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace marrow::test
