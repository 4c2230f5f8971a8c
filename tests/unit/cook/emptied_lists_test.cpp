// Every list of a scene that a mend can empty, under every option that reads
// it: cooked, or refused with a place.
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>

#include "cook/skeleton/build_skeletons.h"
#include "unit/cook/cook_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

// Ada (mesh 0, skin 0), whom one clip moves, and a crate (mesh 1) that another
// carries. The crate stands after what a skeleton begins with, so that a node
// that is no joint is asked for one that is not there.
Builder full() {
  SceneDocument d;
  const std::vector<int> ada = d.character("Ada", 0);
  const int crate = d.node("crate", -1, {0, 0, 3});
  d.prop(crate);
  d.clip("nod");
  d.turn(ada[2], {0, 0.5F, 1});
  d.clip("carry");
  d.carry(crate, {0, 1});
  return d.b;
}

struct Emptied {
  const char *what, *change;
};

// Q is the crate's primitive, as P is Ada's.
const Emptied kEmptied[] = {
    {"nothing", ""},
    // Meshes.
    {"a mesh of points", R"("/Q/mode": 0)"},
    {"a mesh of lines at a node that stands still", R"("/Q/mode": 1, "/animations/1": null)"},
    {"skinned points", R"("/P/mode": 0)"},
    {"skinned points whose joints stand still", R"("/P/mode": 0, "/animations/0": null)"},
    {"all meshes of points", R"("/P/mode": 0, "/Q/mode": 0)"},
    {"points and nothing that moves", R"("/P/mode": 0, "/Q/mode": 0, "/animations": null)"},
    {"two indices", R"("/Q/indices": "=u16x1 0 1")"},
    {"two indices, skinned", R"("/P/indices": "=u16x1 0 1")"},
    {"no indices", R"("/Q/indices": "=u16x1")"},
    {"a strip of no indices, skinned", R"("/P/indices": "=u16x1", "/P/mode": 5)"},
    {"triangles of one vertex", R"("/Q/indices": "=u16x1 0 0 0 1 1 1")"},
    {"triangles of one vertex, skinned", R"("/P/indices": "=u16x1 0 0 0")"},
    {"a strip of one vertex", R"("/Q/indices": "=u16x1 0 0 0 0", "/Q/mode": 5)"},
    {"no positions", R"("/P/attributes/POSITION": null)"},
    {"no positions in any mesh",
     R"("/P/attributes/POSITION": null, "/Q/attributes/_ID": "@/Q/attributes/POSITION", "/Q/attributes/POSITION": null)"},
    {"no primitives", R"("/meshes/1/primitives": [])"},
    {"no primitives in any mesh", R"("/meshes/0/primitives": [], "/meshes/1/primitives": [])"},
    {"one primitive of points beside one of triangles", R"("/meshes/0/primitives/1": "@/P", "/P/mode": 0)"},
    {"no morph targets", R"("/P/targets": [], "/meshes/0/weights": [])"},
    {"meshes that no node draws, without triangles",
     R"("/nodes/5/mesh": null, "/nodes/5/skin": null, "/nodes/6/mesh": null, "/P/mode": 0, "/Q/mode": 0)"},
    // Nodes and scenes.
    {"no children", R"("/nodes/3/children": [])"},
    {"no scenes", R"("/scenes": [], "/scene": null)"},
    {"no nodes in the scene", R"("/scenes/0/nodes": [])"},
    {"no mesh in the scene", R"("/scenes/0/nodes": [0])"},
    {"no joints in the scene", R"("/scenes/0/nodes": [6])"},
    {"all nodes hidden", R"("extend KHR_node_visibility": {"visible": false})"},
    {"all nodes lower levels of one", R"("extend MSFT_lod": {"ids": [0, 5, 6]})"},
    {"no nodes", R"("/nodes": [])"},
    {"no nodes, no scenes, no animations: a library",
     R"("/nodes": null, "/scenes": null, "/scene": null, "/animations": null, "/skins": null)"},
    // Skins.
    {"no skins", R"("/skins": [])"},
    {"no joints in a skin", R"("/skins/0/joints": [])"},
    {"no weights", R"("/P/attributes/WEIGHTS_0": "=f32x4 nan*16")"},
    // Clips.
    {"no clips", R"("/animations": [])"},
    {"no channels", R"("/animations/0/channels": [])"},
    {"no keys", R"("/animations/0/samplers/0": {"input": "=f32x1", "output": "=f32x4"})"},
    {"no channels and no samplers",
     R"("/animations/0/channels": [], "/animations/0/samplers": [],
                                       "/animations/1/channels": [], "/animations/1/samplers": [])"},
    {"channels of nothing", R"("/animations/0/channels/0/target/path": "nothing")"},
    {"channels of what stays out",
     R"("/nodes/7": {"name": "lost"}, "/animations/0/channels/0/target/node": 7, "/animations/1/channels/0/target/node": 7)"},
};

