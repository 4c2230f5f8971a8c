// Reading glTF: geometry, values by hand arithmetic from the specification.
#include "cook/gltf/read.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

TEST(Gltf, SkinnedSceneReadsWithoutWarnings) {
  Builder b = skinned();
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front().text;
  ASSERT_EQ(scene.nodes.size(), 3U);
  EXPECT_EQ(scene.nodes[2].parent, 1);
  EXPECT_EQ(scene.nodes[2].name, "tip");
  expect_near(scene.nodes[2].translation, {0, 1, 0});
  ASSERT_EQ(scene.meshes.size(), 1U);
  const RawPrimitive& primitive = scene.meshes[0].primitives.at(0);
  EXPECT_EQ(primitive.pointer, "/meshes/0/primitives/0");
  EXPECT_EQ(primitive.positions[3], glm::vec3(3, 9, 0));
  EXPECT_EQ(primitive.indices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  ASSERT_EQ(primitive.influences.size(), 4U);
  ASSERT_EQ(primitive.influences[2].size(), 2U);
  EXPECT_EQ(primitive.influences[2][0].joint, 0U);
  EXPECT_EQ(primitive.influences[2][1].weight, 0.75F);
  ASSERT_EQ(scene.skins.size(), 1U);
  EXPECT_EQ(scene.skins[0].joints, (std::vector<int>{1, 2}));
  EXPECT_EQ(scene.skins[0].inverse_bind[1][3], glm::dvec4(0, -1, 0, 1));
  ASSERT_EQ(scene.instances.size(), 1U);
  EXPECT_EQ(scene.instances[0].skin, 0);
  ASSERT_EQ(scene.clips.size(), 1U);
  EXPECT_EQ(scene.clips[0].channels[0].values[1], glm::vec4(0, 0, 1, 0));
  EXPECT_EQ(scene.source_bytes, b.text().size());
}

TEST(Gltf, MissingIndicesAreCounted) {
  Builder b;
  b.primitive({{"POSITION", b.curve(6)}});
  EXPECT_EQ(read(b).meshes[0].primitives[0].indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Gltf, IncompleteTriangleIsDropped) {
  Builder b;
  b.primitive({{"POSITION", b.curve(5)}});
  const RawScene scene = read(b);
  EXPECT_EQ(scene.meshes[0].primitives[0].indices.size(), 3U);
  EXPECT_TRUE(warns(scene, "incomplete-triangle"));
}

TEST(Gltf, StripIsUnrolledWithItsWinding) {
  Builder b;
  b.primitive({{"POSITION", b.curve(5)}})["mode"] = 5;
  // (i, i + 1, i + 2) and, for odd i, (i, i + 2, i + 1).
  EXPECT_EQ(read(b).meshes[0].primitives[0].indices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2, 2, 3, 4}));
}

TEST(Gltf, DegenerateStripTrianglesOnlyJoin) {
  Builder b;
  Json& primitive = b.primitive({{"POSITION", b.curve(6)}});
  primitive["mode"] = 5;
  primitive["indices"] = b.numbers<std::uint32_t>(kU32, "SCALAR", 1, {0, 1, 2, 2, 3, 3, 4, 5});
  EXPECT_EQ(read(b).meshes[0].primitives[0].indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 4}));
}

