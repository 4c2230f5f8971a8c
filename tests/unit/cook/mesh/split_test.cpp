// Meshes with more joints than a palette may have, in parts: each triangle once, and few parts.
#include "cook/skin/primitive_palette.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "disk/cook_on_disk.h"
#include "support/millipede.h"
#include "support/rig.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

using Needs = std::vector<std::vector<std::uint32_t>>;

// Vertex v follows joint v; triangle t has vertices t, t + 1, t + 2.
struct Strip {
  explicit Strip(std::uint32_t joints) {
    for (std::uint32_t v = 0; v < joints; ++v) needs.push_back({v});
    for (std::uint32_t t = 0; t + 2 < joints; ++t) indices.insert(indices.end(), {t, t + 1, t + 2});
  }
  Needs needs;
  std::vector<std::uint32_t> indices;
};

std::vector<std::set<std::uint32_t>> joints_of_parts(const std::vector<std::uint32_t>& indices, const Needs& needs,
                                                     const std::vector<std::uint32_t>& part_of) {
  std::vector<std::set<std::uint32_t>> out(part_of.empty() ? 0 : std::size_t{1} + std::ranges::max(part_of));
  for (std::size_t i = 0; i < indices.size(); ++i)
    out[part_of[i / 3]].insert(needs[indices[i]].begin(), needs[indices[i]].end());
  return out;
}

void expect_parts(const Strip& strip, std::size_t most, std::size_t parts) {
  const std::vector<std::uint32_t> part_of = split_triangles(strip.indices, strip.needs, most);
  ASSERT_EQ(part_of.size(), strip.indices.size() / 3);
  const auto joints = joints_of_parts(strip.indices, strip.needs, part_of);
  EXPECT_EQ(joints.size(), parts) << most;
  for (const auto& set : joints) {
    EXPECT_LE(set.size(), most);
    EXPECT_GE(set.size(), 3u) << "no part is empty";
  }
}

// A part of n joints holds n - 2 triangles of a strip.
TEST(Split, AStripIsCutIntoAsFewPartsAsCanBe) {
  const Strip six(6), many(2000);  // 4 and 1998 triangles
  expect_parts(six, 3, 4);
  expect_parts(six, 4, 2);
  expect_parts(six, 5, 2);
  expect_parts(six, 6, 1);
  expect_parts(many, 341, 6);  // 1998 / 339
  expect_parts(many, 24, 91);  // 1998 / 22
}

TEST(Split, IslandsSharePartsThatHaveRoom) {
  // Eight triangles, each on three joints of its own.
  Strip islands(24);
  islands.indices.clear();
  for (std::uint32_t v = 0; v < 24; ++v) islands.indices.push_back(v);
  expect_parts(islands, 24, 1);
  expect_parts(islands, 12, 2);
  expect_parts(islands, 11, 3);  // three triangles a part
  expect_parts(islands, 3, 8);
}

// The first triangle and the last need the same three joints, the third one more, the second two.
TEST(Split, WhatAddsLeastComesFirst) {
  const Needs needs = {{0, 1}, {1, 2}, {0, 2}, {0, 5, 6}, {0, 3}};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 1, 3, 0, 1, 4, 2, 1, 0};
  EXPECT_EQ(split_triangles(indices, needs, 5), (std::vector<std::uint32_t>{0, 1, 0, 0}));
}

// Any triangles on any joints: nothing is lost, nothing too large, and the same comes out again.
TEST(Split, AnythingFits) {
  test::Random random(7);
  for (int round = 0; round < 40; ++round) {
    const std::uint32_t joints = 30 + 10 * static_cast<std::uint32_t>(round);
    Needs needs;
    for (int v = 0; v < 200; ++v) {
      std::set<std::uint32_t> set;
      const std::uint32_t near = random.below(joints - 9);
      for (int i = 0; i < 1 + v % 8; ++i) set.insert(near + random.below(9));
      needs.emplace_back(set.begin(), set.end());
    }
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < 900; ++i) indices.push_back(random.below(200));
    const std::vector<std::uint32_t> part_of = split_triangles(indices, needs, 27);
    ASSERT_EQ(part_of.size(), 300u);
    std::set<std::uint32_t> all;
    for (const std::uint32_t v : indices) all.insert(needs[v].begin(), needs[v].end());
    const auto parts = joints_of_parts(indices, needs, part_of);
    for (const auto& set : parts) EXPECT_TRUE(!set.empty() && set.size() <= 27);
    EXPECT_GE(parts.size() * 27, all.size());
    EXPECT_EQ(split_triangles(indices, needs, 27), part_of);
  }
}

