// Reading glTF: which scene is cooked, and what of it is drawn.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

// Scenes "attic" (a node with a child, both with meshes) and "cellar" (a mesh), a node of neither, and a clip that
// moves the last node of each.
Builder house() {
  Builder b;
  b.root["nodes"] = {{{"name", "table"}, {"children", {1}}, {"mesh", 0}},
                     {{"name", "lamp"}, {"mesh", 0}},
                     {{"name", "barrel"}, {"mesh", 0}},
                     {{"name", "ghost"}, {"mesh", 0}}};
  b.root["scenes"] = {{{"name", "attic"}, {"nodes", {0}}}, {{"name", "cellar"}, {"nodes", {2}}}};
  b.root["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", b.curve(3)}}}}}}}};
  const int times = b.times({0, 1}), places = b.numbers<float>(kF32, "VEC3", 3, {0, 0, 0, 0, 1, 0});
  for (const int node : {1, 2, 3}) b.channel(times, places, "translation", "LINEAR", node);
  return b;
}

// The nodes that are drawn.
std::vector<int> drawn(const RawScene& scene) {
  std::vector<int> out;
  for (const RawInstance& instance : scene.instances) out.push_back(instance.node);
  return out;
}

std::vector<int> moved(const RawScene& scene) {
  std::vector<int> out;
  for (const RawClip& clip : scene.clips)
    for (const RawChannel& channel : clip.channels) out.push_back(channel.node);
  return out;
}

std::string text_of(const RawScene& scene, const std::string& rule) {
  for (const RawWarning& warning : scene.warnings)
    if (warning.rule == rule) return warning.text;
  return "";
}

using Nodes = std::vector<int>;

// glTF 2.0, section 3.5.1: what `scene` says is shown; without it nothing need be. Then it is the first.
TEST(GltfChosenScene, IsTheDefaultOneElseTheFirst) {
  Builder b = house();
  b.root["scene"] = 1;
  RawScene scene = read(b);
  EXPECT_EQ(drawn(scene), Nodes{2});
  EXPECT_EQ(moved(scene), Nodes{2});
  EXPECT_FALSE(scene.nodes[0].in_scene || scene.nodes[1].in_scene || scene.nodes[3].in_scene);
  EXPECT_TRUE(scene.nodes[2].in_scene);
  EXPECT_TRUE(warns(scene, "channels-left-out", "/animations"));
  const std::string said = text_of(scene, "nodes-outside-scene");
  EXPECT_TRUE(said.starts_with("3 nodes")) << said;
  for (const char* part : {"\"table\", \"lamp\", \"ghost\"", "--scene"})
    EXPECT_NE(said.find(part), std::string::npos) << said;
  b.root.erase("scene");
  scene = read(b);
  EXPECT_EQ(drawn(scene), (Nodes{0, 1}));
  EXPECT_EQ(moved(scene), Nodes{1});
}

TEST(GltfChosenScene, IsTheOneThatIsAskedFor) {
  Builder b = house();
  EXPECT_EQ(drawn(read(b, {.scene = {"cellar"}})), Nodes{2});
  EXPECT_EQ(drawn(read(b, {.scene = {"1"}})), Nodes{2});
  EXPECT_EQ(drawn(read(b, {.scene = {"0"}})), (Nodes{0, 1}));
  b.root["scenes"][0]["name"] = "1";
  EXPECT_EQ(drawn(read(b, {.scene = {"1"}})), (Nodes{0, 1})) << "names come first";
}

// Some exporters list what hangs on a node that does nothing else.
TEST(GltfChosenScene, TakesTheRootOverWhatItLists) {
  Builder b = house();
  b.root["nodes"].push_back({{"name", "above"}, {"children", {0}}});
  const RawScene scene = read(b);
  EXPECT_EQ(drawn(scene), (Nodes{0, 1}));
  EXPECT_TRUE(warns(scene, "scene-lists-no-root", "/scenes/0/nodes/0"));
  // It would be a guess whether these count.
  for (const Json& more :
       {Json{{"translation", {0, 1, 0}}}, Json{{"mesh", 0}}, Json{{"children", {0, 2}}}, Json{{"scale", {1, 1, -1}}}}) {
    Builder guess = house();
    guess.root["nodes"].push_back({{"children", {0}}});
    guess.root["nodes"][4].update(more);
    if (more.contains("children")) guess.root["scenes"].erase(1);
    expect_refused(guess.text(), Exit::invalid, "/scenes/0/nodes/0", "not a root node");
  }
}

TEST(GltfChosenScene, ThatIsNotThereIsRefused) {
  Builder b = house();
  for (const char* name : {"celar", "2", "-1", "1x", "99999999999"})
    expect_failure([&] { read(b, {.scene = {name}}); }, Exit::usage, "", "no scene is called");
  try {
    read(b, {.scene = {"celar"}});
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.file(), "--scene");
    EXPECT_NE(failure.advice().find("did you mean \"cellar\"?"), std::string::npos) << failure.advice();
  }
  // A rule for many files need not fit each.
  const RawScene scene = read(b, {.scene = {"celar", {"marrow.toml", "1:1", false}}});
  EXPECT_EQ(drawn(scene), (Nodes{0, 1}));
  EXPECT_TRUE(warns(scene, "rule-fits-nothing", "/scenes"));
  b.root.erase("scene");
  b.root.erase("scenes");
  expect_failure([&] { read(b, {.scene = {"attic"}}); }, Exit::usage, "", "no scene is called");
}

