// VRM avatars: springs, expressions, look-at and properties, alike of both versions; and what is wrong of them.
#include <cmath>
#include <string>
#include <vector>

#include "marrow/limits.h"
#include "marrow/marrow.h"
#include "unit/cook/gltf/vrm_document.h"
#include "unit/cook/loaded_cook.h"

namespace marrow::cook {
namespace {

LoadedCook cooked(Builder b) {
  return LoadedCook(cook_scene(read(b), {}));
}

std::string text_of(const File& file, const char* node, const char* property) {
  const std::uint32_t n = file.find_node(node);
  const Property* const p = n < file.node_count() ? file.node_property(file.node(n), property) : nullptr;
  return p == nullptr ? "none" : p->type == PropertyType::text ? file.text(p->text) : std::to_string(p->number);
}

class BothVersions : public ::testing::TestWithParam<Builder (*)()> {};
INSTANTIATE_TEST_SUITE_P(Vrm, BothVersions, ::testing::Values(&avatar_1, &avatar_0));

TEST_P(BothVersions, ExpressionsAreAdditiveClipsOfWeights) {
  const LoadedCook c = cooked(GetParam()());
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
  const LoadedCook c = cooked(GetParam()());
  const File& file = c.file;
  EXPECT_EQ(text_of(file, "Hips", "vrm/humanoid"), "hips");
  EXPECT_EQ(text_of(file, "Eye.L", "vrm/humanoid"), "leftEye");
  EXPECT_EQ(text_of(file, "face", "vrm/firstPerson"), "thirdPersonOnly");
  EXPECT_EQ(text_of(file, "Hips", "vrm/expressions/happy/isBinary"), "1.000000");
  EXPECT_EQ(text_of(file, "Head", "vrm/lookAt/type"), "bone");
  EXPECT_EQ(text_of(file, "Head", "vrm/lookAt/offsetFromHeadBone/1"), "0.062500");
  EXPECT_EQ(text_of(file, "Head", "vrm/lookAt/rangeMapHorizontalInner/outputScale"), "10.000000");
  EXPECT_EQ(file.node_count(), 5U) << "two eyes, two bones and the face";
}

TEST(Vrm, LicencesAreKept) {
  const LoadedCook one = cooked(avatar_1()), zero = cooked(avatar_0());
  EXPECT_EQ(text_of(one.file, "Hips", "vrm/specVersion"), "1.0");
  EXPECT_EQ(text_of(one.file, "Hips", "vrm/meta/name"), "Testa");
  EXPECT_EQ(text_of(one.file, "Hips", "vrm/meta/authors/1"), "Eve");
  EXPECT_EQ(text_of(one.file, "Hips", "vrm/meta/licenseUrl"), "https://vrm.dev/licenses/1.0/");
  EXPECT_EQ(text_of(one.file, "Hips", "vrm/meta/thumbnailImage"), "none");
  EXPECT_EQ(text_of(one.file, "Hips", "vrm/expressions/happy/overrideBlink"), "block");
  EXPECT_EQ(text_of(zero.file, "Hips", "vrm/specVersion"), "0.0");
  EXPECT_EQ(text_of(zero.file, "Hips", "vrm/meta/licenseName"), "CC0");
  EXPECT_EQ(text_of(zero.file, "Hips", "vrm/meta/texture"), "none");
  EXPECT_EQ(text_of(zero.file, "Head", "vrm/lookAt/offsetFromHeadBone/2"), "-0.500000");
}

// A turn about the scene's axes, as the eye is not turned at rest. Forward is where the avatar looks.
double excess_deg(const File& file, const char* eye, double yaw_deg, double pitch_deg, double forward) {
  const Skeleton skeleton = file.skeleton(0);
  const JointLimit* const limit = find_limit(skeleton.limits, file.find_joint(skeleton, eye));
  if (limit == nullptr) return -1;
  const double kHalf = 3.14159265358979323846 / 360;
  // Yaw to the avatar's left about +y; pitch down about the avatar's left, which is `forward` times +x.
  const double y = yaw_deg * kHalf, x = pitch_deg * kHalf;
  const double sy = std::sin(y), cy = std::cos(y), sx = std::sin(x) * forward, cx = std::cos(x);
  const float q[4] = {static_cast<float>(cy * sx), static_cast<float>(sy * cx), static_cast<float>(-sy * sx),
                      static_cast<float>(cy * cx)};
  return double{limit_excess(*limit, q)} / kHalf / 2;
}

TEST_P(BothVersions, EyesTurnAsFarAsLookAtSays) {
  const LoadedCook c = cooked(GetParam()());
  const double forward = text_of(c.file, "Hips", "vrm/specVersion") == "1.0" ? 1 : -1;
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

TEST(Vrm, LimitsThatStandThereStay) {
  Builder b = avatar_1();
  b.root["nodes"][kLeftEye]["extras"]["marrow"]["limits"] = {{"speed", 90}};
  const LoadedCook c = cooked(std::move(b));
  const Skeleton skeleton = c.file.skeleton(0);
  const JointLimit* const left = find_limit(skeleton.limits, c.file.find_joint(skeleton, "Eye.L"));
  ASSERT_NE(left, nullptr);
  EXPECT_EQ(left->kind, LimitKind::none);
}

std::string name(const File& file, const SpringChain& chain, std::size_t i) {
  return file.text(file.skeleton(0).names[chain.joints[i].joint]);
}

TEST(Vrm, SpringsOfVersion1AreItsChains) {
  const LoadedCook c = cooked(avatar_1());
  ASSERT_EQ(c.file.spring_count(0), 1U);
  const SpringChain hair = c.file.spring(0, 0);
  ASSERT_EQ(hair.joints.size, 2U);
  EXPECT_EQ(name(c.file, hair, 0), "Hair");
  EXPECT_EQ(name(c.file, hair, 1), "Hair lower");
  EXPECT_EQ(hair.tip[1], -0.0625F);
  EXPECT_EQ(hair.joints[0].radius_m, 0.03125F);
  EXPECT_EQ(hair.joints[0].gravity, 0);
  EXPECT_GT(hair.joints[1].gravity, 0);
  EXPECT_EQ(hair.colliders, 1U);
  ASSERT_EQ(c.file.spring_colliders(0).size, 1U) << "no chain meets the capsule";
  EXPECT_EQ(c.file.spring_colliders(0)[0].from[2], 0.25F);
  EXPECT_EQ(c.file.find_joint(c.file.skeleton(0), "Hair end"), c.file.skeleton(0).joint_count) << "only an end";
}

TEST(Vrm, SpringsOfVersion0AreAllThatHangsBelow) {
  const LoadedCook c = cooked(avatar_0());
  ASSERT_EQ(c.file.spring_count(0), 2U);
  const SpringChain hair = c.file.spring(0, 0), lock = c.file.spring(0, 1);
  ASSERT_EQ(hair.joints.size, 3U);
  EXPECT_EQ(name(c.file, hair, 2), "Hair end");
  EXPECT_NEAR(hair.tip[1], -0.07, 1e-7) << "seven centimetres on";
  ASSERT_EQ(lock.joints.size, 1U);
  EXPECT_EQ(name(c.file, lock, 0), "Lock");
  EXPECT_NEAR(lock.tip[0], 0.07, 1e-7);
  ASSERT_EQ(c.file.spring_colliders(0).size, 1U);
  EXPECT_EQ(c.file.spring_colliders(0)[0].from[2], 0.25F) << "its z goes the other way";
  EXPECT_EQ(lock.colliders, 1U);
}

TEST(Vrm, CollidersOfNodesThatAreNoJointsHangOnTheNearest) {
  Builder b = avatar_1();
  b.root["nodes"][kFace]["translation"] = {0, 0.5, 0};
  b.root["nodes"][kFace]["scale"] = {2, 2, 2};
  b.root["extensions"]["VRMC_springBone"]["colliders"][0]["node"] = kFace;
  const LoadedCook c = cooked(std::move(b));
  ASSERT_EQ(c.file.spring_colliders(0).size, 1U);
  const SpringCollider& ball = c.file.spring_colliders(0)[0];
  EXPECT_STREQ(c.file.text(c.file.skeleton(0).names[ball.joint]), "Head");
  EXPECT_FLOAT_EQ(ball.from[1], 0.75F);
  EXPECT_FLOAT_EQ(ball.from[2], 0.5F);
  EXPECT_FLOAT_EQ(ball.radius_m, 0.25F);
}

TEST(Vrm, SpringsNeedNoAvatar) {
  Builder b = avatar_1();
  b.root["extensions"].erase("VRMC_vrm");
  const LoadedCook c = cooked(std::move(b));
  EXPECT_EQ(c.file.spring_count(0), 1U);
  EXPECT_EQ(c.file.node_count(), 0U);
  EXPECT_EQ(c.file.clip_count(), 0U);
}

TEST(Vrm, ClipPacksHaveNoSprings) {
  Builder b = avatar_1();
  CookOptions options;
  options.clips_only = true;
  const LoadedCook c(cook_scene(read(b), options));
  for (const File::Section& s : c.file.sections()) EXPECT_NE(s.type, format::four_characters("SPRI"));
  EXPECT_EQ(c.file.spring_count(0), 0U);
}

struct Change {
  const char* what;
  void (*change)(Json& extensions);
  const char* where;
  const char* rule;
};

constexpr Change kRefused1[] = {
    {"a list", [](Json& e) { e["VRMC_vrm"] = Json::array(); }, "/extensions/VRMC_vrm", "wrong type"},
    {"springs", [](Json& e) { e["VRMC_springBone"]["springs"] = 3; }, "/extensions/VRMC_springBone/springs",
     "wrong type"},
    {"a node beyond", [](Json& e) { e["VRMC_springBone"]["springs"][0]["joints"][0]["node"] = 10; },
     "/extensions/VRMC_springBone/springs/0/joints/0/node", "reference to nothing"},
    {"no node", [](Json& e) { e["VRMC_springBone"]["springs"][0]["joints"][1].erase("node"); },
     "/extensions/VRMC_springBone/springs/0/joints/1/node", "missing"},
    {"a word", [](Json& e) { e["VRMC_springBone"]["springs"][0]["joints"][0]["stiffness"] = "soft"; },
     "/extensions/VRMC_springBone/springs/0/joints/0/stiffness", "wrong type"},
    {"two numbers",
     [](Json& e) {
       e["VRMC_springBone"]["springs"][0]["joints"][0]["gravityDir"] = {0, 1};
     },
     "/extensions/VRMC_springBone/springs/0/joints/0/gravityDir", "wrong number of items"},
    {"a group beyond", [](Json& e) { e["VRMC_springBone"]["springs"][0]["colliderGroups"] = {2}; },
     "/extensions/VRMC_springBone/springs/0/colliderGroups", "reference to nothing"},
    {"a collider beyond", [](Json& e) { e["VRMC_springBone"]["colliderGroups"][1]["colliders"] = {0.5}; },
     "/extensions/VRMC_springBone/colliderGroups/1/colliders", "reference to nothing"},
    {"a bone beyond",
     [](Json& e) {
       e["VRMC_vrm"]["humanoid"]["humanBones"]["jaw"] = {{"node", 99}};
     },
     "/extensions/VRMC_vrm/humanoid/humanBones/jaw/node", "reference to nothing"},
    {"a bone that is a number", [](Json& e) { e["VRMC_vrm"]["humanoid"]["humanBones"]["jaw"] = 4; },
     "/extensions/VRMC_vrm/humanoid/humanBones/jaw", "wrong type"},
    {"an expression's node",
     [](Json& e) { e["VRMC_vrm"]["expressions"]["preset"]["blink"]["morphTargetBinds"][0]["node"] = -1; },
     "/extensions/VRMC_vrm/expressions/preset/blink/morphTargetBinds/0/node", "reference to nothing"},
    {"an expression's index",
     [](Json& e) { e["VRMC_vrm"]["expressions"]["preset"]["blink"]["morphTargetBinds"][0]["index"] = 0.5; },
     "/extensions/VRMC_vrm/expressions/preset/blink/morphTargetBinds/0/index", "wrong type"},
    {"a range", [](Json& e) { e["VRMC_vrm"]["lookAt"]["rangeMapVerticalUp"]["outputScale"] = false; },
     "/extensions/VRMC_vrm/lookAt/rangeMapVerticalUp/outputScale", "wrong type"},
};

constexpr Change kRefused0[] = {
    {"a text", [](Json& e) { e["VRM"] = "avatar"; }, "/extensions/VRM", "wrong type"},
    {"a bone beyond", [](Json& e) { e["VRM"]["humanoid"]["humanBones"][0]["node"] = 10; },
     "/extensions/VRM/humanoid/humanBones/0/node", "reference to nothing"},
    {"a root beyond", [](Json& e) { e["VRM"]["secondaryAnimation"]["boneGroups"][0]["bones"] = {1e9}; },
     "/extensions/VRM/secondaryAnimation/boneGroups/0/bones", "reference to nothing"},
    {"bones", [](Json& e) { e["VRM"]["secondaryAnimation"]["boneGroups"][0]["bones"] = {"Hair"}; },
     "/extensions/VRM/secondaryAnimation/boneGroups/0/bones/0", "wrong type"},
    {"a collider's node", [](Json& e) { e["VRM"]["secondaryAnimation"]["colliderGroups"][0]["node"] = 77; },
     "/extensions/VRM/secondaryAnimation/colliderGroups/0/node", "reference to nothing"},
    {"a direction",
     [](Json& e) {
       e["VRM"]["secondaryAnimation"]["boneGroups"][0]["gravityDir"] = {0, -1, 0};
     },
     "/extensions/VRM/secondaryAnimation/boneGroups/0/gravityDir", "wrong type"},
    {"binds", [](Json& e) { e["VRM"]["blendShapeMaster"]["blendShapeGroups"][0]["binds"] = 1; },
     "/extensions/VRM/blendShapeMaster/blendShapeGroups/0/binds", "wrong type"},
};

void expect_all_refused(Builder (*document)(), std::span<const Change> changes) {
  for (const Change& c : changes) {
    SCOPED_TRACE(c.what);
    Builder b = document();
    c.change(b.root["extensions"]);
    const std::string text = b.text();
    expect_refused(text, Exit::invalid, c.where, c.rule);
  }
}

TEST(Vrm, WhatIsWrongIsRefusedWhereItStands) {
  expect_all_refused(&avatar_1, kRefused1);
  expect_all_refused(&avatar_0, kRefused0);
}

// Left out with a warning; all else is there.
constexpr Change kLeftOut1[] = {
    {"a chain in a circle",
     [](Json& e) {
       e["VRMC_springBone"]["springs"][0]["joints"] = {{{"node", kHair}}, {{"node", kHairLower}}, {{"node", kHair}}};
     },
     "/extensions/VRMC_springBone/springs/0/joints/2", "spring-goes-up"},
    {"a chain that goes up",
     [](Json& e) {
       e["VRMC_springBone"]["springs"][0]["joints"] = {{{"node", kHairLower}}, {{"node", kHair}}};
     },
     "/extensions/VRMC_springBone/springs/0/joints/1", "spring-goes-up"},
    {"a joint twice", [](Json& e) { e["VRMC_springBone"]["springs"].push_back(e["VRMC_springBone"]["springs"][0]); },
     "/extensions/VRMC_springBone/springs/1/joints/0", "spring-shares-joint"},
    {"one joint",
     [](Json& e) {
       e["VRMC_springBone"]["springs"][0]["joints"] = {{{"node", kHair}}};
     },
     "/extensions/VRMC_springBone/springs/0", "spring-without-bone"},
    {"no shape", [](Json& e) { e["VRMC_springBone"]["colliders"][0].erase("shape"); },
     "/extensions/VRMC_springBone/colliders/0", "collider-dropped"},
    {"a huge radius", [](Json& e) { e["VRMC_springBone"]["colliders"][0]["shape"]["sphere"]["radius"] = 1e30; },
     "/extensions/VRMC_springBone/colliders/0", "collider-dropped"},
    {"a center", [](Json& e) { e["VRMC_springBone"]["springs"][0]["center"] = kHips; },
     "/extensions/VRMC_springBone/springs/0/center", "spring-center-dropped"},
    {"gravity from aside",
     [](Json& e) {
       Json& joint = e["VRMC_springBone"]["springs"][0]["joints"][0];
       joint["gravityDir"] = {1, 0, 0}, joint["gravityPower"] = 1;
     },
     "/extensions/VRMC_springBone/springs/0/joints/0", "spring-gravity-sideways"},
    {"a target beyond",
     [](Json& e) { e["VRMC_vrm"]["expressions"]["preset"]["happy"]["morphTargetBinds"][0]["index"] = 3; },
     "/extensions/VRMC_vrm/expressions/preset/happy", "expression-bind-dropped"},
    {"a node without a mesh",
     [](Json& e) { e["VRMC_vrm"]["expressions"]["preset"]["happy"]["morphTargetBinds"][0]["node"] = kHead; },
     "/extensions/VRMC_vrm/expressions/preset/happy", "expression-bind-dropped"},
    {"a huge weight",
     [](Json& e) { e["VRMC_vrm"]["expressions"]["preset"]["happy"]["morphTargetBinds"][0]["weight"] = 1e30; },
     "/extensions/VRMC_vrm/expressions/preset/happy", "expression-bind-dropped"},
    {"an annotation of a bone", [](Json& e) { e["VRMC_vrm"]["firstPerson"]["meshAnnotations"][0]["node"] = kHead; },
     "/extensions/VRMC_vrm/firstPerson/meshAnnotations/0", "annotation-dropped"},
    {"nothing", [](Json&) {}, "/extensions/VRMC_vrm/expressions", "material-binds-dropped"},
};

constexpr Change kLeftOut0[] = {
    {"a root twice",
     [](Json& e) {
       e["VRM"]["secondaryAnimation"]["boneGroups"][0]["bones"] = {kHair, kHair};
     },
     "/extensions/VRM/secondaryAnimation/boneGroups/0", "spring-shares-joint"},
    {"a root below another",
     [](Json& e) {
       e["VRM"]["secondaryAnimation"]["boneGroups"][0]["bones"] = {kHairLower, kHair};
     },
     "/extensions/VRM/secondaryAnimation/boneGroups/0", "spring-shares-joint"},
    {"a mesh that is not there",
     [](Json& e) { e["VRM"]["blendShapeMaster"]["blendShapeGroups"][0]["binds"][0]["mesh"] = 7; },
     "/extensions/VRM/blendShapeMaster/blendShapeGroups/0", "expression-bind-dropped"},
    {"nothing", [](Json&) {}, "/extensions/VRM/blendShapeMaster", "material-binds-dropped"},
};

void expect_all_left_out(Builder (*document)(), std::span<const Change> changes) {
  for (const Change& c : changes) {
    SCOPED_TRACE(c.what);
    Builder b = document();
    c.change(b.root["extensions"]);
    const RawScene scene = read(b);
    EXPECT_TRUE(warns(scene, c.rule, c.where));
    EXPECT_EQ(LoadedCook(cook_scene(scene, {})).file.skeleton_count(), 1U);
  }
}

TEST(Vrm, WhatAGameCanDoWithoutIsLeftOut) {
  expect_all_left_out(&avatar_1, kLeftOut1);
  expect_all_left_out(&avatar_0, kLeftOut0);
}

TEST(Vrm, SettingsBeyondTheRangesAreHeldWithin) {
  for (const double huge : {1e300, 1e30, -1e30, 1e-30}) {
    Builder b = avatar_1();
    for (Json& joint : b.root["extensions"]["VRMC_springBone"]["springs"][0]["joints"])
      for (const char* setting : {"stiffness", "gravityPower", "dragForce", "hitRadius"})
        joint[setting] = std::clamp(huge, -3e38, 3e38);
    EXPECT_EQ(cooked(std::move(b)).file.spring_count(0), 1U) << huge;
  }
}

TEST(Vrm, NoMoreCollidersThanAFrameHas) {
  Builder b = avatar_1();
  Json& bones = b.root["extensions"]["VRMC_springBone"];
  bones["colliders"] = Json::array_t(100, bones["colliders"][0]);
  bones["colliderGroups"][0]["colliders"] = Json::array();
  for (int c = 0; c < 100; ++c) bones["colliderGroups"][0]["colliders"].push_back(c);
  const RawScene scene = read(b);
  EXPECT_TRUE(warns(scene, "too-many-colliders"));
  const LoadedCook c(cook_scene(scene, {}));
  EXPECT_EQ(c.file.spring_colliders(0).size, kMaxSpringColliders);
  EXPECT_EQ(c.file.spring(0, 0).colliders, ~std::uint64_t{0});
}

TEST(Vrm, ConstraintsAreSaidToBeLeftOut) {
  Builder b = avatar_1();
  b.root["extensionsUsed"].push_back("VRMC_node_constraint");
  EXPECT_TRUE(warns(read(b), "constraints-dropped"));
}

}  // namespace
}  // namespace marrow::cook
