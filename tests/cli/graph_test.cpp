// `marrow graph`, `marrow cook --graph` without a model, `marrow info` of graphs, and `marrow render --graph`.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/cookings.h"
#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

using nlohmann::json;

constexpr const char* kText = R"(output = "body"
[parameters]
speed = { type = "number", range = [0, 2], half_life = 0.1 }
go = { type = "flag" }
hop = { type = "trigger", hold = 0.5 }
[node.move]
type = "space"
by = "speed"
points = [ { at = 0, pose = "idle" }, { pose = "walk" } ]
match_speed = true
sync = true
[node.body]
type = "machine"
start = "still"
state.still = { pose = "idle" }
state.goes = { pose = "move" }
state.hops = { pose = "twist" }
transition = [
  { from = "still", to = "goes", when = "go" },
  { from = "goes", to = "still", when = "not go" },
  { from = "*", to = "hops", when = "hop", fade = 0.2 },
  { from = "hops", to = "still", at_end = 0.1, fade = 0.1 },
]
)";

class GraphTest : public ::testing::Test {
 protected:
  // The sample, whose walk goes at a known speed.
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_EQ(run_marrow({"cook", newt_glb(), "-o", in("newt.mrw"), "--root", "*=ground"}).code, 0);
    write_text(in("move.anim.toml"), kText);
    write_text(in("other.anim.toml"), "output = \"idle\"\n");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::string in(const std::string& name) { return *folder_ / name; }
  static const TemporaryFolder& folder() { return *folder_; }
  static Ran expect(const std::vector<std::string>& arguments, int code, const std::string& words = "") {
    Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, code) << ::testing::PrintToString(arguments) << '\n' << ran.err;
    EXPECT_NE((ran.out + ran.err).find(words), std::string::npos) << words << '\n'
                                                                  << ::testing::PrintToString(arguments) << '\n'
                                                                  << ran.out << ran.err;
    return ran;
  }
  // A character with clips of these names, each the same.
  static std::string model_with(const std::string& name, const std::vector<std::string>& clips) {
    json gltf = json::parse(read_text(in_golden("tiny.gltf")));
    json animation = gltf["animations"][0];
    json turns = json::array();
    for (const json& channel : animation["channels"])
      if (channel["target"]["path"] == "rotation") turns.push_back(channel);
    animation["channels"] = turns;  // so that they go nowhere
    gltf["animations"] = json::array();
    for (const std::string& clip : clips) {
      gltf["animations"].push_back(animation);
      gltf["animations"].back()["name"] = clip;
    }
    write_text(in(name), gltf.dump());
    return in(name);
  }

 private:
  static TemporaryFolder* folder_;
};

TemporaryFolder* GraphTest::folder_ = nullptr;

TEST_F(GraphTest, BeginsOneThatCooksAsItIs) {
  expect({"graph", "new", in("newt.mrw"), "-o", in("new.anim.toml")}, 0);
  const std::string text = read_text(in("new.anim.toml"));
  EXPECT_EQ(text, expect({"graph", "new", in("newt.mrw")}, 0).out);
  for (const char* const part : {"{ at = 0, pose = \"idle\" }", "{ pose = \"walk\" },  # 0.377 m/s",
                                 "match_speed = true", "sync = true", "not in it yet", "twist, reach"})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  const Ran cooked = expect({"cook", newt_glb(), "-o", in("with.mrw"), "--graph", in("new.anim.toml")}, 0);
  EXPECT_EQ(cooked.err.find("warning: no-such-clip"), std::string::npos) << cooked.err;
  EXPECT_EQ(cooked.err.find("unused-node"), std::string::npos) << cooked.err;
  expect({"graph", "check", in("new.anim.toml"), "--for", in("newt.mrw")}, 0, "it fits");
}

