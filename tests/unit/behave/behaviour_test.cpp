// What is shown of a graph, against weights by hand; characters that graphs from anywhere are bound to.
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "behave/behaviour.h"
#include "behave/find_graph.h"
#include "common/failure.h"
#include "disk/disk_files.h"
#include "disk/files.h"
#include "support/places.h"
#include "unit/graph/graph_rig.h"

namespace marrow::tools {
namespace {

// Weights by the names of nodes, or of clips that are named where they are used.
std::map<std::string, double> weights_of(const test::GraphRig& rig) {
  std::map<std::string, double> out;
  for (const ShownNode& n : shown_nodes(rig.animator)) {
    std::string name = rig.file.text(rig.graph.nodes[n.node].name);
    if (name.empty() && n.is_clip) name = n.animation->name;
    out[name] += static_cast<double>(n.weight);
  }
  return out;
}

TEST(Shown, WeighsNodesAsPosesDo) {
  test::GraphRig rig(R"(
output = "over"
[parameters]
speed = { type = "number", range = [0, 4] }
guard = { type = "number", range = [0, 1] }
go = { type = "trigger" }
[node.line]
type = "space"
by = "speed"
points = [ { at = 0, pose = "idle" }, { at = 4, pose = "walk" } ]
[node.body]
type = "machine"
start = "moves"
state.moves = { pose = "line" }
state.jumps = { pose = "jump" }
transition = [ { from = "moves", to = "jumps", when = "go", fade = 0.4 } ]
[node.laid]
type = "layer"
base = "body"
pose = "attack"
weight = "guard"
[node.over]
type = "layer"
base = "laid"
pose = "turn"
mask = { joint = "chest" }
weight = 0.5
)");
  EXPECT_TRUE(shown_nodes(rig.animator).empty()) << "nothing is decided yet";
  rig.set_number("speed", 1);
  rig.set_number("guard", 0.2);
  rig.step(0.1);
  std::map<std::string, double> weights = weights_of(rig);
  EXPECT_NEAR(weights["over"], 1, 1e-6);
  EXPECT_NEAR(weights["laid"], 1, 1e-6) << "a mask takes nothing of its base";
  EXPECT_NEAR(weights["turn"], 0.5, 1e-6);
  EXPECT_NEAR(weights["body"], 0.8, 1e-6);
  EXPECT_NEAR(weights["attack"], 0.2, 1e-6);
  EXPECT_NEAR(weights["idle"], 0.8 * 0.75, 1e-6);
  EXPECT_NEAR(weights["walk"], 0.8 * 0.25, 1e-6);
  EXPECT_EQ(weights.count("jump"), 0u);
  rig.fire("go");
  rig.step(0.1);  // a quarter of the fade: 3/16 - 2/64
  weights = weights_of(rig);
  const double jump = 3.0 / 16 - 2.0 / 64;
  EXPECT_NEAR(weights["jump"], 0.8 * jump, 1e-5);
  EXPECT_NEAR(weights["line"], 0.8 * (1 - jump), 1e-5);
}

TEST(Shown, NodesStandBelowThoseThatTakeThem) {
  const test::GraphRig rig(R"(
output = "over"
[parameters]
speed = { type = "number", range = [0, 4] }
[node.line]
type = "space"
by = "speed"
points = [ { at = 0, pose = "idle" }, { at = 4, pose = "walk" } ]
[node.body]
type = "machine"
start = "moves"
state.moves = { pose = "line" }
state.nothing = { }
state.jumps = { pose = "jump" }
[node.over]
type = "layer"
base = "line"
pose = "body"
)");
  const auto below = [&](std::uint32_t node) {
    std::string out;
    for (const std::uint32_t n : nodes_below(rig.graph, node)) {
      const GraphNode& of = rig.graph.nodes[n];
      out +=
          std::string(rig.file.text(of.kind == GraphNodeKind::clip ? rig.graph.clips[of.record].name : of.name)) + " ";
    }
    return out;
  };
  EXPECT_EQ(below(find_graph_node(rig.binding, "over")), "line body ");
  EXPECT_EQ(below(find_graph_node(rig.binding, "body")), "line jump ");
  EXPECT_EQ(below(find_graph_node(rig.binding, "line")), "idle walk ");
  EXPECT_EQ(below(nodes_below(rig.graph, find_graph_node(rig.binding, "line"))[0]), "");
}

TEST(Shown, KnowsTheTimesOfClips) {
  test::GraphRig rig(R"(
output = "all"
[parameters]
speed = { type = "number", range = [0, 4] }
[node.step]
type = "space"
by = "speed"
points = [ { pose = "walk" }, { pose = "run" } ]
sync = true
[node.all]
type = "layer"
base = "step"
pose = "idle"
mask = { joint = "head" }
)");
  rig.set_number("speed", 1.2);  // the walk's own: it alone, whose segments take half a second each
  rig.step(0.25);
  for (const ShownNode& n : shown_nodes(rig.animator)) {
    if (!n.is_clip) continue;
    EXPECT_NEAR(static_cast<double>(n.time_s), 0.25, 1e-5) << n.animation->name;
  }
}

// A character with a walk that goes by its root, and what a graph of it needs.
class BehaviourTest : public ::testing::Test {
 protected:
  static const LoadedFile& newt() {
    static const LoadedFile made = [] {
      cook::CookOptions options;
      cook::RootRule root;
      root.clips = "*";
      root.root = cook::RootMotion::ground;
      options.motion.roots = {root};
      options.mesh.codec = cook::MeshCodec::none;
      options.clips.raw = true;
      const cook::Result cooked = cook::cook_file(test::in_source("tools/sample/newt.glb"), options);
      return load_mrw("newt.mrw", AlignedBytes(std::span<const std::byte>(cooked.file)));
    }();
    return made;
  }
  static std::uint32_t walk() { return newt().file.find_clip("walk", 0); }
  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = ::testing::TempDir() + "behaviour_" + name;
    write_file_atomically(path, text);
    return path;
  }
};

TEST_F(BehaviourTest, GoesWhereItsClipsGo) {
  const std::string text = write("walk.anim.toml", "output = \"walk\"\n");
  Behaviour behaviour("newt.mrw", newt().file, find_graph("newt.mrw", newt().file, text), {});
  EXPECT_EQ(std::string(behaviour.graph().name), "behaviour_walk");
  const ClipMotion motion = newt().file.motion(walk());
  ASSERT_GT(motion.speed_m_s, 0);
  ASSERT_FALSE(motion.root.empty());
  Character character(newt().file, AsNormals::blended, 0, std::max(1u, behaviour.layers()));
  const auto go = [&] {
    for (int i = 0; i < 240; ++i) behaviour.update(1.0f / 60);
    behaviour.pose(character);
    return character.model_from_joint(0)[0];
  };
  const Affine there = go();
  EXPECT_NEAR(behaviour.time_s(), 4, 1e-5);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(static_cast<double>(behaviour.world_from_model().rows[axis][3]),
                4 * static_cast<double>(motion.speed_m_s * motion.heading[axis]), 0.02)
        << axis;
  // The joint is where the clip's pose has it, moved by the way so far.
  Character still(newt().file);
  still.pose(play_together(newt().file, walk()), behaviour.shown().back().time_s);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(there.rows[axis][3],
                still.model_from_joint(0)[0].rows[axis][3] + behaviour.world_from_model().rows[axis][3], 1e-4);
  behaviour.restart();
  EXPECT_EQ(behaviour.world_from_model().rows[2][3], 0);
  const Affine again = go();
  EXPECT_EQ(std::memcmp(&again, &there, sizeof there), 0);
}

TEST_F(BehaviourTest, SaysWhatIsMissing) {
  const auto refused = [&](const BehaviourArguments& arguments) -> std::string {
    try {
      const Behaviour made("newt.mrw", newt().file, find_graph("newt.mrw", newt().file, arguments.graph),
                           arguments.clips);
      return "";
    } catch (const Failure& failure) {
      return failure.what();
    }
  };
  EXPECT_EQ(refused({write("good.toml", "output = \"walk\""), {}}), "");
  EXPECT_NE(refused({write("clip.toml", "output = \"walkx\""), {}}).find("did you mean \"walk\"?"), std::string::npos);
  EXPECT_NE(refused({"", {}}).find("no graph"), std::string::npos);
  EXPECT_NE(refused({"hero", {}}).find("no graph"), std::string::npos);
  EXPECT_NE(refused({write("bad.toml", "output = 3"), {}}).find("1:10"), std::string::npos);
  EXPECT_NE(refused({"no/such.toml", {}}).find("no/such.toml"), std::string::npos);
}

TEST(FindGraph, ByNameNumberAndPack) {
  const test::GraphFile two({{"one.anim.toml", "output = \"walk\"\n"}, {"two.anim.toml", "output = \"run\"\n"}});
  EXPECT_EQ(std::string(named_graph("f", two.file, "two").name), "two");
  EXPECT_EQ(std::string(named_graph("f", two.file, "0").name), "one");
  for (const char* const wrong : {"", "thre", "2", "-1"})
    EXPECT_THROW(static_cast<void>(named_graph("f", two.file, wrong)), Failure) << wrong;
  cook::CookOptions options;
  options.graphs = {{"a.toml", "output = \"walk\"", {}}, {"b.toml", "output = \"idle\"", {}}};
  const std::string pack = ::testing::TempDir() + "find_graph_pack.mrw";
  DiskFiles files;
  const cook::Result cooked = cook::cook_graphs(options, {files, nullptr, {}, nullptr});
  write_file_atomically(pack, std::span<const std::byte>(cooked.file));
  EXPECT_TRUE(cooked.report["warnings"].empty()) << "its clips come from elsewhere";
  EXPECT_EQ(std::string(find_graph("f", two.file, "b@" + pack).graph.name), "b");
  EXPECT_THROW(find_graph("f", two.file, pack), Failure) << "there are two";
}

}  // namespace
}  // namespace marrow::tools
