// Which nodes become which skeletons, and how a clip of several becomes one each.
#include <algorithm>

#include "disk/cook_on_disk.h"
#include "pose/choose.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

using Names = std::vector<std::string>;

BuiltScene build(SceneDocument& document, const CookOptions& options = {}) {
  Notes notes;
  return build_scene(document.read(), options, notes);
}

Names skeleton_names(const BuiltScene& built) {
  Names out;
  for (const BuiltSkeleton& skeleton : built.skeletons) out.push_back(skeleton.name);
  return out;
}

// "clip/skeleton" of each clip.
Names clip_names(const BuiltScene& built) {
  Names out;
  for (const BuiltClip& clip : built.clips) out.push_back(clip.name + "/" + std::to_string(clip.skeleton));
  return out;
}

TEST(Skeletons, ACharacterEach) {
  SceneDocument d;
  const std::vector<int> a = d.character("Ada", -1), b = d.character("Bob", 1);
  d.clip("greet");
  d.turn(a[3], {0, 0.5F, 1});
  d.turn(b[3], {0, 0.25F});
  d.clip("nod");
  d.turn(b[2], {0, 1});
  const BuiltScene built = build(d);
  EXPECT_EQ(skeleton_names(built), (Names{"Ada", "Bob"}));
  for (const BuiltSkeleton& skeleton : built.skeletons) {
    EXPECT_EQ(skeleton.joint_names, (Names{"hips", "spine", "head", "arm"}));
    EXPECT_EQ(skeleton.model_from_root.size(), 1u);
  }
  EXPECT_EQ(built.skeletons[0].model_from_root[0].rows[0][3], -1.0f);
  EXPECT_EQ(built.skeletons[1].model_from_root[0].rows[0][3], 1.0f);
  EXPECT_EQ(clip_names(built), (Names{"greet/0", "greet/1", "nod/1"}));
  EXPECT_EQ(built.clips[0].duration_s, 1.0f);
  EXPECT_EQ(built.clips[1].duration_s, 1.0f) << "they stay in step";
  ASSERT_EQ(built.meshes.size(), 2u);
  EXPECT_EQ(built.meshes[0].skeleton, 0u);
  EXPECT_EQ(built.meshes[1].skeleton, 1u);
  EXPECT_EQ(built.meshes[0].geometry, built.meshes[1].geometry) << "geometry is shared as ever";
}

