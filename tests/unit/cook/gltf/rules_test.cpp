// Reading glTF: what a scene's faults are mended to or said to be. In a library of parts, which has no scene, what is
// mended elsewhere is refused, and so it is where that is asked for.
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {
namespace {

// skinned() with accessors that its mesh does not use: 7 unsigned 32-bit scalars, 8 normals, 9 tangents, 10 texture
// coordinates, 11 colours, 12 unsigned 16-bit positions, 13 changes of positions, 14 bytes.
Builder furnished() {
  Builder b = skinned();
  for (const char* numbers : {"u32x1 0 1 2 3", "f32x3 0 0 1 0 0 1 0 0 1 0 0 1", "f32x4 1 0 0 1 1 0 0 1 1 0 0 1 1 0 0 1",
                              "f32x2 0 0 1 0 0 1 1 1", "f32x4 0.5*16", "u16x3 0 0 0 0 1 1 0 0 2 4 0 0 3 9 0 0",
                              "f32x3b 0 0 1 0 0 1 0 0 1 0 0 1", "u8x1 0 1 2 3"})
    numbers_of(b, numbers);
  return changed(b, R"("/accessors/12/count": 4, "/bufferViews/12/byteStride": 8)");
}

// A change to furnished(), and the warning or refusal that it meets.
struct Fault {
  const char *change, *said;
};

const Fault kMended[] = {
    {R"("/meshes/0/weights": [1])", "morph-weights-wrong /meshes/0/weights"},
    {R"("/nodes/0/weights": [1])", "morph-weights-wrong /nodes/0/weights"},
    {R"("/P/attributes/FOO": 0)", "unknown-attribute /P/attributes/FOO"},
    {R"("/P/attributes/TEXCOORD": 10)", "unknown-attribute /P/attributes/TEXCOORD"},
    {R"("/P/attributes/TEXCOORD_": 10)", "unknown-attribute /P/attributes/TEXCOORD_"},
    {R"("/P/attributes/TEXCOORD_00": 10)", "unknown-attribute /P/attributes/TEXCOORD_00"},
    {R"("/P/attributes/TEXCOORD_0x": 10)", "unknown-attribute /P/attributes/TEXCOORD_0x"},
    {R"("/P/attributes/NORMAL_0": 8)", "unknown-attribute /P/attributes/NORMAL_0"},
    {R"("/P/attributes/_ID": 7)", "attribute-format /P/attributes/_ID"},
    {R"("/P/attributes/POSITION": 12)", "attribute-format /P/attributes/POSITION"},
    {R"("/P/attributes/POSITION": 8)", "bounds-missing /P/attributes/POSITION"},
    {R"("/P/attributes/TEXCOORD_1": 10)", "attribute-sets-not-continuous /P/attributes/TEXCOORD_1"},
    {R"("/P/targets": [{"FOO": 13}])", "morph-target-wrong /P/targets/0/FOO"},
    {R"("/P/targets": [{"_ID": 13}])", "morph-target-wrong /P/targets/0/_ID"},
    {R"("/P/targets": [{"POSITION": 8}])", "bounds-missing /P/targets/0/POSITION"},
    {R"("/P/targets": [{}])", "empty-target /P/targets/0"},
    {R"("/bufferViews/0/target": 34963)", "buffer-target-wrong /P/attributes/POSITION"},
    {R"("/bufferViews/3/target": 34962)", "buffer-target-wrong /P/indices"},
    {R"("/accessors/3/bufferView": 0)", "buffer-view-shared /P/indices"},
    {R"("/P/attributes/_ID": 14)", "attribute-misaligned /P/attributes/_ID"},
    {R"("/P/attributes/_A": 8, "/accessors/8/bufferView": 0)", "stride-missing /P/attributes/_A"},
    {R"("/images": [{"uri": "a.png"}], "/textures": [{"source": 0}], "/materials": [{"normalTexture": {"index": 0}}], "/P/material": 0)",
     "texture-coordinates-missing /P/material"},
    {R"("/materials": [{"pbrMetallicRoughness": {"baseColorFactor": [2, 0, 0, 1]}}])",
     "colours-clamped /materials/0/pbrMetallicRoughness/baseColorFactor/0"},
    {R"("/nodes/1/matrix": [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])", "matrix-not-affine /nodes/1/matrix"},
    {R"("/nodes/1/matrix": [0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])", "matrix-singular /nodes/1/matrix"},
    {R"("/nodes/1/rotation": [0, 0, 0, 0])", "rotation-zero /nodes/1/rotation"},
    {R"("/nodes/1/rotation": [0, 0, 0, 0.5])", "rotation-not-unit /nodes/1/rotation"},
    {R"("/nodes/2/translation": null, "/nodes/2/matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1])",
     "animated-matrix /animations/0/channels/0/target"},
    {R"("/skins/0/skeleton": 2)", "skeleton-not-above-joints /skins/0/skeleton"},
    {R"("/skins/0/skeleton": 0)", "skeleton-not-above-joints /skins/0/skeleton"},
    {R"("/bufferViews/4/byteStride": 64)", "stride-not-allowed /skins/0/inverseBindMatrices"},
    {R"("/nodes/3": {"children": [4]}, "/nodes/4": {}, "/scenes/0/nodes/2": 4)",
     "scene-lists-no-root /scenes/0/nodes/2"},
    {R"("/animations/0/channels/1": "@/animations/0/channels/0")", "channel-twice /animations/0/channels/1/target"},
    {R"("/bufferViews/5/byteStride": 4)", "stride-not-allowed /animations/0/samplers/0/input"},
    {R"("/bufferViews/6/byteStride": 16)", "stride-not-allowed /animations/0/samplers/0/output"},
    {R"("/accessors/5/max": null)", "bounds-missing /animations/0/samplers/0/input"},
    {R"("/accessors/5/count": 1, "/accessors/11/count": 3, "/animations/0/samplers/0/output": 11, "/animations/0/samplers/0/interpolation": "CUBICSPLINE")",
     "too-few-keys /animations/0/samplers/0/input"},
    {R"("/images": [])", "empty-array /images"},
    {R"("/nodes/2/children": [])", "empty-array /nodes/2/children"},
    {R"("/nodes/0/weights": [])", "empty-array /nodes/0/weights"},
    {R"("/scenes/1": {"nodes": []})", "empty-array /scenes/1/nodes"},
    {R"("/animations/1": {"channels": [], "samplers": []})", "empty-array /animations/1/channels"},
    {R"("/animations/0/channels": [])", "empty-array /animations/0/channels"},
    {R"("/meshes/1": {"primitives": []})", "empty-array /meshes/1/primitives"},
    {R"("/meshes/0/weights": [])", "empty-array /meshes/0/weights"},
    {R"("/P/targets": [])", "empty-array /P/targets"},
    {R"("/accessors/14/min": [])", "empty-array /accessors/14/min"},
    {R"("/accessors/14/count": 0)", "empty-accessor /accessors/14/count"},
    {R"("/bufferViews/14/byteLength": 0, "/accessors/14/count": 0)", "empty-buffer-view /bufferViews/14/byteLength"},
    {R"("/extensionsUsed": ["ACME_a", "ACME_a"])", "duplicate-entry /extensionsUsed/1"},
    {R"("/extensionsRequired": ["KHR_mesh_quantization"])", "extension-not-used /extensionsRequired/0"},
    {R"("/extensions": {"ACME_a": {}})", "undeclared-extension /extensions/ACME_a"},
    {R"("/accessors/14/min": [1, 2])", "bounds-wrong /accessors/14/min"},
    {R"("/accessors/14/max": [1])", "bounds-wrong /accessors/14/max/0"},
};
// What has no better form, in a library neither.
const Fault kOnlySaid[] = {
    {R"("/P/attributes/TANGENT": 9)", "tangents-dropped /P/attributes/TANGENT"},
    {R"("/P/attributes/POSITION": null)", "primitive-without-positions /P/attributes"},
    {R"("/P/mode": 1)", "points-and-lines-dropped /P"},
    {R"("/P/attributes/COLOR_0": 11, "/P/targets": [{"COLOR_0": 11}])", "morph-attribute-dropped /P/targets/0/COLOR_0"},
    {R"("/bufferViews/6/target": 7)", "unknown-buffer-target /bufferViews/6/target"},
    {R"("/extensionsUsed": ["FB_ngon_encoding"], "/extensionsRequired": ["FB_ngon_encoding"])",
     "extension-ignored /extensionsRequired/0"},
    {R"("/asset/version": "2.1", "/asset/minVersion": "2.1")", "newer-minor-version /asset/version"},
    {R"("/buffers/1": {"byteLength": 4})", "buffer-without-data /buffers/1"},
    {R"("/nodes/1/oddity": 1)", "unknown-property /nodes/1/oddity"},
    {R"("/accessors/14/type": "VEC5")", "unknown-accessor-type /accessors/14/type"},
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

RawScene read_with(const std::string& change, bool in_library, const ReadOptions& options = {}) {
  const Builder b = changed(furnished(), change);
  return read_text(in_library ? changed(b, R"("/scene": null, "/scenes": null)").text() : Builder(b).text(), options);
}

void expect_warning(const std::string& change, const std::string& warning, bool in_library,
                    const ReadOptions& options) {
  expect_outcome([&] { return facts_of(read_with(change, in_library, options)); }, "\"warns\": [\"" + warning + "\"]");
}

TEST(GltfRules, FaultsAreMendedInASceneAndRefusedInALibrary) {
  for (const Fault& fault : kMended) {
    SCOPED_TRACE(fault.change);
    expect_warning(fault.change, fault.said, false, {});
    const std::string warning = fault.said, rule = warning.substr(0, warning.find(' ')),
                      where = warning.substr(rule.size() + 1);
    const std::string refusal = "invalid " + where + ": " + rule;
    expect_outcome([&] { return facts_of(read_with(fault.change, false, {.strict = true})); }, refusal);
    if (!where.starts_with("/scenes")) expect_outcome([&] { return facts_of(read_with(fault.change, true)); }, refusal);
  }
  EXPECT_GT(std::size(kMended), 50U);
}

TEST(GltfRules, OthersAreSaid) {
  for (const Fault& fault : kOnlySaid) {
    SCOPED_TRACE(fault.change);
    expect_warning(fault.change, fault.said, false, {});
    expect_warning(fault.change, fault.said, false, {.strict = true});
    expect_warning(fault.change, fault.said, true, {});
  }
}

const Fault kRefusals[] = {
    {R"("/nodes/1/weights": [1])", "invalid /nodes/1/weights: weights without mesh"},
    {R"("/bufferViews/3/byteStride": 4, "/accessors/3/count": 3)", "invalid /P/indices: stride not allowed"},
    {R"("/bufferViews/3/byteStride": 252)", "invalid /bufferViews/3/byteStride: longer than the view"},
    {R"("/bufferViews/3/byteStride": 4, "/bufferViews/3/target": 34963)",
     "invalid /bufferViews/3/byteStride: only vertex data"},
    {R"("/accessors/7/type": "MAT2", "/accessors/7/componentType": 5121, "/accessors/7/byteOffset": 2)",
     "invalid /accessors/7/byteOffset: misaligned"},
    {R"("/accessors/7/normalized": 1)", "invalid /accessors/7/normalized: wrong type"},
    {R"("/accessors/7/normalized": true)", "invalid /accessors/7/normalized: cannot be normalised"},
    {R"("/accessors/7/count": "4")", "invalid /accessors/7/count: wrong type"},
    {R"("/accessors/5/min": ["0"])", "invalid /accessors/5/min/0: wrong type"},
    {R"("/accessors/5": 7)", "invalid /accessors/5: wrong type"},
    {R"("/accessors/7/sparse": {"count": 1, "indices": {"bufferView": 14, "componentType": 5120}, "values": {"bufferView": 7}})",
     "invalid /accessors/7/sparse/indices/componentType: not an unsigned integer"},
    {R"("/accessors/7/sparse": {"count": 1, "indices": {"bufferView": 12, "componentType": 5123}, "values": {"bufferView": 7}})",
     "invalid /accessors/7/sparse/indices/bufferView: byteStride"},
    {R"("/accessors/7/count": 3, "/accessors/7/sparse": {"count": 3, "indices": {"bufferView": 14, "componentType": 5121, "byteOffset": 1}, "values": {"bufferView": 7}})",
     "invalid /accessors/7/sparse/indices: beyond the accessor's end"},
    {R"("/accessors/7/sparse": {"count": 4, "indices": {"bufferView": 14, "componentType": 5121, "byteOffset": 1}, "values": {"bufferView": 7}})",
     "invalid /accessors/7/sparse/indices: beyond the bufferView's end"},
    {R"("/accessors/7/sparse": {"count": 4, "indices": {"bufferView": 14, "componentType": 5121}, "values": {"bufferView": 14}})",
     "invalid /accessors/7/sparse/values: beyond the bufferView's end"},
    {R"("/P/attributes": {})", "invalid /P/attributes: empty object"},
    {R"("/P/attributes": [])", "invalid /P/attributes: wrong type"},
    {R"("/extensionsUsed": [7])", "invalid /extensionsUsed/0: wrong type"},
    {R"("/extensions": [])", "invalid /extensions: wrong type"},
    {R"("/asset/version": "2")", "invalid /asset/version: not a version"},
    {R"("/asset/version": "2.")", "invalid /asset/version: not a version"},
    {R"("/asset/version": "2.0x")", "invalid /asset/version: not a version"},
    {R"("/asset/version": "2-0")", "invalid /asset/version: not a version"},
    {R"("/asset/minVersion": "3.0")", "invalid /asset/minVersion: greater"},
    {R"("/materials": [{"doubleSided": 1}])", "invalid /materials/0/doubleSided: wrong type"},
    {R"("/accessors/14/componentType": 5120, "/P/indices": 14)", "invalid /P/indices: wrong accessor"},
    {R"("/accessors/2/componentType": 5122, "/accessors/2/normalized": true)",
     "invalid /P/attributes/WEIGHTS_0: wrong component type"},
    {R"("/accessors/1/componentType": 5120, "/accessors/1/normalized": true)",
     "invalid /P/attributes/JOINTS_0: wrong component type"},
    {R"("/accessors/4/type": "MAT3", "/accessors/4/componentType": 5121)",
     "invalid /skins/0/inverseBindMatrices: wrong accessor"},
    {R"("/accessors/5/count": 0)", "invalid /animations/0/channels/0/sampler: differ in count"},
    {R"("/accessors/6/count": 0)", "invalid /animations/0/channels/0/sampler: differ in count"},
    {R"("/accessors/0/count": 0, "/accessors/1/count": 0, "/accessors/2/count": 0)",
     "invalid /P/attributes: no vertices"},
    {R"("/accessors/4/count": 0)", "invalid /skins/0/inverseBindMatrices: too few matrices … 0 for"},
    {R"("/bufferViews/14/byteLength": 0)", "invalid /accessors/14: beyond the bufferView's end"},
    {R"("/accessors/6/componentType": 5122)", "invalid /animations/0/channels/0/sampler: wrong output"},
    {R"("/animations/0/channels/0/sampler": 4294967296)",
     "invalid /animations/0/channels/0/sampler: reference to nothing"},
    {R"("/buffers/0/uri": "DATA:application/octet-stream,a%2Fb%aF")",
     "invalid /buffers/0/byteLength: longer than the data"},
    {R"("/buffers/0/uri": "data:application/octet-stream;base64,+/9=")", "invalid /buffers/0/uri: malformed base64"},
    {R"("/buffers/0/uri": "data:application/octet-stream;=x;base64,AAAA")",
     "invalid /buffers/0/uri: malformed data URI"},
    {R"("/buffers/0/uri": "a%4g.bin")", "invalid /buffers/0/uri: malformed URI"},
    {R"("/buffers/0/uri": "a%3Ab.bin")", "invalid /buffers/0/uri: URI not allowed … a drive"},
    {R"("/buffers/0/uri": "a%7Fb.bin")", "invalid /buffers/0/uri: URI not allowed … control character"},
    {R"("/buffers/0/uri": "%5Cb.bin")", "invalid /buffers/0/uri: URI not allowed … backslash"},
};

TEST(GltfRules, WhatHasNoSensibleMeaningIsRefused) {
  for (const Fault& fault : kRefusals) {
    SCOPED_TRACE(fault.change);
    expect_outcome([&] { return facts_of(read_with(fault.change, false)); }, fault.said);
  }
  EXPECT_GT(std::size(kRefusals), 40U);
}

// glTF has no accessors without elements, but exporters write channels of no keys: these move nothing, others do.
TEST(GltfRules, ChannelsWithoutKeysAreLeftOut) {
  for (const std::string spline : {"LINEAR", "STEP", "CUBICSPLINE"}) {
    const std::string empty =
        R"("/animations/0/samplers/1": {"input": "=f32x1", "output": "=f32x3", "interpolation": ")" + spline + R"("},
      "/animations/0/channels/1": {"sampler": 1, "target": {"node": 1, "path": "scale"}})";
    expect_rows(skinned(),
                {{"beside others: two accessors, two views, one channel", empty,
                  R"("warns": ["empty-accessor /accessors/7/count", "empty-buffer-view /bufferViews/8/byteLength",
                                          "channel-without-keys /animations/0/channels/1/sampler"],
                                "warnings/#": 5, "clips/#": 1, "clips/0/channels/#": 1, "clips/0/channels/0/node": 2)"},
                 {"alone", empty + R"(, "/animations/0/channels/0": null)",
                  R"("clips": [], "warns": ["clip-dropped /animations/0"])"}});
  }
}

