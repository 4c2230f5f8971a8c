// Reading glTF: nodes and skins, values by hand arithmetic from the specification.
#include <gtest/gtest.h>

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {
namespace {

TEST(GltfNodes, Transforms) {
  expect_rows(
      "",
      {{"a matrix is taken apart: scale 2, 3, 4, then a quarter turn about z, then a move; columns y, −x, z",
        R"("/nodes/0/matrix": [0, 2, 0, 0,  -3, 0, 0, 0,  0, 0, 4, 0,  5, 6, 7, 1])",
        R"("nodes/0/translation ~1e-12": [5, 6, 7], "nodes/0/scale ~1e-12": [2, 3, 4],
                       "nodes/0/rotation ~1e-12": [0, 0, 0.70710678118654752, 0.70710678118654752])"},
       {"a mirror has one negative axis", R"("/nodes/0/matrix": [-2, 0, 0, 0,  0, 3, 0, 0,  0, 0, 4, 0,  0, 0, 0, 1])",
        R"("warns only": [], "nodes/0/scale ~1e-12": [-2, 3, 4], "nodes/0/rotation ~1e-12": [0, 0, 0, 1])"},
       {"shear is dropped", R"("/nodes/0/matrix": [1, 0, 0, 0,  0.5, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1])",
        R"("warns": ["matrix-sheared /nodes/0/matrix"])"},
       {"a rotation is normalised", R"("/nodes/0/rotation": [5, 5, 5, 5])",
        R"("nodes/0/rotation/3 ~1e-12": 0.5, "warns": ["rotation-not-unit /nodes/0/rotation"])"},
       {"but libraries are held to the letter", R"("/nodes/0/rotation": [5, 5, 5, 5], "/scene": null, "/scenes": null)",
        "invalid /nodes/0/rotation: rotation-not-unit … the file has no scene"},
       {"a scale of zero stays invertible", R"("/nodes/0/scale": [0, 1, 2])",
        R"("nodes/0/scale/0": 1e-6, "warns": ["scale-zero"])"}});
}

// A point seen through either must be the same, whichever axis is chosen.
TEST(GltfNodes, AMirrorMirrors) {
  Builder b = document_of(R"("nodes": [{"matrix": [1, 0, 0, 0,  0, 1, 0, 0,  0, 0, -1, 0,  0, 0, 0, 1]}])");
  const RawNode node = read(b).nodes.at(0);
  expect_near(node.rotation * (node.scale * glm::dvec3(1, 2, 3)), {1, 2, -3});
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
  const std::pair<std::string, std::string> names[] = {
      {"../../tmp/x", ".._.._tmp_x"}, {"/etc", "_etc"},           {"con", "con_"},
      {"LPT1.txt", "LPT1.txt_"},      {"a\nb\x1b[2J", "a_b_[2J"}, {"\u202Ecba", "_cba"}};
  const auto expect = [](const std::string& name, const std::string& cleaned) {
    Builder b;
    b.root["nodes"][0]["name"] = name;
    EXPECT_EQ(read(b).nodes[0].name, cleaned);
  };
  for (const auto& [name, cleaned] : names) expect(name, cleaned);
  for (const char* good : {"mixamorig:Hips", "Arm/Hand.L", "Knochen_\u00FC", "\u9AA8", "console", "a..b", ""})
    expect(good, good);
}

TEST(GltfSkins, WhatDoesNotFitIsMended) {
  expect_rows(skinned(), {{"a singular inverse bind comes from the rest pose: the tip is at (0, 1, 0)",
                           R"("/skins/0/inverseBindMatrices":
                   "=f32x16 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1  1 0 0 0 1 0 0 0 0 0 1 0 0 -1 0 1")",
                           R"("skins/0/inverse_bind/1/3": [0, -1, 0, 1], "skins/0/inverse_bind/1/1": [0, 1, 0, 0],
                   "warns": ["inverse-bind-unusable /skins/0/inverseBindMatrices"])"},
                          {"a skin without weights is drawn rigidly",
                           R"("/P/attributes/JOINTS_0": null, "/P/attributes/WEIGHTS_0": null)",
                           R"("instances/0/skin": -1, "warns": ["skin-without-weights /nodes/0/skin"])"},
                          {"weights without a skin are dropped", R"("/nodes/0/skin": null)",
                           R"("P/influences": [], "warns": ["weights-without-skin /nodes/0"])"}});
}

}  // namespace
}  // namespace marrow::cook
