// Reading glTF: what a scene's faults are mended to or said to be. In a library of parts, which has no scene, what is
// mended elsewhere is refused, and so it is where that is asked for.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

// skinned() with accessors that its mesh does not use: 7 unsigned 32-bit scalars, 8 normals, 9 tangents, 10 texture
// coordinates, 11 colours, 12 unsigned 16-bit positions, 13 changes of positions, 14 bytes.
Builder furnished() {
  Builder b = skinned();
  b.numbers<std::uint32_t>(kU32, "SCALAR", 1, {0, 1, 2, 3});
  b.numbers<float>(kF32, "VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  b.numbers<float>(kF32, "VEC4", 4, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  b.numbers<float>(kF32, "VEC2", 2, {0, 0, 1, 0, 0, 1, 1, 1});
  b.numbers<float>(kF32, "VEC4", 4, std::vector<float>(16, 0.5F));
  b.numbers<std::uint16_t>(kU16, "VEC3", 3, {0, 0, 0, 0, 1, 1, 0, 0, 2, 4, 0, 0, 3, 9, 0, 0});
  b.root["accessors"][12]["count"] = 4;
  b.root["bufferViews"][12]["byteStride"] = 8;
  b.positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  b.numbers<std::uint8_t>(kU8, "SCALAR", 1, {0, 1, 2, 3});
  return b;
}

enum class Kind { mended, said };

struct Fault {
  const char* patch;  // RFC 6902, applied to furnished()
  Kind kind;
  const char* rule;
  const char* where;
};

#define ADD(path, value) R"({"op":"add","path":")" path R"(","value":)" value "}"
#define DROP(path) R"({"op":"remove","path":")" path R"("})"
#define PRIMITIVE "/meshes/0/primitives/0"
#define ATTRIBUTES PRIMITIVE "/attributes"

const Fault kFaults[] = {
    // Meshes.
    {"[" ADD("/meshes/0/weights", "[1]") "]", Kind::mended, "morph-weights-wrong", "/meshes/0/weights"},
    {"[" ADD("/nodes/0/weights", "[1]") "]", Kind::mended, "morph-weights-wrong", "/nodes/0/weights"},
    {"[" ADD(ATTRIBUTES "/FOO", "0") "]", Kind::mended, "unknown-attribute", ATTRIBUTES "/FOO"},
    {"[" ADD(ATTRIBUTES "/TEXCOORD", "10") "]", Kind::mended, "unknown-attribute", ATTRIBUTES "/TEXCOORD"},
    {"[" ADD(ATTRIBUTES "/TEXCOORD_", "10") "]", Kind::mended, "unknown-attribute", ATTRIBUTES "/TEXCOORD_"},
    {"[" ADD(ATTRIBUTES "/TEXCOORD_00", "10") "]", Kind::mended, "unknown-attribute", ATTRIBUTES "/TEXCOORD_00"},
    {"[" ADD(ATTRIBUTES "/TEXCOORD_0x", "10") "]", Kind::mended, "unknown-attribute", ATTRIBUTES "/TEXCOORD_0x"},
    {"[" ADD(ATTRIBUTES "/NORMAL_0", "8") "]", Kind::mended, "unknown-attribute", ATTRIBUTES "/NORMAL_0"},
    {"[" ADD(ATTRIBUTES "/_ID", "7") "]", Kind::mended, "attribute-format", ATTRIBUTES "/_ID"},
    {"[" ADD(ATTRIBUTES "/POSITION", "12") "]", Kind::mended, "attribute-format", ATTRIBUTES "/POSITION"},
    {"[" ADD(ATTRIBUTES "/POSITION", "8") "]", Kind::mended, "bounds-missing", ATTRIBUTES "/POSITION"},
    {"[" ADD(ATTRIBUTES "/TEXCOORD_1", "10") "]", Kind::mended, "attribute-sets-not-continuous",
     ATTRIBUTES "/TEXCOORD_1"},
    {"[" ADD(ATTRIBUTES "/TANGENT", "9") "]", Kind::said, "tangents-dropped", ATTRIBUTES "/TANGENT"},
    {"[" DROP(ATTRIBUTES "/POSITION") "]", Kind::said, "primitive-without-positions", ATTRIBUTES},
    {"[" ADD(PRIMITIVE "/mode", "1") "]", Kind::said, "points-and-lines-dropped", PRIMITIVE},
    {"[" ADD(PRIMITIVE "/targets", R"([{"FOO":13}])") "]", Kind::mended, "morph-target-wrong",
     PRIMITIVE "/targets/0/FOO"},
    {"[" ADD(PRIMITIVE "/targets", R"([{"_ID":13}])") "]", Kind::mended, "morph-target-wrong",
     PRIMITIVE "/targets/0/_ID"},
    {"[" ADD(PRIMITIVE "/targets", R"([{"POSITION":8}])") "]", Kind::mended, "bounds-missing",
     PRIMITIVE "/targets/0/POSITION"},
    {"[" ADD(ATTRIBUTES "/COLOR_0", "11") "," ADD(PRIMITIVE "/targets", R"([{"COLOR_0":11}])") "]", Kind::said,
     "morph-attribute-dropped", PRIMITIVE "/targets/0/COLOR_0"},
    {"[" ADD(PRIMITIVE "/targets", "[{}]") "]", Kind::mended, "empty-target", PRIMITIVE "/targets/0"},
    {"[" ADD("/bufferViews/0/target", "34963") "]", Kind::mended, "buffer-target-wrong", ATTRIBUTES "/POSITION"},
    {"[" ADD("/bufferViews/3/target", "34962") "]", Kind::mended, "buffer-target-wrong", PRIMITIVE "/indices"},
    {"[" ADD("/bufferViews/6/target", "7") "]", Kind::said, "unknown-buffer-target", "/bufferViews/6/target"},
    // The first twelve bytes are zeros, whatever they are taken for.
    {"[" ADD("/accessors/3/bufferView", "0") "]", Kind::mended, "buffer-view-shared", PRIMITIVE "/indices"},
    {"[" ADD(ATTRIBUTES "/_ID", "14") "]", Kind::mended, "attribute-misaligned", ATTRIBUTES "/_ID"},
    {"[" ADD(ATTRIBUTES "/_A", "8") "," ADD("/accessors/8/bufferView", "0") "]", Kind::mended, "stride-missing",
     ATTRIBUTES "/_A"},
    {"[" ADD("/images", R"([{"uri":"a.png"}])") "," ADD("/textures", R"([{"source":0}])") "," ADD(
         "/materials", R"([{"normalTexture":{"index":0}}])") "," ADD(PRIMITIVE "/material", "0") "]",
     Kind::mended, "texture-coordinates-missing", PRIMITIVE "/material"},
    {"[" ADD("/materials", R"([{"pbrMetallicRoughness":{"baseColorFactor":[2,0,0,1]}}])") "]", Kind::mended,
     "colours-clamped", "/materials/0/pbrMetallicRoughness/baseColorFactor/0"},
    // Nodes and skins.
    {"[" ADD("/nodes/1/matrix", "[1,0,0,0.5, 0,1,0,0, 0,0,1,0, 0,0,0,1]") "]", Kind::mended, "matrix-not-affine",
     "/nodes/1/matrix"},
    {"[" ADD("/nodes/1/matrix", "[0,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]") "]", Kind::mended, "matrix-singular",
     "/nodes/1/matrix"},
    {"[" ADD("/nodes/1/rotation", "[0,0,0,0]") "]", Kind::mended, "rotation-zero", "/nodes/1/rotation"},
    {"[" ADD("/nodes/1/rotation", "[0,0,0,0.5]") "]", Kind::mended, "rotation-not-unit", "/nodes/1/rotation"},
    {"[" DROP("/nodes/2/translation") "," ADD("/nodes/2/matrix", "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,1,0,1]") "]",
     Kind::mended, "animated-matrix", "/animations/0/channels/0/target"},
    {"[" ADD("/skins/0/skeleton", "2") "]", Kind::mended, "skeleton-not-above-joints", "/skins/0/skeleton"},
    {"[" ADD("/skins/0/skeleton", "0") "]", Kind::mended, "skeleton-not-above-joints", "/skins/0/skeleton"},
    {"[" ADD("/bufferViews/4/byteStride", "64") "]", Kind::mended, "stride-not-allowed",
     "/skins/0/inverseBindMatrices"},
    {"[" ADD("/nodes/3", R"({"children":[4]})") "," ADD("/nodes/4", "{}") "," ADD("/scenes/0/nodes/2", "4") "]",
     Kind::mended, "scene-lists-no-root", "/scenes/0/nodes/2"},
    // Animations.
    {R"([{"op":"copy","from":"/animations/0/channels/0","path":"/animations/0/channels/1"}])", Kind::mended,
     "channel-twice", "/animations/0/channels/1/target"},
    {"[" ADD("/bufferViews/5/byteStride", "4") "]", Kind::mended, "stride-not-allowed",
     "/animations/0/samplers/0/input"},
    {"[" ADD("/bufferViews/6/byteStride", "16") "]", Kind::mended, "stride-not-allowed",
     "/animations/0/samplers/0/output"},
    {"[" DROP("/accessors/5/max") "]", Kind::mended, "bounds-missing", "/animations/0/samplers/0/input"},
    {"[" ADD("/accessors/5/count", "1") "," ADD("/accessors/11/count", "3") "," ADD(
         "/animations/0/samplers/0/output", "11") "," ADD("/animations/0/samplers/0/interpolation",
                                                          R"("CUBICSPLINE")") "]",
     Kind::mended, "too-few-keys", "/animations/0/samplers/0/input"},
    // The document.
    {"[" ADD("/images", "[]") "]", Kind::mended, "empty-array", "/images"},
    {"[" ADD("/nodes/2/children", "[]") "]", Kind::mended, "empty-array", "/nodes/2/children"},
    {"[" ADD("/nodes/0/weights", "[]") "]", Kind::mended, "empty-array", "/nodes/0/weights"},
    {"[" ADD("/scenes/1", R"({"nodes":[]})") "]", Kind::mended, "empty-array", "/scenes/1/nodes"},
    {"[" ADD("/animations/1", R"({"channels":[],"samplers":[]})") "]", Kind::mended, "empty-array",
     "/animations/1/channels"},
    {"[" ADD("/animations/0/channels", "[]") "]", Kind::mended, "empty-array", "/animations/0/channels"},
    {"[" ADD("/meshes/1", R"({"primitives":[]})") "]", Kind::mended, "empty-array", "/meshes/1/primitives"},
    {"[" ADD("/meshes/0/weights", "[]") "]", Kind::mended, "empty-array", "/meshes/0/weights"},
    {"[" ADD(PRIMITIVE "/targets", "[]") "]", Kind::mended, "empty-array", PRIMITIVE "/targets"},
    {"[" ADD("/accessors/14/min", "[]") "]", Kind::mended, "empty-array", "/accessors/14/min"},
    {"[" ADD("/accessors/14/count", "0") "]", Kind::mended, "empty-accessor", "/accessors/14/count"},
    {"[" ADD("/bufferViews/14/byteLength", "0") "," ADD("/accessors/14/count", "0") "]", Kind::mended,
     "empty-buffer-view", "/bufferViews/14/byteLength"},
    {"[" ADD("/extensionsUsed", R"(["ACME_a","ACME_a"])") "]", Kind::mended, "duplicate-entry", "/extensionsUsed/1"},
    {"[" ADD("/extensionsUsed", R"(["FB_ngon_encoding"])") "," ADD("/extensionsRequired",
                                                                   R"(["FB_ngon_encoding"])") "]",
     Kind::said, "extension-ignored", "/extensionsRequired/0"},
    {"[" ADD("/extensionsRequired", R"(["KHR_mesh_quantization"])") "]", Kind::mended, "extension-not-used",
     "/extensionsRequired/0"},
    {"[" ADD("/extensions", R"({"ACME_a":{}})") "]", Kind::mended, "undeclared-extension", "/extensions/ACME_a"},
    {"[" ADD("/asset/version", R"("2.1")") "," ADD("/asset/minVersion", R"("2.1")") "]", Kind::said,
     "newer-minor-version", "/asset/version"},
    {"[" ADD("/buffers/1", R"({"byteLength":4})") "]", Kind::said, "buffer-without-data", "/buffers/1"},
    {"[" ADD("/nodes/1/oddity", "1") "]", Kind::said, "unknown-property", "/nodes/1/oddity"},
    {"[" ADD("/accessors/14/type", R"("VEC5")") "]", Kind::said, "unknown-accessor-type", "/accessors/14/type"},
    {"[" ADD("/accessors/14/min", "[1,2]") "]", Kind::mended, "bounds-wrong", "/accessors/14/min"},
    {"[" ADD("/accessors/14/max", "[1]") "]", Kind::mended, "bounds-wrong", "/accessors/14/max/0"},
};

TEST(GltfRules, AFurnishedDocumentHasNoFault) {
  Builder b = furnished();
  EXPECT_TRUE(read(b).warnings.empty());
  EXPECT_TRUE(read(b, {.strict = true}).warnings.empty());
  b.root.erase("scene");
  b.root.erase("scenes");
  const RawScene library = read(b);
  EXPECT_TRUE(warns(library, "no-scenes", "/scenes"));
  EXPECT_EQ(library.warnings.size(), 1U);
}

TEST(GltfRules, FaultsAreMendedInAScene) {
  std::size_t checked = 0;
  for (const Fault& fault : kFaults) {
    SCOPED_TRACE(fault.patch);
    const RawScene scene = read_text(Json::parse(furnished().text()).patch(Json::parse(fault.patch)).dump());
    EXPECT_TRUE(warns(scene, fault.rule, fault.where));
    ++checked;
  }
  EXPECT_EQ(checked, std::size(kFaults));
}

TEST(GltfRules, WhatIsMendedIsRefusedInALibrary) {
  std::size_t refused = 0, read = 0;
  for (const Fault& fault : kFaults) {
    SCOPED_TRACE(fault.patch);
    Json root = Json::parse(furnished().text()).patch(Json::parse(fault.patch));
    const std::string scene = root.dump();
    root.erase("scene");
    root.erase("scenes");
    const bool in_scene = std::string(fault.where).starts_with("/scenes");
    if (fault.kind == Kind::mended) {
      expect_failure([&] { read_text(scene, {.strict = true}); }, Exit::invalid, fault.where, fault.rule);
      if (!in_scene) expect_failure([&] { read_text(root.dump()); }, Exit::invalid, fault.where, fault.rule);
      ++refused;
    } else {
      EXPECT_TRUE(warns(read_text(scene, {.strict = true}), fault.rule, fault.where));
      EXPECT_TRUE(warns(read_text(root.dump()), fault.rule, fault.where));
      ++read;
    }
  }
  EXPECT_EQ(refused + read, std::size(kFaults));
  EXPECT_GT(refused, 35U);
}

struct Refusal {
  const char* patch;  // RFC 6902, applied to furnished()
  Exit code;
  const char* where;
  const char* rule;
};

#define SPARSE(count, indices, values) \
  R"({"count":)" count R"(,"indices":{"bufferView":)" indices R"(},"values":{"bufferView":)" values "}}"

const Refusal kRefusals[] = {
    {"[" ADD("/nodes/1/weights", "[1]") "]", Exit::invalid, "/nodes/1/weights", "weights without mesh"},
    {"[" ADD("/bufferViews/3/byteStride", "4") "," ADD("/accessors/3/count", "3") "]", Exit::invalid,
     PRIMITIVE "/indices", "stride not allowed"},
    {"[" ADD("/bufferViews/3/byteStride", "252") "]", Exit::invalid, "/bufferViews/3/byteStride",
     "longer than the view"},
    {"[" ADD("/bufferViews/3/byteStride", "4") "," ADD("/bufferViews/3/target", "34963") "]", Exit::invalid,
     "/bufferViews/3/byteStride", "only vertex data"},
    {"[" ADD("/accessors/7/type", R"("MAT2")") "," ADD("/accessors/7/componentType", "5121") "," ADD(
         "/accessors/7/byteOffset", "2") "]",
     Exit::invalid, "/accessors/7/byteOffset", "misaligned"},
    {"[" ADD("/accessors/7/normalized", "1") "]", Exit::invalid, "/accessors/7/normalized", "wrong type"},
    {"[" ADD("/accessors/7/normalized", "true") "]", Exit::invalid, "/accessors/7/normalized", "cannot be normalised"},
    {"[" ADD("/accessors/7/count", R"("4")") "]", Exit::invalid, "/accessors/7/count", "wrong type"},
    {"[" ADD("/accessors/5/min", R"(["0"])") "]", Exit::invalid, "/accessors/5/min/0", "wrong type"},
    {"[" ADD("/accessors/5", "7") "]", Exit::invalid, "/accessors/5", "wrong type"},
    {"[" ADD("/accessors/7/sparse", SPARSE("1", R"(14,"componentType":5120)", "7")) "]", Exit::invalid,
     "/accessors/7/sparse/indices/componentType", "not an unsigned integer"},
    {"[" ADD("/accessors/7/sparse", SPARSE("1", R"(12,"componentType":5123)", "7")) "]", Exit::invalid,
     "/accessors/7/sparse/indices/bufferView", "byteStride"},
    {"[" ADD("/accessors/7/count", "3") "," ADD("/accessors/7/sparse",
                                                SPARSE("3", R"(14,"componentType":5121,"byteOffset":1)", "7")) "]",
     Exit::invalid, "/accessors/7/sparse/indices", "beyond the accessor's end"},
    {"[" ADD("/accessors/7/sparse", SPARSE("4", R"(14,"componentType":5121,"byteOffset":1)", "7")) "]", Exit::invalid,
     "/accessors/7/sparse/indices", "beyond the bufferView's end"},
    {"[" ADD("/accessors/7/sparse", SPARSE("4", R"(14,"componentType":5121)", "14")) "]", Exit::invalid,
     "/accessors/7/sparse/values", "beyond the bufferView's end"},
    {"[" ADD(PRIMITIVE "/attributes", "{}") "]", Exit::invalid, PRIMITIVE "/attributes", "empty object"},
    {"[" ADD(PRIMITIVE "/attributes", "[]") "]", Exit::invalid, PRIMITIVE "/attributes", "wrong type"},
    {"[" ADD("/extensionsUsed", "[7]") "]", Exit::invalid, "/extensionsUsed/0", "wrong type"},
    {"[" ADD("/extensions", "[]") "]", Exit::invalid, "/extensions", "wrong type"},
    {"[" ADD("/asset/version", R"("2")") "]", Exit::invalid, "/asset/version", "not a version"},
    {"[" ADD("/asset/version", R"("2.")") "]", Exit::invalid, "/asset/version", "not a version"},
    {"[" ADD("/asset/version", R"("2.0x")") "]", Exit::invalid, "/asset/version", "not a version"},
    {"[" ADD("/asset/version", R"("2-0")") "]", Exit::invalid, "/asset/version", "not a version"},
    {"[" ADD("/asset/minVersion", R"("3.0")") "]", Exit::invalid, "/asset/minVersion", "greater"},
    {"[" ADD("/materials", R"([{"doubleSided":1}])") "]", Exit::invalid, "/materials/0/doubleSided", "wrong type"},
    {"[" ADD("/accessors/14/componentType", "5120") "," ADD(PRIMITIVE "/indices", "14") "]", Exit::invalid,
     PRIMITIVE "/indices", "wrong accessor"},
    {"[" ADD("/accessors/2/componentType", "5122") "," ADD("/accessors/2/normalized", "true") "]", Exit::invalid,
     ATTRIBUTES "/WEIGHTS_0", "wrong component type"},
    {"[" ADD("/accessors/1/componentType", "5120") "," ADD("/accessors/1/normalized", "true") "]", Exit::invalid,
     ATTRIBUTES "/JOINTS_0", "wrong component type"},
    {"[" ADD("/accessors/4/type", R"("MAT3")") "," ADD("/accessors/4/componentType", "5121") "]", Exit::invalid,
     "/skins/0/inverseBindMatrices", "wrong accessor"},
    {"[" ADD("/accessors/5/count", "0") "]", Exit::invalid, "/animations/0/channels/0/sampler", "differ in count"},
    {"[" ADD("/accessors/6/count", "0") "]", Exit::invalid, "/animations/0/channels/0/sampler", "differ in count"},
    {"[" ADD("/accessors/0/count", "0") "," ADD("/accessors/1/count", "0") "," ADD("/accessors/2/count", "0") "]",
     Exit::invalid, ATTRIBUTES, "no vertices"},
    {"[" ADD("/accessors/4/count", "0") "]", Exit::invalid, "/skins/0/inverseBindMatrices", "0 for"},
    {"[" ADD("/bufferViews/14/byteLength", "0") "]", Exit::invalid, "/accessors/14", "beyond the bufferView's end"},
    {"[" ADD("/accessors/6/componentType", "5122") "]", Exit::invalid, "/animations/0/channels/0/sampler",
     "wrong output"},
    {"[" ADD("/buffers/0/uri", R"("DATA:application/octet-stream,a%2Fb%aF")") "]", Exit::invalid,
     "/buffers/0/byteLength", "longer than the data"},
    {"[" ADD("/buffers/0/uri", R"("data:application/octet-stream;base64,+/9=")") "]", Exit::invalid, "/buffers/0/uri",
     "malformed base64"},
    {"[" ADD("/buffers/0/uri", R"("data:application/octet-stream;=x;base64,AAAA")") "]", Exit::invalid,
     "/buffers/0/uri", "malformed data URI"},
    {"[" ADD("/buffers/0/uri", R"("a%4g.bin")") "]", Exit::invalid, "/buffers/0/uri", "malformed URI"},
    {"[" ADD("/buffers/0/uri", R"("a%3Ab.bin")") "]", Exit::invalid, "/buffers/0/uri", "a drive"},
    {"[" ADD("/buffers/0/uri", R"("a%7Fb.bin")") "]", Exit::invalid, "/buffers/0/uri", "control character"},
    {"[" ADD("/buffers/0/uri", R"("%5Cb.bin")") "]", Exit::invalid, "/buffers/0/uri", "backslash"},
};

TEST(GltfRules, WhatHasNoSensibleMeaningIsRefused) {
  std::size_t checked = 0;
  for (const Refusal& refusal : kRefusals) {
    SCOPED_TRACE(refusal.patch);
    const Json root = Json::parse(furnished().text()).patch(Json::parse(refusal.patch));
    try {
      read_text(root.dump());
      ADD_FAILURE() << "read";
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), refusal.code) << failure.what();
      EXPECT_EQ(failure.where(), refusal.where) << failure.what();
      EXPECT_NE(std::string(failure.what()).find(refusal.rule), std::string::npos) << failure.what();
    }
    ++checked;
  }
  EXPECT_EQ(checked, std::size(kRefusals));
}