// Names as makers of characters give them.
TEST_F(GraphTest, KnowsClipsByTheirNames) {
  struct Maker {
    std::vector<std::string> clips;
    std::vector<std::string> parts;  // of the text
  };
  const Maker makers[] = {
      {{"CharacterArmature|Death", "CharacterArmature|Duck", "CharacterArmature|HitReact", "CharacterArmature|Idle",
        "CharacterArmature|Idle_Attack", "CharacterArmature|Jump", "CharacterArmature|Jump_Idle",
        "CharacterArmature|Jump_Land", "CharacterArmature|Punch", "CharacterArmature|Run",
        "CharacterArmature|Run_Attack", "CharacterArmature|Walk", "CharacterArmature|Wave", "CharacterArmature|Yes"},
       {"{ at = 0, pose = \"CharacterArmature|Idle\" }", "{ at = 1, pose = \"CharacterArmature|Walk\" }",
        "{ at = 2, pose = \"CharacterArmature|Run\" }", "state.jump = { pose = \"CharacterArmature|Jump\" }",
        "state.air = { pose = \"CharacterArmature|Jump_Idle\" }",
        "state.land = { pose = \"CharacterArmature|Jump_Land\" }", "clip = \"CharacterArmature|Death\"",
        "when = \"punch\"", "when = \"hit_react\"", "when = \"wave\"", "not in it yet:\n#   CharacterArmature|Duck"}},
      {{"Man_Idle", "Man_Standing", "Man_Walk", "Man_RunningJump", "Man_Clapping", "Man_SwordSlash"},
       {"type = \"pick\"\nposes = [ \"Man_Idle\", \"Man_Standing\" ]", "state.jump = { pose = \"Man_RunningJump\" }",
        "when = \"speed > 0.5\"", "when = \"sword_slash\""}},
      {{"mixamo.com", "walking", "idle \"odd\" name", "tab\there"}, {"pose = \"idle \\\"odd\\\" name\""}},
      {{"Take 001"}, {"output = \"Take 001\"\n"}},
      {{"T-Pose", "Bite"}, {"output ="}},
  };
  int number = 0;
  for (const Maker& maker : makers) {
    const std::string model = model_with("maker" + std::to_string(number++) + ".gltf", maker.clips);
    const std::string text =
        expect({"graph", "new", model, "-o", in("made.anim.toml")}, 0).out + read_text(in("made.anim.toml"));
    for (const std::string& part : maker.parts) EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    const Ran cooked = expect({"cook", model, "-o", in("made.mrw"), "--graph", in("made.anim.toml")}, 0);
    EXPECT_EQ(cooked.err.find("no-such-clip"), std::string::npos) << cooked.err;
    EXPECT_EQ(cooked.err.find("unused-node"), std::string::npos) << cooked.err;
    expect({"graph", "check", in("made.anim.toml"), "--for", model}, 0, "it fits");
  }
  expect({"graph", "new", model_with("none.gltf", {""})}, kInvalid, "no clip with a name");
  expect({"graph", "new", in("newt.mrw"), "-o", in("newt.mrw")}, kUsage, "newt.mrw");
}

TEST_F(GraphTest, ChecksTextsAndWhetherTheyFit) {
  expect({"graph", "check", in("move.anim.toml")}, 0, "6 nodes, 3 parameters, 4 clips");
  expect({"graph", "check", in("move.anim.toml"), "--for", in("newt.mrw")}, 0, "it fits " + in("newt.mrw"));
  write_text(in("wrong.anim.toml"), "output = \"walk\"\n[node.a]\ntype = \"clop\"\n");
  expect({"graph", "check", in("wrong.anim.toml")}, kUsage, "wrong.anim.toml: 3:8: there is no type \"clop\"");
  write_text(in("wrong.anim.toml"), "output = \"wolk\"\n");
  expect({"graph", "check", in("wrong.anim.toml")}, 0, "1 nodes, 0 parameters, 1 clips");
  expect({"graph", "check", in("wrong.anim.toml"), "--for", in("newt.mrw")}, kUsage, "did you mean \"walk\"?");
  expect({"graph", "check", in("newt.mrw")}, kUsage, "no graph");
  expect({"graph"}, kUsage, "A subcommand is required");
  expect({"graph", "chekc", in("newt.mrw")}, kUsage, "");
}

