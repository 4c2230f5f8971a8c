// --between: clips played from frames, by hand.
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

// A triangle with a corner at its node, whose x is t³ at t = 0, 1, 2, 3, 4 s and on lines between.
void write_cubes(const std::string& gltf, const std::string& bin) {
  const float numbers[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2, 3, 4, 0, 0, 0, 1, 0, 0, 8, 0, 0, 27, 0, 0, 64, 0, 0};
  std::string bytes(sizeof numbers, '\0');
  std::memcpy(bytes.data(), numbers, sizeof numbers);
  write_text(bin, bytes);
  write_text(gltf, R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "n", "mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "animations": [{"name": "go", "samplers": [{"input": 1, "output": 2}],
                    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 5, "type": "SCALAR", "min": [0], "max": [4]},
      {"bufferView": 2, "componentType": 5126, "count": 5, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 20},
                    {"buffer": 0, "byteOffset": 56, "byteLength": 60}],
    "buffers": [{"byteLength": 116, "uri": "cubes.bin"}]})");
}

class Between : public ::testing::Test {
 protected:
  Between() {
    write_cubes(folder_ / "cubes.gltf", folder_ / "cubes.bin");
    cook(folder_ / "cubes.gltf", cubes_);
    cook(in_golden("face.gltf"), face_);
  }
  static void cook(const std::string& in, const std::string& out) {
    const Ran ran =
        run_marrow({"cook", in, "-o", out, "--mesh-codec", "none", "--clip-codec", "raw", "--keep-vertex-order"});
    EXPECT_EQ(ran.code, 0) << ran.err;
  }
  // Of the first vertex.
  double x(const std::string& file, const std::string& clip, const std::string& time,
           const std::vector<std::string>& how) const {
    std::vector<std::string> arguments = {"pose", file, "--clip", clip, "--time", time, "-o", folder_ / "p.obj"};
    arguments.insert(arguments.end(), how.begin(), how.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::ifstream in(folder_ / "p.obj");
    for (std::string line; std::getline(in, line);)
      if (line.rfind("v ", 0) == 0) return std::stod(line.substr(2));
    return -1;
  }
  double cube(const std::string& time, const std::string& kind) const {
    return x(cubes_, "go", time, {"--between", kind, "--frames", "1"});
  }
  TemporaryFolder folder_;
  std::string cubes_ = folder_ / "cubes.mrw", face_ = folder_ / "face.mrw";
};

// A second's frames are the keys 0, 1, 8, 27, 64.
TEST_F(Between, FramesAreInterpolatedAsAsked) {
  EXPECT_NEAR(cube("1.5", "linear"), 4.5, 1e-5);
  EXPECT_NEAR(cube("1.5", "quadratic"), 3.75, 1e-5) << "-0 / 8 + 3 · 1 / 4 + 3 · 8 / 8";
  EXPECT_NEAR(cube("1.5", "cubic"), 3.375, 1e-5) << "half of that and half of 3 · 1 / 8 + 3 · 8 / 4 - 27 / 8";
  EXPECT_NEAR(cube("1.5", "bicubic"), 3.375, 1e-5);
  // No frame is before the first interval, none behind the last.
  EXPECT_NEAR(cube("0.5", "linear"), 0.5, 1e-5);
  EXPECT_NEAR(cube("0.5", "quadratic"), -0.25, 1e-5) << "3 · 0 / 8 + 3 · 1 / 4 - 8 / 8";
  EXPECT_NEAR(cube("0.5", "cubic"), -0.25, 1e-5);
  for (const char* const kind : {"quadratic", "cubic"})
    EXPECT_NEAR(cube("3.5", kind), 43.25, 1e-4) << "-8 / 8 + 3 · 27 / 4 + 3 · 64 / 8";
  // Frames are met, and outside there are the ends.
  for (const char* const kind : {"linear", "quadratic", "cubic"}) {
    EXPECT_NEAR(cube("2", kind), 8, 1e-5);
    EXPECT_NEAR(cube("-3", kind), 0, 1e-5);
    EXPECT_NEAR(cube("9", kind), 64, 1e-4);
  }
}

// Two seconds apart: 0, 8, 64. Without --between the clip has its own lines.
TEST_F(Between, TheRateDecides) {
  EXPECT_NEAR(x(cubes_, "go", "1", {"--between", "linear", "--frames", "0.5"}), 4, 1e-5);
  EXPECT_NEAR(x(cubes_, "go", "1", {"--between", "cubic", "--frames", "0.5"}), 8 * 0.75 - 64.0 / 8, 1e-5);
  EXPECT_NEAR(x(cubes_, "go", "1.5", {}), 4.5, 1e-5);
}

// Half a second apart the smile is 0, 0.5, 1, 0, a decimetre along x, about which the head turns.
TEST_F(Between, MorphWeightsToo) {
  EXPECT_NEAR(x(face_, "speak", "1.25", {}), 0.05, 1e-5);
  EXPECT_NEAR(x(face_, "speak", "1.25", {"--between", "linear", "--frames", "2"}), 0.05, 1e-5);
  EXPECT_NEAR(x(face_, "speak", "1.25", {"--between", "cubic", "--frames", "2"}), 0.06875, 1e-5)
      << "-0.5 / 8 + 3 · 1 / 4 + 0, of the last two";
}

TEST_F(Between, WhatMakesNoSenseIsRefused) {
  const std::vector<std::vector<std::string>> cases = {{"--between", "cubic"},
                                                       {"--frames", "10"},
                                                       {"--between", "quartic", "--frames", "10"},
                                                       {"--between", "cubic", "--frames", "0"},
                                                       {"--between", "cubic", "--frames", "nan"},
                                                       {"--between", "cubic", "--frames", "1000"}};
  for (const auto& c : cases) {
    std::vector<std::string> arguments = {"pose", cubes_, "--clip", "go", "-o", folder_ / "p.obj"};
    arguments.insert(arguments.end(), c.begin(), c.end());
    EXPECT_EQ(run_marrow(arguments).code, 1) << c.back();
  }
  const Ran rests = run_marrow({"pose", cubes_, "--between", "cubic", "--frames", "10", "-o", folder_ / "p.obj"});
  EXPECT_EQ(rests.code, 1);
  EXPECT_NE(rests.err.find("nothing plays: give --clip too"), std::string::npos) << rests.err;
}

}  // namespace
}  // namespace marrow::test
