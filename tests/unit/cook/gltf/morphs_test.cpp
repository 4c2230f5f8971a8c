// Reading and cooking morph targets: values by hand from the specification,
// faults mended or refused, errors measured.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "common/aligned_bytes.h"
#include "cook/geometry/build_geometry.h"
#include "support/double_math.h"
#include "support/rig.h"
#include "unit/cook/cook_text.h"

namespace marrow::cook {
namespace {

TEST(GltfMorphs, AreReadWithNamesAndWeights) {
  const std::string targets = R"("/P/targets": [{"POSITION": 0}, {"POSITION": 0}], )";
  expect_rows(
      kTriangle,
      {{"positions and normalised normals, each alone",
        R"("/P/attributes/NORMAL": "=f32x3 0 0 1 0 0 1 0 0 1", "/extensionsUsed": ["KHR_mesh_quantization"],
           "/P/targets": [{"POSITION": "=f32x3 0 0 1 0 0 0 0.5 0 0"}, {"NORMAL": 1}],
           "/accessors/1": {"bufferView": "=i16 32767 0 0 0 0 0 0 0 -32767 0 0 0", "componentType": 5122, "type": "VEC3",
                            "count": 3, "normalized": true},
           "/meshes/0/extras": {"targetNames": ["up", "side"]}, "/meshes/0/weights": [0.25, -2], "/nodes/0/name": "n")",
        R"("P/targets/#": 2, "P/targets/0/positions/2": [0.5, 0, 0], "P/targets/0/normals": [], "P/targets/1/positions": [],
           "P/targets/1/normals/0": [1, 0, 0], "P/targets/1/normals/2": [0, 0, -1],
           "instances/0/weights": [{"target": "up"}, {"channel": "n.side", "rest": -2}])"},
       {"two nodes or two targets with one name would otherwise get one weight",
        targets +
            R"("/meshes/0/extras": {"targetNames": ["smile", "smile"]}, "/scenes/0/nodes": [0, 1],
          "/nodes": [{"name": "n", "mesh": 0}, {"name": "n", "mesh": 0}], "/animations": [{"channels":
            [{"sampler": 0, "target": {"node": 1, "path": "weights"}}],
            "samplers": [{"input": "=f32x1 0", "output": "=f32x1 1 2"}]}])",
        R"("instances": [{"weights": [{"channel": "n.smile"}, {"channel": "n.weights[1]"}]},
                         {"weights": [{"channel": "nodes[1].smile"}, {"channel": "nodes[1].weights[1]", "target": "smile"}]}],
           "clips/0/scalars": [{"name": "nodes[1].smile"}, {"values": [2]}])"},
       {"a sparse accessor without a base: zeros but for what it lists (glTF "
        "2.0, section 3.6.2.3)",
        R"("/P/targets": [{"POSITION": 1}], "/accessors/1": {"componentType": 5126, "type": "VEC3", "count": 3,
          "min": [0, 0, 0], "max": [7, 8, 9], "sparse": {"count": 1, "values": {"bufferView": "=f32 7 8 9"},
                                                         "indices": {"bufferView": "=u16 1", "componentType": 5123}}})",
        R"("P/targets/0/positions": [[0, 0, 0], [7, 8, 9], [0, 0, 0]])"},
       {"a primitive with fewer gets empty ones",
        targets + R"("/meshes/0/primitives/1": {"attributes": {"POSITION": 0}})",
        R"("warns": ["morph-targets-unequal"], "meshes/0/primitives/#": 2, "meshes/0/primitives/1/targets/#": 2,
           "meshes/0/primitives/1/targets/0/positions": [])"}});
}

