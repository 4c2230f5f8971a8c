// Tests reading glTF: values by hand arithmetic from the specification, and every way a file can be wrong.
#include "cook/gltf/read.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/failure.h"

namespace marrow::cook {
namespace {

using Json = nlohmann::json;
using tools::Exit;
using tools::Failure;

constexpr int kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::string base64(std::span<const std::byte> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      bits = bits << 8 | (i + b < bytes.size() ? std::to_integer<unsigned>(bytes[i + b]) : 0U);
    }
    for (std::size_t c = 0; c < 4; ++c) text += c > bytes.size() - i ? '=' : kDigits[bits >> (18 - 6 * c) & 63];
  }
  return text;
}

// A document under construction: one buffer, a view and an accessor a block of numbers.
struct Builder {
  Json root = {
      {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}, {"nodes", {Json::object()}}};
  std::vector<std::byte> bytes;

  template <class T>
  int view(const std::vector<T>& numbers, Json extra = Json::object()) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t offset = bytes.size();
    bytes.resize(offset + numbers.size() * sizeof(T));
    std::memcpy(bytes.data() + offset, numbers.data(), numbers.size() * sizeof(T));
    extra.update({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", numbers.size() * sizeof(T)}});
    root["bufferViews"].push_back(extra);
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  int accessor(Json accessor) {
    root["accessors"].push_back(std::move(accessor));
    return static_cast<int>(root["accessors"].size()) - 1;
  }

  template <class T>
  int numbers(int component, const char* type, std::size_t components, const std::vector<T>& values,
              const Json& extra = Json::object()) {
    Json json = {{"bufferView", view(values)},
                 {"componentType", component},
                 {"type", type},
                 {"count", values.size() / components}};
    json.update(extra);
    return accessor(std::move(json));
  }

  int positions(const std::vector<float>& xyz) {
    Json low = {xyz[0], xyz[1], xyz[2]};
    Json high = low;
    for (std::size_t i = 0; i < xyz.size(); ++i) {
      low[i % 3] = std::min(low[i % 3].get<float>(), xyz[i]);
      high[i % 3] = std::max(high[i % 3].get<float>(), xyz[i]);
    }
    return numbers(kF32, "VEC3", 3, xyz, {{"min", low}, {"max", high}});
  }

  int times(const std::vector<float>& seconds) {
    return numbers(kF32, "SCALAR", 1, seconds, {{"min", {seconds.front()}}, {"max", {seconds.back()}}});
  }

  // `count` vertices (i, i², 0): no three on a line.
  int curve(std::size_t count) {
    std::vector<float> xyz;
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<float>(i);
      xyz.insert(xyz.end(), {x, x * x, 0});
    }
    return positions(xyz);
  }

  // Adds a primitive to the only mesh, drawn at node 0.
  Json& primitive(Json attributes) {
    root["nodes"][0]["mesh"] = 0;
    root["meshes"][0]["primitives"].push_back({{"attributes", std::move(attributes)}});
    return root["meshes"][0]["primitives"].back();
  }

  void channel(int input, int output, const std::string& path, const std::string& interpolation = "LINEAR",
               int node = 0) {
    Json& animation = root["animations"][0];
    const std::size_t sampler = animation.contains("samplers") ? animation["samplers"].size() : 0;
    animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
    animation["channels"].push_back({{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
  }

  std::string text() {
    if (!bytes.empty()) {
      root["buffers"] = {
          {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
    }
    return root.dump();
  }
};

RawScene read_text(const std::string& text) {
  return read_gltf("test.gltf", std::as_bytes(std::span(text.data(), text.size())));
}

RawScene read(Builder& builder) {
  return read_text(builder.text());
}

bool warns(const RawScene& scene, const std::string& rule, const std::string& pointer = "") {
  return std::ranges::any_of(scene.warnings, [&](const RawWarning& warning) {
    return warning.rule == rule && (pointer.empty() || warning.pointer == pointer);
  });
}

void expect_failure(const std::function<void()>& action, Exit code, const std::string& where, const std::string& rule) {
  try {
    action();
    ADD_FAILURE() << "expected: " << where << ": " << rule;
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), code) << failure.what();
    EXPECT_EQ(failure.where(), where) << failure.what();
    EXPECT_NE(failure.rule().find(rule), std::string::npos) << failure.what();
    EXPECT_FALSE(failure.advice().empty()) << failure.what();
  }
}

void expect_refused(const std::string& text, Exit code, const std::string& where, const std::string& rule) {
  SCOPED_TRACE(text.substr(0, 200));
  expect_failure([&] { read_text(text); }, code, where, rule);
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-12) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

// A bone above another, four vertices on each, a clip that turns the upper one. Without a fault.
Builder skinned() {
  Builder b;
  b.root["nodes"] = {
      {{"mesh", 0}, {"skin", 0}}, {{"name", "root"}, {"children", {2}}}, {{"name", "tip"}, {"translation", {0, 1, 0}}}};
  b.root["scenes"][0]["nodes"] = {0, 1};
  const int positions = b.curve(4);
  const int joints = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0});
  const int weights = b.numbers<float>(kF32, "VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 0.25F, 0.75F, 0, 0, 1, 0, 0, 0});
  const int indices = b.numbers<std::uint16_t>(kU16, "SCALAR", 1, {0, 1, 2, 1, 3, 2});
  b.root["meshes"] = {{{"primitives",
                        {{{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                          {"indices", indices}}}}}};
  const int inverse_bind = b.numbers<float>(kF32, "MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  b.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse_bind}, {"skeleton", 1}}};
  const int times = b.times({0, 1});
  const int rotations = b.numbers<float>(kF32, "VEC4", 4, {0, 0, 0, 1, 0, 0, 1, 0});
  b.channel(times, rotations, "rotation", "LINEAR", 2);
  return b;
}

// --- geometry ---------------------------------------------------------------------------------------------------

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
  const RawPrimitive& primitive = scene.meshes[0].primitives[0];
  EXPECT_EQ(primitive.material, "skin");
  EXPECT_TRUE(primitive.double_sided);
  EXPECT_EQ(primitive.base_colour, glm::vec4(.5F, .25F, 0, 1));
}

TEST(Gltf, MorphTargetsGiveOneWarningAMesh) {
  Builder b;
  const int positions = b.curve(3);
  Json& primitive = b.primitive({{"POSITION", positions}});
  for (int i = 0; i < 80; ++i) primitive["targets"].push_back({{"POSITION", positions}});
  const RawScene scene = read(b);
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_EQ(scene.warnings[0].rule, "morph-targets-dropped");
  EXPECT_EQ(scene.warnings[0].pointer, "/meshes/0");
}

// --- Draco ------------------------------------------------------------------------------------------------------

struct DracoTriangle {
  std::vector<std::byte> bytes;
  int position = 0, joints = 0, weights = 0;  // unique ids
};

DracoTriangle encode_draco() {
  draco::TriangleSoupMeshBuilder soup;
  soup.Start(2);
  const int position = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int joints = soup.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
  const int weights = soup.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_FLOAT32);
  const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5F}};
  const std::uint8_t joint[4] = {0, 0, 0, 0};
  const float weight[4] = {1, 0, 0, 0};
  const int faces[2][3] = {{0, 1, 2}, {1, 3, 2}};
  for (int f = 0; f < 2; ++f) {
    const draco::FaceIndex face(static_cast<std::uint32_t>(f));
    soup.SetAttributeValuesForFace(position, face, corners[faces[f][0]], corners[faces[f][1]], corners[faces[f][2]]);
    soup.SetAttributeValuesForFace(joints, face, joint, joint, joint);
    soup.SetAttributeValuesForFace(weights, face, weight, weight, weight);
  }
  const std::unique_ptr<draco::Mesh> mesh = soup.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  DracoTriangle result;
  const auto* begin = reinterpret_cast<const std::byte*>(buffer.data());
  result.bytes.assign(begin, begin + buffer.size());
  result.position = static_cast<int>(mesh->attribute(position)->unique_id());
  result.joints = static_cast<int>(mesh->attribute(joints)->unique_id());
  result.weights = static_cast<int>(mesh->attribute(weights)->unique_id());
  return result;
}

Builder with_draco() {
  const DracoTriangle encoded = encode_draco();
  Builder b;
  b.root["extensionsUsed"] = b.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  b.root["nodes"] = {{{"mesh", 0}, {"skin", 0}}, Json::object()};
  b.root["scenes"][0]["nodes"] = {0, 1};
  b.root["skins"] = {{{"joints", {1}}}};
  const int positions =
      b.accessor({{"componentType", kF32}, {"type", "VEC3"}, {"count", 4}, {"min", {0, 0, 0}}, {"max", {1, 1, 0.5}}});
  const int joints = b.accessor({{"componentType", kU8}, {"type", "VEC4"}, {"count", 4}});
  const int weights = b.accessor({{"componentType", kF32}, {"type", "VEC4"}, {"count", 4}});
  const int indices = b.accessor({{"componentType", kU16}, {"type", "SCALAR"}, {"count", 6}});
  Json& primitive = b.primitive({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
  primitive["indices"] = indices;
  primitive["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", b.view(encoded.bytes)},
      {"attributes", {{"POSITION", encoded.position}, {"JOINTS_0", encoded.joints}, {"WEIGHTS_0", encoded.weights}}}};
  return b;
}

constexpr const char* kDracoPointer = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

TEST(GltfDraco, GeometryJointsAndWeightsAreDecoded) {
  Builder b = with_draco();
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  const RawPrimitive& primitive = scene.meshes[0].primitives.at(0);
  ASSERT_EQ(primitive.positions.size(), 4U);
  ASSERT_EQ(primitive.indices.size(), 6U);
  // The coder may renumber vertices; the triangles' corners in space stay.
  std::vector<glm::vec3> corners;
  for (const std::uint32_t index : primitive.indices) corners.push_back(primitive.positions[index]);
  const std::vector<glm::vec3> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0.5F}, {0, 1, 0}};
  EXPECT_EQ(corners, expected);
  ASSERT_EQ(primitive.influences.size(), 4U);
  EXPECT_EQ(primitive.influences[3].size(), 1U);
  EXPECT_EQ(primitive.influences[3][0].weight, 1.0F);
}

