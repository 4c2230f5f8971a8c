// Reading glTF: which scene is cooked, and what of it is drawn.
#include <string>

#include <gtest/gtest.h>

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {
namespace {

// Scenes "attic" (a node with a child, both with meshes) and "cellar" (a mesh), a node of neither, and a clip that
// moves the last node of each.
Builder house() {
  return document_of(R"("nodes": [{"name": "table", "children": [1], "mesh": 0}, {"name": "lamp", "mesh": 0},
                           {"name": "barrel", "mesh": 0}, {"name": "ghost", "mesh": 0}],
    "scenes": [{"name": "attic", "nodes": [0]}, {"name": "cellar", "nodes": [2]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0"}}]}],
    "animations": [{"samplers": [{"input": "=f32x1 0 1", "output": "=f32x3 0 0 0 0 1 0"}], "channels":
      [{"sampler": 0, "target": {"node": 1, "path": "translation"}}, {"sampler": 0, "target": {"node": 2, "path": "translation"}},
       {"sampler": 0, "target": {"node": 3, "path": "translation"}}]}])");
}

TEST(GltfChosenScene, IsTheDefaultOneElseTheFirst) {
  expect_rows(house(), {{"glTF 2.0, section 3.5.1: what \"scene\" says is shown", R"("/scene": 1)", R"(
      "drawn": [2], "moved": [2], "nodes/0/in_scene": false, "nodes/1/in_scene": false, "nodes/2/in_scene": true,
      "nodes/3/in_scene": false, "warns": ["channels-left-out /animations", "nodes-outside-scene"],
      "said/nodes-outside-scene": ["…3 nodes", "…\"table\", \"lamp\", \"ghost\"", "…--scene"])"},
                        {"without it nothing need be: then it is the first", R"("/scene": null)",
                         R"("drawn": [0, 1], "moved": [1])"}});
}

TEST(GltfChosenScene, IsTheOneThatIsAskedFor) {
  expect_rows(house(), {{"by its name", "", R"("drawn": [2])"}}, {.scene = {"cellar"}});
  expect_rows(house(), {{"by its number", "", R"("drawn": [0, 1])"}}, {.scene = {"0"}});
  expect_rows(house(),
              {{"by its number", "", R"("drawn": [2])"},
               {"names come first", R"("/scenes/0/name": "1")", R"("drawn": [0, 1])"}},
              {.scene = {"1"}});
}

// Some exporters list what hangs on a node that does nothing else.
TEST(GltfChosenScene, TakesTheRootOverWhatItLists) {
  const std::string refused = "invalid /scenes/0/nodes/0: not a root node";
  expect_rows(house(), {{"that does nothing else", R"("/nodes/4": {"name": "above", "children": [0]})",
                         R"("drawn": [0, 1], "warns": ["scene-lists-no-root /scenes/0/nodes/0"])"},
                        {"moved", R"("/nodes/4": {"children": [0], "translation": [0, 1, 0]})", refused},
                        {"with a mesh", R"("/nodes/4": {"children": [0], "mesh": 0})", refused},
                        {"with others", R"("/nodes/4": {"children": [0, 2]}, "/scenes/1": null)", refused},
                        {"mirrored", R"("/nodes/4": {"children": [0], "scale": [1, 1, -1]})", refused}});
}

TEST(GltfChosenScene, ThatIsNotThereIsRefused) {
  for (const char* name : {"celar", "2", "-1", "1x", "99999999999"})
    expect_rows(house(), {{name, "", "usage : no scene is called … --scene"}}, {.scene = {name}});
  expect_rows(house(), {{"near", "", "usage : no scene is called … did you mean \"cellar\"?"}}, {.scene = {"celar"}});
  expect_rows(house(), {{"none", R"("/scene": null, "/scenes": null)", "usage : no scene is called"}},
              {.scene = {"attic"}});
  expect_rows(
      house(),
      {{"a rule for many files need not fit each", "", R"("drawn": [0, 1], "warns": ["rule-fits-nothing /scenes"])"}},
      {.scene = {"celar", {"marrow.toml", "1:1", false}}});
}

TEST(GltfChosenScene, WithoutAnyAllNodesAreCooked) {
  const std::string all =
      R"("drawn": [0, 1, 2, 3], "moved": [1, 2, 3], "warns": ["no-scenes /scenes"], "draws_elsewhere": false)";
  expect_rows(house(), {{"none", R"("/scene": null, "/scenes": null)", all},
                        {"an empty list", R"("/scene": null, "/scenes": [])", all}});
}

TEST(GltfChosenScene, SaysWhereMeshesAreDrawnInstead) {
  expect_rows(house(), {{"elsewhere", R"("/scenes/0/nodes": [])",
                         R"("drawn": [], "draws_elsewhere": true, "warns": ["empty-array /scenes/0/nodes"])"},
                        {"no node draws one", R"("/nodes": [{}], "/scenes": null, "/scene": null, "/animations": null)",
                         R"("draws_elsewhere": false)"}});
}

// A skin of another scene may hang together in ways that only that scene explains.
TEST(GltfChosenScene, OthersSkinsAreNoneOfItsBusiness) {
  const std::string skin =
      R"("/nodes/4": {"name": "root a"}, "/nodes/5": {"name": "root b"}, "/scenes/1/nodes": [2, 4, 5],
                              "/skins": [{"joints": [4, 5]}])";
  expect_rows(house(), {{"of the other", skin, R"("drawn": [0, 1])"},
                        {"joints are in its scene", skin + R"(, "/nodes/0/skin": 0)",
                         "invalid /skins/0/joints/0: no common root"}});
}

// KHR_node_visibility: what hangs below a hidden node is hidden, too.
TEST(GltfVisibility, HiddenMeshesAreLeftOut) {
  const auto with = [](const char* table, const char* lamp) {
    return std::string(R"("/extensionsUsed": ["KHR_node_visibility"], "/extensionsRequired": ["KHR_node_visibility"],
      "/nodes/0/extensions": {"KHR_node_visibility": )") +
           table + R"(}, "/nodes/1/extensions": {"KHR_node_visibility": )" + lamp + "}";
  };
  expect_rows(house(), {{"both; what it holds may be a joint", with(R"({"visible": false})", R"({"visible": true})"),
                         R"("drawn": [], "nodes/0/in_scene": true, "moved": [1], "warns not": ["extension-ignored"],
                            "said/hidden-nodes": "…\"table\", \"lamp\"")"},
                        {"true unless it says otherwise", with("{}", R"({"visible": false})"), R"("drawn": [0])"},
                        {"a number", with("{}", R"({"visible": 0})"),
                         "invalid /nodes/1/extensions/KHR_node_visibility/visible: wrong type"}});
}

TEST(GltfVisibility, ThatIsAnimatedIsSaid) {
  expect_rows(house(), {{"said", R"("/extensionsUsed": ["KHR_animation_pointer", "KHR_node_visibility"],
      "/animations/0/channels/1/target": {"path": "pointer", "extensions":
        {"KHR_animation_pointer": {"pointer": "/nodes/2/extensions/KHR_node_visibility/visible"}}})",
                         R"("warns": ["visibility-not-animated /animations/0/channels/1/target/path"])"}});
}

// MSFT_lod: "ids" are nodes that take the node's place from afar.
TEST(GltfLevels, LowerOnesAreLeftOut) {
  const auto with = [](const char* table, const char* barrel) {
    return std::string(
               R"("/extensionsUsed": ["MSFT_lod"], "/extensionsRequired": ["MSFT_lod"], "/scenes/0/nodes": [0, 2],
      "/nodes/0/extensions": {"MSFT_lod": {"ids": )") +
           table + R"(}}, "/nodes/2/extensions": {"MSFT_lod": {"ids": )" + barrel + "}}";
  };
  expect_rows(
      house(),
      {{"whether the scene lists them or not", with("[2, 3]", "[]"),
        R"("drawn": [0, 1], "said/lower-levels": "…\"barrel\", \"ghost\"", "warns not": ["nodes-outside-scene"])"},
       {"two that name each other", with("[2, 3]", "[0]"), R"("drawn": [0, 1])"},
       {"none but itself", with("[0]", "[]"), R"("drawn": [0, 1, 2])"}});
}

}  // namespace
}  // namespace marrow::cook