// glTF has no accessors without elements, but exporters write channels of no keys: these move nothing, others do.
TEST(GltfRules, ChannelsWithoutKeysAreLeftOut) {
  std::size_t checked = 0;
  for (const char* spline : {"LINEAR", "STEP", "CUBICSPLINE"}) {
    Builder b = skinned();
    Json& animation = b.root["animations"][0];
    animation["samplers"].push_back({{"input", b.numbers<float>(kF32, "SCALAR", 1, {})},
                                     {"output", b.numbers<float>(kF32, "VEC3", 3, {})},
                                     {"interpolation", spline}});
    animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 1}, {"path", "scale"}}}});
    const RawScene scene = read(b);
    EXPECT_TRUE(warns(scene, "empty-accessor", "/accessors/7/count"));
    EXPECT_TRUE(warns(scene, "empty-buffer-view", "/bufferViews/8/byteLength"));
    EXPECT_TRUE(warns(scene, "channel-without-keys", "/animations/0/channels/1/sampler"));
    EXPECT_EQ(scene.warnings.size(), 5u) << "two accessors, two views, one channel";
    ASSERT_EQ(scene.clips.size(), 1u);
    ASSERT_EQ(scene.clips[0].channels.size(), 1u);
    EXPECT_EQ(scene.clips[0].channels[0].node, 2);
    animation["channels"].erase(0);
    const RawScene still = read(b);
    EXPECT_TRUE(still.clips.empty());
    EXPECT_TRUE(warns(still, "clip-dropped", "/animations/0"));
    ++checked;
  }
  EXPECT_EQ(checked, 3u);
}