TEST(GltfDraco, EveryPrefixIsRefused) {
  const std::size_t size = encode_draco().bytes.size();
  std::size_t refused = 0;
  for (std::size_t length = 1; length < size; ++length) {
    Builder b = with_draco();
    b.root["bufferViews"][0]["byteLength"] = length;
    expect_failure([&] { read(b); }, Exit::invalid, kDracoPointer, "Draco");
    ++refused;
  }
  EXPECT_EQ(refused, size - 1);
}

TEST(GltfDraco, PromisesAreChecked) {
  Builder count = with_draco();
  for (int i = 0; i < 3; ++i) count.root["accessors"][static_cast<std::size_t>(i)]["count"] = 5;
  expect_failure([&] { read(count); }, Exit::invalid, kDracoPointer, "differs from the accessors");
  Builder id = with_draco();
  id.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]["JOINTS_0"] = 77;
  expect_failure([&] { read(id); }, Exit::invalid, "/meshes/0/primitives/0/attributes/JOINTS_0",
                 "wrong Draco attribute");
  Builder indices = with_draco();
  indices.root["accessors"][3]["count"] = 3;  // fewer: seen before anything is unfolded
  expect_failure([&] { read(indices); }, Exit::invalid, kDracoPointer, "differs from the accessors");
  indices.root["accessors"][3]["count"] = 9;
  expect_failure([&] { read(indices); }, Exit::invalid, "/meshes/0/primitives/0/indices",
                 "differs from the Draco data");
}

// --- nodes ------------------------------------------------------------------------------------------------------

RawNode read_matrix(const Json& matrix, RawScene* scene = nullptr) {
  Builder b;
  b.root["nodes"][0]["matrix"] = matrix;
  RawScene read_scene = read(b);
  if (scene != nullptr) *scene = read_scene;
  return read_scene.nodes.at(0);
}

TEST(GltfNodes, MatrixIsDecomposed) {
  // Scale 2, 3, 4, then a quarter turn about z, then a move: columns are the scaled axes y, −x, z.
  const RawNode node = read_matrix({0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1});
  expect_near(node.translation, {5, 6, 7});
  expect_near(node.scale, {2, 3, 4});
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(node.rotation.z, half, 1e-12);
  EXPECT_NEAR(node.rotation.w, half, 1e-12);
}

TEST(GltfNodes, MirroredMatrixHasOneNegativeAxis) {
  RawScene scene;
  const RawNode node = read_matrix({-2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1}, &scene);
  expect_near(node.scale, {-2, 3, 4});
  EXPECT_NEAR(std::abs(node.rotation.w), 1, 1e-12);
  EXPECT_TRUE(scene.warnings.empty());
  // A point seen through either must be the same, whichever axis is chosen.
  const RawNode other = read_matrix({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1});
  expect_near(other.rotation * (other.scale * glm::dvec3(1, 2, 3)), {1, 2, -3});
}

TEST(GltfNodes, ShearIsDroppedWithAWarning) {
  RawScene scene;
  read_matrix({1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, &scene);
  EXPECT_TRUE(warns(scene, "matrix-sheared", "/nodes/0/matrix"));
}

TEST(GltfNodes, RotationIsNormalisedInAScene) {
  Builder b;
  b.root["nodes"][0]["rotation"] = {5, 5, 5, 5};
  const RawScene scene = read(b);
  EXPECT_NEAR(scene.nodes[0].rotation.w, 0.5, 1e-12);
  EXPECT_TRUE(warns(scene, "rotation-not-unit", "/nodes/0/rotation"));
}

TEST(GltfNodes, LibrariesAreHeldToTheLetter) {
  Builder b;
  b.root.erase("scene");
  b.root.erase("scenes");
  b.root["nodes"][0]["rotation"] = {5, 5, 5, 5};
  expect_failure([&] { read(b); }, Exit::invalid, "/nodes/0/rotation", "rotation-not-unit");
}

TEST(GltfNodes, ZeroScaleStaysInvertible) {
  Builder b;
  b.root["nodes"][0]["scale"] = {0, 1, 2};
  const RawScene scene = read(b);
  EXPECT_EQ(scene.nodes[0].scale.x, 1e-6);
  EXPECT_TRUE(warns(scene, "scale-zero"));
}

TEST(GltfNodes, SceneMembershipIsKnown) {
  Builder b;
  b.root["nodes"] = {{{"children", {1}}}, Json::object(), {{"children", {3}}}, Json::object()};
  b.root["scenes"] = {{{"nodes", {2}}}, {{"nodes", {0}}}};
  b.root["scene"] = 1;
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.nodes[0].in_scene && scene.nodes[1].in_scene);
  EXPECT_FALSE(scene.nodes[2].in_scene || scene.nodes[3].in_scene);
  EXPECT_TRUE(warns(scene, "nodes-outside-scene"));
}

