// Reading glTF: every way a document can be wrong, and what is mended or only said.
#include <string>

#include <gtest/gtest.h>

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {
namespace {

// A change to skinned(), whose accessors are 0 positions, 1 joints, 2 weights, 3 indices, 4 inverse binds, 5 times,
// 6 rotations; and how it is refused.
const struct {
  const char *change, *said;
} kBadDocuments[] = {
    {R"("/asset": null)", "invalid /asset: missing"},
    {R"("/asset/version": "1.0")", "unsupported /asset/version: glTF 1.0"},
    {R"("/asset/version": "1.0", "/nodes": {"n": {}}, "/scene": "s", "/scenes": {"s": {"nodes": ["n"]}})",
     "unsupported /asset/version: glTF 1.0"},
    {R"("/asset": null, "/nodes": {"n": {}})", "unsupported /asset/version: glTF 1.0"},
    {R"("/asset/version": "3.0")", "unsupported /asset/version: glTF 3.0"},
    {R"("/asset/version": "two")", "invalid /asset/version: not a version"},
    {R"("/asset/minVersion": "2.9")", "invalid /asset/minVersion: greater"},
    {R"("/scene": 4)", "invalid /scene: reference to nothing"},
    {R"("/scene": "x")", "invalid /scene: wrong type"},
    {R"("/scenes/0/nodes": [0, 2], "/nodes/1/translation": [1, 0, 0])", "invalid /scenes/0/nodes/1: not a root"},
    {R"("/nodes/0/mesh": 1)", "invalid /nodes/0/mesh: reference to nothing"},
    {R"("/nodes/0/skin": 2147483648)", "invalid /nodes/0/skin: reference to nothing"},
    {R"("/nodes/0/mesh": null)", "invalid /nodes/0/skin: skin without mesh"},
    {R"("/nodes/1/children": [-1])", "invalid /nodes/1/children/0: reference to nothing"},
    {R"("/nodes/2/children": [2])", "invalid /nodes/2/children/0: two parents"},
    {R"("/nodes/2/children": [1])", "invalid /nodes/1: node loop"},
    {R"("/nodes/0/children": [0])", "invalid /nodes/0: node loop"},
    {R"("/nodes/2/matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])", "invalid /nodes/2/matrix: both"},
    {R"("/nodes/2/rotation": [0, 0, 0, 1, 0])", "invalid /nodes/2/rotation: wrong number"},
    {R"("/nodes/2/translation/1": 1e+39)", "invalid /nodes/2/translation/1: out of range"},
    {R"("/nodes/2/translation/1": 10000000000000.0)", "invalid /nodes/2: beyond 1e12"},
    {R"("/nodes/1/scale": [10000000.0, 1, 1], "/nodes/2/translation/0": 10000000.0)",
     "invalid /nodes/2: with the nodes above"},
    {R"("/nodes/2/name": 7)", "invalid /nodes/2/name: wrong type"},
    {R"("/skins/0/joints": [1, 1])", "invalid /skins/0/joints/1: listed twice"},
    {R"("/skins/0/joints": [])", "invalid /skins/0/joints: wrong number"},
    {R"("/nodes/3": {}, "/skins/0/joints/2": 3)", "invalid /skins/0/joints/2: no common root"},
    {R"("/scenes/0/nodes": [0])", "invalid /nodes/0/skin: joints outside the scene"},
    {R"("/skins/0/joints": [1])", "invalid /P/attributes/JOINTS_0: joint that the skin lacks"},
    {R"("/accessors/4/count": 1)", "invalid /skins/0/inverseBindMatrices: too few"},
    {R"("/skins/0/inverseBindMatrices": 6)", "invalid /skins/0/inverseBindMatrices: wrong accessor"},
    {R"("/accessors/0/count": 5)", "invalid /accessors/0: beyond the bufferView"},
    {R"("/accessors/0/count": 4611686018427387904)", "invalid /accessors/0/count: out of range"},
    {R"("/accessors/0/count": 4294967295)", "invalid /accessors/0: beyond the bufferView"},
    {R"("/accessors/0/count": 0)", "invalid /P/attributes/POSITION: differs in count"},
    {R"("/accessors/0/count": 2.5)", "invalid /accessors/0/count: wrong type"},
    {R"("/accessors/0/byteOffset": 4294967292)", "invalid /accessors/0: beyond the bufferView"},
    {R"("/accessors/2/byteOffset": 2)", "invalid /accessors/2/byteOffset: misaligned"},
    {R"("/accessors/0/componentType": 5124)", "invalid /accessors/0/componentType: unknown component"},
    {R"("/accessors/0/normalized": true)", "invalid /accessors/0/normalized: cannot be normalised"},
    {R"("/accessors/0/bufferView": null, "/accessors/0/byteOffset": 0)",
     "invalid /accessors/0/byteOffset: without a bufferView"},
    {R"("/accessors/0/bufferView": 99)", "invalid /accessors/0/bufferView: reference to nothing"},
    {R"("/accessors/0/sparse": {"count": 5, "indices": {"bufferView": 3, "componentType": 5123}, "values": {"bufferView": 0}})",
     "invalid /accessors/0/sparse/count: more than"},
    {R"("/accessors/0/sparse": {"count": 4, "indices": {"bufferView": 3, "componentType": 5123}, "values": {"bufferView": 0}})",
     "invalid /accessors/0/sparse/indices: must increase"},
    {R"("/bufferViews/0/byteOffset": 9007199254740991)", "invalid /bufferViews/0/byteLength: beyond the buffer"},
    {R"("/bufferViews/0/byteLength": 0)", "invalid /accessors/0: beyond the bufferView's end"},
    {R"("/bufferViews/0/byteStride": -12)", "invalid /bufferViews/0/byteStride: out of range"},
    {R"("/bufferViews/0/byteStride": 13)", "invalid /bufferViews/0/byteStride: multiple of 4"},
    {R"("/bufferViews/0/byteStride": 8)", "invalid /accessors/0: overlap"},
    {R"("/buffers/0/byteLength": 2147483647)", "invalid /buffers/0/byteLength: longer than the data"},
    {R"("/P/indices": 0)", "invalid /P/indices: wrong accessor"},
    {R"("/P/mode": 42)", "invalid /P/mode: out of range"},
    {R"("/P/attributes/WEIGHTS_0": null)", "invalid /P/attributes/JOINTS_0: pairs"},
    {R"("/P/attributes/JOINTS_0": 2)", "invalid /P/attributes/JOINTS_0: wrong component type"},
    {R"("/P/attributes/POSITION": 2)", "invalid /P/attributes/POSITION: wrong accessor type"},
    {R"("/accessors/1/count": 2)", "invalid /P/attributes/POSITION: differs in count"},
    {R"("/meshes/0/primitives": {})", "invalid /meshes/0/primitives: wrong type"},
    {R"("/animations/0/channels/0/sampler": 1)", "invalid /animations/0/channels/0/sampler: reference to nothing"},
    {R"("/animations/0/samplers/0/interpolation": "")",
     "invalid /animations/0/samplers/0/interpolation: unknown value"},
    {R"("/animations/0/samplers/0/input": 1)", "invalid /animations/0/samplers/0/input: wrong accessor"},
    {R"("/animations/0/samplers/0/output": 5)", "invalid /animations/0/channels/0/sampler: wrong output"},
    {R"("/accessors/6/count": 1)", "invalid /animations/0/channels/0/sampler: differ in count"},
    {R"("/animations/0/channels/1": "@/animations/0/channels/0", "/animations/0/samplers/1": "@/animations/0/samplers/0", "/animations/0/samplers/1/interpolation": "STEP", "/animations/0/channels/1/sampler": 1)",
     "invalid /animations/0/channels/1/target: animated twice"},
    {R"("/extensionsRequired": ["EVIL_x"])", "unsupported /extensionsRequired/0: EVIL_x"},
    {R"("/extensions": {"KHR_x": []})", "invalid /extensions/KHR_x: wrong type"},
    {R"("/images": [{"bufferView": 99, "mimeType": "image/png"}])",
     "invalid /images/0/bufferView: reference to nothing"},
    {R"("/images": [{"uri": "..%2fx.png"}])", "invalid /images/0/uri: not allowed"},
};

TEST(GltfRefusals, AreLocatedAndCoded) {
  for (const auto& [change, said] : kBadDocuments) expect_rows(skinned(), {{said, change, said}});
  EXPECT_GT(std::size(kBadDocuments), 60U);
}

// A channel of node 0 by these times and places.
std::string channel(const std::string& times, const std::string& places) {
  return R"("/animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                             "samplers": [{"input": "=)" +
         times + R"(", "output": "=f32x3 )" + places + R"("}]}])";
}