Builder emptied(const Emptied& by) {
  std::string change = by.change;
  for (std::size_t at; (at = change.find("/Q")) != std::string::npos;) change.replace(at, 2, "/meshes/1/primitives/0");
  if (!change.starts_with("\"extend ")) return changed(full(), change);
  Builder b = full();
  const auto extension = members(change);
  const std::string name = extension.begin().key().substr(7);
  b.root["extensionsUsed"] = {name};
  for (Json& node : b.root["nodes"]) node["extensions"][name] = Json::parse(extension.begin().value().dump());
  return b;
}

// "onto Ada" is what --skeleton reads; shapes only marrow.toml has.
const char* const kAsked[] = {"",
                              "--mesh-codec meshopt --keep-vertex-order",
                              "--mesh-codec none --keep * --images embed --scene 0",
                              "--clips-only",
                              "--clips-only onto Ada",
                              "onto Ada",
                              "--auto-skeleton humanoid",
                              "--auto-weights nearest --rebind --smooth-weights 1",
                              "--weights-over-time mood=hips,head",
                              "--subdivide 1 --lod 0.5:2",
                              "--as fit --helpers auto --mwe --psd 2",
                              "--eigenskin 1",
                              "--additive nod=carry",
                              "--roles head=head --roles jaw=",
                              "[[shapes]]",
                              "--strict"};

CookOptions asked_of(const std::string& text) {
  const std::size_t end = std::min(text.find("onto Ada"), text.find("[[shapes]]"));
  CookOptions options = options_of(text.empty() ? "" : "--clip-codec raw " + text.substr(0, end));
  if (text.ends_with("onto Ada")) {
    SceneDocument d;
    d.character("Ada", 0);
    options.onto = std::make_shared<const Character>(Character{"ada.mrw", build_skeletons(d.read()).skeletons});
  }
  if (text == "[[shapes]]") options.shapes = {{"mood", "", {{"mood", 0}}, {{"", {0}}, {"smile", {1}}}}};
  return options;
}

TEST(EmptiedLists, AreCookedOrRefusedWithAPlace) {
  std::size_t cooked = 0, refused = 0;
  for (const char* const asked : kAsked)
    for (const Emptied& by : kEmptied) {
      SCOPED_TRACE(std::string(by.what) + ", " + asked);
      try {
        const LoadedCook done(cook_text(emptied(by), asked_of(asked)));
        ++cooked;
      } catch (const Failure& failure) {
        ++refused;
        const Exit code = failure.code();
        EXPECT_TRUE(code == Exit::usage || code == Exit::invalid || code == Exit::unsupported) << failure.what();
        const std::string file = failure.file();
        EXPECT_TRUE(failure.where().starts_with('/') || file.starts_with("--") || file == "[[shapes]]")
            << "no place: " << failure.what();
        EXPECT_FALSE(failure.rule().empty() || failure.advice().empty()) << failure.what();
      }
    }
  EXPECT_EQ(cooked + refused, std::size(kEmptied) * std::size(kAsked));
  EXPECT_GT(cooked, 250u);
  EXPECT_GT(refused, 100u);
  std::printf("%zu cooked, %zu refused\n", cooked, refused);
}

// What is drawn beside a mesh without triangles is cooked, and the mesh named.
TEST(EmptiedLists, LeaveTheOthersAlone) {
  std::size_t checked = 0;
  for (const Emptied& by : kEmptied) {
    const std::string what = by.what;
    if (what != "a mesh of points" && what != "two indices" && what != "no primitives" && what != "skinned points")
      continue;
    SCOPED_TRACE(what);
    const bool is_ada = what == "skinned points";
    const Result cooked = cook_text(emptied(by));
    ASSERT_EQ(cooked.report["meshes"].size(), 1u);
    EXPECT_EQ(cooked.report["meshes"][0]["name"], is_ada ? "prop" : "Ada mesh");
    EXPECT_EQ(cooked.report["meshes"][0]["triangles"], 2);
    EXPECT_TRUE(std::ranges::any_of(cooked.report["warnings"], [&](const auto& warning) {
      return warning["pointer"].template get<std::string>().starts_with(is_ada ? "/meshes/0" : "/meshes/1");
    }));
    ++checked;
  }
  EXPECT_EQ(checked, 4u);
}

}  // namespace
}  // namespace marrow::cook