TEST(GltfRules, LongListsAndPathsAreCutOff) {
  std::string sets, nodes = "{}";
  for (int set = 1; set < 17; ++set)
    for (const auto& [name, accessor] : {std::pair("JOINTS_", 1), std::pair("WEIGHTS_", 2)})
      sets += (sets.empty() ? "" : ", ") + fmt::format(R"("/P/attributes/{}{}": {})", name, set, accessor);
  for (int i = 0; i < 200'000; ++i) nodes += ",{}";
  expect_rows(skinned(), {{"a path", R"("/buffers": [{"byteLength": 1, "uri": ")" + std::string(5000, 'a') + R"("}])",
                           "invalid /buffers/0/uri: not allowed"},
                          {"joint sets", sets, "unsupported /P/attributes/JOINTS_16: too many joint sets"}});
  expect_refused(R"({"asset": {"version": "2.0"}, "nodes": [)" + nodes + "]}", Exit::unsupported, "/nodes",
                 "too many items");
}

TEST(GltfRules, Matrices) {
  const std::string first = R"("/skins/0/inverseBindMatrices": "=f32x16 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 )";
  expect_rows(skinned(), {{"axes that fall together give no rotation",
                           R"("/nodes/1/matrix": [1,0,0,0, 1,0,0,0, 0,0,1,0, 5,6,7,1])",
                           R"("warns": ["matrix-sheared /nodes/1/matrix", "matrix-singular /nodes/1/matrix"],
                   "nodes/1/rotation": [0, 0, 0, 1], "nodes/1/translation": [5, 6, 7])"},
                          {"no number", first + R"(nan 0 0 0 0 1 0 0 0 0 1 0 0 -1 0 1")",
                           "invalid /skins/0/inverseBindMatrices: not a finite number"},
                          {"projective", first + R"(1 0 0 0.5 0 1 0 0 0 0 1 0 0 -1 0 1")",
                           R"("warns": ["matrix-not-affine /skins/0/inverseBindMatrices"],
                   "skins/0/inverse_bind/1/0/3": 0, "skins/0/inverse_bind/1/3/1": -1)"},
                          {"neither the matrix nor what the rest pose gives in its place has an inverse",
                           first + R"(2e9 0 0 0 0 1 0 0 0 0 1 0 0 -1 0 1", "/nodes/2/scale": [2e9, 1, 1])",
                           R"("warns": ["inverse-bind-unusable /skins/0/inverseBindMatrices"],
                   "skins/0/inverse_bind/1": [[1,0,0,0], [0,1,0,0], [0,0,1,0], [0,0,0,1]])"}});
}

