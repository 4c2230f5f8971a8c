// Clip packs from glTF: for the file's own skeletons, and for a character's by the names of its joints.
#include <memory>

#include "cook/prepare/match_skeletons.h"
#include "cook/skeleton/build_skeletons.h"
#include "cook/write/write_scene.h"
#include "disk/cook_on_disk.h"
#include "support/places.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

using Names = std::vector<std::string>;

// Hips, spine, head and arm of a character called Ada.
Character ada() {
  SceneDocument d;
  d.character("Ada", 3);
  return {"ada.mrw", build_skeletons(d.read()).skeletons};
}

CookOptions pack_options(Character character) {
  CookOptions options;
  options.clips_only = true;
  options.onto = std::make_shared<const Character>(std::move(character));
  return options;
}

// Ada's joints exported apart: another root, another order, no head, and something in her hand.
struct Apart {
  Apart() {
    ground = d.node("ground");
    root = d.node("export root", ground, {0, 0, 5});
    hips = d.node("hips", root, {0, 1, 0});
    spine = d.node("spine", hips, {0, 0.5F, 0});
    arm = d.node("arm", spine, {0.25F, 0.125F, 0});
    cup = d.node("cup", arm);
  }
  BuiltScene build(const CookOptions& options = pack_options(ada())) {
    RawScene scene = d.read();
    notes = {scene.warnings, {}};
    return build_scene(std::move(scene), options, notes);
  }
  SceneDocument d;
  Notes notes;
  int ground, root, hips, spine, arm, cup;
};

// An arm's length from the shoulder a shell of 3 cm says little.
TEST(Packs, KeepTheirPromiseAtTheCharactersVertices) {
  const std::string path = test::in_golden("dance.gltf");
  CookOptions options;
  options.clips_only = true;
  const auto vertex_error = [&] {
    return cook_file(path, options).report["clips"][0]["max_vertex_error_m"].get<double>();
  };
  EXPECT_EQ(vertex_error(), 0) << "no mesh is known";
  options.onto = std::make_shared<const Character>(read_character(path));
  EXPECT_EQ(options.onto->meshes.size(), 1u);
  const double at_vertices = vertex_error();
  EXPECT_GT(at_vertices, 0);
  EXPECT_LE(at_vertices, 1e-4);
  options.clips.shell = 1e-4;  // at the joints alone
  EXPECT_GT(vertex_error(), 1e-4) << "measured, if not kept";
}

TEST(Packs, HoldTheSkeletonsThatClipsMove) {
  SceneDocument d;
  d.character("Ada", 0);
  const std::vector<int> b = d.character("Bob", 0);
  d.prop(d.node("stone"));
  d.clip("nod");
  d.turn(b[2], {0, 1});
  Notes notes;
  CookOptions options;
  options.clips_only = true;
  const BuiltScene built = build_scene(d.read(), options, notes);
  EXPECT_TRUE(built.is_pack);
  EXPECT_TRUE(built.meshes.empty());
  ASSERT_EQ(built.skeletons.size(), 1u);
  EXPECT_EQ(built.skeletons[0].name, "Bob");
  EXPECT_EQ(built.clips.at(0).skeleton, 0u);
  d.b.root.erase("animations");
  expect_failure([&] { build_scene(d.read(), options, notes); }, Exit::invalid, "/animations", "no-clips");
}

TEST(Packs, NodesAreMatchedByName) {
  Apart a;
  a.d.clip("wave");
  a.d.turn(a.arm, {0, 0.5F, 1});
  const BuiltScene built = a.build();
  ASSERT_EQ(built.skeletons.size(), 1u);
  EXPECT_EQ(built.skeletons[0].name, "Ada");
  EXPECT_EQ(built.skeletons[0].joint_names, (Names{"hips", "spine", "head", "arm"}));
  const std::vector<SoaTransform> rest = ada().skeletons[0].rest;
  EXPECT_EQ(std::memcmp(built.skeletons[0].rest.data(), rest.data(), sizeof(SoaTransform)), 0) << "the character's";
  ASSERT_EQ(built.clips.size(), 1u);
  EXPECT_TRUE(a.notes.warnings.empty());
  CookOptions raw = pack_options(ada());
  raw.clips.raw = true;
  const BuiltScene kept = a.build(raw);
  ASSERT_EQ(kept.clips.at(0).tracks.size(), 1u);
  EXPECT_EQ(kept.clips[0].tracks[0].joint, 3u) << "the arm's place in Ada";
}