TEST(GltfRefusals, DamagedNumbersAreFound) {
  const std::string first = "invalid /animations/0/samplers/0/";
  expect_rows(kTriangle,
              {{"a position", R"("/P/attributes/POSITION": "=f32x3 0 0 0 1 nan 0 0 1 0")",
                "invalid /P/attributes/POSITION: not a finite number"},
               {"a time", channel("f32x1 0 nan", "0*6"), first + "input: not a finite number"},
               {"times", channel("f32x1 0 2 1", "0*9"), first + "input: times must increase"},
               {"a value", channel("f32x1 0 1", "0 0 0 0 nan 0"), first + "output: not a finite number"},
               {"a huge value", channel("f32x1 0 1", "0 0 0 0 2e12 0"), first + "output: beyond 1e12"},
               {"an index", R"("/P/indices": "=u16x1 0 1 3")", "invalid /P/indices: vertex that does not exist"},
               {"restart", R"("/P/indices": "=u8x1 0 1 255")", "invalid /P/indices: primitive restart"}});
}

TEST(GltfRefusals, MemoryIsNotForTheAsking) {
  const std::string zeros =
      R"("/accessors/0/bufferView": null, "/accessors/0/min": [0, 0, 0], "/accessors/0/max": [0, 0, 0],
                               "/accessors/0/count": )";
  expect_rows(kTriangle, {{"unfolded", zeros + "16000000", "unsupported /P: unfolds too far"},
                          {"of one accessor", zeros + "20000000", "unsupported /accessors/0/count: too many zeros"}});
}

