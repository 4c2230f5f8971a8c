// Reading glTF: geometry, values by hand arithmetic from the specification.
#include <gtest/gtest.h>

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {
namespace {

TEST(Gltf, SkinnedSceneReadsWithoutWarnings) {
  expect_rows(skinned(), {{"all of it", "", R"(
    "warns only": [], "nodes/#": 3, "nodes/2/parent": 1, "nodes/2/name": "tip", "nodes/2/translation": [0, 1, 0],
    "meshes/#": 1, "P/pointer": "/P", "P/positions/3": [3, 9, 0], "P/indices": [0, 1, 2, 1, 3, 2],
    "P/influences/#": 4, "P/influences/2": [[0, 0.25], [1, 0.75]],
    "skins/#": 1, "skins/0/joints": [1, 2], "skins/0/inverse_bind/1/3": [0, -1, 0, 1],
    "instances/#": 1, "instances/0/skin": 0, "clips/#": 1, "clips/0/channels/0/values/1": [0, 0, 1, 0])"}});
  Builder b = skinned();
  EXPECT_EQ(read(b).source_bytes, b.text().size());
}

TEST(Gltf, TrianglesOfEveryMode) {
  const std::string five = R"("/P/attributes/POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0 4 16 0")";
  const std::string six = R"("/P/attributes/POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0 4 16 0 5 25 0")";
  expect_rows(
      kTriangle,
      {{"missing indices are counted", six, R"("P/indices": [0, 1, 2, 3, 4, 5])"},
       {"an incomplete triangle is dropped", five, R"("P/indices/#": 3, "warns": ["incomplete-triangle"])"},
       {"a strip keeps its winding: (i, i + 1, i + 2) and, for odd i, (i, i + 2, i + 1)", five + R"(, "/P/mode": 5)",
        R"("P/indices": [0, 1, 2, 1, 3, 2, 2, 3, 4])"},
       {"degenerate triangles of a strip only join", six + R"(, "/P/mode": 5, "/P/indices": "=u32x1 0 1 2 2 3 3 4 5")",
        R"("P/indices": [0, 1, 2, 3, 5, 4])"},
       {"a fan goes round its first vertex", five + R"(, "/P/mode": 6)",
        R"("P/indices": [1, 2, 0, 2, 3, 0, 3, 4, 0])"}});
  for (const char* mode : {"0", "1", "2", "3"})
    expect_rows(kTriangle, {{"points and lines are left out", six + R"(, "/P/mode": )" + mode,
                             R"("meshes/0/primitives": [], "warns": ["points-and-lines-dropped /P"])"}});
}

TEST(Gltf, Accessors) {
  const std::string sparse = R"("sparse": {"count": 2, "indices": {"bufferView": "=u16 1 3", "componentType": 5123},
                                           "values": {"bufferView": "=f32 7 8 9 4 5 6"}})";
  expect_rows(kTriangle,
              {{"strided attributes are taken apart: x y z u v a vertex",
                R"("/P/attributes/POSITION": 1, "/P/attributes/TEXCOORD_0": 2,
                   "/accessors/1": "@/accessors/0",
                   "/accessors/1/bufferView": "=f32/20 0 0 0 .1 .2  1 0 0 .3 .4  0 1 0 .5 .6", "/accessors/1/max": [1, 1, 0],
                   "/accessors/2": {"bufferView": "=f32/20 0 0 0 .1 .2  1 0 0 .3 .4  0 1 0 .5 .6", "byteOffset": 12,
                                    "componentType": 5126, "type": "VEC2", "count": 3})",
                R"("warns only": [], "P/positions/2": [0, 1, 0], "P/uvs/1": [0.3, 0.4])"},
               {"sparse ones replace elements of others, or zeros",
                R"("/accessors/0": {"bufferView": "=f32 0 0 0 1 1 0 2 4 0 3 9 0", "componentType": 5126, "type": "VEC3",
                                    "count": 4, "min": [0, 0, 0], "max": [9, 9, 9], )" +
                    sparse + R"(}, "/accessors/1": {"componentType": 5126, "type": "VEC3", "count": 4, "min": [0, 0, 0],
                                                    "max": [7, 8, 9], )" +
                    sparse + R"(}, "/P/mode": 5, "/meshes/0/primitives/-": {"attributes": {"POSITION": 1}, "mode": 5})",
                R"("warns only": [], "P/positions": [[0, 0, 0], [7, 8, 9], [2, 4, 0], [4, 5, 6]],
                   "meshes/0/primitives/1/positions": [[0, 0, 0], [7, 8, 9], [0, 0, 0], [4, 5, 6]])"},
               {"normalised integers become fractions; -32768 is clamped",
                R"("/P/attributes/COLOR_0": "=u8x4n 0 51 102 255 255 0 0 0 0 255 0 0",
                   "/P/attributes/TEXCOORD_0": "=u16x2n 0 65535 13107 0 0 0",
                   "/animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}], "samplers":
                     [{"input": "=f32x1 0 1", "output": "=i16x4n 0 0 0 32767 -32768 0 0 0"}]}])",
                R"("P/colours/0": [0, 0.2, 0.4, 1], "P/uvs/0": [0, 1], "P/uvs/1": [0.2, 0],
                   "clips/0/channels/0/values": [[0, 0, 0, 1], [-1, 0, 0, 0]])"},
               {"quantised positions keep their units",
                R"("/extensionsUsed": ["KHR_mesh_quantization"], "/extensionsRequired": ["KHR_mesh_quantization"],
                   "/accessors/0": {"bufferView": "=i16/8 -5 0 7 0  1 2 3 0  300 400 500 0", "componentType": 5122,
                                    "type": "VEC3", "count": 3, "min": [-5, 0, 3], "max": [300, 400, 500]},
                   "/accessors/1": {"bufferView": "=i8/4 0 127 0 0  0 0 -127 0  127 0 0 0", "componentType": 5120,
                                    "type": "VEC3", "count": 3, "normalized": true}, "/P/attributes/NORMAL": 1)",
                R"("warns only": [], "P/positions/2": [300, 400, 500], "P/normals/1": [0, 0, -1])"}});
}