TEST(Packs, NodesThatAreNoJointsMustNotMove) {
  Apart a;
  a.d.clip("wave");
  a.d.turn(a.arm, {0, 1});
  a.d.carry(a.cup, {0, 1});
  a.d.carry(a.root, {0, 1});
  expect_failure([&] { a.build(); }, Exit::invalid, "/nodes/1", "no such joint in ada.mrw");
  try {
    a.build();
  } catch (const Failure& failure) {
    EXPECT_NE(failure.advice().find("\"export root\", \"cup\""), std::string::npos) << failure.what();
  }
  Apart still;
  still.d.clip("wave");
  still.d.turn(still.arm, {0, 1});
  still.d.turn(still.cup, {0.5F});
  EXPECT_EQ(still.build().clips.size(), 1u);
  EXPECT_TRUE(warns(still.notes, "no-such-joint", "/nodes/5"));
}

TEST(Packs, NodesThatMoveAreToldWhatJointsAreCalled) {
  Apart a;
  a.d.clip("wave");
  a.d.b.root["nodes"][static_cast<std::size_t>(a.arm)]["name"] = "Arm.";
  a.d.turn(a.arm, {0, 1});
  a.d.carry(a.cup, {0, 1});
  try {
    a.build();
    ADD_FAILURE() << "not refused";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.advice(),
              "clips move \"Arm.\" (did you mean \"arm\"?), \"cup\"; name them as the character's joints before you "
              "export, which are \"hips\", \"spine\", \"head\", \"arm\"");
  }
}

TEST(Packs, CamerasMayMoveBesideThem) {
  Apart a;
  const int camera = a.d.node("camera");
  a.d.b.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  a.d.b.root["nodes"][static_cast<std::size_t>(camera)]["camera"] = 0;
  a.d.clip("wave");
  a.d.turn(a.arm, {0, 1});
  a.d.carry(camera, {0, 1});
  EXPECT_EQ(a.build().clips.size(), 1u);
  EXPECT_TRUE(warns(a.notes, "no-such-joint", "/nodes/" + std::to_string(camera)));
}

TEST(Packs, ParentsMustBeTheSame) {
  Apart a;
  const int arm = a.d.node("head", a.hips);
  a.d.clip("wave");
  a.d.turn(arm, {0, 1});
  expect_failure([&] { a.build(); }, Exit::invalid, "/nodes/6", "another parent");
}

TEST(Packs, NamesMustBeUnique) {
  Apart a;
  const int second = a.d.node("arm", a.spine);
  a.d.clip("wave");
  a.d.turn(second, {0, 1});
  expect_failure([&] { a.build(); }, Exit::invalid, "/nodes/6", "not unique");
  Apart b;
  b.d.clip("wave");
  b.d.turn(b.arm, {0, 1});
  Character twice = ada();
  twice.skeletons[0].joint_names[2] = "arm";
  expect_failure([&] { b.build(pack_options(twice)); }, Exit::invalid, "/nodes/4", "not unique");
}

TEST(Packs, WhatStandsOtherwiseIsHeldThere) {
  Apart a;
  a.d.b.root["nodes"][static_cast<std::size_t>(a.spine)]["translation"] = {0, 0.75, 0};
  a.d.clip("wave");
  a.d.turn(a.arm, {0, 1});
  CookOptions options = pack_options(ada());
  options.clips.raw = true;
  const BuiltScene built = a.build(options);
  EXPECT_TRUE(warns(a.notes, "rest-pose-differs"));
  ASSERT_EQ(built.clips.at(0).tracks.size(), 2u);
  const auto held = std::ranges::find(built.clips[0].tracks, 1, &Track::joint);
  ASSERT_NE(held, built.clips[0].tracks.end());
  EXPECT_EQ(held->path, TrackPath::translation);
  EXPECT_EQ(held->key_count, 1u);
  EXPECT_EQ(built.clips[0].values[held->first_value + 1], 0.75f);
}

TEST(Packs, APackIsNoCharacter) {
  Apart a;
  a.d.clip("wave");
  a.d.turn(a.arm, {0, 1});
  expect_failure([&] { a.build(pack_options({"pack.mrw", {}})); }, Exit::invalid, "", "no skeleton");
}

TEST(Packs, AreSmallAndLoad) {
  Apart a;
  a.d.clip("wave");
  a.d.turn(a.arm, {0, 0.5F, 1});
  const WrittenFile written = write_scene(a.build(), "test");
  // Header, table, reference of 4 joints at 10 bytes, and names.
  EXPECT_LE(written.bytes.size() - written.clip_bytes.at(0), 32u + 3 * 16 + 16 + 4 * 10 + 64 + 3 * 15);
}

}  // namespace
}  // namespace marrow::cook
