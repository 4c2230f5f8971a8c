// Clips of one name on two skeletons: posed and exported together or apart, of a file and of a pack.
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "road/reference.h"

namespace marrow::test {
namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string out(values.size() * sizeof(T), '\0');
  std::memcpy(out.data(), values.data(), out.size());
  return out;
}

// Two triangles, each a skeleton of its own: "walk" takes red a metre along x in 1 s, another "walk" blue two metres
// along y in 2 s.
std::string two_walks() {
  nlohmann::json j = nlohmann::json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
    "nodes":[{"name":"red","mesh":0},{"name":"blue","mesh":0}],
    "meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[
      {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
      {"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]},
      {"bufferView":2,"componentType":5126,"count":2,"type":"VEC3"},
      {"bufferView":3,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[2]},
      {"bufferView":4,"componentType":5126,"count":2,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":8},
      {"buffer":0,"byteOffset":44,"byteLength":24},{"buffer":0,"byteOffset":68,"byteLength":8},
      {"buffer":0,"byteOffset":76,"byteLength":24}],
    "buffers":[{"byteLength":100,"uri":"two.bin"}]})");
  for (int i = 0; i < 2; ++i)
    j["animations"].push_back({{"name", "walk"},
                               {"samplers", {{{"input", 1 + 2 * i}, {"output", 2 + 2 * i}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", i}, {"path", "translation"}}}}}}});
  return j.dump();
}

class SameNames : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    write_text(in("two.bin"),
               bytes_of<float>({0,      0, 0, 1, 0, 0, 0, 1, 0, /**/ 0, 1, /**/ 0, 0, 0, 1, 0, 0, /**/ 0, 2,
                                /**/ 0, 0, 0, 0, 2, 0}));
    write_text(in("two.gltf"), two_walks());
    run({"cook", in("two.gltf"), "-o", in("two.mrw"), "--mesh-codec", "none"});
    run({"cook", in("two.gltf"), "-o", in("pack.mrw"), "--clips-only", "--skeleton", in("two.mrw")});
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::string in(const std::string& name) { return *folder_ / name; }
  static void run(const std::vector<std::string>& arguments) {
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ::testing::PrintToString(arguments) << '\n' << ran.err;
  }
  // Where the first vertex of each triangle is at 1 s: x of red, y of blue.
  static std::vector<float> at_one_second(const std::string& clip, bool from_pack) {
    std::vector<std::string> arguments = {"pose", in("two.mrw"), "--clip", clip, "--time", "1", "-o", in("p.bin")};
    if (from_pack) arguments.insert(arguments.end(), {"--clips", in("pack.mrw")});
    run(arguments);
    const std::string bytes = read_text(in("p.bin"));
    std::vector<float> all(18);
    EXPECT_EQ(bytes.size(), 72u);
    std::memcpy(all.data(), bytes.data(), std::min<std::size_t>(bytes.size(), 72));
    return {all[0], all[10]};
  }

 private:
  static TemporaryFolder* folder_;
};

TemporaryFolder* SameNames::folder_ = nullptr;

TEST_F(SameNames, ArePosedTogetherOrApart) {
  for (const bool from_pack : {false, true}) {
    const auto expect_at = [&](const std::string& clip, float red, float blue) {
      const std::vector<float> at = at_one_second(clip, from_pack);
      EXPECT_NEAR(at[0], red, 2e-4f) << clip << from_pack;
      EXPECT_NEAR(at[1], blue, 2e-4f) << clip << from_pack;
    };
    expect_at("walk", 1, 1);
    expect_at("1", 1, 1);
    expect_at("walk@red", 1, 0);
    expect_at("walk@blue", 0, 1);
    expect_at("1@1", 0, 1);
    expect_at("walk@0", 1, 0);
  }
}

TEST_F(SameNames, WhatIsNotThereIsRefusedWithWhatIs) {
  for (const char* const clip : {"walk@green", "run@red", "1@red", "0@1", "walk@2", "@red"}) {
    const Ran ran = run_marrow({"pose", in("two.mrw"), "--clip", clip, "-o", in("p.bin")});
    EXPECT_EQ(ran.code, kUsage) << ran.err;
    EXPECT_NE(ran.err.find("there are 0 \"walk@red\", 1 \"walk@blue\""), std::string::npos) << ran.err;
  }
}

// Each animation moves its own node, for as long as in the source.
TEST_F(SameNames, AreExportedApart) {
  const auto expect_animations = [&](std::vector<std::string> options, const std::vector<int>& nodes) {
    options.insert(options.begin(), {"export", in("two.mrw"), "-o", in("out.glb")});
    run(options);
    const Reference exported(in("out.glb"));
    ASSERT_EQ(exported.source().animations.size(), nodes.size()) << ::testing::PrintToString(options);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const double end_s = nodes[a] == 0 ? 1 : 2;
      EXPECT_NEAR(exported.duration_s(a), end_s, 1e-6);
      const std::vector<Vec3> p = exported.at(a, end_s).positions;
      ASSERT_EQ(p.size(), 6u);
      EXPECT_NEAR(p[0][0], nodes[a] == 0 ? 1 : 0, 2e-4);
      EXPECT_NEAR(p[3][1], nodes[a] == 0 ? 0 : 2, 2e-4);
    }
  };
  expect_animations({}, {0, 1});
  expect_animations({"--clip", "walk@red"}, {0});
  expect_animations({"--clip", "walk@blue"}, {1});
  expect_animations({"--clip", "walk"}, {0, 1});
  expect_animations({"--clips", in("pack.mrw")}, {0, 1});
  expect_animations({"--clips", in("pack.mrw"), "--clip", "walk@blue"}, {1});
}

// Red goes a metre a second along x; blue rises, and so goes nowhere over the ground. The same in the file and in the
// pack.
TEST_F(SameNames, MoveOverTheGround) {
  const auto info = nlohmann::json::parse(run_marrow({"info", in("two.mrw"), in("pack.mrw"), "--json"}).out);
  for (std::size_t file = 0; file < 2; ++file) {
    const auto& clips = info.at(file).at("clips");
    EXPECT_NEAR(clips.at(0).at("motion").at("speed_m_s").get<double>(), 1, 1e-3);
    EXPECT_NEAR(clips.at(0).at("motion").at("heading").at(0).get<double>(), 1, 1e-6);
    EXPECT_TRUE(clips.at(1).at("motion").at("speed_m_s").is_null());
  }
  EXPECT_NE(run_marrow({"info", in("pack.mrw")}).out.find("moves at 1 m/s"), std::string::npos);
}

}  // namespace
}  // namespace marrow::test