TEST(GltfNodes, LongChainsDoNotRecurse) {
  constexpr int kLength = 100'000;
  Builder b;
  b.root["nodes"] = Json::array();
  Json joints = Json::array();
  for (int i = 0; i < kLength; ++i) {
    b.root["nodes"].push_back(i + 1 < kLength ? Json{{"children", {i + 1}}} : Json::object());
    joints.push_back(i);
  }
  b.root["skins"] = {{{"joints", joints}, {"skeleton", 0}}};
  const RawScene scene = read(b);
  EXPECT_EQ(scene.nodes.size(), static_cast<std::size_t>(kLength));
  EXPECT_EQ(scene.nodes.back().parent, kLength - 2);
}

TEST(GltfNodes, NamesAreMadeSafe) {
  Builder b;
  const auto cleaned = [&](const char* name) {
    b.root["nodes"][0]["name"] = name;
    return read(b).nodes[0].name;
  };
  EXPECT_EQ(cleaned("../../tmp/x"), ".._.._tmp_x");
  EXPECT_EQ(cleaned("/etc"), "_etc");
  EXPECT_EQ(cleaned("con"), "con_");
  EXPECT_EQ(cleaned("LPT1.txt"), "LPT1.txt_");
  EXPECT_EQ(cleaned("a\nb\x1b[2J"), "a_b_[2J");
  EXPECT_EQ(cleaned("\xE2\x80\xAE"
                    "cba"),
            "_cba");
  for (const char* good : {"mixamorig:Hips", "Arm/Hand.L", "Knochen_\xC3\xBC", "\xE9\xAA\xA8", "console", "a..b", ""}) {
    EXPECT_EQ(cleaned(good), good);
  }
}

// --- skins ------------------------------------------------------------------------------------------------------

TEST(GltfSkins, SingularInverseBindComesFromTheRestPose) {
  Builder b = skinned();
  const int matrices = b.numbers<float>(kF32, "MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                                           1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  b.root["skins"][0]["inverseBindMatrices"] = matrices;
  const RawScene scene = read(b);
  EXPECT_EQ(scene.skins[0].inverse_bind[1][3], glm::dvec4(0, -1, 0, 1));  // the tip is at (0, 1, 0)
  EXPECT_EQ(scene.skins[0].inverse_bind[1][1], glm::dvec4(0, 1, 0, 0));
  EXPECT_TRUE(warns(scene, "inverse-bind-unusable", "/skins/0/inverseBindMatrices"));
}

TEST(GltfSkins, SkinWithoutWeightsIsDrawnRigidly) {
  Builder b = skinned();
  b.root["meshes"][0]["primitives"][0]["attributes"].erase("JOINTS_0");
  b.root["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  const RawScene scene = read(b);
  EXPECT_EQ(scene.instances[0].skin, kNone);
  EXPECT_TRUE(warns(scene, "skin-without-weights", "/nodes/0/skin"));
}

TEST(GltfSkins, WeightsWithoutSkinAreDropped) {
  Builder b = skinned();
  b.root["nodes"][0].erase("skin");
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.meshes[0].primitives[0].influences.empty());
  EXPECT_TRUE(warns(scene, "weights-without-skin", "/nodes/0"));
}

// --- clips ------------------------------------------------------------------------------------------------------

TEST(GltfClips, CubicSplinesKeepTheirTangents) {
  Builder b;
  // In-tangent, value, out-tangent.
  const std::vector<float> numbers = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
  b.channel(b.times({0.5F, 2}), b.numbers<float>(kF32, "VEC3", 3, numbers), "translation", "CUBICSPLINE");
  const RawScene scene = read(b);
  const RawChannel& channel = scene.clips.at(0).channels.at(0);
  EXPECT_EQ(channel.interpolation, RawInterpolation::cubic_spline);
  EXPECT_EQ(channel.path, RawPath::translation);
  EXPECT_EQ(channel.times_s, (std::vector<float>{0.5F, 2}));
  ASSERT_EQ(channel.values.size(), 6U);
  EXPECT_EQ(channel.values[1], glm::vec4(4, 5, 6, 0));
  EXPECT_EQ(channel.values[5], glm::vec4(16, 17, 18, 0));
}

TEST(GltfClips, QuaternionTangentsAreNotNormalised) {
  Builder b;
  const std::vector<float> numbers = {9, 0, 0, 0, 0, 0, 0, 1, 5, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 7, 0, 0, 0};
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "VEC4", 4, numbers), "rotation", "CUBICSPLINE");
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.clips[0].channels[0].values[2], glm::vec4(5, 0, 0, 0));
}

TEST(GltfClips, StepIsKept) {
  Builder b;
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "VEC3", 3, {1, 1, 1, 2, 2, 2}), "scale", "STEP");
  EXPECT_EQ(read(b).clips[0].channels[0].interpolation, RawInterpolation::step);
}

TEST(GltfClips, KeysThatCannotBePlayedAreDropped) {
  Builder b;
  const int times = b.times({0, 1e-45F, 1, 1, 2, 9e30F});
  std::vector<float> values;
  for (int i = 0; i < 6; ++i) values.insert(values.end(), {static_cast<float>(i), 0, 0});
  b.channel(times, b.numbers<float>(kF32, "VEC3", 3, values), "translation");
  const RawScene scene = read(b);
  const RawChannel& channel = scene.clips[0].channels[0];
  EXPECT_EQ(channel.times_s, (std::vector<float>{0, 1, 2}));
  EXPECT_EQ(channel.values[1].x, 2);
  EXPECT_EQ(channel.values[2].x, 4);
  EXPECT_TRUE(warns(scene, "keys-too-close", "/animations/0/samplers/0/input"));
  EXPECT_TRUE(warns(scene, "keys-too-late", "/animations/0/samplers/0/input"));
}

TEST(GltfClips, OddRotationsAreNormalised) {
  Builder b;
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "VEC4", 4, {0, 0, 0, 2, 0, 0, 0, 0}), "rotation");
  const RawScene scene = read(b);
  EXPECT_EQ(scene.clips[0].channels[0].values[0], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(scene.clips[0].channels[0].values[1], glm::vec4(0, 0, 0, 1));
  EXPECT_TRUE(warns(scene, "rotation-keys-not-unit"));
}

TEST(GltfClips, WhatMovesNothingIsLeftOut) {
  Builder b;
  b.primitive({{"POSITION", b.curve(3)}});
  const int times = b.times({0, 1});
  const int move = b.numbers<float>(kF32, "VEC3", 3, {0, 0, 0, 1, 0, 0});
  b.channel(times, move, "pointer");
  RawScene scene = read(b);
  EXPECT_TRUE(scene.clips.empty());
  EXPECT_TRUE(warns(scene, "channel-dropped", "/animations/0/channels/0/target/path"));
  EXPECT_TRUE(warns(scene, "clip-dropped", "/animations/0"));
  b.channel(times, move, "translation");
  scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  EXPECT_EQ(scene.clips[0].channels.size(), 1U);
}

// --- numbers ----------------------------------------------------------------------------------------------------

// A triangle with two morph targets, drawn at node 0.
Builder morphing() {
  Builder b;
  const int positions = b.curve(3);
  b.primitive({{"POSITION", positions}})["targets"] = {{{"POSITION", positions}}, {{"POSITION", positions}}};
  return b;
}