TEST(GltfRules, NumbersOfVertices) {
  expect_rows(furnished(),
              {{"UVs, colours, and tangents: none, one too long, one without a sign, one as it should be",
                R"("/P/attributes/TEXCOORD_0": "=f32x2 0 0 nan 0 0 1e13 1 1", "/P/attributes/NORMAL": 8,
                   "/P/attributes/COLOR_0": "=f32x4 nan 0 0 1 0 2 0 1 0 0 -1 1 0 0 0 1.0000001",
                   "/P/attributes/TANGENT": "=f32x4 nan 0 0 1 2 0 0 -1 1 0 0 0.5 0 1 0 -1")",
                R"("warns": ["uvs-mended /P/attributes/TEXCOORD_0", "colours-clamped /P/attributes/COLOR_0",
                             "tangents-mended /P/attributes/TANGENT"],
                   "P/uvs": [[0, 0], [0, 0], [0, 0], [1, 1]],
                   "P/colours/0": [1, 0, 0, 1], "P/colours/1": [0, 1, 0, 1], "P/colours/2": [0, 0, 0, 1],
                   "P/tangents/0/2 ~1e-6": 0, "P/tangents/1": [1, 0, 0, -1], "P/tangents/2": [1, 0, 0, 1],
                   "P/tangents/3": [0, 1, 0, -1])"}});
  const RawScene scene = read_with(
      R"("/P/attributes/NORMAL": 8, "/P/attributes/TANGENT": "=f32x4 nan 0 0 1 2 0 0 -1 1 0 0 1 0 1 0 1")", false);
  EXPECT_NEAR(glm::length(glm::vec3(scene.meshes[0].primitives[0].tangents[0])), 1, 1e-6);
  const std::string lost = R"("/P/attributes/WEIGHTS_0": "=f32x4 1 0 0 0 nan 0 0 0 0.25 0.75 0 0 1 0 0 0")";
  expect_rows(skinned(),
              {{"without a weight the first joint listed counts", lost,
                R"("warns": ["weights-not-finite /P/attributes/WEIGHTS_0", "weights-zero /P/attributes/WEIGHTS_0"],
                              "P/influences/1/#": 1, "P/influences/1/0/0": 1)"},
               {"before 0", R"("/animations/0/samplers/0/input": "=f32x1 -1 1")",
                "invalid /animations/0/samplers/0/input: negative time"}});
  expect_rows(skinned(), {{"strictly", lost, "invalid /accessors/7: not a finite number"}}, {.strict = true});
}