TEST(Gltf, FanIsUnrolledRoundItsFirstVertex) {
  Builder b;
  b.primitive({{"POSITION", b.curve(5)}})["mode"] = 6;
  EXPECT_EQ(read(b).meshes[0].primitives[0].indices, (std::vector<std::uint32_t>{1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(Gltf, PointsAndLinesAreLeftOut) {
  for (const int mode : {0, 1, 2, 3}) {
    Builder b;
    b.primitive({{"POSITION", b.curve(6)}})["mode"] = mode;
    const RawScene scene = read(b);
    EXPECT_TRUE(scene.meshes[0].primitives.empty());
    EXPECT_TRUE(warns(scene, "points-and-lines-dropped", "/meshes/0/primitives/0"));
  }
}

TEST(Gltf, StridedAttributesAreTakenApart) {
  Builder b;
  // x y z u v a vertex.
  const int view = b.view<float>({0, 0, 0, .1F, .2F, 1, 0, 0, .3F, .4F, 0, 1, 0, .5F, .6F}, {{"byteStride", 20}});
  const int positions = b.accessor({{"bufferView", view},
                                    {"componentType", kF32},
                                    {"type", "VEC3"},
                                    {"count", 3},
                                    {"min", {0, 0, 0}},
                                    {"max", {1, 1, 0}}});
  const int uvs =
      b.accessor({{"bufferView", view}, {"byteOffset", 12}, {"componentType", kF32}, {"type", "VEC2"}, {"count", 3}});
  b.primitive({{"POSITION", positions}, {"TEXCOORD_0", uvs}});
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.meshes[0].primitives[0].positions[2], glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.meshes[0].primitives[0].uvs[1], glm::vec2(.3F, .4F));
}

TEST(Gltf, SparseReplacesElements) {
  Builder b;
  const int indices = b.view<std::uint16_t>({1, 3});
  const int values = b.view<float>({7, 8, 9, 4, 5, 6});
  const Json sparse = {{"count", 2},
                       {"indices", {{"bufferView", indices}, {"componentType", kU16}}},
                       {"values", {{"bufferView", values}}}};
  const int based = b.curve(4);
  b.root["accessors"][static_cast<std::size_t>(based)].update(
      {{"sparse", sparse}, {"min", {0, 0, 0}}, {"max", {9, 9, 9}}});
  const int zeros = b.accessor({{"componentType", kF32},
                                {"type", "VEC3"},
                                {"count", 4},
                                {"sparse", sparse},
                                {"min", {0, 0, 0}},
                                {"max", {7, 8, 9}}});
  b.primitive({{"POSITION", based}})["mode"] = 5;
  b.primitive({{"POSITION", zeros}})["mode"] = 5;
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  const std::vector<glm::vec3> over_base = {{0, 0, 0}, {7, 8, 9}, {2, 4, 0}, {4, 5, 6}};
  const std::vector<glm::vec3> over_zeros = {{0, 0, 0}, {7, 8, 9}, {0, 0, 0}, {4, 5, 6}};
  EXPECT_EQ(scene.meshes[0].primitives[0].positions, over_base);
  EXPECT_EQ(scene.meshes[0].primitives[1].positions, over_zeros);
}

TEST(Gltf, NormalisedIntegersBecomeFractions) {
  Builder b;
  const Json norm = {{"normalized", true}};
  const int colours = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {0, 51, 102, 255, 255, 0, 0, 0, 0, 255, 0, 0}, norm);
  const int uvs = b.numbers<std::uint16_t>(kU16, "VEC2", 2, {0, 65535, 13107, 0, 0, 0}, norm);
  b.primitive({{"POSITION", b.curve(3)}, {"COLOR_0", colours}, {"TEXCOORD_0", uvs}});
  b.channel(b.times({0, 1}), b.numbers<std::int16_t>(kI16, "VEC4", 4, {0, 0, 0, 32767, -32768, 0, 0, 0}, norm),
            "rotation");
  const RawScene scene = read(b);
  const RawPrimitive& primitive = scene.meshes[0].primitives[0];
  EXPECT_EQ(primitive.colours[0], glm::vec4(0, 0.2F, 0.4F, 1));
  EXPECT_EQ(primitive.uvs[0], glm::vec2(0, 1));
  EXPECT_EQ(primitive.uvs[1], glm::vec2(0.2F, 0));
  EXPECT_EQ(scene.clips[0].channels[0].values[0], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(scene.clips[0].channels[0].values[1], glm::vec4(-1, 0, 0, 0));  // -32768 is clamped
}

TEST(Gltf, QuantisedPositionsKeepTheirUnits) {
  Builder b;
  b.root["extensionsUsed"] = b.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  const int view = b.view<std::int16_t>({-5, 0, 7, 0, 1, 2, 3, 0, 300, 400, 500, 0}, {{"byteStride", 8}});
  const int positions = b.accessor({{"bufferView", view},
                                    {"componentType", kI16},
                                    {"type", "VEC3"},
                                    {"count", 3},
                                    {"min", {-5, 0, 3}},
                                    {"max", {300, 400, 500}}});
  const int normal_view = b.view<std::int8_t>({0, 127, 0, 0, 0, 0, -127, 0, 127, 0, 0, 0}, {{"byteStride", 4}});
  const int normals = b.accessor(
      {{"bufferView", normal_view}, {"componentType", kI8}, {"type", "VEC3"}, {"count", 3}, {"normalized", true}});
  b.primitive({{"POSITION", positions}, {"NORMAL", normals}});
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.meshes[0].primitives[0].positions[2], glm::vec3(300, 400, 500));
  EXPECT_EQ(scene.meshes[0].primitives[0].normals[1], glm::vec3(0, 0, -1));
}

TEST(Gltf, AllJointSetsAreRead) {
  Builder b = skinned();
  Json joints = Json::array();
  for (int i = 1; i <= 8; ++i) joints.push_back(i);
  b.root["nodes"] = {{{"mesh", 0}, {"skin", 0}},
                     {{"children", {2, 3, 4, 5, 6, 7, 8}}},
                     Json::object(),
                     Json::object(),
                     Json::object(),
                     Json::object(),
                     Json::object(),
                     Json::object(),
                     Json::object()};
  b.root["skins"] = {{{"joints", joints}}};
  const int joints0 = b.numbers<std::uint16_t>(kU16, "VEC4", 4, {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3});
  const int joints1 = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {4, 5, 6, 7, 4, 5, 6, 7, 4, 5, 6, 7});
  const int weights0 = b.numbers<float>(kF32, "VEC4", 4, {.3F, .2F, .1F, .1F, 1, 0, 0, 0, 1, 0, 0, 0});
  const int weights1 =
      b.numbers<std::uint8_t>(kU8, "VEC4", 4, {51, 0, 0, 26, 0, 0, 0, 0, 0, 0, 0, 0}, {{"normalized", true}});
  b.root["meshes"] = Json::array();
  b.primitive({{"POSITION", b.curve(3)},
               {"JOINTS_0", joints0},
               {"WEIGHTS_0", weights0},
               {"JOINTS_1", joints1},
               {"WEIGHTS_1", weights1}});
  const RawScene scene = read(b);
  const std::vector<RawInfluence>& vertex = scene.meshes[0].primitives[0].influences[0];
  ASSERT_EQ(vertex.size(), 6U);
  EXPECT_EQ(vertex[4].joint, 4U);
  EXPECT_EQ(vertex[4].weight, 0.2F);
  EXPECT_EQ(vertex[5].joint, 7U);
  EXPECT_FLOAT_EQ(vertex[5].weight, 26.0F / 255.0F);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Gltf, WeightsThatCannotBeAreMended) {
  Builder b = skinned();
  // Joint 1 twice; no weight at all; below zero; too small to compute with.
  const int joints = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
  const int weights =
      b.numbers<float>(kF32, "VEC4", 4, {.5F, .25F, .25F, 0, 0, 0, 0, 0, 1, -.5F, 0, 0, 1, 1e-41F, 0, 0});
  b.root["meshes"][0]["primitives"][0]["attributes"].update({{"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
  const RawScene scene = read(b);
  const auto& influences = scene.meshes[0].primitives[0].influences;
  ASSERT_EQ(influences[0].size(), 2U);
  EXPECT_EQ(influences[0][0].joint, 1U);
  EXPECT_EQ(influences[0][0].weight, 0.75F);
  ASSERT_EQ(influences[1].size(), 1U);
  EXPECT_EQ(influences[1][0].joint, 1U);
  EXPECT_EQ(influences[1][0].weight, 1.0F);
  EXPECT_EQ(influences[2].size(), 1U);
  EXPECT_EQ(influences[3].size(), 1U);
  for (const char* rule : {"joints-listed-twice", "weights-zero", "weights-negative", "weights-denormal"}) {
    EXPECT_TRUE(warns(scene, rule, "/meshes/0/primitives/0/attributes/WEIGHTS_0")) << rule;
  }
}

TEST(Gltf, DamagedNormalsAreRemade) {
  Builder b;
  const int positions = b.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});  // faces +z
  const int normals = b.numbers<float>(kF32, "VEC3", 3, {kNan, 0, 0, 0, 0, 0, 0, 3, 4});
  b.primitive({{"POSITION", positions}, {"NORMAL", normals}});
  const RawScene scene = read(b);
  const auto& read_normals = scene.meshes[0].primitives[0].normals;
  EXPECT_EQ(read_normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(read_normals[1], glm::vec3(0, 0, 1));
  EXPECT_FLOAT_EQ(read_normals[2].y, 0.6F);
  EXPECT_TRUE(warns(scene, "normals-remade"));
  EXPECT_TRUE(warns(scene, "normals-not-unit"));
}

TEST(Gltf, LostVerticesMoveToTheMiddle) {
  Builder b;
  b.primitive({{"POSITION", b.positions({0, 0, 0, 2, 0, 0, 3e38F, 0, 0, 0, 2, 0})}})["mode"] = 5;
  const RawScene scene = read(b);
  expect_near(scene.meshes[0].primitives[0].positions[2], {2.0 / 3, 2.0 / 3, 0}, 1e-6);
  EXPECT_TRUE(warns(scene, "position-out-of-reach"));
}

TEST(Gltf, MaterialIsCarried) {
  Builder b;
  b.root["materials"] = {
      {{"name", "skin"}, {"doubleSided", true}, {"pbrMetallicRoughness", {{"baseColorFactor", {.5, .25, 0, 1}}}}}};
  b.primitive({{"POSITION", b.curve(3)}})["material"] = 0;
  const RawScene scene = read(b);
  ASSERT_EQ(scene.meshes[0].primitives[0].material, 0);
  const RawMaterial& material = scene.materials[0];
  EXPECT_EQ(material.name, "skin");
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.base_colour, glm::vec4(.5F, .25F, 0, 1));
}

}  // namespace
}  // namespace marrow::cook