TEST(GltfNumbers, WeightsAreATargetEach) {
  Builder b = morphing();
  b.root["nodes"][0]["name"] = "face";
  b.root["meshes"][0]["weights"] = {0.25, 0.5};
  b.root["meshes"][0]["extras"] = {{"targetNames", {"smile"}}};
  b.channel(b.times({0, 1, 3}), b.numbers<float>(kF32, "SCALAR", 1, {0, 1, 2, 3, 4, 5}), "weights", "STEP");
  const RawScene scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  EXPECT_TRUE(scene.clips[0].channels.empty());
  ASSERT_EQ(scene.clips[0].scalars.size(), 2U);
  const RawScalar &smile = scene.clips[0].scalars[0], &other = scene.clips[0].scalars[1];
  EXPECT_EQ(smile.name, "face.smile");
  EXPECT_EQ(other.name, "face.weights[1]");
  EXPECT_EQ(smile.rest, 0.25F);
  EXPECT_EQ(other.rest, 0.5F);
  EXPECT_EQ(smile.interpolation, RawInterpolation::step);
  EXPECT_EQ(smile.times_s, (std::vector<float>{0, 1, 3}));
  EXPECT_EQ(smile.values, (std::vector<float>{0, 2, 4}));
  EXPECT_EQ(other.values, (std::vector<float>{1, 3, 5}));
}

TEST(GltfNumbers, TheNodesWeightsComeFirstAndANodeMayHaveNoName) {
  Builder b = morphing();
  b.root["meshes"][0]["weights"] = {0.25, 0.5};
  b.root["nodes"][0]["weights"] = {0.75, 1};
  // 255 is 1, 51 is 0.2: normalised bytes.
  b.channel(b.times({0}), b.numbers<std::uint8_t>(kU8, "SCALAR", 1, {255, 51}, {{"normalized", true}}), "weights");
  const RawScene scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  ASSERT_EQ(scene.clips[0].scalars.size(), 2U);
  EXPECT_EQ(scene.clips[0].scalars[0].name, "nodes[0].weights[0]");
  EXPECT_EQ(scene.clips[0].scalars[0].rest, 0.75F);
  EXPECT_EQ(scene.clips[0].scalars[1].rest, 1);
  EXPECT_EQ(scene.clips[0].scalars[0].values, (std::vector<float>{1}));
  EXPECT_FLOAT_EQ(scene.clips[0].scalars[1].values[0], 0.2F);
}

// A key of a spline: in-tangents of all targets, values of all, out-tangents of all.
TEST(GltfNumbers, SplinesOfWeights) {
  Builder b = morphing();
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "SCALAR", 1, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}), "weights",
            "CUBICSPLINE");
  const RawScene scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  ASSERT_EQ(scene.clips[0].scalars.size(), 2U);
  EXPECT_EQ(scene.clips[0].scalars[0].values, (std::vector<float>{1, 3, 5, 7, 9, 11}));
  EXPECT_EQ(scene.clips[0].scalars[1].values, (std::vector<float>{2, 4, 6, 8, 10, 12}));
}