// Every brace and quote closed, an edge for each transition and each pose that is taken.
TEST_F(GraphTest, DrawsADigraph) {
  const std::string dot = expect({"graph", "dot", in("move.anim.toml")}, 0).out;
  EXPECT_EQ(dot.rfind("digraph \"move\" {\n", 0), 0u) << dot;
  int depth = 0;
  std::size_t quotes = 0, edges = 0;
  for (std::size_t i = 0; i < dot.size(); ++i) {
    depth += dot[i] == '{' ? 1 : dot[i] == '}' ? -1 : 0;
    quotes += dot[i] == '"' ? 1 : 0;
    edges += dot.compare(i, 4, " -> ") == 0 ? 1 : 0;
  }
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(quotes % 2, 0u);
  // Four transitions, the start, three states' poses, two points, the output.
  EXPECT_EQ(edges, 4u + 1 + 3 + 2 + 1) << dot;
  for (const char* const part : {"label = \"not go\"", "label = \"0.1 s before the end\"", "any state", "at its speed",
                                 "exactly as fast, in step", "space by speed"})
    EXPECT_NE(dot.find(part), std::string::npos) << part << '\n' << dot;
  EXPECT_EQ(dot, expect({"graph", "dot", in("move.anim.toml"), "-o", in("g.dot")}, 0).out + read_text(in("g.dot")));
}

TEST_F(GraphTest, CooksPacksOfGraphsAlone) {
  const std::string pack = in("pack.mrw");
  expect({"cook", "--graph", in("move.anim.toml"), "--graph", in("other.anim.toml"), "-o", pack, "--report",
          in("pack.json"), "--depfile", in("pack.d")},
         0, "2 graphs");
  const json report = json::parse(read_text(in("pack.json")));
  EXPECT_TRUE(report["warnings"].empty()) << "clips come from elsewhere";
  EXPECT_NE(read_text(in("pack.d")).find("other.anim.toml"), std::string::npos);
  const json info = json::parse(expect({"info", pack, "--json"}, 0).out);
  ASSERT_EQ(info["graphs"].size(), 2u);
  EXPECT_EQ(info["graphs"][1]["name"], "other");
  expect({"render", in("newt.mrw"), "--graph", "move@" + pack, "--trace", in("p.json")}, 0);
  expect({"render", in("newt.mrw"), "--graph", pack, "--trace", in("p.json")}, kUsage, "several graphs");
  expect({"render", in("newt.mrw"), "--graph", "mvoe@" + pack, "--trace", in("p.json")}, kUsage,
         "did you mean \"move\"?");
  expect({"graph", "dot", pack, "other"}, 0, "digraph \"other\"");
  // What is wrong leaves nothing.
  expect({"cook", "--graph", in("none.toml"), "-o", in("x.mrw")}, kIo, "none.toml");
  expect({"cook", "--graph", in("move.anim.toml"), "-o", in("x.bin")}, kUsage, ".mrw");
  expect({"cook", "--graph", in("move.anim.toml"), "--as", "fit", "-o", in("x.mrw")}, kUsage, "graphs without a model");
  expect({"cook", "-o", in("x.mrw")}, kUsage, "inputs is required");
  expect({"cook", "--graph", in("move.anim.toml"), "-o", in("move.anim.toml")}, kUsage, "move.anim.toml");
  for (const std::string& name : folder().listing()) EXPECT_NE(name.substr(0, 2), "x.") << name;
  // A pack has no character in it.
  expect({"info", pack}, 0, "graph \"move\"");
  expect({"diff", pack, pack}, 0);
  expect({"pose", pack, "-o", in("x.bin")}, kInvalid, "no mesh");
  expect({"render", pack, "--graph", "move", "--trace", in("p.json")}, kUsage, "wants a clip");
}