// A clip of several skeletons is one a skeleton; they play together by their name, if they have one.
TEST(Skeletons, PartsOfAClipPlayTogetherByNameAndByNumber) {
  SceneDocument d;
  const std::vector<int> a = d.character("Ada", -1), b = d.character("Bob", 1);
  for (const char* name : {"greet", "nod", ""}) {
    d.clip(name);
    d.turn(a[3], {0, 0.5F, 1});
    d.turn(b[3], {0, 0.25F});
  }
  const LoadedCook cooked(cook_scene(d.read(), {}));
  const File& file = cooked.file;
  ASSERT_EQ(file.clip_count(), 6u);
  const auto played = [&](const std::string& clip) {
    const tools::Play play = tools::choose("two.mrw", file, {clip, "", 0}).play;
    return std::vector<std::uint32_t>(play.clip_of_skeleton.begin(), play.clip_of_skeleton.end());
  };
  for (const char* of_greet : {"greet", "0", "1"}) EXPECT_EQ(played(of_greet), (std::vector<std::uint32_t>{0, 1}));
  for (const char* of_nod : {"nod", "2", "3"}) EXPECT_EQ(played(of_nod), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(played("4"), (std::vector<std::uint32_t>{4, kNoClip}));
  EXPECT_EQ(played("5"), (std::vector<std::uint32_t>{kNoClip, 5}));
}

TEST(Skeletons, OneSkinTiesTrees) {
  SceneDocument d;
  const int left = d.node("left"), right = d.node("right"), alone = d.node("alone");
  d.skin("wings", {left, right});
  d.skin("tail", {alone});
  const BuiltScene built = build(d);
  EXPECT_EQ(skeleton_names(built), (Names{"wings", "tail"}));
  EXPECT_EQ(built.skeletons[0].joint_names, (Names{"left", "right"}));
}

TEST(Skeletons, TargetsAndWeaponsGoWithTheirCharacter) {
  SceneDocument d;
  const std::vector<int> a = d.character("Ada", -1), b = d.character("Bob", 1);
  const int armature_of_bob = 6;
  ASSERT_EQ(d.b.root["nodes"][6]["name"], "Bob armature");
  const int sword = d.node("sword");
  d.prop(sword);
  const int target = d.node("target", armature_of_bob);
  const int ball = d.node("ball");
  d.prop(ball);
  d.clip("strike");
  d.turn(a[3], {0, 1});
  d.carry(sword, {0, 1});
  d.clip("fight");  // both, yet the target stands below Bob's armature
  d.turn(a[3], {0, 1});
  d.turn(b[3], {0, 1});
  d.carry(target, {0, 1});
  d.carry(ball, {0, 1});  // is neither's
  CookOptions options;
  options.prepare.keep = {"target"};
  const BuiltScene built = build(d, options);
  EXPECT_EQ(skeleton_names(built), (Names{"Ada", "Bob", "ball"}));
  EXPECT_EQ(built.skeletons[0].joint_names, (Names{"hips", "sword", "spine", "head", "arm"}));
  EXPECT_EQ(built.skeletons[1].joint_names, (Names{"hips", "target", "spine", "head", "arm"}));
  EXPECT_EQ(clip_names(built), (Names{"strike/0", "fight/0", "fight/1", "fight/2"}));
}

// Cameras, empties and what hangs on nothing else are no joints, unless they are kept or carry something.
TEST(Skeletons, WhatCarriesNothingIsNoJoint) {
  SceneDocument d;
  const std::vector<int> a = d.character("Ada", 0);
  const int rig = d.node("rig"), camera = d.node("camera", rig, {60, 0, 0}), socket = d.node("socket", a[3]);
  const int cart = d.node("cart"), box = d.node("box", cart);
  d.prop(box);
  d.clip("fly");
  for (const int node : {a[3], rig, camera, socket, cart}) d.carry(node, {0, 1});
  Notes notes;
  const BuiltScene built = build_scene(d.read(), {}, notes);
  EXPECT_EQ(built.skeletons.at(0).joint_names, (Names{"hips", "cart", "spine", "head", "arm"}));
  EXPECT_EQ(built.skeletons.size(), 1u);
  EXPECT_TRUE(warns(notes, "motion-of-nothing", "/nodes/" + std::to_string(rig)));
  CookOptions options;
  options.prepare.keep = {"cam*", "socket"};
  Notes none;
  EXPECT_EQ(build_scene(d.read(), options, none).skeletons.at(0).joint_names,
            (Names{"hips", "rig", "cart", "spine", "camera", "head", "arm", "socket"}));
  EXPECT_FALSE(warns(none, "motion-of-nothing"));
}

TEST(Skeletons, WhatOneClipMovesBelowOneRootIsAMachine) {
  SceneDocument d;
  const int engine = d.node("engine"), crane = d.node("crane");
  const int piston = d.node("piston", engine), wheel = d.node("wheel", engine), hook = d.node("hook", crane);
  for (const int part : {piston, wheel, hook}) d.prop(part);
  d.clip("run");
  for (const int part : {piston, wheel, hook}) d.carry(part, {0, 1});
  const BuiltScene built = build(d);
  EXPECT_EQ(skeleton_names(built), (Names{"piston", "hook"}));
  EXPECT_EQ(built.skeletons[0].joint_names, (Names{"piston", "wheel"}));
  EXPECT_EQ(clip_names(built), (Names{"run/0", "run/1"}));
}

TEST(Skeletons, SceneryIsOneAtTheEnd) {
  SceneDocument d;
  for (int i = 0; i < 300; ++i) d.prop(d.node("stone " + std::to_string(i), -1, {static_cast<float>(i), 0, 0}));
  const std::vector<int> a = d.character("Ada", 0);
  d.clip("nod");
  d.turn(a[2], {0, 1});
  const BuiltScene built = build(d);
  ASSERT_EQ(built.skeletons.size(), 2u);
  EXPECT_EQ(built.skeletons[0].name, "Ada");
  EXPECT_EQ(built.skeletons[1].joint_names.size(), 300u);
  EXPECT_EQ(built.skeletons[1].parents, std::vector<std::uint16_t>(300, kNoJoint));
  ASSERT_EQ(built.meshes.size(), 301u);
  EXPECT_EQ(built.meshes[7].skeleton, 1u);
  EXPECT_EQ(built.meshes[7].joints, std::vector<std::uint16_t>{7});
}

TEST(Skeletons, MorphWeightsGoWithTheirMeshAndOtherNumbersWithTheFirst) {
  SceneDocument d;
  const std::vector<int> a = d.character("Ada", 0), b = d.character("Bob", 0);
  RawScene scene = d.read();
  const auto scalar = [](const char* name, int node) {
    RawScalar s;
    s.name = name;
    s.node = node;
    s.times_s = {0, 2};
    s.values = {0, 1};
    return s;
  };
  RawClip clip;
  clip.name = "speak";
  const auto body = std::ranges::find(scene.nodes, "Bob body", &RawNode::name) - scene.nodes.begin();
  clip.scalars = {scalar("mood", kNone), scalar("smile", static_cast<int>(body))};
  scene.clips = {clip};
  clip.name = "walk";
  clip.channels.push_back({a[2], RawPath::translation, RawInterpolation::linear, {0, 1}, {{}, {1, 0, 0, 0}}});
  scene.clips.push_back(clip);
  Notes notes;
  const BuiltScene built = build_scene(scene, {}, notes);
  EXPECT_EQ(clip_names(built), (Names{"speak/1", "walk/0", "walk/1"}));
  EXPECT_EQ(built.clips[0].channel_names, (Names{"mood", "smile"}));
  EXPECT_EQ(built.clips[1].channel_names, (Names{"mood"}));
  EXPECT_EQ(built.clips[2].channel_names, (Names{"smile"}));
  EXPECT_TRUE(built.clips[2].tracks.empty());
  EXPECT_EQ(built.clips[1].duration_s, 2.0f);
}

TEST(Skeletons, AdditiveClipsTakeTheReferenceOfTheirOwnSkeleton) {
  SceneDocument d;
  const std::vector<int> a = d.character("Ada", 0), b = d.character("Bob", 0);
  d.clip("aim");
  d.carry(a[3], {0, 1});
  d.carry(b[3], {0, 1});
  d.clip("stand");
  d.carry(a[2], {0, 1});
  CookOptions options;
  options.clips.additive = {{"aim", "stand"}};
  const BuiltScene built = build(d, options);
  EXPECT_EQ(clip_names(built), (Names{"aim/0", "aim/1", "stand/0"}));
  ASSERT_EQ(built.clips[0].reference.size(), 1u);
  EXPECT_EQ(built.clips[0].reference[0].translation[1][2], 0.0f) << "the head as \"stand\" begins";
  EXPECT_TRUE(built.clips[1].reference.empty()) << "\"stand\" leaves Bob at rest";
  options.clips.additive = {{"aim", "no such clip"}};
  EXPECT_THROW(build(d, options), Failure);
}

TEST(Skeletons, AreCookedWithoutMeshes) {
  SceneDocument d;
  const int hips = d.node("hips"), head = d.node("head", hips), other = d.node("other");
  d.clip("nod");
  d.turn(head, {0, 1});
  Notes notes;
  const BuiltScene built = build_scene(d.read(), {}, notes);
  EXPECT_EQ(skeleton_names(built), Names{"head"}) << "nothing moves above it";
  EXPECT_TRUE(warns(notes, "no-meshes"));
  EXPECT_EQ(clip_names(built), Names{"nod/0"});
  d.b.root.erase("animations");
  d.b.root["skins"] = {{{"joints", {hips, head}}}};
  EXPECT_EQ(build(d).skeletons.at(0).joint_names, (Names{"hips", "head"}));
  d.b.root.erase("skins");
  expect_failure([&] { build(d); }, Exit::invalid, "/meshes", "no-meshes");
  EXPECT_EQ(other, 2);
}

}  // namespace
}  // namespace marrow::cook