TEST(GltfChosenScene, WithoutAnyAllNodesAreCooked) {
  Builder b = house();
  for (const bool empty : {false, true}) {
    b.root.erase("scene");
    b.root.erase("scenes");
    if (empty) b.root["scenes"] = Json::array();
    const RawScene scene = read(b);
    EXPECT_EQ(drawn(scene), (Nodes{0, 1, 2, 3}));
    EXPECT_EQ(moved(scene), (Nodes{1, 2, 3}));
    EXPECT_TRUE(warns(scene, "no-scenes", "/scenes"));
    EXPECT_FALSE(scene.draws_elsewhere);
  }
}

TEST(GltfChosenScene, SaysWhereMeshesAreDrawnInstead) {
  Builder b = house();
  b.root["scenes"][0]["nodes"] = Json::array();
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.instances.empty() && scene.draws_elsewhere);
  EXPECT_TRUE(warns(scene, "empty-array", "/scenes/0/nodes"));
  b.root["nodes"] = Json::array({Json::object()});
  b.root.erase("scenes");
  b.root.erase("scene");
  b.root.erase("animations");
  EXPECT_FALSE(read(b).draws_elsewhere) << "no node draws one";
}

// A skin of another scene may hang together in ways that only that scene explains.
TEST(GltfChosenScene, OthersSkinsAreNoneOfItsBusiness) {
  Builder b = house();
  b.root["nodes"].push_back({{"name", "root a"}});
  b.root["nodes"].push_back({{"name", "root b"}});
  b.root["scenes"][1]["nodes"] = {2, 4, 5};
  b.root["skins"] = {{{"joints", {4, 5}}}};
  EXPECT_EQ(drawn(read(b)), (Nodes{0, 1}));
  b.root["nodes"][0]["skin"] = 0;
  EXPECT_THROW(read(b), Failure) << "joints are in its scene";
}

// KHR_node_visibility: what hangs below a hidden node is hidden, too.
TEST(GltfVisibility, HiddenMeshesAreLeftOut) {
  Builder b = house();
  const auto set = [&](int node, const Json& visible) {
    b.root["nodes"][static_cast<std::size_t>(node)]["extensions"]["KHR_node_visibility"] = visible;
  };
  b.root["extensionsUsed"] = b.root["extensionsRequired"] = {"KHR_node_visibility"};
  set(0, {{"visible", false}});
  set(1, {{"visible", true}});
  RawScene scene = read(b);
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_TRUE(scene.nodes[0].in_scene) << "what it holds may be a joint";
  EXPECT_EQ(moved(scene), Nodes{1});
  EXPECT_NE(text_of(scene, "hidden-nodes").find("\"table\", \"lamp\""), std::string::npos);
  EXPECT_FALSE(warns(scene, "extension-ignored"));
  set(0, Json::object());
  set(1, {{"visible", false}});
  EXPECT_EQ(drawn(read(b)), Nodes{0}) << "true unless it says otherwise";
  set(1, {{"visible", 0}});
  expect_failure([&] { read(b); }, Exit::invalid, "/nodes/1/extensions/KHR_node_visibility/visible", "wrong type");
}

TEST(GltfVisibility, ThatIsAnimatedIsSaid) {
  Builder b = house();
  b.root["extensionsUsed"] = {"KHR_animation_pointer", "KHR_node_visibility"};
  b.root["animations"][0]["channels"][1]["target"] = {
      {"path", "pointer"},
      {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/2/extensions/KHR_node_visibility/visible"}}}}}};
  const RawScene scene = read(b);
  EXPECT_TRUE(warns(scene, "visibility-not-animated", "/animations/0/channels/1/target/path"));
}

// MSFT_lod: "ids" are nodes that take the node's place from afar.
TEST(GltfLevels, LowerOnesAreLeftOut) {
  Builder b = house();
  b.root["extensionsUsed"] = b.root["extensionsRequired"] = {"MSFT_lod"};
  b.root["scenes"][0]["nodes"] = {0, 2};
  b.root["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {2, 3};
  RawScene scene = read(b);
  EXPECT_EQ(drawn(scene), (Nodes{0, 1})) << "whether the scene lists them or not";
  EXPECT_NE(text_of(scene, "lower-levels").find("\"barrel\", \"ghost\""), std::string::npos);
  EXPECT_FALSE(warns(scene, "nodes-outside-scene"));
  b.root["nodes"][2]["extensions"]["MSFT_lod"]["ids"] = {0};
  EXPECT_EQ(drawn(read(b)), (Nodes{0, 1})) << "two that name each other";
  b.root["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {0};
  b.root["nodes"][2]["extensions"]["MSFT_lod"]["ids"] = Json::array();
  EXPECT_EQ(drawn(read(b)), (Nodes{0, 1, 2})) << "none but itself";
}

}  // namespace
}  // namespace marrow::cook