TEST_F(GraphTest, IsListedByInfo) {
  const std::string file = in("listed.mrw");
  write_text(in("far.anim.toml"), std::string(kText) + "[node.unused]\ntype = \"clip\"\nclip = \"walk\"\n");
  write_text(in("two.anim.toml"), "output = \"elsewhere\"\n");
  expect({"cook", newt_glb(), "-o", file, "--graph", in("far.anim.toml"), "--graph", in("two.anim.toml")}, 0);
  const json info = json::parse(expect({"info", file, "--json"}, 0).out);
  const json& graph = info["graphs"][0];
  EXPECT_EQ(graph["name"], "far");
  EXPECT_EQ(graph["nodes"], 6);
  const json speed = {{"name", "speed"}, {"type", "number"}, {"range", {0.0, 2.0}}, {"initial", 0.0}};
  for (const auto& [key, value] : speed.items()) EXPECT_EQ(graph["parameters"][0][key], value) << key;
  EXPECT_FLOAT_EQ(graph["parameters"][0]["half_life_s"].get<float>(), 0.1f);
  EXPECT_EQ(graph["parameters"][1], json({{"name", "go"}, {"type", "flag"}, {"initial", false}}));
  EXPECT_EQ(graph["parameters"][2]["type"], "trigger");
  std::set<std::string> clips;
  for (const json& clip : graph["clips"]) {
    clips.insert(clip["name"]);
    EXPECT_TRUE(clip["in_file"].get<bool>());
  }
  EXPECT_EQ(clips, (std::set<std::string>{"idle", "walk", "twist"}));
  EXPECT_EQ(info["graphs"][1]["clips"][0], json({{"name", "elsewhere"}, {"in_file", false}}));
  std::size_t sum = 0;
  for (const auto& [name, bytes] : info["totals"].items()) sum += bytes.get<std::size_t>();
  EXPECT_EQ(sum, info["bytes"].get<std::size_t>());
  const std::string text = expect({"info", file}, 0).out;
  for (const char* const part : {"graph \"far\": ", "speed  number from 0 to 2, 0 at first, half of the way in 0.1 s",
                                 "hop    trigger, waits 0.5 s", "clips of other files: elsewhere"})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
}

#ifdef MARROW_HAS_GLES
class ActingTest : public GraphTest {
 protected:
  static json trace(const std::string& script, const std::vector<std::string>& more = {}) {
    write_text(in("in.txt"), script);
    std::vector<std::string> arguments = {"render",   in("newt.mrw"), "--graph", in("move.anim.toml"),
                                          "--script", in("in.txt"),   "--trace", in("t.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect(arguments, 0);
    return json::parse(read_text(in("t.json")));
  }
};

TEST_F(ActingTest, TracesWhatHappens) {
  const json t = trace("1 go true\n0 speed 0.377\n4 go false\n4.5 hop\n", {"--fps", "10"});
  EXPECT_EQ(t["graph"], "move");
  ASSERT_EQ(t["frames"].size(), 66u) << "until 2 s after the last line";
  std::map<std::string, int> steps;
  for (const json& frame : t["frames"]) {
    const double time_s = frame["time_s"];
    const std::string state = frame["states"]["body"]["state"];
    EXPECT_EQ(state, time_s <= 1.05 ? "still" : time_s <= 4.05 ? "goes" : time_s <= 4.55 ? "still" : "hops") << time_s;
    EXPECT_EQ(frame["parameters"]["go"], time_s > 1.05 && time_s <= 4.05) << time_s;
    // It goes from 1 s to 4 s, at the walk's speed, which the parameter has: along z.
    const double way = std::clamp(time_s - 1, 0.0, 3.0) * 0.377;
    EXPECT_NEAR(frame["root"]["place_m"][2].get<double>(), way, 0.01) << time_s;
    EXPECT_NEAR(frame["root"]["place_m"][0].get<double>(), 0, 0.01) << time_s;
    double shown = 0;
    for (const json& node : frame["shown"])
      if (node.contains("clip")) shown += node["weight"].get<double>();
    EXPECT_NEAR(shown, 1, 1e-5) << time_s;
    for (const json& e : frame["events"]) {
      EXPECT_LE(e["at_s"].get<double>(), time_s + 1e-6);
      EXPECT_GE(e["at_s"].get<double>(), time_s - 0.1001);
      if (time_s > 1.05 && time_s <= 4.05) ++steps[e["name"]];
    }
  }
  // A walk of 1.2 s for 3 s: two and a half rounds, each foot comes down once in each.
  EXPECT_NEAR(steps["left_foot"], 2.5, 0.6);
  EXPECT_NEAR(steps["right_foot"], 2.5, 0.6);
}

// What happens does not depend on the frames that are asked for.
TEST_F(ActingTest, IsTheSameAtAnyFrameRate) {
  const std::string script = "0.333 go true\n0 speed 0.3\n1.777 hop\n";
  const json slow = trace(script, {"--fps", "5"}), fast = trace(script, {"--fps", "60"});
  for (std::size_t i = 0; i < slow["frames"].size(); ++i) {
    const json &a = slow["frames"][i], &b = fast["frames"][12 * i];
    EXPECT_EQ(a["states"]["body"]["state"], b["states"]["body"]["state"]) << i;
    EXPECT_NEAR(a["root"]["place_m"][2].get<double>(), b["root"]["place_m"][2].get<double>(), 1e-5) << i;
  }
}

TEST_F(ActingTest, DrawsPicturesStripsAndMovies) {
  write_text(in("walk.txt"), "0 go true\n0 speed 0.377\n");
  const std::vector<std::string> base = {"render",   in("newt.mrw"), "--graph", in("move.anim.toml"),
                                         "--script", in("walk.txt")};
  const auto draw = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments = base;
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"-o", in(name)});
    expect(arguments, 0);
    return read_text(in(name));
  };
  const std::string early = draw("a.png", {"--time", "0.5", "--size", "64x64"}),
                    again = draw("b.png", {"--time", "0.5", "--size", "64x64"});
  EXPECT_EQ(early, again);
  EXPECT_NE(early, draw("c.png", {"--time", "2", "--size", "64x64"}));
  EXPECT_NE(draw("d.png", {"--time", "2", "--size", "64x64", "--camera", "stand"}),
            draw("e.png", {"--time", "2", "--size", "64x64", "--camera", "follow"}));
  // Two rows of four, with two pixels between them.
  const std::string film = draw("f.png", {"--film", "9", "--size", "20x10", "--seconds", "2"});
  const auto number = [&](std::size_t at) {
    return static_cast<unsigned>(static_cast<unsigned char>(film[at + 2]) << 8 |
                                 static_cast<unsigned char>(film[at + 3]));
  };
  EXPECT_EQ(number(16), 5 * 22u - 2);
  EXPECT_EQ(number(20), 2 * 12u - 2);
  draw("movie.png", {"--movie", "--size", "48x48", "--fps", "4", "--seconds", "1"});
  draw("clip.png", {"--movie", "--turn", "90", "--size", "48x48", "--fps", "4", "--time", "1"});
  // A model is cooked on the way, and without an output nothing is drawn.
  expect({"render", newt_glb(), "--graph", in("move.anim.toml"), "--time", "0.2", "--size", "32x32", "-o", in("m.png")},
         0);
  expect({"render", newt_glb(), "--clip", "walk", "-o", in("m.png")}, kInvalid, "cook it first");
}

