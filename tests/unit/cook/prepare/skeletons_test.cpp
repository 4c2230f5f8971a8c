// Which nodes become which skeletons, and how a clip of several becomes one each.
#include <algorithm>

#include "disk/cook_on_disk.h"
#include "pose/choose.h"
#include "unit/cook/cook_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

// Ada at x = -1 and Bob at 1: armatures are 0 and 6, hips 1 and 7, spines 2 and 8, heads 3 and 9, arms 4 and 10, bodies
// 5 and 11. Others begin with 12.
Builder two_characters() {
  SceneDocument d;
  d.character("Ada", -1), d.character("Bob", 1);
  return d.b;
}
// Nodes of these members, from 12 on, roots of the scene beside both characters; meshes/2 is a prop.
std::string with(const std::vector<std::string>& nodes) {
  std::string
      out = R"("/meshes/2": {"primitives": [{"attributes": {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0"}, "indices":
                       "=u16x1 0 1 2 1 3 2"}]})",
      roots = "0, 5, 6, 11";
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    out += ", \"/nodes/" + std::to_string(12 + n) + "\": {" + nodes[n] + "}";
    if (nodes[n].find("below") == std::string::npos) roots += ", " + std::to_string(12 + n);
  }
  return out + ", \"/scenes/0/nodes\": [" + roots + "]";
}

