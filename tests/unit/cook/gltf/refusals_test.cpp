// Reading glTF: every way a document can be wrong, and what is mended or only said.
#include "cook/gltf/read.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

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
    {R"([{"op":"replace","path":"/asset/version","value":"1.0"},{"op":"replace","path":"/nodes","value":{"n":{}}},
         {"op":"replace","path":"/scene","value":"s"},{"op":"replace","path":"/scenes","value":{"s":{"nodes":["n"]}}}])",
     Exit::unsupported, "/asset/version", "glTF 1.0"},
    {R"([{"op":"remove","path":"/asset"},{"op":"replace","path":"/nodes","value":{"n":{}}}])", Exit::unsupported,
     "/asset/version", "glTF 1.0"},
    {R"([{"op":"replace","path":"/asset/version","value":"3.0"}])", Exit::unsupported, "/asset/version", "glTF 3.0"},
    {R"([{"op":"replace","path":"/asset/version","value":"two"}])", Exit::invalid, "/asset/version", "not a version"},
    {R"([{"op":"add","path":"/asset/minVersion","value":"2.9"}])", Exit::invalid, "/asset/minVersion", "greater"},
    {R"([{"op":"replace","path":"/scene","value":4}])", Exit::invalid, "/scene", "reference to nothing"},
    {R"([{"op":"replace","path":"/scene","value":"x"}])", Exit::invalid, "/scene", "wrong type"},
    {R"([{"op":"replace","path":"/scenes/0/nodes","value":[0,2]},
         {"op":"add","path":"/nodes/1/translation","value":[1,0,0]}])",
     Exit::invalid, "/scenes/0/nodes/1", "not a root"},
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
    {R"([{"op":"replace","path":"/nodes/2/translation/1","value":1e13}])", Exit::invalid, "/nodes/2", "beyond 1e12"},
    {R"([{"op":"add","path":"/nodes/1/scale","value":[1e7,1,1]},{"op":"replace","path":"/nodes/2/translation/0","value":1e7}])",
     Exit::invalid, "/nodes/2", "with the nodes above"},
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
    {R"([{"op":"replace","path":"/accessors/0/count","value":0}])", Exit::invalid,
     "/meshes/0/primitives/0/attributes/POSITION", "differs in count"},
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
    {R"([{"op":"replace","path":"/bufferViews/0/byteLength","value":0}])", Exit::invalid, "/accessors/0",
     "beyond the bufferView's end"},
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
    {R"([{"op":"copy","from":"/animations/0/channels/0","path":"/animations/0/channels/1"},
         {"op":"copy","from":"/animations/0/samplers/0","path":"/animations/0/samplers/1"},
         {"op":"replace","path":"/animations/0/samplers/1/interpolation","value":"STEP"},
         {"op":"replace","path":"/animations/0/channels/1/sampler","value":1}])",
     Exit::invalid, "/animations/0/channels/1/target", "animated twice"},
    {R"([{"op":"add","path":"/extensionsRequired","value":["EVIL_x"]}])", Exit::unsupported, "/extensionsRequired/0",
     "EVIL_x"},
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

  Builder huge;
  huge.channel(huge.times({0, 1}), huge.numbers<float>(kF32, "VEC3", 3, {0, 0, 0, 0, 2e12F, 0}), "translation");
  expect_failure([&] { read(huge); }, Exit::invalid, "/animations/0/samplers/0/output", "beyond 1e12");

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
  expect_refused("\xEF\xBB\xBF" + start + ",}", Exit::invalid, "@30", "not JSON");
  expect_refused("[]", Exit::invalid, "@0", "not a glTF file");
  expect_refused(start + std::string(1, '\0') + "}", Exit::invalid, "@26", "not JSON");
  std::string deep = start + R"(,"extras":)";
  deep += std::string(100'000, '[') + std::string(100'000, ']') + "}";
  expect_refused(deep, Exit::invalid, "@163", "nested too deeply");
}

// glTF 2.0, section 2.7: writers must not add one, readers may skip it.
TEST(GltfRepairs, AByteOrderMarkIsSkipped) {
  const std::string text = "\xEF\xBB\xBF" + skinned().text();
  const RawScene scene = read_text(text);
  EXPECT_EQ(scene.nodes.size(), 3U);
  EXPECT_TRUE(warns(scene, "byte-order-mark", "@0"));
  EXPECT_EQ(scene.warnings.size(), 1U);
  expect_failure([&] { read_text(text, {.strict = true}); }, Exit::invalid, "@0", "byte-order-mark");
}

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
  b.root["extensionsUsed"] = {"KHR_lights_punctual", "ACME_x"};
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::array();
  b.root["oddity"] = 1;
  const int uv = b.numbers<float>(kF32, "VEC2", 2, {0, 0, 0, 0, 0, 0});
  const int colour = b.numbers<float>(kF32, "VEC3", 3, std::vector<float>(9));
  b.primitive(
      {{"POSITION", b.curve(3)}, {"TEXCOORD_0", uv}, {"TEXCOORD_1", uv}, {"COLOR_0", colour}, {"COLOR_1", colour}});
  const RawScene scene = read(b);
  for (const char* rule : {"cameras-dropped", "lights-dropped", "unknown-property", "extra-uvs-dropped",
                           "extra-colours-dropped", "extension-ignored"}) {
    EXPECT_TRUE(warns(scene, rule)) << rule;
  }
}

TEST(GltfRepairs, RepeatedWarningsAreCounted) {
  Builder b;
  for (int i = 0; i < 1042; ++i) b.root["odd" + std::to_string(i)] = 1;
  const RawScene scene = read(b);
  EXPECT_EQ(scene.warnings.size(), 1000U);
  EXPECT_NE(scene.warnings.back().text.find("42 more"), std::string::npos);
}

TEST(GltfRepairs, AFileWithoutMeshesReads) {
  const RawScene scene = read_text(R"({"asset":{"version":"2.0"}})");
  EXPECT_TRUE(scene.nodes.empty() && scene.meshes.empty() && scene.warnings.empty());
}

}  // namespace
}  // namespace marrow::cook
