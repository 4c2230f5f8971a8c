// Reading glTF: nodes and skins, values by hand arithmetic from the specification.
#include "cook/gltf/read.h"

#include <cmath>

#include <gtest/gtest.h>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

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
  try {
    read(b);
  } catch (const Failure& failure) {
    EXPECT_NE(failure.advice().find("the file has no scene"), std::string::npos) << failure.advice();
  }
}

TEST(GltfNodes, ZeroScaleStaysInvertible) {
  Builder b;
  b.root["nodes"][0]["scale"] = {0, 1, 2};
  const RawScene scene = read(b);
  EXPECT_EQ(scene.nodes[0].scale.x, 1e-6);
  EXPECT_TRUE(warns(scene, "scale-zero"));
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

}  // namespace
}  // namespace marrow::cook