TEST(GltfRules, LongListsAndPathsAreCutOff) {
  Json root = Json::parse(furnished().text());
  root["buffers"][0]["uri"] = std::string(5000, 'a');
  expect_refused(root.dump(), Exit::invalid, "/buffers/0/uri", "not allowed");
  Builder sets = skinned();
  Json& attributes = sets.root["meshes"][0]["primitives"][0]["attributes"];
  for (int set = 1; set < 17; ++set) {
    attributes["JOINTS_" + std::to_string(set)] = 1;
    attributes["WEIGHTS_" + std::to_string(set)] = 2;
  }
  expect_refused(sets.text(), Exit::unsupported, "/meshes/0/primitives/0/attributes/JOINTS_16", "too many joint sets");
  root = {{"asset", {{"version", "2.0"}}}, {"nodes", Json::array_t(200'001, Json::object())}};
  expect_refused(root.dump(), Exit::unsupported, "/nodes", "too many items");
}

TEST(GltfRules, AxesThatFallTogetherGiveNoRotation) {
  Builder b = skinned();
  b.root["nodes"][1]["matrix"] = {1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  const RawScene scene = read(b);
  EXPECT_TRUE(warns(scene, "matrix-sheared", "/nodes/1/matrix"));
  EXPECT_TRUE(warns(scene, "matrix-singular", "/nodes/1/matrix"));
  EXPECT_EQ(scene.nodes[1].rotation, glm::dquat(1, 0, 0, 0));
  EXPECT_EQ(scene.nodes[1].translation, glm::dvec3(5, 6, 7));
}

// A pair of matrices for skinned(), the second one as given.
Builder bound_by(const std::vector<float>& second) {
  Builder b = skinned();
  std::vector<float> numbers = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  numbers.insert(numbers.end(), second.begin(), second.end());
  b.root["skins"][0]["inverseBindMatrices"] = b.numbers<float>(kF32, "MAT4", 16, numbers);
  return b;
}

TEST(GltfRules, InverseBindMatrices) {
  const std::string where = "/skins/0/inverseBindMatrices";
  Builder lost = bound_by({kNan, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  expect_failure([&] { read(lost); }, Exit::invalid, where, "not a finite number");
  Builder projective = bound_by({1, 0, 0, 0.5F, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  const RawScene scene = read(projective);
  EXPECT_TRUE(warns(scene, "matrix-not-affine", where));
  EXPECT_EQ(scene.skins[0].inverse_bind[1][0][3], 0.0);
  EXPECT_EQ(scene.skins[0].inverse_bind[1][3][1], -1.0);
  // Neither the matrix nor what the rest pose gives in its place has an inverse.
  Builder huge = bound_by({2e9F, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  huge.root["nodes"][2]["scale"] = {2e9, 1, 1};
  const RawScene mended = read(huge);
  EXPECT_TRUE(warns(mended, "inverse-bind-unusable", where));
  EXPECT_EQ(mended.skins[0].inverse_bind[1], glm::dmat4(1));
}

TEST(GltfRules, NumbersOfVertices) {
  Builder b = furnished();
  Json& attributes = b.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["TEXCOORD_0"] = b.numbers<float>(kF32, "VEC2", 2, {0, 0, kNan, 0, 0, 1e13F, 1, 1});
  attributes["COLOR_0"] =
      b.numbers<float>(kF32, "VEC4", 4, {kNan, 0, 0, 1, 0, 2, 0, 1, 0, 0, -1, 1, 0, 0, 0, 1.0000001F});
  attributes["NORMAL"] = 8;
  // One tangent is none, one too long, one without a sign; one is as it should be.
  attributes["TANGENT"] = b.numbers<float>(kF32, "VEC4", 4, {kNan, 0, 0, 1, 2, 0, 0, -1, 1, 0, 0, 0.5F, 0, 1, 0, -1});
  const RawScene scene = read(b);
  const RawPrimitive& primitive = scene.meshes[0].primitives[0];
  EXPECT_TRUE(warns(scene, "uvs-mended", ATTRIBUTES "/TEXCOORD_0"));
  EXPECT_TRUE(warns(scene, "colours-clamped", ATTRIBUTES "/COLOR_0"));
  EXPECT_TRUE(warns(scene, "tangents-mended", ATTRIBUTES "/TANGENT"));
  EXPECT_EQ(primitive.uvs, (std::vector<glm::vec2>{{0, 0}, {0, 0}, {0, 0}, {1, 1}}));
  EXPECT_EQ(primitive.colours[0], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(primitive.colours[1], glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(primitive.colours[2], glm::vec4(0, 0, 0, 1));
  EXPECT_NEAR(glm::length(glm::vec3(primitive.tangents[0])), 1, 1e-6);
  EXPECT_NEAR(primitive.tangents[0].z, 0, 1e-6) << "square to the normal";
  EXPECT_EQ(primitive.tangents[1], glm::vec4(1, 0, 0, -1));
  EXPECT_EQ(primitive.tangents[2], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(primitive.tangents[3], glm::vec4(0, 1, 0, -1));

  Builder weights = skinned();
  weights.root["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
      weights.numbers<float>(kF32, "VEC4", 4, {1, 0, 0, 0, kNan, 0, 0, 0, 0.25F, 0.75F, 0, 0, 1, 0, 0, 0});
  const RawScene mended = read(weights);
  EXPECT_TRUE(warns(mended, "weights-not-finite", ATTRIBUTES "/WEIGHTS_0"));
  EXPECT_TRUE(warns(mended, "weights-zero", ATTRIBUTES "/WEIGHTS_0"));
  ASSERT_EQ(mended.meshes[0].primitives[0].influences[1].size(), 1U);
  EXPECT_EQ(mended.meshes[0].primitives[0].influences[1][0].joint, 1U) << "the first joint listed";
  expect_failure([&] { read(weights, {.strict = true}); }, Exit::invalid, "/accessors/7", "not a finite number");
  Builder early = skinned();
  early.root["animations"][0]["samplers"][0]["input"] = early.times({-1, 1});
  expect_failure([&] { read(early); }, Exit::invalid, "/animations/0/samplers/0/input", "negative time");
}

// Vertices 0 and 1 list both joints, 2 lists joint 1 twice, 3 has one weight that is infinite and one below zero.
TEST(GltfRules, WeightsBeyondAllBoundsAreShares) {
  Builder b = skinned();
  const float infinite = std::numeric_limits<float>::infinity();
  Json& attributes = b.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0});
  attributes["WEIGHTS_0"] = b.numbers<float>(
      kF32, "VEC4", 4, {3e38F, 1e38F, 0, 0, 3e38F, 1, 0, 0, 3e38F, 3e38F, 0, 0, infinite, -3e38F, 0.5F, 0});
  const RawScene scene = read(b);
  const auto& vertices = scene.meshes[0].primitives[0].influences;
  const auto expect_vertex = [&](std::size_t v, const std::vector<std::pair<std::uint32_t, float>>& expected) {
    ASSERT_EQ(vertices[v].size(), expected.size()) << v;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(vertices[v][i].joint, expected[i].first) << v;
      EXPECT_NEAR(vertices[v][i].weight, expected[i].second, 1e-6) << v;
    }
  };
  expect_vertex(0, {{0, 0.75F}, {1, 0.25F}});
  expect_vertex(1, {{1, 1.0F}});
  expect_vertex(2, {{1, 1.0F}});
  expect_vertex(3, {{0, 0.5F}});
  for (const char* rule : {"weights-not-finite", "weights-negative", "weights-not-normalised", "joints-listed-twice"})
    EXPECT_TRUE(warns(scene, rule, ATTRIBUTES "/WEIGHTS_0")) << rule;
}

// A normal that points along x, and damaged ones where triangles have no area.
TEST(GltfRules, NormalsOfNothing) {
  Builder b;
  const int positions = b.positions({0, 0, 0, 1, 0, 0, 2, 0, 0});
  const int normals = b.numbers<float>(kF32, "VEC3", 3, {kNan, 0, 0, 1, 0, 0, 0, 0, 0});
  const int tangents = b.numbers<float>(kF32, "VEC4", 4, {1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1});
  b.primitive({{"POSITION", positions}, {"NORMAL", normals}, {"TANGENT", tangents}});
  const RawScene scene = read(b);
  const RawPrimitive& primitive = scene.meshes[0].primitives[0];
  EXPECT_EQ(primitive.normals[0], glm::vec3(0, 1, 0)) << "upward, for want of a surface";
  EXPECT_EQ(primitive.normals[1], glm::vec3(1, 0, 0));
  EXPECT_NEAR(primitive.tangents[1].x, 0, 1e-6) << "square to the normal";

  Builder lost;
  lost.primitive({{"POSITION", lost.positions({2e12F, 0, 0, 2e12F, 1, 0, 2e12F, 0, 1})}});
  const RawScene none = read(lost);
  EXPECT_EQ(none.meshes[0].primitives[0].positions[0], glm::vec3(0)) << "no vertex is left to stand amid";
}

}  // namespace
}  // namespace marrow::cook