Json pointer_channel(int sampler, const char* to) {
  return {{"sampler", sampler},
          {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", to}}}}}}}};
}

// A document of numbers in extras, one animation whose only sampler drives `pointers`.
Builder pointing(const std::vector<const char*>& pointers) {
  Builder b;
  b.primitive({{"POSITION", b.curve(3)}});
  b.root["extensionsUsed"] = {"KHR_animation_pointer"};
  b.root["extras"] = {{"wind", 3}};
  b.root["asset"]["extras"] = {{"mood", 2}};
  b.root["nodes"][0].update(
      {{"name", "hero"},
       {"translation", {1, 2, 3}},
       {"extras",
        {{"health", 0.5}, {"a/b~c", 4}, {"list", {7, {{"deep", 8}}}}, {"text", "x"}, {"on", true}, {"huge", 1e300}}}});
  b.root["scenes"][0]["extras"] = {{"fog", 0.125}};
  b.root["animations"] = {
      {{"samplers", {{{"input", b.times({0, 2})}, {"output", b.numbers<float>(kF32, "SCALAR", 1, {1, 5})}}}},
       {"channels", Json::array()}}};
  for (const char* to : pointers) b.root["animations"][0]["channels"].push_back(pointer_channel(0, to));
  return b;
}

TEST(GltfNumbers, PointersToNumbersInExtras) {
  const struct {
    const char *pointer, *name;
    float rest;
  } cases[] = {{"/nodes/0/extras/health", "hero.health", 0.5F},
               {"/nodes/0/extras/a~1b~0c", "hero.a/b~c", 4},
               {"/nodes/0/extras/list/0", "hero.list[0]", 7},
               {"/nodes/0/extras/list/1/deep", "hero.list[1].deep", 8},
               {"/scenes/0/extras/fog", "scenes[0].fog", 0.125F},
               {"/asset/extras/mood", "mood", 2},
               {"/extras/wind", "wind", 3}};
  std::vector<const char*> pointers;
  for (const auto& c : cases) pointers.push_back(c.pointer);
  Builder b = pointing(pointers);
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.clips.size(), 1U);
  ASSERT_EQ(scene.clips[0].scalars.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(scene.clips[0].scalars[i].name, cases[i].name);
    EXPECT_EQ(scene.clips[0].scalars[i].rest, cases[i].rest);
    EXPECT_EQ(scene.clips[0].scalars[i].times_s, (std::vector<float>{0, 2}));
    EXPECT_EQ(scene.clips[0].scalars[i].values, (std::vector<float>{1, 5}));
  }
}

TEST(GltfNumbers, OtherPointersAreLeftOutAndSaid) {
  const std::vector<const char*> pointers = {"",
                                             "nodes/0/extras/health",
                                             "/",
                                             "/nodes/0/translation",
                                             "/nodes/0/extras",
                                             "/nodes/0/extras/none",
                                             "/nodes/0/extras/text",
                                             "/nodes/0/extras/on",
                                             "/nodes/0/extras/huge",
                                             "/nodes/0/extras/list",
                                             "/nodes/0/extras/list/2",
                                             "/nodes/0/extras/list/00",
                                             "/nodes/0/extras/list/-1",
                                             "/nodes/0/extras/list/99999999999999999999999",
                                             "/nodes/0/extras/health/x",
                                             "/nodes/0/extras/a~2b",
                                             "/nodes/0/extras/a~",
                                             "/nodes/1/extras/health",
                                             "/nodes/x/extras/health",
                                             "/asset/version/extras/x",
                                             "/animations/0/extras/x"};
  std::size_t dropped = 0;
  for (const char* to : pointers) {
    Builder b = pointing({to});
    const RawScene scene = read(b);
    dropped += warns(scene, "channel-dropped", "/animations/0/channels/0/target/path") && scene.clips.empty();
  }
  EXPECT_EQ(dropped, pointers.size());
}

TEST(GltfNumbers, MistakesAreRefused) {
  Builder twice = pointing({"/extras/wind", "/extras/wind"});
  expect_refused(twice.text(), Exit::invalid, "/animations/0/channels/1/target", "animated twice");
  Builder vectors = pointing({"/extras/wind"});
  vectors.root["animations"][0]["samplers"][0]["output"] = vectors.numbers<float>(kF32, "VEC3", 3, {1, 2, 3, 4, 5, 6});
  expect_refused(vectors.text(), Exit::invalid, "/animations/0/channels/0/sampler", "wrong output accessor");
  Builder fewer = pointing({"/extras/wind"});
  fewer.root["animations"][0]["samplers"][0]["output"] = fewer.numbers<float>(kF32, "SCALAR", 1, {1});
  expect_refused(fewer.text(), Exit::invalid, "/animations/0/channels/0/sampler", "differ in count");
  Builder no_pointer = pointing({"/extras/wind"});
  no_pointer.root["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"] = Json::object();
  expect_refused(no_pointer.text(), Exit::invalid,
                 "/animations/0/channels/0/target/extensions/KHR_animation_pointer/pointer", "missing");
  Builder number = pointing({"/extras/wind"});
  number.root["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"]["pointer"] = 7;
  expect_refused(number.text(), Exit::invalid,
                 "/animations/0/channels/0/target/extensions/KHR_animation_pointer/pointer", "wrong type");
  Builder no_sampler = pointing({"/extras/wind"});
  no_sampler.root["animations"][0]["channels"][0]["sampler"] = 9;
  expect_refused(no_sampler.text(), Exit::invalid, "/animations/0/channels/0/sampler", "reference to nothing");
}

// --- refusals ---------------------------------------------------------------------------------------------------

struct BadDocument {
  const char* patch;  // RFC 6902, applied to skinned()
  Exit code;
  const char* where;
  const char* rule;
};

// Accessors of skinned(): 0 positions, 1 joints, 2 weights, 3 indices, 4 inverse binds, 5 times, 6 rotations.
const BadDocument kBadDocuments[] = {
    {R"([{"op":"remove","path":"/asset"}])", Exit::invalid, "/asset", "missing"},
    {R"([{"op":"replace","path":"/asset/version","value":"1.0"}])", Exit::unsupported, "/asset/version", "glTF 1.0"},
    {R"([{"op":"replace","path":"/asset/version","value":"two"}])", Exit::invalid, "/asset/version", "not a version"},
    {R"([{"op":"add","path":"/asset/minVersion","value":"2.9"}])", Exit::invalid, "/asset/minVersion", "greater"},
    {R"([{"op":"replace","path":"/scene","value":4}])", Exit::invalid, "/scene", "reference to nothing"},
    {R"([{"op":"replace","path":"/scene","value":"x"}])", Exit::invalid, "/scene", "wrong type"},
    {R"([{"op":"replace","path":"/scenes/0/nodes","value":[0,2]}])", Exit::invalid, "/scenes/0/nodes/1", "not a root"},
    {R"([{"op":"replace","path":"/nodes/0/mesh","value":1}])", Exit::invalid, "/nodes/0/mesh", "reference to nothing"},
    {R"([{"op":"replace","path":"/nodes/0/skin","value":2147483648}])", Exit::invalid, "/nodes/0/skin",
     "reference to nothing"},
    {R"([{"op":"remove","path":"/nodes/0/mesh"}])", Exit::invalid, "/nodes/0/skin", "skin without mesh"},
    {R"([{"op":"replace","path":"/nodes/1/children","value":[-1]}])", Exit::invalid, "/nodes/1/children/0",
     "reference to nothing"},
    {R"([{"op":"add","path":"/nodes/2/children","value":[2]}])", Exit::invalid, "/nodes/2/children/0", "two parents"},
    {R"([{"op":"add","path":"/nodes/2/children","value":[1]}])", Exit::invalid, "/nodes/1", "node loop"},
    {R"([{"op":"add","path":"/nodes/0/children","value":[0]}])", Exit::invalid, "/nodes/0", "node loop"},
    {R"([{"op":"add","path":"/nodes/2/matrix","value":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])", Exit::invalid,
     "/nodes/2/matrix", "both"},
    {R"([{"op":"add","path":"/nodes/2/rotation","value":[0,0,0,1,0]}])", Exit::invalid, "/nodes/2/rotation",
     "wrong number"},
    {R"([{"op":"replace","path":"/nodes/2/translation/1","value":1e39}])", Exit::invalid, "/nodes/2/translation/1",
     "out of range"},
    {R"([{"op":"replace","path":"/nodes/2/name","value":7}])", Exit::invalid, "/nodes/2/name", "wrong type"},
    {R"([{"op":"replace","path":"/skins/0/joints","value":[1,1]}])", Exit::invalid, "/skins/0/joints/1",
     "listed twice"},
    {R"([{"op":"replace","path":"/skins/0/joints","value":[]}])", Exit::invalid, "/skins/0/joints", "wrong number"},
    {R"([{"op":"add","path":"/nodes/3","value":{}},{"op":"add","path":"/skins/0/joints/2","value":3}])", Exit::invalid,
     "/skins/0/joints/2", "no common root"},
    {R"([{"op":"replace","path":"/scenes/0/nodes","value":[0]}])", Exit::invalid, "/nodes/0/skin",
     "joints outside the scene"},
    {R"([{"op":"replace","path":"/skins/0/joints","value":[1]}])", Exit::invalid,
     "/meshes/0/primitives/0/attributes/JOINTS_0", "joint that the skin lacks"},
    {R"([{"op":"replace","path":"/accessors/4/count","value":1}])", Exit::invalid, "/skins/0/inverseBindMatrices",
     "too few"},
    {R"([{"op":"replace","path":"/skins/0/inverseBindMatrices","value":6}])", Exit::invalid,
     "/skins/0/inverseBindMatrices", "wrong accessor"},
    {R"([{"op":"replace","path":"/accessors/0/count","value":5}])", Exit::invalid, "/accessors/0",
     "beyond the bufferView"},
    {R"([{"op":"replace","path":"/accessors/0/count","value":4611686018427387904}])", Exit::invalid,
     "/accessors/0/count", "out of range"},
    {R"([{"op":"replace","path":"/accessors/0/count","value":4294967295}])", Exit::invalid, "/accessors/0",
     "beyond the bufferView"},
    {R"([{"op":"replace","path":"/accessors/0/count","value":0}])", Exit::invalid, "/accessors/0/count",
     "out of range"},
    {R"([{"op":"replace","path":"/accessors/0/count","value":2.5}])", Exit::invalid, "/accessors/0/count",
     "wrong type"},
    {R"([{"op":"add","path":"/accessors/0/byteOffset","value":4294967292}])", Exit::invalid, "/accessors/0",
     "beyond the bufferView"},
    {R"([{"op":"add","path":"/accessors/2/byteOffset","value":2}])", Exit::invalid, "/accessors/2/byteOffset",
     "misaligned"},
    {R"([{"op":"replace","path":"/accessors/0/componentType","value":5124}])", Exit::invalid,
     "/accessors/0/componentType", "unknown component"},
    {R"([{"op":"add","path":"/accessors/0/normalized","value":true}])", Exit::invalid, "/accessors/0/normalized",
     "cannot be normalised"},
    {R"([{"op":"remove","path":"/accessors/0/bufferView"},{"op":"add","path":"/accessors/0/byteOffset","value":0}])",
     Exit::invalid, "/accessors/0/byteOffset", "without a bufferView"},
    {R"([{"op":"replace","path":"/accessors/0/bufferView","value":99}])", Exit::invalid, "/accessors/0/bufferView",
     "reference to nothing"},
    {R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":5,"indices":{"bufferView":3,"componentType":5123},"values":{"bufferView":0}}}])",
     Exit::invalid, "/accessors/0/sparse/count", "more than"},
    {R"([{"op":"add","path":"/accessors/0/sparse","value":{"count":4,"indices":{"bufferView":3,"componentType":5123},"values":{"bufferView":0}}}])",
     Exit::invalid, "/accessors/0/sparse/indices", "must increase"},
    {R"([{"op":"replace","path":"/bufferViews/0/byteOffset","value":9007199254740991}])", Exit::invalid,
     "/bufferViews/0/byteLength", "beyond the buffer"},
    {R"([{"op":"replace","path":"/bufferViews/0/byteLength","value":0}])", Exit::invalid, "/bufferViews/0/byteLength",
     "out of range"},
    {R"([{"op":"add","path":"/bufferViews/0/byteStride","value":-12}])", Exit::invalid, "/bufferViews/0/byteStride",
     "out of range"},
    {R"([{"op":"add","path":"/bufferViews/0/byteStride","value":13}])", Exit::invalid, "/bufferViews/0/byteStride",
     "multiple of 4"},
    {R"([{"op":"add","path":"/bufferViews/0/byteStride","value":8}])", Exit::invalid, "/accessors/0", "overlap"},
    {R"([{"op":"replace","path":"/buffers/0/byteLength","value":2147483647}])", Exit::invalid, "/buffers/0/byteLength",
     "longer than the data"},
    {R"([{"op":"replace","path":"/meshes/0/primitives/0/indices","value":0}])", Exit::invalid,
     "/meshes/0/primitives/0/indices", "wrong accessor"},
    {R"([{"op":"add","path":"/meshes/0/primitives/0/mode","value":42}])", Exit::invalid, "/meshes/0/primitives/0/mode",
     "out of range"},
    {R"([{"op":"remove","path":"/meshes/0/primitives/0/attributes/WEIGHTS_0"}])", Exit::invalid,
     "/meshes/0/primitives/0/attributes/JOINTS_0", "pairs"},
    {R"([{"op":"replace","path":"/meshes/0/primitives/0/attributes/JOINTS_0","value":2}])", Exit::invalid,
     "/meshes/0/primitives/0/attributes/JOINTS_0", "wrong component type"},
    {R"([{"op":"replace","path":"/meshes/0/primitives/0/attributes/POSITION","value":2}])", Exit::invalid,
     "/meshes/0/primitives/0/attributes/POSITION", "wrong accessor type"},
    {R"([{"op":"replace","path":"/accessors/1/count","value":2}])", Exit::invalid,
     "/meshes/0/primitives/0/attributes/POSITION", "differs in count"},
    {R"([{"op":"replace","path":"/meshes/0/primitives","value":{}}])", Exit::invalid, "/meshes/0/primitives",
     "wrong type"},
    {R"([{"op":"replace","path":"/animations/0/channels","value":[]}])", Exit::invalid, "/animations/0/channels",
     "wrong number"},
    {R"([{"op":"replace","path":"/animations/0/channels/0/sampler","value":1}])", Exit::invalid,
     "/animations/0/channels/0/sampler", "reference to nothing"},
    {R"([{"op":"replace","path":"/animations/0/samplers/0/interpolation","value":""}])", Exit::invalid,
     "/animations/0/samplers/0/interpolation", "unknown value"},
    {R"([{"op":"replace","path":"/animations/0/samplers/0/input","value":1}])", Exit::invalid,
     "/animations/0/samplers/0/input", "wrong accessor"},
    {R"([{"op":"replace","path":"/animations/0/samplers/0/output","value":5}])", Exit::invalid,
     "/animations/0/channels/0/sampler", "wrong output"},
    {R"([{"op":"replace","path":"/accessors/6/count","value":1}])", Exit::invalid, "/animations/0/channels/0/sampler",
     "differ in count"},
    {R"([{"op":"copy","from":"/animations/0/channels/0","path":"/animations/0/channels/1"}])", Exit::invalid,
     "/animations/0/channels/1/target", "animated twice"},
    {R"([{"op":"add","path":"/extensionsRequired","value":["EVIL_x"]}])", Exit::unsupported, "/extensionsRequired/0",
     "EVIL_x"},
    {R"([{"op":"add","path":"/extensionsUsed","value":["EXT_meshopt_compression"]},{"op":"add","path":"/extensionsRequired","value":["EXT_meshopt_compression"]}])",
     Exit::unsupported, "/extensionsRequired/0", "EXT_meshopt_compression"},
    {R"([{"op":"add","path":"/extensions","value":{"KHR_x":[]}}])", Exit::invalid, "/extensions/KHR_x", "wrong type"},
    {R"([{"op":"add","path":"/images","value":[{"bufferView":99,"mimeType":"image/png"}]}])", Exit::invalid,
     "/images/0/bufferView", "reference to nothing"},
    {R"([{"op":"add","path":"/images","value":[{"uri":"..%2fx.png"}]}])", Exit::invalid, "/images/0/uri",
     "not allowed"},
};

TEST(GltfRefusals, AreLocatedAndCoded) {
  std::size_t checked = 0;
  for (const BadDocument& bad : kBadDocuments) {
    Builder b = skinned();
    const Json root = Json::parse(b.text());
    expect_refused(root.patch(Json::parse(bad.patch)).dump(), bad.code, bad.where, bad.rule);
    ++checked;
  }
  EXPECT_EQ(checked, std::size(kBadDocuments));
  EXPECT_GT(checked, 50U);
}

TEST(GltfRefusals, DamagedNumbersAreFound) {
  Builder position;
  position.primitive({{"POSITION", position.numbers<float>(kF32, "VEC3", 3, {0, 0, 0, 1, kNan, 0, 0, 1, 0},
                                                           {{"min", {0, 0, 0}}, {"max", {1, 1, 0}}})}});
  expect_failure([&] { read(position); }, Exit::invalid, "/meshes/0/primitives/0/attributes/POSITION",
                 "not a finite number");

  Builder time;
  const int times = time.numbers<float>(kF32, "SCALAR", 1, {0, kNan}, {{"min", {0}}, {"max", {1}}});
  time.channel(times, time.numbers<float>(kF32, "VEC3", 3, {0, 0, 0, 0, 0, 0}), "translation");
  expect_failure([&] { read(time); }, Exit::invalid, "/animations/0/samplers/0/input", "not a finite number");

  Builder unsorted;
  unsorted.channel(unsorted.times({0, 2, 1}), unsorted.numbers<float>(kF32, "VEC3", 3, std::vector<float>(9)),
                   "translation");
  expect_failure([&] { read(unsorted); }, Exit::invalid, "/animations/0/samplers/0/input", "times must increase");

  Builder value;
  value.channel(value.times({0, 1}), value.numbers<float>(kF32, "VEC3", 3, {0, 0, 0, 0, kNan, 0}), "translation");
  expect_failure([&] { read(value); }, Exit::invalid, "/animations/0/samplers/0/output", "not a finite number");

  Builder index;
  index.primitive({{"POSITION", index.curve(3)}})["indices"] =
      index.numbers<std::uint16_t>(kU16, "SCALAR", 1, {0, 1, 3});
  expect_failure([&] { read(index); }, Exit::invalid, "/meshes/0/primitives/0/indices", "vertex that does not exist");

  Builder restart;
  restart.primitive({{"POSITION", restart.curve(3)}})["indices"] =
      restart.numbers<std::uint8_t>(kU8, "SCALAR", 1, {0, 1, 255});
  expect_failure([&] { read(restart); }, Exit::invalid, "/meshes/0/primitives/0/indices", "primitive restart");
}

TEST(GltfRefusals, MemoryIsNotForTheAsking) {
  Builder b;
  const int zeros = b.accessor(
      {{"componentType", kF32}, {"type", "VEC3"}, {"count", 16'000'000}, {"min", {0, 0, 0}}, {"max", {0, 0, 0}}});
  b.primitive({{"POSITION", zeros}});
  expect_failure([&] { read(b); }, Exit::unsupported, "/meshes/0/primitives/0", "unfolds too far");
  b.root["accessors"][0]["count"] = 20'000'000;
  expect_failure([&] { read(b); }, Exit::unsupported, "/accessors/0/count", "too many zeros");
}

TEST(GltfRefusals, JsonIsStrict) {
  const std::string start = R"({"asset":{"version":"2.0"})";
  expect_refused(start + R"(,"nodes":[{"translation":[NaN,0,0]}]})", Exit::invalid, "@52", "not JSON");
  expect_refused(start + R"(,"nodes":[{"translation":[.5,0,0]}]})", Exit::invalid, "@52", "not JSON");
  expect_refused(start + R"(,"x":1e400})", Exit::invalid, "@35", "not JSON");
  expect_refused(start + R"(,})", Exit::invalid, "@27", "not JSON");
  expect_refused(start + "} x", Exit::invalid, "@28", "not JSON");
  expect_refused(start, Exit::invalid, "@26", "not JSON");
  expect_refused(start + ",\"nodes\":[{\"name\":\"\xC0\x80\"}]}", Exit::invalid, "@45", "not JSON");
  expect_refused(R"({"asset":{"version":"2.0","version":"2.0"}})", Exit::invalid, "@34", "duplicate name");
  expect_refused("\xEF\xBB\xBF" + start + "}", Exit::invalid, "@0", "not a glTF file");
  expect_refused("[]", Exit::invalid, "@0", "not a glTF file");
  expect_refused(start + std::string(1, '\0') + "}", Exit::invalid, "@26", "not JSON");
  std::string deep = start + R"(,"extras":)";
  deep += std::string(100'000, '[') + std::string(100'000, ']') + "}";
  expect_refused(deep, Exit::invalid, "@163", "nested too deeply");
}

// --- container --------------------------------------------------------------------------------------------------

void append_u32(std::string& text, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) text += static_cast<char>(value >> (8 * i) & 0xFF);
}

std::string chunk(const std::string& type, std::string content, char padding) {
  while (content.size() % 4 != 0) content += padding;
  std::string text;
  append_u32(text, static_cast<std::uint32_t>(content.size()));
  return text + type + content;
}

std::string glb(const std::string& chunks, std::uint32_t version = 2, int excess = 0) {
  std::string text = "glTF";
  append_u32(text, version);
  append_u32(text, static_cast<std::uint32_t>(static_cast<int>(chunks.size()) + 12 + excess));
  return text + chunks;
}

const std::string kBin("BIN\0", 4);

std::string triangle_json() {
  Builder b;
  b.primitive({{"POSITION", b.curve(3)}});
  b.root["buffers"] = {{{"byteLength", b.bytes.size()}}};
  return b.root.dump();
}

std::string triangle_bin() {
  Builder b;
  b.curve(3);
  return {reinterpret_cast<const char*>(b.bytes.data()), b.bytes.size()};
}

TEST(GltfContainer, BinaryChunkIsTheFirstBuffer) {
  const RawScene scene = read_text(glb(chunk("JSON", triangle_json(), ' ') + chunk(kBin, triangle_bin(), '\0')));
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.meshes[0].primitives[0].positions[2], glm::vec3(2, 4, 0));
}

