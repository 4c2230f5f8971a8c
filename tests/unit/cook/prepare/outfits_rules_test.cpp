// Hair and clothes for a body: what is matched with what, what is left out, and what is refused.
#include <memory>

#include "cook/prepare/match_skeletons.h"
#include "cook/skeleton/build_skeletons.h"
#include "disk/cook_on_disk.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

using Names = std::vector<std::string>;

// Hips, spine, head and arm of a character called Ada, and as many of Bob.
Character ada_and_bob(bool bob = false) {
  SceneDocument d;
  d.character("Ada", 3);
  if (bob) {
    const std::vector<int> b = d.character("Bob", 0);
    for (const int n : b) {
      Json& name = d.b.root["nodes"][static_cast<std::size_t>(n)]["name"];
      name = "bob " + name.get<std::string>();
    }
  }
  return {"ada.mrw", build_skeletons(d.read()).skeletons};
}

// A hat: head on a root of its own, and a feather with a tip.
struct Hat {
  Hat() {
    rig = d.node("hat rig", -1, {0, 0, 5});
    root = d.node("root", rig);
    spine = d.node("spine", root, {0, 0.5F, 0});
    head = d.node("head", spine, {0, 0.25F, 0});
    feather = d.node("feather", head, {0, 0.125F, 0});
    tip = d.node("tip", feather, {0, 0.125F, 0});
  }
  BuiltScene build(const Character& body = ada_and_bob()) {
    CookOptions options;
    options.onto = std::make_shared<const Character>(body);
    options.mesh.codec = MeshCodec::none;
    RawScene scene = d.read();
    notes = {scene.warnings, {}};
    return build_scene(std::move(scene), options, notes);
  }
  void expect_refused(int node, const std::string& rule, const Character& body = ada_and_bob()) {
    expect_failure([&] { build(body); }, Exit::invalid, "/nodes/" + std::to_string(node), rule);
  }
  std::vector<std::string> joints_of_mesh(const BuiltScene& built, std::size_t mesh) const {
    Names out;
    for (const std::uint16_t j : built.meshes.at(mesh).joints)
      out.push_back(built.skeletons.at(built.meshes[mesh].skeleton).joint_names.at(j));
    return out;
  }
  SceneDocument d;
  Notes notes;
  int rig, root, spine, head, feather, tip;
};

TEST(OutfitRules, OwnJointsStandBehindTheBodysOfTheirParent) {
  Hat hat;
  hat.d.skin("hat", {hat.head, hat.tip});
  const BuiltScene built = hat.build();
  ASSERT_EQ(built.skeletons.size(), 1u);
  EXPECT_EQ(built.skeletons[0].name, "Ada");
  EXPECT_EQ(built.skeletons[0].joint_names, (Names{"hips", "spine", "head", "arm", "feather", "tip"}));
  EXPECT_EQ(built.skeletons[0].parents, (std::vector<std::uint16_t>{kNoJoint, 0, 1, 1, 2, 4}));
  EXPECT_EQ(hat.joints_of_mesh(built, 0), (Names{"head", "tip"}));
  EXPECT_TRUE(hat.notes.warnings.empty()) << hat.notes.warnings.front().text;
  Hat knee;  // between the body's joints of a generation
  const int buckle = knee.d.node("buckle", knee.spine);
  knee.d.skin("belt", {knee.spine, buckle, knee.tip});
  EXPECT_EQ(knee.build().skeletons[0].joint_names, (Names{"hips", "spine", "head", "arm", "buckle", "feather", "tip"}));
}

TEST(OutfitRules, WhatNothingFollowsMayHangAnywhere) {
  Hat hat;
  hat.d.skin("hat", {hat.head, hat.tip, hat.root});
  Json& joints = hat.d.b.root["skins"][0]["joints"];
  joints = {hat.root, hat.head, hat.tip};
  // Vertices follow the first, the second and the last of the skin; here the second and the last.
  Json& attributes = hat.d.b.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      hat.d.b.numbers<std::uint8_t>(kU8, "VEC4", 4, {1, 0, 0, 0, 1, 2, 0, 0, 1, 2, 0, 0, 2, 0, 0, 0});
  const BuiltScene built = hat.build();
  EXPECT_EQ(hat.joints_of_mesh(built, 0), (Names{"head", "tip"}));
  Hat follows;
  follows.d.skin("hat", {follows.root, follows.head, follows.tip});
  follows.expect_refused(follows.root, "no such joint in ada.mrw");
}

TEST(OutfitRules, MeshesMayHangOnNodesThatAreCalledLikeJoints) {
  Hat hat;
  const int offset = hat.d.node("offset", hat.head, {0, 1, 0});
  const int pin = hat.d.node("pin", offset, {0.5F, 0, 0});
  hat.d.prop(pin);
  const BuiltScene built = hat.build();
  EXPECT_EQ(built.skeletons[0].joint_names, (Names{"hips", "spine", "head", "arm"})) << "none of its own";
  EXPECT_EQ(hat.joints_of_mesh(built, 0), (Names{"head"}));
  EXPECT_EQ(built.meshes[0].inverse_bind[0].rows[0][3], 0.5F);
  EXPECT_EQ(built.meshes[0].inverse_bind[0].rows[1][3], 1);
  Hat lost;
  lost.d.prop(lost.d.node("heads"));
  lost.expect_refused(6, "no such joint in ada.mrw");
  try {
    lost.build();
  } catch (const Failure& failure) {
    EXPECT_NE(failure.advice().find("did you mean \"head\"?"), std::string::npos) << failure.what();
  }
}

