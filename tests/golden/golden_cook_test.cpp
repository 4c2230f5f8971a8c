// Cooking is deterministic and has not changed: the golden file's source still cooks to the golden file's bytes.
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/load_mrw.h"
#include "disk/cook_on_disk.h"
#include "support/golden.h"
#include "support/places.h"

namespace marrow {
namespace {

cook::Result cook_file(const char* name, bool raw_clips, const std::vector<cook::AdditiveRule>& additive = {}) {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.clips.additive = additive;
  options.mesh.keep_vertex_order = raw_clips;
  options.clips.raw = raw_clips;
  options.clips.shell = 0.03;
  return cook::cook_file(test::in_golden(name), options);
}

void expect_golden(const cook::Result& cooked, const test::AlignedBlock& golden) {
  ASSERT_EQ(cooked.file.size(), golden.size());
  for (std::size_t i = 0; i < golden.size(); ++i) ASSERT_EQ(cooked.file[i], golden.data()[i]) << "byte " << i;
}

// If this fails because the format's version rose or the cooker got better on purpose: see golden/README.md.
TEST(GoldenCook, GivesTheGoldenBytes) {
  expect_golden(cook_file("tiny.gltf", true), test::golden_copy());
  expect_golden(cook_file("dance.gltf", false), test::golden_coded_copy());
  expect_golden(cook_file("stride.gltf", false), test::golden_uneven_copy());
  expect_golden(cook_file("face.gltf", false, {{"speak", "first"}}), test::golden_channels_copy());
  cook::CookOptions pack;
  pack.clips_only = true;
  pack.mesh.codec = cook::MeshCodec::none;
  expect_golden(cook::cook_file(test::in_golden("dance.gltf"), pack), test::golden_pack_copy());
  pack.mesh.codec = cook::MeshCodec::draco;
  expect_golden(cook::cook_file(test::in_golden("dance.gltf"), pack), test::golden_packed_copy());
}

TEST(GoldenCook, GivesTheGoldenBytesOfLooks) {
  cook::CookOptions options;
  options.source.images = cook::Images::embed;
  options.mesh.codec = cook::MeshCodec::none;
  options.prepare.keep = {"*"};
  expect_golden(cook::cook_file(test::in_golden("looks.gltf"), options), test::golden_looks_copy());
}

TEST(GoldenCook, GivesTheGoldenBytesOfLevels) {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.clips.raw = true;
  options.mesh.lod = {{0.5, 8}, {0.25, 1}};
  expect_golden(cook::cook_file(test::in_golden("tiny.gltf"), options), test::golden_lod_copy());
}

TEST(GoldenCook, GivesTheGoldenBytesOfLimits) {
  expect_golden(cook_file("limits.gltf", true), test::golden_limits_copy());
}

TEST(GoldenCook, GivesTheGoldenBytesOfSprings) {
  expect_golden(cook_file("springs.gltf", true), test::golden_springs_copy());
}

TEST(GoldenCook, GivesTheGoldenBytesOfRoles) {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.mesh.keep_vertex_order = true;
  options.clips.raw = true;
  options.motion.roots = {{"walk", cook::RootMotion::ground}};
  expect_golden(cook::cook_file(test::in_golden("roles.gltf"), options), test::golden_roles_copy());
}

TEST(GoldenCook, GivesTheGoldenBytesOfPoseMaps) {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.mesh.keep_vertex_order = true;
  options.clips.raw = true;
  options.retarget.poses = {{test::in_golden("roles.gltf"), test::in_golden("maps.toml"), {}}};
  expect_golden(cook::cook_file(test::in_golden("roles.gltf"), options), test::golden_maps_copy());
}

TEST(GoldenCook, GivesTheGoldenBytesOfGraphs) {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.mesh.keep_vertex_order = true;
  options.clips.raw = true;
  options.motion.roots = {{"walk", cook::RootMotion::ground, {}}};
  options.graphs = {{test::in_golden("graph.toml"), {}, {}}};
  expect_golden(cook::cook_file(test::in_golden("roles.gltf"), options), test::golden_graph_copy());
}

TEST(GoldenCook, TwiceGivesTheSameBytes) {
  EXPECT_EQ(cook_file("dance.gltf", false).file, cook_file("dance.gltf", false).file);
}

// A change of the packed format leaves seeds behind that mutants never get past.
TEST(GoldenCook, SeedsOfPackedFilesUnpack) {
  std::size_t tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::in_source("tests/fuzz/seeds"))) {
    if (entry.path().extension() != ".mrw") continue;
    EXPECT_NO_THROW(tools::load_mrw(entry.path().string())) << entry.path();
    ++tried;
  }
  EXPECT_GE(tried, 10u);
}

}  // namespace
}  // namespace marrow