TEST(GltfContainer, BytesAfterTheEndAreDropped) {
  const std::string file = glb(chunk("JSON", triangle_json(), ' ') + chunk(kBin, triangle_bin(), '\0'));
  const RawScene scene = read_text(file + "and more");
  EXPECT_TRUE(warns(scene, "glb-trailing-bytes", "@" + std::to_string(file.size())));
}

TEST(GltfContainer, BreachesAreLocated) {
  const std::string json = chunk("JSON", R"({"asset":{"version":"2.0"}})", ' ');  // 8 + 28 bytes
  const std::string bin = chunk(kBin, "data", '\0');
  expect_refused("glTF", Exit::invalid, "@4", "cut short");
  expect_refused(glb(json, 1), Exit::unsupported, "@4", "version 1");
  expect_refused(glb(json, 3), Exit::invalid, "@4", "version 3");
  expect_refused(glb(""), Exit::invalid, "@8", "too small");
  expect_refused(glb(json, 2, 4), Exit::invalid, "@48", "cut short");
  expect_refused(glb(bin + json), Exit::invalid, "@12", "not JSON");
  expect_refused(glb(chunk("JSON", "", ' ')), Exit::invalid, "@12", "empty");
  expect_refused(glb(json + json), Exit::invalid, "@48", "second JSON");
  expect_refused(glb(json + bin + bin), Exit::invalid, "@60", "second BIN");
  expect_refused(glb(json + chunk("XXXX", "data", ' ') + bin), Exit::invalid, "@60", "misplaced");
  expect_refused(glb(json + "abc"), Exit::invalid, "@51", "header cut short");
  std::string huge;
  append_u32(huge, 0xFFFFFFFC);
  expect_refused(glb(huge + "JSON{}  "), Exit::invalid, "@12", "too long");
  std::string odd;
  append_u32(odd, 3);
  expect_refused(glb(odd + "JSON{} "), Exit::invalid, "@12", "multiple of 4");
  const RawScene scene = read_text(glb(json + chunk("XXXX", "data", ' ')));
  EXPECT_TRUE(warns(scene, "unknown-chunk", "@48"));
}