TEST(GltfRules, WeightsBeyondAllBoundsAreShares) {
  expect_rows(skinned(),
              {{"0 and 1 list both joints, 2 lists joint 1 twice, 3 has one weight that is infinite and one below zero",
                R"("/P/attributes/JOINTS_0": "=u8x4 0 1 0 0  1 0 0 0  1 1 0 0  1 0 0 0",
                   "/P/attributes/WEIGHTS_0": "=f32x4 3e38 1e38 0 0  3e38 1 0 0  3e38 3e38 0 0  inf -3e38 0.5 0")",
                R"("P/influences ~1e-6": [[[0, 0.75], [1, 0.25]], [[1, 1]], [[1, 1]], [[0, 0.5]]],
                   "warns": ["weights-not-finite /P/attributes/WEIGHTS_0", "weights-negative /P/attributes/WEIGHTS_0",
                     "weights-not-normalised /P/attributes/WEIGHTS_0", "joints-listed-twice /P/attributes/WEIGHTS_0"])"}});
}

TEST(GltfRules, NormalsOfNothing) {
  expect_rows("", {{"upward, for want of a surface, where triangles have no area, and tangents square to that",
                    R"("/nodes/0/mesh": 0, "/meshes": [{"primitives": [{"attributes": {
                      "POSITION": "=f32x3 0 0 0 1 0 0 2 0 0", "NORMAL": "=f32x3 nan 0 0 1 0 0 0 0 0",
                      "TANGENT": "=f32x4 1 0 0 1 0 0 0 1 1 0 0 1"}}]}])",
                    R"("P/normals/0": [0, 1, 0], "P/normals/1": [1, 0, 0], "P/tangents/1/0 ~1e-6": 0)"},
                   {"no vertex is left to stand amid",
                    R"("/nodes/0/mesh": 0, "/meshes": [{"primitives": [{"attributes": {
                      "POSITION": "=f32x3 2e12 0 0 2e12 1 0 2e12 0 1"}}]}])",
                    R"("P/positions/0": [0, 0, 0])"}});
}

}  // namespace
}  // namespace marrow::cook
