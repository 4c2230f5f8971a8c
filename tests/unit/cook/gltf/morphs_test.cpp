// Reading and cooking morph targets: values by hand from the specification, faults mended or refused, errors measured.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "common/aligned_bytes.h"
#include "cook/geometry/build_geometry.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "support/double_math.h"
#include "support/rig.h"
#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

// Three vertices with normals along z; the caller adds targets.
Builder with_normals(Json** primitive) {
  Builder b;
  const int positions = b.curve(3);
  const int normals = b.numbers<float>(kF32, "VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  *primitive = &b.primitive({{"POSITION", positions}, {"NORMAL", normals}});
  return b;
}

TEST(GltfMorphs, AreReadWithNamesAndWeights) {
  Json* primitive = nullptr;
  Builder b = with_normals(&primitive);
  const int moved = b.positions({0, 0, 1, 0, 0, 0, 0.5F, 0, 0});
  const int turned = b.numbers<std::int16_t>(kI16, "VEC3", 3, {32767, 0, 0, 0, 0, 0, 0, 0, -32767, 0, 0, 0},
                                             {{"normalized", true}, {"count", 3}});
  (*primitive)["targets"] = {{{"POSITION", moved}}, {{"NORMAL", turned}}};
  b.root["extensionsUsed"] = {"KHR_mesh_quantization"};
  b.root["meshes"][0]["extras"] = {{"targetNames", {"up", "side"}}};
  b.root["meshes"][0]["weights"] = {0.25, -2};
  b.root["nodes"][0]["name"] = "n";
  const RawScene scene = read(b);
  const RawPrimitive& p = scene.meshes[0].primitives[0];
  ASSERT_EQ(p.targets.size(), 2U);
  EXPECT_EQ(p.targets[0].positions[2], glm::vec3(0.5F, 0, 0));
  EXPECT_TRUE(p.targets[0].normals.empty());
  EXPECT_TRUE(p.targets[1].positions.empty());
  EXPECT_EQ(p.targets[1].normals[0], glm::vec3(1, 0, 0));
  EXPECT_EQ(p.targets[1].normals[2], glm::vec3(0, 0, -1));
  ASSERT_EQ(scene.instances[0].weights.size(), 2U);
  EXPECT_EQ(scene.instances[0].weights[0].target, "up");
  EXPECT_EQ(scene.instances[0].weights[1].channel, "n.side");
  EXPECT_EQ(scene.instances[0].weights[1].rest, -2);
}

// Two nodes or two targets with one name would otherwise get one weight.
TEST(GltfMorphs, EveryWeightHasAChannelOfItsOwn) {
  Builder b;
  const int positions = b.curve(3);
  b.primitive({{"POSITION", positions}})["targets"] = {{{"POSITION", positions}}, {{"POSITION", positions}}};
  b.root["meshes"][0]["extras"] = {{"targetNames", {"smile", "smile"}}};
  b.root["nodes"] = {{{"name", "n"}, {"mesh", 0}}, {{"name", "n"}, {"mesh", 0}}};
  b.root["scenes"][0]["nodes"] = {0, 1};
  b.channel(b.times({0}), b.numbers<float>(kF32, "SCALAR", 1, {1, 2}), "weights", "LINEAR", 1);
  const RawScene scene = read(b);
  ASSERT_EQ(scene.instances.size(), 2U);
  EXPECT_EQ(scene.instances[0].weights[0].channel, "n.smile");
  EXPECT_EQ(scene.instances[0].weights[1].channel, "n.weights[1]");
  EXPECT_EQ(scene.instances[1].weights[0].channel, "nodes[1].smile");
  EXPECT_EQ(scene.instances[1].weights[1].channel, "nodes[1].weights[1]");
  EXPECT_EQ(scene.instances[1].weights[1].target, "smile");
  ASSERT_EQ(scene.clips[0].scalars.size(), 2U);
  EXPECT_EQ(scene.clips[0].scalars[0].name, "nodes[1].smile");
  EXPECT_EQ(scene.clips[0].scalars[1].values, (std::vector<float>{2}));
}

// A sparse accessor without a base: zeros but for what it lists (glTF 2.0, section 3.6.2.3).
TEST(GltfMorphs, SparseOnesAreZeroElsewhere) {
  Builder b;
  Json& primitive = b.primitive({{"POSITION", b.curve(3)}});
  const int indices = b.view<std::uint16_t>({1}), values = b.view<float>({7, 8, 9});
  primitive["targets"] = {{{"POSITION", b.accessor({{"componentType", kF32},
                                                    {"type", "VEC3"},
                                                    {"count", 3},
                                                    {"min", {0, 0, 0}},
                                                    {"max", {7, 8, 9}},
                                                    {"sparse",
                                                     {{"count", 1},
                                                      {"indices", {{"bufferView", indices}, {"componentType", kU16}}},
                                                      {"values", {{"bufferView", values}}}}}})}}};
  const RawScene scene = read(b);
  const std::vector<glm::vec3>& moved = scene.meshes[0].primitives[0].targets.at(0).positions;
  ASSERT_EQ(moved.size(), 3U);
  EXPECT_EQ(moved[0], glm::vec3(0));
  EXPECT_EQ(moved[1], glm::vec3(7, 8, 9));
  EXPECT_EQ(moved[2], glm::vec3(0));
}

TEST(GltfMorphs, FaultsAreMendedOrRefused) {
  const auto document = [](const std::function<Json(Builder&)>& target) {
    auto b = std::make_shared<Builder>();
    Json& primitive = b->primitive({{"POSITION", b->curve(3)}});
    primitive["targets"] = Json::array({target(*b)});
    return b;
  };
  const auto targets = [](const RawScene& scene) { return scene.meshes[0].primitives[0].targets; };
  const RawScene count = read(*document([](Builder& b) { return Json{{"POSITION", b.curve(4)}}; }));
  EXPECT_TRUE(warns(count, "morph-target-wrong", "/meshes/0/primitives/0/targets/0/POSITION"));
  EXPECT_TRUE(targets(count).at(0).positions.empty());
  const RawScene normal = read(*document([](Builder& b) {
    return Json{{"NORMAL", b.numbers<float>(kF32, "VEC3", 3, {1, 0, 0, 1, 0, 0, 1, 0, 0})}};
  }));
  EXPECT_TRUE(warns(normal, "morph-target-wrong"));
  EXPECT_TRUE(targets(normal).at(0).normals.empty()) << "the base has none";
  const RawScene flat = read(*document([](Builder& b) {
    return Json{
        {"POSITION", b.numbers<float>(kF32, "VEC2", 2, {1, 0, 1, 0, 1, 0}, {{"min", {1, 0}}, {"max", {1, 0}}})}};
  }));
  EXPECT_TRUE(warns(flat, "morph-target-wrong"));
  EXPECT_TRUE(targets(flat).at(0).positions.empty());
  const RawScene far = read(*document([](Builder& b) {
    return Json{{"POSITION", b.positions({1, 0, 0, 3e38F, 0, 0, 0, 0, 0})}};
  }));
  EXPECT_TRUE(warns(far, "morph-change-out-of-reach"));
  EXPECT_EQ(targets(far).at(0).positions[1], glm::vec3(0));
  EXPECT_EQ(targets(far).at(0).positions[0], glm::vec3(1, 0, 0));
  expect_refused(document([](Builder& b) {
                   return Json{{"POSITION", b.numbers<float>(kF32, "VEC3", 3, {kNan, 0, 0, 0, 0, 0, 0, 0, 0})}};
                 })->text(),
                 Exit::invalid, "/meshes/0/primitives/0/targets/0/POSITION", "not a finite number");
}

TEST(GltfMorphs, APrimitiveWithFewerGetsEmptyOnes) {
  Builder b;
  const int positions = b.curve(3);
  b.primitive({{"POSITION", positions}})["targets"] = {{{"POSITION", positions}}, {{"POSITION", positions}}};
  b.primitive({{"POSITION", positions}});
  const RawScene scene = read(b);
  EXPECT_TRUE(warns(scene, "morph-targets-unequal"));
  ASSERT_EQ(scene.meshes[0].primitives.size(), 2U);
  EXPECT_EQ(scene.meshes[0].primitives[1].targets.size(), 2U);
  EXPECT_TRUE(scene.meshes[0].primitives[1].targets[0].positions.empty());
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
  CookOptions options;
  options.mesh.codec = MeshCodec::none;
  options.mesh.keep_vertex_order = true;
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

TEST(Morphs, WhatNoneMovesHasNone) {
  Builder b;
  const int positions = b.curve(3);
  const int zeros = b.positions({0, 0, 0, 0, 0, 0, 0, 0, 0});
  b.primitive({{"POSITION", positions}})["targets"] = {{{"POSITION", zeros}}, {{"POSITION", positions}}};
  b.primitive({{"POSITION", positions}})["targets"] = {{{"POSITION", zeros}}, {{"POSITION", zeros}}};
  Notes notes;
  const BuiltScene built = build_scene(read(b), {}, notes);
  ASSERT_EQ(built.meshes.size(), 2U);
  EXPECT_EQ(built.geometries.at(built.meshes[0].geometry).target_count, 2U);
  EXPECT_EQ(built.meshes[0].targets.size(), 2U);
  EXPECT_EQ(built.geometries.at(built.meshes[1].geometry).target_count, 0U);
  EXPECT_EQ(built.meshes[1].targets.size(), 0U);
}

// glTF wants a mesh without normals flat: none are stored, of its targets neither.
TEST(Morphs, NoNormalsAreMade) {
  Builder b;
  Json& primitive = b.primitive({{"POSITION", b.positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}});
  primitive["targets"] = {{{"POSITION", b.positions({0, 0, 0, 0, 0, 0, 0, -1, 1})}}};
  RawScene scene = read(b);
  CookOptions options;
  options.mesh.codec = MeshCodec::none;
  const Result cooked = cook_scene(scene, options);
  const tools::AlignedBytes block{std::span<const std::byte>(cooked.file)};
  File file;
  ASSERT_EQ(load({block.data(), block.size()}, file), Status::ok);
  EXPECT_EQ(file.mesh(0).geometry.normals, nullptr);
  ASSERT_EQ(file.mesh(0).geometry.targets.size, 1u);
  EXPECT_EQ(file.mesh(0).geometry.targets[0].attributes, std::uint32_t{kMorphsPositions});
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
  CookOptions options;
  options.mesh.codec = MeshCodec::none;
  const Result cooked = cook_scene(scene, options);
  tools::AlignedBytes block{std::span<const std::byte>(cooked.file)};
  File file;
  ASSERT_EQ(load({block.data(), block.size()}, file), Status::ok);
  const Geometry g = file.mesh(0).geometry;
  ASSERT_GE(g.targets[0].block_count, 4U);
  const auto* blocks = static_cast<const std::byte*>(g.target_blocks);
  std::memcpy(block.data() + (blocks - block.data()) + 2, blocks, 2);  // the second is the first again
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
