// Hair and clothes for a body: what is matched with what, what is left out, and what is refused.
#include <memory>

#include "cook/skeleton/build_skeletons.h"
#include "unit/cook/cook_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

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

// A hat: a rig with the root 1, spine 2, head 3, a feather 4 and its tip 5; node 6 draws a mesh that follows them.
Builder hat() {
  return document_of(
      R"("scenes": [{"nodes": [0, 6]}], "nodes": [{"name": "hat rig", "translation": [0, 0, 5], "children": [1]},
    {"name": "root", "children": [2]}, {"name": "spine", "translation": [0, 0.5, 0], "children": [3]},
    {"name": "head", "translation": [0, 0.25, 0], "children": [4]},
    {"name": "feather", "translation": [0, 0.125, 0], "children": [5]}, {"name": "tip", "translation": [0, 0.125, 0]}, {}])");
}
// Vertices follow the first, the second and the last of these joints.
std::string skin(const std::string& joints) {
  const std::string last = std::to_string(std::ranges::count(joints, ',')), second = last == "0" ? "0" : "1";
  return R"("/nodes/6": {"mesh": 0, "skin": 0}, "/skins": [{"name": "hat", "joints": [)" + joints + R"(]}],
    "/meshes": [{"primitives": [{"indices": "=u16x1 0 1 2 1 3 2", "attributes": {"POSITION":
      "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0", "WEIGHTS_0": "=f32x4 1 0 0 0 1 0 0 0 .25 .75 0 0 1 0 0 0", "JOINTS_0":
      "=u8x4 0 0 0 0 )" +
         second + " 0 0 0 0 " + last + " 0 0 " + last + R"( 0 0 0"}}]}])";
}
// A mesh at a node, behind what else is said.
std::string prop(const std::string& node, const std::string& before = R"("/meshes": [{"primitives": []}])") {
  return before + R"(, "/meshes/1": {"primitives": [{"attributes": {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0"},
                        "indices": "=u16x1 0 1 2 1 3 2"}]}, "/nodes/)" +
         node + R"(/mesh": 1)";
}

void expect_outfits(std::initializer_list<CookRow> rows, const Character& body = ada_and_bob()) {
  expect_cooked(hat(), rows, [&](CookOptions& options) { options.onto = std::make_shared<const Character>(body); });
}

const std::string kNoneOfItsOwn = R"("skeletons": [{"name": "Ada", "joints": ["hips", "spine", "head", "arm"]}], )";

TEST(OutfitRules, JointsOfTheBodyAndOnesOwn) {
  const std::string below_tip = R"(, "/nodes/5/children": [7], "/nodes/7": )",
                    below_head = R"("/nodes/3/children": [4, 7], )";
  expect_outfits(
      {{"own joints stand behind the body's of their parent", "", skin("3, 5"),
        R"("skeletons": [{"name": "Ada", "joints": ["hips", "spine", "head", "arm", "feather", "tip"],
                          "parents": [65535, 0, 1, 1, 2, 4]}], "meshes/0/joints": ["head", "tip"], "warns only": [])"},
       {"or between those of a generation", "",
        skin("2, 7, 5") + R"(, "/nodes/7": {"name": "buckle"}, "/nodes/2/children": [3, 7])",
        R"("skeletons": [{"joints": ["hips", "spine", "head", "arm", "buckle", "feather", "tip"]}])"},
       {"what nothing follows may hang anywhere", "",
        skin("1, 3, 5") + R"(, "/P/attributes/JOINTS_0": "=u8x4 1 0 0 0 1 2 0 0 1 2 0 0 2 0 0 0")",
        R"("meshes/0/joints": ["head", "tip"])"},
       {"what something follows may not", "", skin("1, 3, 5"), "invalid /nodes/1: no such joint in ada.mrw"},
       {"meshes may hang on nodes that are called like joints", "",
        below_head +
            R"("/nodes/7": {"translation": [0, 1, 0], "children": [8]}, "/nodes/8": {"translation": [0.5, 0, 0]}, )" +
            prop("8"),
        kNoneOfItsOwn + R"("meshes/0/joints": ["head"],
           "meshes/0/inverse_bind/0": [[1, 0, 0, 0.5], [0, 1, 0, 1], [0, 0, 1, 0]])"},
       {"but not elsewhere", "", R"("/nodes/6": {"name": "heads"}, )" + prop("6"),
        "invalid /nodes/6: no such joint in ada.mrw … did you mean \"head\"?"},
       {"joints hang as in the body", "", skin("3, 5") + below_tip + R"({"name": "hips"})",
        "invalid /nodes/7: another parent"},
       {"some may be missing between", "", skin("3, 1") + R"(, "/nodes/1": {"name": "hips", "children": [3]},
          "/nodes/2": {"name": "nobody"}, "/nodes/3": {"name": "head", "translation": [0, 0.75, 0]}, "/nodes/4": {}, "/nodes/5": {})",
        kNoneOfItsOwn + R"("meshes/#": 1)"},
       {"names are unique, but what skins name goes first", "", skin("3, 5") + below_tip + R"({"name": "head"})",
        R"("skeletons/0/joints/#": 6)"},
       {"of skins they are", "", skin("3, 5, 7") + below_tip + R"({"name": "head"})", "invalid /nodes/7: not unique"}});
  Character twice = ada_and_bob();
  twice.skeletons[0].joint_names[3] = "head";
  expect_outfits({{"of the body too", "", skin("3"), "invalid /nodes/3: not unique"}}, twice);
}