TEST(GltfContainer, EveryPrefixIsRefused) {
  const std::string file = glb(chunk("JSON", triangle_json(), ' ') + chunk(kBin, triangle_bin(), '\0'));
  std::size_t refused = 0;
  for (std::size_t length = 0; length < file.size(); ++length) {
    EXPECT_THROW(read_text(file.substr(0, length)), Failure) << length;
    ++refused;
  }
  EXPECT_EQ(refused, file.size());
}

TEST(GltfContainer, OtherFilesAreNamedAsSuch) {
  expect_refused("\x89PNG\r\n\x1a\n", Exit::invalid, "@0", "not a glTF file");
  expect_refused("", Exit::invalid, "@0", "empty file");
}

// --- URIs and files ---------------------------------------------------------------------------------------------

class GltfFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "gltf_test_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    outer_ = name;
    folder_ = outer_ / "scene";
    std::filesystem::create_directory(folder_);
    write(outer_ / "secret.bin", std::string(64, 's'));
  }
  void TearDown() override { std::filesystem::remove_all(outer_); }

  static void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
  }

  std::string scene_with_uri(const std::string& uri, std::size_t length = 36) {
    Builder b;
    b.primitive({{"POSITION", b.curve(3)}});
    b.root["buffers"] = {{{"byteLength", length}, {"uri", uri}}};
    const std::string path = (folder_ / "scene.gltf").string();
    write(path, b.root.dump());
    return path;
  }

  std::filesystem::path outer_, folder_;
};

TEST_F(GltfFiles, ExternalBufferIsRead) {
  write(folder_ / "a b.bin", triangle_bin() + "rest");
  const std::string path = scene_with_uri("a%20b.bin");
  const RawScene scene = read_gltf(path);
  EXPECT_EQ(scene.meshes[0].primitives[0].positions[1], glm::vec3(1, 1, 0));
  EXPECT_EQ(scene.source, path);
  EXPECT_EQ(scene.source_bytes, std::filesystem::file_size(path) + 36);
}