TEST_F(ActingTest, RefusesWhatMakesNoSense) {
  const auto refused = [&](std::vector<std::string> more, const std::string& words, int code = kUsage) {
    std::vector<std::string> arguments = {"render", in("newt.mrw"), "-o", in("no.png")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect(arguments, code, words);
  };
  const std::string graph = in("move.anim.toml");
  write_text(in("bad.txt"), "0 speed 1\n1 sped 2\n");
  refused({"--graph", graph, "--script", in("bad.txt")}, "bad.txt: 2:3: there is no parameter \"sped\"");
  refused({"--graph", graph, "--clip", "walk"}, "--clip");
  refused({"--graph", graph, "--ik", "hand.L=0,1,0"}, "--ik");
  refused({"--graph", graph, "--path", "crowd"}, "--path crowd");
  refused({"--graph", graph, "--camera", "sit"}, "--camera");
  refused({"--graph", graph, "--seconds", "-1"}, "--seconds");
  refused({"--graph", graph, "--film", "3", "--movie"}, "--film");
  refused({"--graph", graph, "--film", "64", "--size", "8000x8000"}, "pixels in all are too many");
  refused({"--graph", graph, "--trace", in("t.txt")}, ".json");
  refused({"--graph", graph, "--trace", in("no/such/t.json")}, "t.json", kIo);
  refused({"--graph", graph, "--clips", in("newt.mrw")}, "not a clip pack", kInvalid);
  refused({"--graph"}, "no graph");
  refused({"--script", in("bad.txt")}, "--graph");
  refused({"--clips", in("a.mrw"), "--clips", in("b.mrw"), "--clip", "walk"}, "several packs");
  expect({"render", in("newt.mrw")}, kUsage, "--output is required");
  for (const std::string& name : folder().listing()) EXPECT_NE(name, "no.png");
}
#endif

}  // namespace
}  // namespace marrow::test