TEST(OutfitRules, FollowTheSkeletonsThatTheyNeed) {
  const std::string bob = R"("/nodes/7": {"name": "bob head"}, "/scenes/0/nodes": [0, 6, 7], )";
  expect_outfits({{"one", "", bob + prop("7"), R"("skeletons": [{"name": "Bob"}])"},
                  {"both", "", bob + prop("7", skin("3, 5")), R"("skeletons/#": 2)"},
                  {"across", "", bob + prop("7", skin("3, 7")), "invalid /nodes/7: a skin across two skeletons"}},
                 ada_and_bob(true));
}

TEST(OutfitRules, ClipsMoveOwnJointsAlone) {
  expect_outfits(
      {{"others are the body's", "", skin("3, 5") + R"(, "/clips": "nod: turn 3, turn 4; sit: turn 2, carry 1")",
        R"("clips": [{"name": "nod"}], "warns": ["clips-of-body /animations"])"},
       {"a joint because a clip moves it", "", R"("/nodes/3/children": [4, 7], "/nodes/7": {"name": "wheel"},
                     "/clips": "spin: turn 7", )" + prop("7"),
        R"("skeletons/0/joints": ["hips", "spine", "head", "arm", "wheel"], "clips/#": 1)"},
       {"without meshes it is a clip pack", "", R"("/clips": "nod: turn 3")", R"("report/clip_pack": true)"}});
  expect_outfits({{"onto a pack", "", skin("3"), "invalid : no skeleton"}}, Character{"walk.mrw"});
}

// All inverse binds but those given are the identity, so it is what both sides have above them that is compared.
TEST(OutfitRules, AnotherBindPoseIsAWarning) {
  const std::string moved = skin("3, 2") + R"(, "/nodes/3/translation": [0, 0.3125, 0])";
  expect_outfits(
      {{"rests like the body", "", skin("3, 2"), R"("warns not": ["bind-pose-differs"])"},
       {"bound as if head and spine, which most follow, stood in one place: 0.25 m apart in the body", "", moved,
        R"("warns": ["bind-pose-differs /skins/0"], "said/bind-pose-differs": "…at \"head\" vertices are up to 0.25 m")"},
       {"where it was bound with the body's rest pose, that of its own file does not count", "",
        moved + R"(, "/skins/0/inverseBindMatrices":
                     "=f32x16 1 0 0 0 0 1 0 0 0 0 1 0 0 -.25 0 1  1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")",
        R"("warns not": ["bind-pose-differs"])"}});
}

}  // namespace
}  // namespace marrow::cook