TEST(Skeletons, ACharacterEach) {
  expect_cooked(two_characters(), {{"and clips of both stay in step", "",
                                    R"("/clips": "greet: turn 4 0 0.5 1, turn 10 0 0.25; nod: turn 9")", R"(
    "skeletons": [{"name": "Ada", "joints": ["hips", "spine", "head", "arm"]}, {"name": "Bob", "joints": ["hips", "spine", "head", "arm"]}],
    "clips": [{"name": "greet", "skeleton": 0, "duration_s": 1}, {"name": "greet", "skeleton": 1, "duration_s": 1},
              {"name": "nod", "skeleton": 1}], "meshes": [{"skeleton": 0}, {"skeleton": 1}])"}});
  Builder b = two_characters();
  Notes notes;
  const BuiltScene built = build_scene(read(b), {}, notes);
  for (const std::size_t s : {0U, 1U}) {
    ASSERT_EQ(built.skeletons[s].model_from_root.size(), 1u);
    EXPECT_EQ(built.skeletons[s].model_from_root[0].rows[0][3], s == 0 ? -1.0f : 1.0f);
  }
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

TEST(Skeletons, WhichNodesMakeOne) {
  expect_cooked(
      two_characters(),
      {{"targets and weapons go with their character; the target stands below Bob's armature, the ball is neither's",
        "--keep target",
        with({R"("name": "sword", "mesh": 2)", R"("name": "target", "extras": {"below": 6})",
              R"("name": "ball", "mesh": 2)"}) +
            R"(, "/nodes/6/children": [7, 13],
               "/clips": "strike: turn 4, carry 12; fight: turn 4, turn 10, carry 13, carry 14")",
        R"("skeletons": [{"name": "Ada", "joints": ["hips", "sword", "spine", "head", "arm"]},
                         {"name": "Bob", "joints": ["hips", "target", "spine", "head", "arm"]}, {"name": "ball"}],
           "clips": [{"name": "strike", "skeleton": 0}, {"name": "fight", "skeleton": 0}, {"name": "fight", "skeleton": 1},
                     {"name": "fight", "skeleton": 2}])"}});
  // Cameras, empties and what hangs on nothing else are no joints, unless they are kept or carry something.
  const std::string stage =
      R"("/nodes/6": {"name": "rig", "children": [7]}, "/nodes/7": {"name": "camera", "translation": [60, 0, 0]},
    "/nodes/4/children": [8], "/nodes/8": {"name": "socket"}, "/nodes/9": {"name": "cart", "children": [10]},
    "/nodes/10": {"name": "box", "mesh": 1}, "/scenes/0/nodes": [0, 5, 6, 9], "/meshes/1": {"primitives": [
      {"attributes": {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0"}, "indices": "=u16x1 0 1 2 1 3 2"}]},
    "/clips": "fly: carry 4, carry 6, carry 7, carry 8, carry 9")";
  SceneDocument ada;
  ada.character("Ada", 0);
  expect_cooked(
      ada.b,
      {{"what carries nothing is no joint", "", stage,
        R"("skeletons": [{"joints": ["hips", "cart", "spine", "head", "arm"]}], "warns": ["motion-of-nothing /nodes/6"])"},
       {"unless it is kept", "--keep cam* --keep socket", stage,
        R"("skeletons/0/joints": ["hips", "rig", "cart", "spine", "camera", "head", "arm", "socket"],
                            "warns not": ["motion-of-nothing"])"}});
}

TEST(Skeletons, TreesThatHangTogether) {
  const std::string prop = R"("meshes": [{"primitives": [{"attributes": {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0"},
                                                          "indices": "=u16x1 0 1 2 1 3 2"}]}], )";
  expect_cooked(
      document_of(prop + R"("scenes": [{"nodes": [0, 1]}], "nodes": [{"name": "engine", "children": [2, 3]},
                  {"name": "crane", "children": [4]}, {"name": "piston", "mesh": 0}, {"name": "wheel", "mesh": 0}, {"name": "hook", "mesh": 0}])"),
      {{"what one clip moves below one root is a machine", "", R"("/clips": "run: carry 2, carry 3, carry 4")",
        R"("skeletons": [{"name": "piston", "joints": ["piston", "wheel"]}, {"name": "hook"}],
                     "clips": [{"name": "run", "skeleton": 0}, {"name": "run", "skeleton": 1}])"}});
  SceneDocument d;
  const int left = d.node("left"), right = d.node("right"), alone = d.node("alone");
  d.skin("wings", {left, right});
  d.skin("tail", {alone});
  expect_cooked(d.b, {{"one skin ties trees", "", "",
                       R"("skeletons": [{"name": "wings", "joints": ["left", "right"]}, {"name": "tail"}])"}});
  const Builder bare = document_of(R"("scenes": [{"nodes": [0, 2]}],
                                      "nodes": [{"name": "hips", "children": [1]}, {"name": "head"}, {"name": "other"}])");
  expect_cooked(
      bare, {{"without meshes: nothing moves above it", "", R"("/clips": "nod: turn 1")",
              R"("skeletons": [{"name": "head"}], "warns": ["no-meshes"], "clips": [{"name": "nod", "skeleton": 0}])"},
             {"of a skin", "", R"("/skins": [{"joints": [0, 1]}])", R"("skeletons": [{"joints": ["hips", "head"]}])"},
             {"of nothing", "", "", "invalid /meshes: no-meshes"}});
}

TEST(Skeletons, SceneryIsOneAtTheEnd) {
  SceneDocument d;
  for (int i = 0; i < 300; ++i) d.prop(d.node("stone " + std::to_string(i), -1, {static_cast<float>(i), 0, 0}));
  const std::vector<int> a = d.character("Ada", 0);
  d.clip("nod");
  d.turn(a[2], {0, 1});
  Notes notes;
  const BuiltScene built = build_scene(d.read(), {}, notes);
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
  expect_facts(facts_of(LoadedCook(cook_scene(scene, {}))), R"("clips": [
    {"name": "speak", "skeleton": 1, "channels": ["mood", "smile"]},
    {"name": "walk", "skeleton": 0, "channels": ["mood"], "duration_s": 2},
    {"name": "walk", "skeleton": 1, "channels": ["smile"], "tracks": []}])");
}

TEST(Skeletons, AdditiveClipsTakeTheReferenceOfTheirOwnSkeleton) {
  const std::string clips = R"("/clips": "aim: carry 4, carry 10; stand: carry 3")";
  expect_cooked(two_characters(), {{"\"stand\" leaves Bob at rest", "--additive aim=stand", clips, R"("clips": [
      {"name": "aim", "skeleton": 0, "reference": true}, {"name": "aim", "skeleton": 1, "reference": false},
      {"name": "stand", "skeleton": 0}])"},
                                   {"no such clip", "--additive aim=sit", clips, "usage : no clip"}});
  Builder b = changed(two_characters(), clips);
  const LoadedCook cooked(cook_text(b, options_of("--additive aim=stand")));
  ASSERT_NE(cooked.file.clip(0).reference, nullptr);
  EXPECT_EQ(cooked.file.clip(0).reference[0].translation[1][2], 0.0f) << "the head as \"stand\" begins";
}

}  // namespace
}  // namespace marrow::cook
