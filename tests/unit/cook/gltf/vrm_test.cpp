// VRM avatars: springs, expressions, look-at and properties, alike of both
// versions; and what is wrong of them.
#include <cmath>
#include <string>
#include <vector>

#include "marrow/limits.h"
#include "marrow/marrow.h"
#include "unit/cook/cook_text.h"
#include "unit/cook/gltf/vrm_document.h"

namespace marrow::cook {
namespace {

class BothVersions : public ::testing::TestWithParam<Builder (*)()> {};
INSTANTIATE_TEST_SUITE_P(Vrm, BothVersions, ::testing::Values(&avatar_1, &avatar_0));

TEST_P(BothVersions, ExpressionsAreAdditiveClipsOfWeights) {
  const LoadedCook c(cook_text(GetParam()()));
  const File& file = c.file;
  ASSERT_EQ(file.clip_count(), 2U) << "glow changes a material alone";
  const std::uint32_t happy = file.find_clip("expression/happy");
  ASSERT_LT(happy, file.clip_count());
  EXPECT_TRUE(file.clip(happy).additive);
  EXPECT_EQ(file.clip(happy).duration_s, 0);
  EXPECT_LT(file.find_clip("expression/blink"), file.clip_count());

  std::vector<std::byte> shared(animations_bytes(file, file) + 16), own(character_bytes(file, {}) + 16);
  const auto on_boundary = [](std::vector<std::byte>& v) {
    void* at = v.data();
    std::size_t space = v.size();
    std::align(16, v.size() - 16, at, space);
    return Span<std::byte>(static_cast<std::byte*>(at), v.size() - 16);
  };
  Animations animations;
  marrow::Character character;
  ASSERT_EQ(make_animations(file, file, on_boundary(shared), animations), Status::ok);
  ASSERT_EQ(make_character(file, {}, on_boundary(own), character), Status::ok);
  const std::uint32_t face = file.find_mesh("face");
  ASSERT_LT(face, file.mesh_count());
  ASSERT_EQ(pose_character(character, {}), Status::ok);
  ASSERT_EQ(add_expression(character, {find_animation(animations, "expression/happy"), 0, 0.75F}), Status::ok);
  ASSERT_EQ(add_expression(character, {find_animation(animations, "expression/blink"), 0, 1}), Status::ok);
  const Span<float> weights = character.meshes[face].weights;
  ASSERT_EQ(weights.size, 3U);
  EXPECT_FLOAT_EQ(weights[0], 0.75F);
  EXPECT_FLOAT_EQ(weights[1], 1);
  EXPECT_FLOAT_EQ(weights[2], 0.25F + 0.75F * 0.5F) << "on top of the mesh's own";
}

TEST_P(BothVersions, NodesSayWhatTheyAre) {
  expect_cooked(GetParam()(), {{"two eyes, two bones and the face", "", "", R"("nodes/#": 5,
    "node/Hips/properties": {"vrm/humanoid": "hips", "vrm/expressions/happy/isBinary": true},
    "node/Eye.L/properties": {"vrm/humanoid": "leftEye"}, "node/face/properties": {"vrm/firstPerson": "thirdPersonOnly"},
    "node/Head/properties": {"vrm/lookAt/type": "bone", "vrm/lookAt/offsetFromHeadBone/1": 0.0625,
                             "vrm/lookAt/rangeMapHorizontalInner/outputScale": 10})"}});
}

TEST(Vrm, LicencesAreKept) {
  expect_cooked(avatar_1(), {{"version 1", "", "",
                              R"("node/Hips/properties": {"vrm/specVersion": "1.0",
      "vrm/meta/name": "Testa", "vrm/meta/authors/1": "Eve", "vrm/meta/licenseUrl": "https://vrm.dev/licenses/1.0/",
      "vrm/expressions/happy/overrideBlink": "block"}, "!node/Hips/properties": {"vrm/meta/thumbnailImage": 0})"}});
  expect_cooked(avatar_0(), {{"version 0", "", "", R"(
    "node/Hips/properties": {"vrm/specVersion": "0.0", "vrm/meta/licenseName": "CC0"},
    "!node/Hips/properties": {"vrm/meta/texture": -1},
    "node/Head/properties": {"vrm/lookAt/offsetFromHeadBone/2": -0.5})"}});
}

// A turn about the scene's axes, as the eye is not turned at rest. Forward is
// where the avatar looks.
double excess_deg(const File& file, const char* eye, double yaw_deg, double pitch_deg, double forward) {
  const Skeleton skeleton = file.skeleton(0);
  const JointLimit* const limit = find_limit(skeleton.limits, file.find_joint(skeleton, eye));
  if (limit == nullptr) return -1;
  const double kHalf = 3.14159265358979323846 / 360;
  // Yaw to the avatar's left about +y; pitch down about the avatar's left,
  // which is `forward` times +x.
  const double y = yaw_deg * kHalf, x = pitch_deg * kHalf;
  const double sy = std::sin(y), cy = std::cos(y), sx = std::sin(x) * forward, cx = std::cos(x);
  const float q[4] = {static_cast<float>(cy * sx), static_cast<float>(sy * cx), static_cast<float>(-sy * sx),
                      static_cast<float>(cy * cx)};
  return double{limit_excess(*limit, q)} / kHalf / 2;
}

TEST_P(BothVersions, EyesTurnAsFarAsLookAtSays) {
  const LoadedCook c(cook_text(GetParam()()));
  const double forward = GetParam() == &avatar_1 ? 1 : -1;
  const auto left = [&](double yaw, double pitch) { return excess_deg(c.file, "Eye.L", yaw, pitch, forward); };
  const auto right = [&](double yaw, double pitch) { return excess_deg(c.file, "Eye.R", yaw, pitch, forward); };
  EXPECT_EQ(left(0, 0), 0);
  EXPECT_EQ(left(19.9, 0), 0) << "outwards";
  EXPECT_NEAR(left(25, 0), 5, 0.01);
  EXPECT_NEAR(left(-15, 0), 5, 0.01) << "inwards";
  EXPECT_NEAR(right(15, 0), 5, 0.01) << "inwards";
  EXPECT_NEAR(right(-25, 0), 5, 0.01) << "outwards";
  EXPECT_NEAR(left(0, 10), 2, 0.01) << "down";
  EXPECT_NEAR(left(0, -15), 3, 0.01) << "up";
  EXPECT_EQ(right(-19.9, -11.9), 0);
}

TEST(Vrm, SpringsAndWhatTheyNeed) {
  expect_cooked(
      avatar_1(),
      {{"version 1: its chains; no chain meets the capsule; the last node is "
        "only an end",
        "", "",
        R"("skeletons/0/springs/#": 1, "skeletons/0/springs/0/joints/#": 2, "skeletons/0/springs/0/tip/1": -0.0625,
           "skeletons/0/springs/0/joints/0": {"joint": "Hair", "radius_m": 0.03125, "gravity": 0},
           "skeletons/0/springs/0/joints/1": {"joint": "Hair lower", "gravity": "> 0"},
           "skeletons/0/springs/0/colliders": 1, "skeletons/0/colliders/#": 1, "skeletons/0/colliders/0/from/2": 0.25,
           "skeletons/0/joints": ["Hips", "Head", "Eye.L", "Eye.R", "Hair", "Hair lower"])"},
       {"colliders of nodes that are no joints hang on the nearest", "",
        R"("/nodes/8/translation": [0, 0.5, 0], "/nodes/8/scale": [2, 2, 2],
           "/extensions/VRMC_springBone/colliders/0/node": 8)",
        R"("skeletons/0/colliders/#": 1, "skeletons/0/colliders/0/joint": "Head", "skeletons/0/colliders/0/radius_m ~1e-7": 0.25,
           "skeletons/0/colliders/0/from/1 ~1e-7": 0.75, "skeletons/0/colliders/0/from/2 ~1e-7": 0.5)"},
       {"springs need no avatar", "", R"("/extensions/VRMC_vrm": null)",
        R"("skeletons/0/springs/#": 1, "nodes": [], "clips": [])"},
       {"limits that stand there stay", "", R"("/nodes/3/extras": {"marrow": {"limits": {"speed": 90}}})",
        R"("skeletons/0/limits/Eye.L": 0)"},
       {"constraints are said to be left out", "", R"("/extensionsUsed/-": "VRMC_node_constraint")",
        R"("warns": ["constraints-dropped"])"}});
  expect_cooked(
      avatar_0(),
      {{"version 0: all that hangs below, and seven centimetres on; its z goes "
        "the other way",
        "", "",
        R"("skeletons/0/springs/#": 2, "skeletons/0/springs/0/joints/#": 3, "skeletons/0/springs/0/joints/2/joint": "Hair end",
           "skeletons/0/springs/0/tip/1 ~1e-7": -0.07, "skeletons/0/springs/1/joints/#": 1,
           "skeletons/0/springs/1/joints/0/joint": "Lock", "skeletons/0/springs/1/tip/0 ~1e-7": 0.07,
           "skeletons/0/springs/1/colliders": 1, "skeletons/0/colliders/#": 1, "skeletons/0/colliders/0/from/2": 0.25)"}});
}

TEST(Vrm, ClipPacksHaveNoSprings) {
  const LoadedCook c(cook_text(avatar_1(), options_of("--clips-only")));
  for (const File::Section& s : c.file.sections()) EXPECT_NE(s.type, format::four_characters("SPRI"));
  EXPECT_EQ(c.file.spring_count(0), 0U);
}

// Pointers below "/extensions".
struct Fault {
  const char *name, *change, *said;
};
std::string in_extensions(const std::string& text) {
  std::string out = text;
  for (const std::string name : {"VRMC_vrm", "VRMC_springBone", "VRM"})
    for (const std::string before : {"\"", " "})
      for (const std::string behind : {"\"", "/", ":"})
        for (std::size_t at; (at = out.find(before + name + behind)) != std::string::npos;)
          out.replace(at + 1, 0, "/extensions/");
  return out;
}

const Fault kRefused1[] = {
    {"a list", R"("VRMC_vrm": [])", "VRMC_vrm: wrong type"},
    {"springs", R"("VRMC_springBone/springs": 3)", "VRMC_springBone/springs: wrong type"},
    {"a node beyond", R"("VRMC_springBone/springs/0/joints/0/node": 10)",
     "VRMC_springBone/springs/0/joints/0/node: reference to nothing"},
    {"no node", R"("VRMC_springBone/springs/0/joints/1/node": null)",
     "VRMC_springBone/springs/0/joints/1/node: missing"},
    {"a word", R"("VRMC_springBone/springs/0/joints/0/stiffness": "soft")",
     "VRMC_springBone/springs/0/joints/0/stiffness: wrong type"},
    {"two numbers", R"("VRMC_springBone/springs/0/joints/0/gravityDir": [0, 1])",
     "VRMC_springBone/springs/0/joints/0/gravityDir: wrong number of items"},
    {"a group beyond", R"("VRMC_springBone/springs/0/colliderGroups": [2])",
     "VRMC_springBone/springs/0/colliderGroups: reference to nothing"},
    {"a collider beyond", R"("VRMC_springBone/colliderGroups/1/colliders": [0.5])",
     "VRMC_springBone/colliderGroups/1/colliders: reference to nothing"},
    {"a bone beyond", R"("VRMC_vrm/humanoid/humanBones/jaw": {"node": 99})",
     "VRMC_vrm/humanoid/humanBones/jaw/node: reference to nothing"},
    {"a bone that is a number", R"("VRMC_vrm/humanoid/humanBones/jaw": 4)",
     "VRMC_vrm/humanoid/humanBones/jaw: wrong type"},
    {"an expression's node", R"("VRMC_vrm/expressions/preset/blink/morphTargetBinds/0/node": -1)",
     "VRMC_vrm/expressions/preset/blink/morphTargetBinds/0/node: reference to "
     "nothing"},
    {"an expression's index", R"("VRMC_vrm/expressions/preset/blink/morphTargetBinds/0/index": 0.5)",
     "VRMC_vrm/expressions/preset/blink/morphTargetBinds/0/index: wrong type"},
    {"a range", R"("VRMC_vrm/lookAt/rangeMapVerticalUp/outputScale": false)",
     "VRMC_vrm/lookAt/rangeMapVerticalUp/outputScale: wrong type"},
};
const Fault kRefused0[] = {
    {"a text", R"("VRM": "avatar")", "VRM: wrong type"},
    {"a bone beyond", R"("VRM/humanoid/humanBones/0/node": 10)",
     "VRM/humanoid/humanBones/0/node: reference to nothing"},
    {"a root beyond", R"("VRM/secondaryAnimation/boneGroups/0/bones": [1e9])",
     "VRM/secondaryAnimation/boneGroups/0/bones: reference to nothing"},
    {"bones", R"("VRM/secondaryAnimation/boneGroups/0/bones": ["Hair"])",
     "VRM/secondaryAnimation/boneGroups/0/bones/0: wrong type"},
    {"a collider's node", R"("VRM/secondaryAnimation/colliderGroups/0/node": 77)",
     "VRM/secondaryAnimation/colliderGroups/0/node: reference to nothing"},
    {"a direction", R"("VRM/secondaryAnimation/boneGroups/0/gravityDir": [0, -1, 0])",
     "VRM/secondaryAnimation/boneGroups/0/gravityDir: wrong type"},
    {"binds", R"("VRM/blendShapeMaster/blendShapeGroups/0/binds": 1)",
     "VRM/blendShapeMaster/blendShapeGroups/0/binds: wrong type"},
};

void expect_all_refused(const Builder& avatar, std::span<const Fault> faults) {
  for (const Fault& f : faults)
    expect_rows(avatar, {{f.name, in_extensions(f.change), in_extensions(std::string("invalid ") + f.said)}});
}

TEST(Vrm, WhatIsWrongIsRefusedWhereItStands) {
  expect_all_refused(avatar_1(), kRefused1);
  expect_all_refused(avatar_0(), kRefused0);
}

// Left out with a warning; all else is there.
const Fault kLeftOut1[] = {
    {"a chain in a circle", R"("VRMC_springBone/springs/0/joints": [{"node": 5}, {"node": 6}, {"node": 5}])",
     "spring-goes-up VRMC_springBone/springs/0/joints/2"},
    {"a chain that goes up", R"("VRMC_springBone/springs/0/joints": [{"node": 6}, {"node": 5}])",
     "spring-goes-up VRMC_springBone/springs/0/joints/1"},
    {"a joint twice", R"("VRMC_springBone/springs/1": "@/extensions/VRMC_springBone/springs/0")",
     "spring-shares-joint VRMC_springBone/springs/1/joints/0"},
    {"one joint", R"("VRMC_springBone/springs/0/joints": [{"node": 5}])",
     "spring-without-bone VRMC_springBone/springs/0"},
    {"no shape", R"("VRMC_springBone/colliders/0/shape": null)", "collider-dropped VRMC_springBone/colliders/0"},
    {"a huge radius", R"("VRMC_springBone/colliders/0/shape/sphere/radius": 1e30)",
     "collider-dropped VRMC_springBone/colliders/0"},
    {"a center", R"("VRMC_springBone/springs/0/center": 1)", "spring-center-dropped VRMC_springBone/springs/0/center"},
    {"gravity from aside",
     R"("VRMC_springBone/springs/0/joints/0/gravityDir": [1, 0, 0], "VRMC_springBone/springs/0/joints/0/gravityPower": 1)",
     "spring-gravity-sideways VRMC_springBone/springs/0/joints/0"},
    {"a target beyond", R"("VRMC_vrm/expressions/preset/happy/morphTargetBinds/0/index": 3)",
     "expression-bind-dropped VRMC_vrm/expressions/preset/happy"},
    {"a node without a mesh", R"("VRMC_vrm/expressions/preset/happy/morphTargetBinds/0/node": 2)",
     "expression-bind-dropped VRMC_vrm/expressions/preset/happy"},
    {"a huge weight", R"("VRMC_vrm/expressions/preset/happy/morphTargetBinds/0/weight": 1e30)",
     "expression-bind-dropped VRMC_vrm/expressions/preset/happy"},
    {"an annotation of a bone", R"("VRMC_vrm/firstPerson/meshAnnotations/0/node": 2)",
     "annotation-dropped VRMC_vrm/firstPerson/meshAnnotations/0"},
    {"nothing", "", "material-binds-dropped VRMC_vrm/expressions"},
};
const Fault kLeftOut0[] = {
    {"a root twice", R"("VRM/secondaryAnimation/boneGroups/0/bones": [5, 5])",
     "spring-shares-joint VRM/secondaryAnimation/boneGroups/0"},
    {"a root below another", R"("VRM/secondaryAnimation/boneGroups/0/bones": [6, 5])",
     "spring-shares-joint VRM/secondaryAnimation/boneGroups/0"},
    {"a mesh that is not there", R"("VRM/blendShapeMaster/blendShapeGroups/0/binds/0/mesh": 7)",
     "expression-bind-dropped VRM/blendShapeMaster/blendShapeGroups/0"},
    {"nothing", "", "material-binds-dropped VRM/blendShapeMaster"},
};

void expect_all_left_out(const Builder& avatar, std::span<const Fault> faults) {
  for (const Fault& f : faults)
    expect_cooked(avatar, {{f.name, "", in_extensions(f.change),
                            in_extensions(std::string(R"("skeletons/#": 1, "warns": [")") + f.said + "\"]")}});
}

TEST(Vrm, WhatAGameCanDoWithoutIsLeftOut) {
  expect_all_left_out(avatar_1(), kLeftOut1);
  expect_all_left_out(avatar_0(), kLeftOut0);
}

TEST(Vrm, SettingsBeyondTheRangesAreHeldWithin) {
  for (const std::string huge : {"3e38", "1e30", "-1e30", "1e-30"}) {
    std::string change;
    for (const std::string joint : {"0", "1", "2"})
      for (const std::string setting : {"stiffness", "gravityPower", "dragForce", "hitRadius"})
        change += (change.empty() ? "\"" : ", \"") + ("VRMC_springBone/springs/0/joints/" + joint) + "/" + setting +
                  "\": " + huge;
    expect_cooked(avatar_1(), {{huge, "", in_extensions(change), R"("skeletons/0/springs/#": 1)"}});
  }
}

TEST(Vrm, NoMoreCollidersThanAFrameHas) {
  Builder b = avatar_1();
  Json& bones = b.root["extensions"]["VRMC_springBone"];
  bones["colliders"] = Json::array_t(100, bones["colliders"][0]);
  bones["colliderGroups"][0]["colliders"] = Json::array();
  for (int c = 0; c < 100; ++c) bones["colliderGroups"][0]["colliders"].push_back(c);
  expect_cooked(b, {{"all of 64", "", "",
                     R"("warns": ["too-many-colliders"], "skeletons/0/colliders/#": 64,
                                             "skeletons/0/springs/0/colliders": 18446744073709551615)"}});
  EXPECT_EQ(kMaxSpringColliders, 64U);
}

}  // namespace
}  // namespace marrow::cook