TEST(GltfRefusals, JsonIsStrict) {
  const std::string start = R"({"asset":{"version":"2.0"})";
  const std::string deep = R"(,"extras":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}";
  const struct {
    std::string text, where;
    const char* rule = "not JSON";
  } cases[] = {{start + R"(,"nodes":[{"translation":[NaN,0,0]}]})", "@52"},
               {start + R"(,"nodes":[{"translation":[.5,0,0]}]})", "@52"},
               {start + R"(,"x":1e400})", "@35"},
               {start + R"(,})", "@27"},
               {start + "} x", "@28"},
               {start, "@26"},
               {start + ",\"nodes\":[{\"name\":\"\xC0\x80\"}]}", "@45"},
               {R"({"asset":{"version":"2.0","version":"2.0"}})", "@34", "duplicate name"},
               {"\xEF\xBB\xBF" + start + ",}", "@30"},
               {"[]", "@0", "not a glTF file"},
               {start + std::string(1, '\0') + "}", "@26"},
               {start + deep, "@163", "nested too deeply"}};
  for (const auto& c : cases) expect_refused(c.text, Exit::invalid, c.where, c.rule);
}

// glTF 2.0, section 2.7: writers must not add one, readers may skip it.
TEST(GltfRepairs, AByteOrderMarkIsSkipped) {
  const std::string text = "\xEF\xBB\xBF" + skinned().text();
  expect_facts(facts_of(read_text(text)), R"("nodes/#": 3, "warns only": ["byte-order-mark @0"])");
  expect_failure([&] { read_text(text, {.strict = true}); }, Exit::invalid, "@0", "byte-order-mark");
}

TEST(GltfRepairs, OfAccessorsAndWhatIsNotCarried) {
  expect_rows(
      kTriangle,
      {{"a bound is wrong", R"("/accessors/0/max/0": 1)", R"("warns": ["bounds-wrong /accessors/0/max/0"])"},
       {"bounds are too few", R"("/accessors/0/max": [1])", R"("warns": ["bounds-wrong /accessors/0/max"])"},
       {"bounds are missing", R"("/accessors/0/max": null)", R"("warns": ["bounds-missing /P/attributes/POSITION"])"},
       {"floats may spell integers", R"("/accessors/0/count": 3.0)", R"("P/positions/#": 3)"},
       {"what is not carried is named",
        R"("/cameras": [{"type": "perspective"}], "/extensionsUsed": ["KHR_lights_punctual", "ACME_x"],
                   "/extensions": {"KHR_lights_punctual": {"lights": []}}, "/oddity": 1,
                   "/P/attributes/TEXCOORD_0": "=f32x2 0*6", "/P/attributes/TEXCOORD_1": "=f32x2 0*6",
                   "/P/attributes/COLOR_0": "=f32x3 0*9", "/P/attributes/COLOR_1": "=f32x3 0*9")",
        R"("warns": ["cameras-dropped", "lights-dropped", "unknown-property", "extra-uvs-dropped",
                             "extra-colours-dropped", "extension-ignored"])"}});
  expect_facts(facts_of(read_text(R"({"asset":{"version":"2.0"}})")), R"("nodes": [], "meshes": [], "warns only": [])");
}

TEST(GltfRepairs, RepeatedWarningsAreCounted) {
  Builder b;
  for (int i = 0; i < 1042; ++i) b.root["odd" + std::to_string(i)] = 1;
  const RawScene scene = read(b);
  EXPECT_EQ(scene.warnings.size(), 1000U);
  EXPECT_NE(scene.warnings.back().text.find("42 more"), std::string::npos);
}

}  // namespace
}  // namespace marrow::cook