TEST_F(GltfFiles, HostileUrisAreRefused) {
  const char* uris[] = {"../secret.bin",
                        "..%2fsecret.bin",
                        "%2e%2e/secret.bin",
                        "x/../../secret.bin",
                        "/etc/passwd",
                        "file:///etc/passwd",
                        "http://127.0.0.1/x",
                        "c:\\x",
                        "c:x",
                        "\\\\host\\x",
                        "..\\secret.bin",
                        "a%00b",
                        "a%0ab",
                        "%",
                        "%zz",
                        "~/x",
                        ""};
  std::size_t refused = 0;
  for (const char* uri : uris) {
    SCOPED_TRACE(uri);
    const std::string path = scene_with_uri(uri);
    const bool malformed = std::string(uri).starts_with("%") && std::string(uri).size() < 4;
    expect_failure([&] { read_gltf(path); }, Exit::invalid, "/buffers/0/uri",
                   malformed ? "malformed URI" : "not allowed");
    ++refused;
  }
  EXPECT_EQ(refused, std::size(uris));
}

TEST_F(GltfFiles, UrisAreDecodedOnce) {
  expect_failure([&] { read_gltf(scene_with_uri("..%252fsecret.bin")); }, Exit::io, "/buffers/0/uri", "no such file");
}

TEST_F(GltfFiles, LinksMayNotLeaveTheFolder) {
  std::filesystem::create_symlink(outer_ / "secret.bin", folder_ / "link.bin");
  expect_failure([&] { read_gltf(scene_with_uri("link.bin")); }, Exit::invalid, "/buffers/0/uri", "not allowed");
  write(folder_ / "real.bin", triangle_bin());
  std::filesystem::create_symlink("real.bin", folder_ / "good.bin");
  EXPECT_EQ(read_gltf(scene_with_uri("good.bin")).meshes.size(), 1U);
}

TEST_F(GltfFiles, OnlyRegularFilesAreOpened) {
  expect_failure([&] { read_gltf(scene_with_uri("none.bin")); }, Exit::io, "/buffers/0/uri", "no such file");
  expect_failure([&] { read_gltf(scene_with_uri(".")); }, Exit::io, "/buffers/0/uri", "is a directory");
  ASSERT_EQ(mkfifo((folder_ / "pipe.bin").c_str(), 0600), 0);
  expect_failure([&] { read_gltf(scene_with_uri("pipe.bin")); }, Exit::io, "/buffers/0/uri", "not a regular file");
  expect_failure([&] { read_gltf((folder_ / "pipe.bin").string()); }, Exit::io, "@0", "not a regular file");
  expect_failure([&] { read_gltf(folder_.string()); }, Exit::io, "@0", "is a directory");
  expect_failure([&] { read_gltf((folder_ / "none.gltf").string()); }, Exit::io, "@0", "no such file");
  expect_failure([&] { read_gltf("/dev/zero"); }, Exit::io, "@0", "not a regular file");
}

TEST_F(GltfFiles, ShortBuffersAreRefused) {
  write(folder_ / "short.bin", "abc");
  expect_failure([&] { read_gltf(scene_with_uri("short.bin")); }, Exit::invalid, "/buffers/0/byteLength",
                 "longer than the data");
}

TEST(GltfUris, MemoryHasNoFolder) {
  Builder b;
  b.root["buffers"] = {{{"byteLength", 4}, {"uri", "x.bin"}}};
  expect_failure([&] { read(b); }, Exit::io, "/buffers/0/uri", "cannot read");
}

TEST(GltfUris, DataUrisAreStrict) {
  const auto with = [](const std::string& uri) {
    return Json{{"asset", {{"version", "2.0"}}}, {"buffers", {{{"byteLength", 1}, {"uri", uri}}}}}.dump();
  };
  for (const char* good : {"data:application/octet-stream;base64,AA==", "data:application/gltf-buffer;base64,AAAA",
                           "data:application/gltf-buffer,%00", "data:application/octet-stream;charset=x;base64,AAA="}) {
    EXPECT_NO_THROW(read_text(with(good))) << good;
  }
  for (const char* bad : {"data:", "data:application/octet-stream;base64", "data:application/octet-stream;;base64,AA==",
                          "data:application/octet-stream;base64;x=y,AA==", "data:application/octet-stream;base64,AA",
                          "data:application/octet-stream;base64,AB==", "data:application/octet-stream;base64,====",
                          "data:application/octet-stream;base64,A A=", "data:application/octet-stream;base64,!!!!",
                          "data:application/octet-stream,%0", "data:text/plain;base64,AA=="}) {
    EXPECT_THROW(read_text(with(bad)), Failure) << bad;
  }
}

// --- repairs and warnings ---------------------------------------------------------------------------------------

TEST(GltfRepairs, WrongBoundsAreIgnored) {
  Builder b;
  const int positions = b.curve(3);
  b.primitive({{"POSITION", positions}});
  b.root["accessors"][0]["max"] = {1, 1, 0};
  EXPECT_TRUE(warns(read(b), "bounds-wrong", "/accessors/0/max/0"));
  b.root["accessors"][0]["max"] = {1};
  EXPECT_TRUE(warns(read(b), "bounds-wrong", "/accessors/0/max"));
  b.root["accessors"][0].erase("max");
  EXPECT_TRUE(warns(read(b), "bounds-missing", "/meshes/0/primitives/0/attributes/POSITION"));
}

TEST(GltfRepairs, FloatsMaySpellIntegers) {
  Builder b;
  b.primitive({{"POSITION", b.curve(3)}});
  std::string text = b.text();
  const std::string count = "\"count\":3";
  text.replace(text.find(count), count.size(), "\"count\":3.0");
  EXPECT_EQ(read_text(text).meshes[0].primitives[0].positions.size(), 3U);
}

TEST(GltfRepairs, WhatIsNotCarriedIsNamed) {
  Builder b;
  b.root["cameras"] = {{{"type", "perspective"}}};
  b.root["images"] = {{{"uri", "a.png"}}, {{"uri", "b.png"}}};
  b.root["extensionsUsed"] = {"KHR_lights_punctual", "ACME_x"};
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::array();
  b.root["oddity"] = 1;
  const int uv = b.numbers<float>(kF32, "VEC2", 2, {0, 0, 0, 0, 0, 0});
  const int colour = b.numbers<float>(kF32, "VEC3", 3, std::vector<float>(9));
  b.primitive(
      {{"POSITION", b.curve(3)}, {"TEXCOORD_0", uv}, {"TEXCOORD_1", uv}, {"COLOR_0", colour}, {"COLOR_1", colour}});
  const RawScene scene = read(b);
  for (const char* rule : {"cameras-dropped", "textures-dropped", "lights-dropped", "unknown-property",
                           "extra-uvs-dropped", "extra-colours-dropped", "extension-ignored"}) {
    EXPECT_TRUE(warns(scene, rule)) << rule;
  }
  EXPECT_EQ(std::ranges::count(scene.warnings, "textures-dropped", &RawWarning::rule), 1);
}

TEST(GltfRepairs, RepeatedWarningsAreCounted) {
  Builder b;
  for (int i = 0; i < 50; ++i) b.root["odd" + std::to_string(i)] = 1;
  const RawScene scene = read(b);
  EXPECT_EQ(scene.warnings.size(), 8U);
  EXPECT_NE(scene.warnings.back().text.find("42 more"), std::string::npos);
}

TEST(GltfRepairs, AFileWithoutMeshesReads) {
  const RawScene scene = read_text(R"({"asset":{"version":"2.0"}})");
  EXPECT_TRUE(scene.nodes.empty() && scene.meshes.empty() && scene.warnings.empty());
}

}  // namespace
}  // namespace marrow::cook