TEST(OutfitRules, JointsHangAsInTheBody) {
  Hat hat;
  hat.d.skin("hat", {hat.head, hat.tip});
  hat.expect_refused(hat.d.node("hips", hat.tip), "another parent");
  SceneDocument d;  // without the spine
  const int hips = d.node("hips"), head = d.node("head", hips, {0, 0.75F, 0});
  d.skin("hat", {head, hips});
  Hat sparse;
  sparse.d = d;
  EXPECT_EQ(sparse.build().skeletons[0].joint_names, (Names{"hips", "spine", "head", "arm"}));
}

TEST(OutfitRules, NamesAreUnique) {
  Hat hat;
  hat.d.skin("hat", {hat.head, hat.tip});
  hat.d.node("head", hat.tip);  // no joint: what skins name goes first
  EXPECT_EQ(hat.build().skeletons[0].joint_names.size(), 6u);
  const int second = hat.d.node("head", hat.tip);
  hat.d.skin("more", {second});
  hat.expect_refused(second, "not unique");
  Character twice = ada_and_bob();
  twice.skeletons[0].joint_names[3] = "head";
  Hat other;
  other.d.skin("hat", {other.head});
  other.expect_refused(other.head, "not unique", twice);
}

TEST(OutfitRules, FollowTheSkeletonsThatTheyNeed) {
  Hat hat;
  const int bob = hat.d.node("bob head");
  hat.d.prop(bob);
  const Character both = ada_and_bob(true);
  const BuiltScene one = hat.build(both);
  ASSERT_EQ(one.skeletons.size(), 1u);
  EXPECT_EQ(one.skeletons[0].name, "Bob");
  hat.d.skin("hat", {hat.head, hat.tip});
  EXPECT_EQ(hat.build(both).skeletons.size(), 2u);
  hat.d.skin("across", {hat.head, bob});
  hat.expect_refused(bob, "a skin across two skeletons", both);
}

TEST(OutfitRules, ClipsMoveOwnJointsAlone) {
  Hat hat;
  hat.d.skin("hat", {hat.head, hat.tip});
  hat.d.clip("nod");
  hat.d.turn(hat.head, {0, 1});
  hat.d.turn(hat.feather, {0, 1});
  hat.d.clip("sit");
  hat.d.turn(hat.spine, {0, 1});
  hat.d.carry(hat.root, {0, 1});
  const BuiltScene built = hat.build();
  ASSERT_EQ(built.clips.size(), 1u);
  EXPECT_EQ(built.clips[0].name, "nod");
  EXPECT_TRUE(warns(hat.notes, "clips-of-body", "/animations"));
  Hat spinning;  // a joint because a clip moves it
  const int wheel = spinning.d.node("wheel", spinning.head);
  spinning.d.prop(wheel);
  spinning.d.clip("spin");
  spinning.d.turn(wheel, {0, 1});
  const BuiltScene spins = spinning.build();
  EXPECT_EQ(spins.skeletons[0].joint_names.back(), "wheel");
  EXPECT_EQ(spins.clips.size(), 1u);
}

// All inverse binds of a scene document are the identity, so it is what both sides have above them that is compared.
TEST(OutfitRules, AnotherBindPoseIsAWarning) {
  Hat hat;
  hat.d.skin("hat", {hat.head, hat.spine});
  hat.build();
  EXPECT_FALSE(warns(hat.notes, "bind-pose-differs")) << "rests like the body";
  hat.d.b.root["nodes"][static_cast<std::size_t>(hat.head)]["translation"] = {0, 0.3125F, 0};
  hat.build();
  ASSERT_TRUE(warns(hat.notes, "bind-pose-differs", "/skins/0"));
  // Most follow the spine. Bound as if head and spine stood in one place, which are 0.25 m apart in the body.
  const std::string& text = hat.notes.warnings.back().text;
  EXPECT_NE(text.find("at \"head\" vertices are up to 0.25 m"), std::string::npos) << text;
  // Where it was bound with the body's rest pose, that of its own file does not count.
  std::vector<float> binds(32, 0.0F);
  for (const std::size_t i : {0U, 5U, 10U, 15U, 16U, 21U, 26U, 31U}) binds[i] = 1;
  binds[13] = -0.25F;  // the head above the spine
  hat.d.b.root["skins"][0]["inverseBindMatrices"] = hat.d.b.numbers<float>(kF32, "MAT4", 16, binds);
  hat.build();
  EXPECT_FALSE(warns(hat.notes, "bind-pose-differs"));
}

TEST(OutfitRules, WithoutMeshesIsAClipPack) {
  Hat hat;
  hat.d.clip("nod");
  hat.d.turn(hat.head, {0, 1});
  EXPECT_TRUE(hat.build().is_pack);
  Hat onto_pack;
  onto_pack.d.skin("hat", {onto_pack.head});
  expect_failure([&] { onto_pack.build(Character{"walk.mrw"}); }, Exit::invalid, "", "no skeleton");
}

}  // namespace
}  // namespace marrow::cook