TEST(GltfMorphs, FaultsAreMendedOrRefused) {
  const auto target = [](const std::string& of) { return R"("/P/targets": [{)" + of + "}]"; };
  expect_rows(
      kTriangle,
      {{"four", target(R"("POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0")"),
        R"("warns": ["morph-target-wrong /P/targets/0/POSITION"], "P/targets/0/positions": [])"},
       {"normals, which the base has not", target(R"("NORMAL": "=f32x3 1 0 0 1 0 0 1 0 0")"),
        R"("warns": ["morph-target-wrong"], "P/targets/0/normals": [])"},
       {"flat", target(R"("POSITION": "=f32x2 1 0 1 0 1 0")"),
        R"("warns": ["morph-target-wrong"], "P/targets/0/positions": [])"},
       {"far", target(R"("POSITION": "=f32x3 1 0 0 3e38 0 0 0 0 0")"),
        R"("warns": ["morph-change-out-of-reach"], "P/targets/0/positions/1": [0, 0, 0], "P/targets/0/positions/0": [1, 0, 0])"},
       {"no number", target(R"("POSITION": "=f32x3 nan 0 0 0 0 0 0 0 0")"),
        "invalid /P/targets/0/POSITION: not a finite number"}});
}

// A strip of 40 vertices, 10 blocks on one joint; targets of noise.
RawPrimitive strip(double most_turn) {
  test::Random random(91);
  RawPrimitive p;
  for (int v = 0; v < 40; ++v) {
    p.positions.emplace_back(v / 2, v % 2, 0);
    p.normals.emplace_back(0, 0, 1);
    if (v >= 2) p.indices.insert(p.indices.end(), {std::uint32_t(v - 2), std::uint32_t(v - 1), std::uint32_t(v)});
  }
  RawTarget& target = p.targets.emplace_back();
  for (int v = 0; v < 40; ++v) {
    const auto noise = [&](double most) { return static_cast<float>(random.between(-most, most)); };
    const bool moves = v >= 8 && v < 21;
    const float x = noise(3), y = noise(3), z = noise(3), a = noise(most_turn), c = noise(most_turn);
    target.positions.push_back(moves ? glm::vec3(x, y, z) : glm::vec3(0));
    target.normals.push_back(moves ? glm::vec3(a, c, 0) : glm::vec3(0));
  }
  p.targets.emplace_back();  // moves nothing
  RawTarget& noise = p.targets.emplace_back();
  noise.normals.assign(40, glm::vec3(1e-6F, 0, 0));  // an exporter's rounding
  return p;
}

TEST(Morphs, AreSparseAndExactToHalfAStep) {
  const RawPrimitive p = strip(1.5);
  const CookOptions options = options_of("--mesh-codec none --keep-vertex-order");
  const BuiltGeometry built = build_geometry(p, std::vector<Binding>(40, {{0}, {1.0}, {}}), 1, {}, options.mesh);
  const std::byte* const base = built.section.data();
  const format::GeometryLayout geometry = layout(built.header);
  format::MorphHeader h;
  std::memcpy(&h, base + format::morph_start(geometry), sizeof h);
  const format::MorphLayout l = layout(h, geometry);
  const auto* const targets = reinterpret_cast<const MorphTarget*>(base + l.targets);
  const auto* const blocks = reinterpret_cast<const std::uint16_t*>(base + l.blocks);
  const auto* const records = reinterpret_cast<const std::int16_t*>(base + l.records);
  const auto* const slots = reinterpret_cast<const std::uint32_t*>(base + geometry.source_slots);
  ASSERT_EQ(h.target_count, 3U);
  EXPECT_EQ(targets[0].attributes, std::uint32_t{kMorphsPositions | kMorphsNormals});
  EXPECT_EQ(targets[1].block_count + targets[1].attributes, 0U);
  EXPECT_EQ(targets[2].block_count + targets[2].attributes, 0U);
  EXPECT_EQ(h.record_count, 2 * targets[0].block_count);
  EXPECT_LT(h.block_count, 10U) << "thirteen of forty vertices move";
  float most = 0;
  double worst = 0, worst_deg = 0;
  for (const glm::vec3& d : p.targets[0].positions)
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(d[c]));
  std::size_t moved = 0;
  std::set<std::uint32_t> used;
  for (std::size_t v = 0; v < 40; ++v) {
    const auto* const block = std::find(blocks, blocks + h.block_count, slots[v] / 4);
    const std::size_t b = static_cast<std::size_t>(block - blocks), lane = slots[v] % 4;
    if (b == h.block_count) {
      EXPECT_EQ(p.targets[0].positions[v], glm::vec3(0)) << v;
      continue;
    }
    test::Vec3 want{0, 0, 1}, got{0, 0, 1};
    for (std::size_t c = 0; c < 3; ++c) {
      const int axis = static_cast<int>(c);
      const double stored = records[24 * b + 4 * c + lane] * static_cast<double>(targets[0].position_step);
      worst = std::max(worst, std::abs(stored - static_cast<double>(p.targets[0].positions[v][axis])));
      want[c] += static_cast<double>(p.targets[0].normals[v][axis]);
      got[c] += records[24 * b + 12 + 4 * c + lane] * static_cast<double>(targets[0].normal_step);
    }
    worst_deg = std::max(worst_deg, test::angle_deg(want, got));
    if (p.targets[0].positions[v] == glm::vec3(0)) continue;
    ++moved;
    used.insert(blocks[b]);
  }
  EXPECT_EQ(moved, 13U);
  EXPECT_EQ(used.size(), h.block_count) << "a block that nothing moves";
  EXPECT_LE(worst, static_cast<double>(most) / 65534 * 1.001);
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst_deg, 0.01);
}