TEST(Gltf, WeightsAreReadAndMended) {
  expect_rows(skinned(),
              {{"all joint sets are read",
                R"("/nodes": [{"mesh": 0, "skin": 0}, {"children": [2, 3, 4, 5, 6, 7, 8]}, {}, {}, {}, {}, {}, {}, {}],
                   "/skins": [{"joints": [1, 2, 3, 4, 5, 6, 7, 8]}], "/animations": null, "/P/indices": null,
                   "/P/attributes/POSITION": "=f32x3 0 0 0 1 1 0 2 4 0",
                   "/P/attributes/JOINTS_0": "=u16x4 0 1 2 3  0 1 2 3  0 1 2 3",
                   "/P/attributes/WEIGHTS_0": "=f32x4 .3 .2 .1 .1  1 0 0 0  1 0 0 0",
                   "/P/attributes/JOINTS_1": "=u8x4 4 5 6 7  4 5 6 7  4 5 6 7",
                   "/P/attributes/WEIGHTS_1": "=u8x4n 51 0 0 26 0*8")",
                R"("warns only": [], "P/influences/0/#": 6, "P/influences/0/4": [4, 0.2],
                   "P/influences/0/5 ~1e-8": [7, 0.10196078431372549])"},
               {"joint 1 twice; no weight at all; below zero; too small to compute with",
                R"("/P/attributes/JOINTS_0": "=u8x4 1 1 0 0  1 0 0 0  0 1 0 0  0 1 0 0",
                   "/P/attributes/WEIGHTS_0": "=f32x4 .5 .25 .25 0  0 0 0 0  1 -.5 0 0  1 1e-41 0 0")",
                R"("P/influences/0/#": 2, "P/influences/0/0": [1, 0.75], "P/influences/1": [[1, 1]],
                   "P/influences/2/#": 1, "P/influences/3/#": 1, "warns":
                   ["joints-listed-twice /P/attributes/WEIGHTS_0", "weights-zero /P/attributes/WEIGHTS_0",
                    "weights-negative /P/attributes/WEIGHTS_0", "weights-denormal /P/attributes/WEIGHTS_0"])"}});
}

TEST(Gltf, VerticesAndMaterials) {
  expect_rows(
      kTriangle,
      {{"damaged normals are remade: it faces +z",
        R"("/P/attributes/POSITION": "=f32x3 0 0 0 1 0 0 0 1 0", "/P/attributes/NORMAL": "=f32x3 nan 0 0 0 0 0 0 3 4")",
        R"("P/normals/0": [0, 0, 1], "P/normals/1": [0, 0, 1], "P/normals/2/1 ~1e-7": 0.6,
                   "warns": ["normals-remade", "normals-not-unit"])"},
       {"lost vertices move to the middle",
        R"("/P/attributes/POSITION": "=f32x3 0 0 0 2 0 0 3e38 0 0 0 2 0", "/P/mode": 5)",
        R"("P/positions/2 ~1e-6": [0.6666667, 0.6666667, 0], "warns": ["position-out-of-reach"])"},
       {"a material is carried",
        R"("/materials": [{"name": "skin", "doubleSided": true,
                                   "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0, 1]}}], "/P/material": 0)",
        R"("P/material": 0, "materials/0": {"name": "skin", "double_sided": true, "base_colour": [0.5, 0.25, 0, 1]})"}});
}

}  // namespace
}  // namespace marrow::cook