TEST(Split, ManyTrianglesTakeNoTime) {
  const test::Millipede millipede(400);
  const RawPrimitive& p = millipede.scene.meshes[0].primitives[0];
  Needs needs;
  for (const auto& vertex : p.influences) {
    needs.emplace_back();
    for (const RawInfluence& i : vertex) needs.back().push_back(i.joint);
    std::ranges::sort(needs.back());
  }
  std::vector<std::uint32_t> indices;
  while (indices.size() < 300'000) indices.insert(indices.end(), p.indices.begin(), p.indices.end());
  const auto start = std::chrono::steady_clock::now();
  const std::vector<std::uint32_t> part_of = split_triangles(indices, needs, 341);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::printf("  %zu triangles on 2000 joints: %.3f s\n", indices.size() / 3, took.count());
  EXPECT_LT(took.count(), 10) << "a tenth of a second, but for sanitizers";
  EXPECT_LE(joints_of_parts(indices, needs, part_of).size(), 7u) << "six would hold 2000 joints without a seam";
}

// Of fewer entries than the option takes.
CookOptions with_palette(std::size_t most) {
  CookOptions options = options_of("--clip-codec raw --mesh-codec none");
  options.mesh.most_entries = most;
  return options;
}

TEST(Split, TheReportSaysIntoWhat) {
  const test::Millipede millipede(30);  // 150 joints
  const LoadedCook cooked(cook_scene(millipede.scene, with_palette(64)));
  const LoadedCook whole(cook_scene(millipede.scene, with_palette(kMaxJoints)));
  ASSERT_EQ(whole.file.mesh_count(), 1u);
  EXPECT_FALSE(whole.report["meshes"][0].contains("split"));
  EXPECT_EQ(whole.file.mesh(0).joint_count, 150u);
  const std::uint32_t parts = cooked.file.mesh_count();
  ASSERT_EQ(parts, 3u);
  std::size_t vertices = 0, triangles = 0;
  for (std::uint32_t m = 0; m < parts; ++m) {
    const Mesh mesh = cooked.file.mesh(m);
    EXPECT_LE(mesh.palette_size(), 64u);
    EXPECT_EQ(mesh.is_next_part, m > 0);
    EXPECT_STREQ(mesh.name, "millipede");
    const auto& split = cooked.report["meshes"][m]["split"];
    EXPECT_EQ(split["part"], m);
    EXPECT_EQ(split["parts"], parts);
    vertices += mesh.geometry.vertex_count;
    triangles += mesh.geometry.index_count / 3;
  }
  // Two cuts through a ring of eight at least; a leg that is cut off costs two to three more.
  const std::size_t doubled = cooked.report["meshes"][0]["split"]["doubled_vertices"];
  EXPECT_EQ(vertices, whole.file.mesh(0).geometry.vertex_count + doubled);
  EXPECT_EQ(triangles, whole.file.mesh(0).geometry.index_count / 3);
  EXPECT_GE(doubled, 16u);
  EXPECT_LE(doubled, 48u);
}

TEST(Split, SameBytesEveryTime) {
  const test::Millipede millipede(30);
  const CookOptions options = options_of("--palette 24 --clip-codec raw --mesh-codec meshopt --lod 0.5:8,0.1:2");
  EXPECT_EQ(cook_scene(millipede.scene, options).file, cook_scene(millipede.scene, options).file);
}

TEST(Split, TheOptionIsAPaletteThatATriangleFits) {
  const auto palette = [](const std::string& n) { return options_of("--palette " + n).mesh.most_entries; };
  EXPECT_EQ(CookOptions().mesh.most_entries, 341u);
  EXPECT_EQ(palette("24"), 24u);
  EXPECT_EQ(palette("32767"), 32767u);
  for (const char* const bad : {"23", "0", "-1", "32768", "100.5", "nan", "", "24x"})
    EXPECT_THROW(palette(bad), tools::Failure) << bad;
}

// Three vertices of two joints each, all of them others.
TEST(Split, ATriangleThatNeedsMoreIsRefused) {
  test::Millipede millipede(2);
  RawPrimitive& p = millipede.scene.meshes[0].primitives[0];
  p.indices = {0, 1, 2};
  for (std::uint32_t v = 0; v < 3; ++v) p.influences[v] = {{2 * v, 0.5f}, {2 * v + 1, 0.5f}};
  EXPECT_NO_THROW(cook_scene(millipede.scene, with_palette(6)));
  try {
    cook_scene(millipede.scene, with_palette(5));
    ADD_FAILURE() << "not refused";
  } catch (const tools::Failure& failure) {
    EXPECT_EQ(failure.code(), tools::Exit::unsupported);
    EXPECT_STREQ(failure.what(),
                 "millipede.gltf: /meshes/0/primitives/0: a triangle follows 6 joints and helpers: give --palette 6 "
                 "or more");
  }
}

}  // namespace
}  // namespace marrow::cook
