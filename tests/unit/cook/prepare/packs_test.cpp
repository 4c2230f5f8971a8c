// Clip packs from glTF: for the file's own skeletons, and for a character's by the names of its joints.
#include <cstring>
#include <memory>

#include "cook/skeleton/build_skeletons.h"
#include "cook/write/write_scene.h"
#include "disk/cook_on_disk.h"
#include "support/places.h"
#include "unit/cook/cook_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

// Hips, spine, head and arm of a character called Ada.
Character ada() {
  SceneDocument d;
  d.character("Ada", 3);
  return {"ada.mrw", build_skeletons(d.read()).skeletons};
}

// Ada's joints exported apart: another root, another order, no head, and something in her hand; and a camera.
Builder apart() {
  return document_of(R"("scenes": [{"nodes": [0, 6]}], "nodes": [{"name": "ground", "children": [1]},
    {"name": "export root", "translation": [0, 0, 5], "children": [2]},
    {"name": "hips", "translation": [0, 1, 0], "children": [3]},
    {"name": "spine", "translation": [0, 0.5, 0], "children": [4]},
    {"name": "arm", "translation": [0.25, 0.125, 0], "children": [5]}, {"name": "cup"}, {"name": "camera", "camera": 0}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}])");
}

void expect_packs(std::initializer_list<CookRow> rows, const Character& character = ada()) {
  expect_cooked(apart(), rows, [&](CookOptions& options) {
    options.clips_only = true;
    options.onto = std::make_shared<const Character>(character);
  });
}

// An arm's length from the shoulder a shell of 3 cm says little.
TEST(Packs, KeepTheirPromiseAtTheCharactersVertices) {
  const std::string path = test::in_golden("dance.gltf");
  CookOptions options = options_of("--clips-only");
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
  expect_cooked(d.b,
                {{"Bob's", "--clips-only", "",
                  R"("report/clip_pack": true, "meshes": [], "skeletons": [{"name": "Bob"}], "clips/0/skeleton": 0)"},
                 {"none", "--clips-only", R"("/animations": null)", "invalid /animations: no-clips"}});
}

TEST(Packs, NodesAreMatchedByName) {
  const std::string joints = R"("skeletons": [{"name": "Ada", "joints": ["hips", "spine", "head", "arm"]}], )";
  expect_packs({{"all in their places", "", R"("/clips": "wave: turn 4 0 0.5 1")",
                 joints + R"("clips/#": 1, "warns not": ["no-such-joint"])"},
                {"the arm's place in Ada", "--clip-codec raw", R"("/clips": "wave: turn 4 0 0.5 1")",
                 joints + R"("clips/0/tracks": [{"joint": 3}])"},
                {"nodes that are no joints must not move", "", R"("/clips": "wave: turn 4, carry 5, carry 1")",
                 "invalid /nodes/1: no such joint in ada.mrw … \"export root\", \"cup\""},
                {"but may be held", "", R"("/clips": "wave: turn 4, turn 5 0.5")",
                 R"("clips/#": 1, "warns": ["no-such-joint /nodes/5"])"},
                {"nodes that move are told what joints are called", "",
                 R"("/nodes/4/name": "Arm.", "/clips": "wave: turn 4, carry 5")",
                 "invalid /nodes/4: no such joint in ada.mrw … clips move \"Arm.\" (did you mean \"arm\"?), \"cup\"; "
                 "name them as the "
                 "character's joints before you export, which are \"hips\", \"spine\", \"head\", \"arm\""},
                {"cameras may move beside them", "", R"("/clips": "wave: turn 4, carry 6")",
                 R"("clips/#": 1, "warns": ["no-such-joint /nodes/6"])"},
                {"parents must be the same", "",
                 R"("/nodes/7": {"name": "head"}, "/nodes/2/children": [3, 7], "/clips": "wave: turn 7")",
                 "invalid /nodes/7: another parent"},
                {"names must be unique", "",
                 R"("/nodes/7": {"name": "arm"}, "/nodes/3/children": [4, 7], "/clips": "wave: turn 7")",
                 "invalid /nodes/7: not unique"},
                {"what stands otherwise is held there", "--clip-codec raw",
                 R"("/nodes/3/translation": [0, 0.75, 0], "/clips": "wave: turn 4")",
                 R"("warns": ["rest-pose-differs"], "clips/0/tracks/#": 2,
           "clips/0/tracks/1": {"joint": 1, "path": "translation", "keys": 1, "values": [0, 0.75, 0]})"}});
  Character twice = ada();
  twice.skeletons[0].joint_names[2] = "arm";
  expect_packs({{"in the character, too", "", R"("/clips": "wave: turn 4")", "invalid /nodes/4: not unique"}}, twice);
  expect_packs({{"a pack is no character", "", R"("/clips": "wave: turn 4")", "invalid : no skeleton"}},
               {"pack.mrw", {}});
}

TEST(Packs, HaveTheCharactersRestAndAreSmall) {
  Builder b = changed(apart(), R"("/clips": "wave: turn 4 0 0.5 1")");
  CookOptions options = options_of("--clips-only");
  options.onto = std::make_shared<const Character>(ada());
  Notes notes;
  const BuiltScene built = build_scene(read(b), options, notes);
  const std::vector<SoaTransform> rest = ada().skeletons[0].rest;
  EXPECT_EQ(std::memcmp(built.skeletons.at(0).rest.data(), rest.data(), sizeof(SoaTransform)), 0) << "the character's";
  EXPECT_TRUE(notes.warnings.empty());
  const WrittenFile written = write_scene(built, "test");
  // Header, table, reference of 4 joints at 10 bytes, and names.
  EXPECT_LE(written.bytes.size() - written.clip_bytes.at(0), 32u + 3 * 16 + 16 + 4 * 10 + 64 + 3 * 15);
}

}  // namespace
}  // namespace marrow::cook