TEST(Morphs, WhatNoneMovesHasNoneAndNoNormalsAreMade) {
  const std::string zeros = R"({"POSITION": "=f32x3b 0*9"})";
  expect_cooked(document_of(kTriangle),
                {{"targets of zeros", "",
                  R"("/P/targets": [)" + zeros + R"(, {"POSITION": 0}],
                    "/meshes/0/primitives/1": {"attributes": {"POSITION": 0}, "targets": [)" +
                      zeros + ", " + zeros + "]}",
                  R"("meshes": [{"targets": 2, "weights": 2}, {"targets": 0, "weights": 0}])"}});
  // glTF wants a mesh without normals flat: none are stored, of its targets
  // neither.
  const LoadedCook cooked(cook_text(changed(document_of(kTriangle),
                                            R"("/P/attributes/POSITION": "=f32x3 0 0 0 1 0 0 0 1 0",
      "/P/targets": [{"POSITION": "=f32x3 0 0 0 0 0 0 0 -1 1"}])"),
                                    options_of("--mesh-codec none")));
  const Geometry geometry = cooked.file.mesh(0).geometry;
  EXPECT_EQ(geometry.normals, nullptr);
  ASSERT_EQ(geometry.targets.size, 1u);
  EXPECT_EQ(geometry.targets[0].attributes, std::uint32_t{kMorphsPositions});
}

// Two blocks of a target that do not ascend; the golden files have one.
TEST(Morphs, BlocksThatDoNotAscendAreRefused) {
  RawScene scene;
  scene.source = "strip";
  scene.nodes.emplace_back();
  scene.meshes.emplace_back();
  scene.meshes[0].primitives.push_back(strip(0.5));
  scene.meshes[0].weights.resize(3);
  scene.instances.push_back({0, 0, kNone, scene.meshes[0].weights});
  const Result cooked = cook_scene(scene, options_of("--mesh-codec none"));
  tools::AlignedBytes block{std::span<const std::byte>(cooked.file)};
  File file;
  ASSERT_EQ(load({block.data(), block.size()}, file), Status::ok);
  const Geometry g = file.mesh(0).geometry;
  ASSERT_GE(g.targets[0].block_count, 4U);
  const auto* blocks = static_cast<const std::byte*>(g.target_blocks);
  std::memcpy(block.data() + (blocks - block.data()) + 2, blocks,
              2);  // the second is the first again
  const std::uint64_t sum =
      format::checksum(block.data() + sizeof(format::Header), block.size() - sizeof(format::Header));
  std::memcpy(block.data() + offsetof(format::Header, checksum), &sum, sizeof sum);
  DataError error;
  EXPECT_EQ(load({block.data(), block.size()}, file, &error), Status::bad_data);
  EXPECT_STREQ(error.rule, "a target's blocks ascend");
  EXPECT_EQ(error.offset, static_cast<std::size_t>(blocks - block.data()) + 2);
}

}  // namespace
}  // namespace marrow::cook
