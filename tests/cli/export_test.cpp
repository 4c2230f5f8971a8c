// `marrow export` and `marrow diff` as a user runs them: what comes back from a cooked file, and what two differ in.
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "road/reference.h"
#include "support/places.h"

namespace marrow::test {
namespace {

std::string golden(const char* name) {
  return in_golden(name);
}

nlohmann::json json_of(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  return nlohmann::json::parse(glb.substr(20, length));
}

// The same scene by the reference evaluator, which reads both files itself. Cooked with the order kept and raw clips,
// so only rounding is left.
TEST(CliExport, PosesAsItsSource) {
  const TemporaryFolder folder;
  int models = 0, poses = 0;
  for (const char* name : {"tiny.gltf", "dance.gltf"}) {
    ASSERT_EQ(run_marrow({"cook", golden(name), "-o", folder / "m.mrw", "--keep-vertex-order", "--clip-codec", "raw",
                          "--mesh-codec", "none"})
                  .code,
              0);
    const Ran ran = run_marrow({"export", folder / "m.mrw", "-o", folder / "m.glb"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out + ran.err, "");
    const Reference source(golden(name)), exported(folder / "m.glb");
    ASSERT_EQ(source.source().animations.size(), exported.source().animations.size());
    for (std::size_t a = 0; a < source.source().animations.size(); ++a) {
      EXPECT_FLOAT_EQ(static_cast<float>(exported.duration_s(a)), static_cast<float>(source.duration_s(a)));
      for (int i = 0; i < 16; ++i) {
        const double time_s = source.duration_s(a) * i / 15;
        const ReferencePose p = source.at(a, time_s), q = exported.at(a, time_s);
        ASSERT_EQ(p.positions.size(), q.positions.size());
        double worst = 0;
        for (std::size_t v = 0; v < p.positions.size(); ++v)
          worst = std::max(worst, length(minus(p.positions[v], q.positions[v])));
        EXPECT_LT(worst, 1e-5 * source.diagonal()) << name << ' ' << time_s;
        ++poses;
      }
    }
    ++models;
  }
  EXPECT_EQ(models, 2);
  EXPECT_GE(poses, 3 * 16);
}

TEST(CliExport, GivesTheSameBytesTwice) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_marrow({"export", golden("dance_v1.mrw"), "-o", folder / "a.glb"}).code, 0);
  ASSERT_EQ(run_marrow({"export", golden("dance_v1.mrw"), "-o", folder / "b.glb"}).code, 0);
  EXPECT_EQ(read_text(folder / "a.glb"), read_text(folder / "b.glb"));
  EXPECT_EQ(folder.listing().size(), 2u);
}

// Numbers that move no joint come back under their names, when the export is cooked again.
TEST(CliExport, KeepsChannels) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_marrow({"export", golden("face_v1.mrw"), "-o", folder / "f.glb"}).code, 0);
  const Ran again = run_marrow({"cook", folder / "f.glb", "-o", folder / "f.mrw", "--json"});
  ASSERT_EQ(again.code, 0) << again.err;
  const auto names = [](const nlohmann::json& clips) {
    std::multiset<std::string> out;
    for (const auto& clip : clips)
      for (const auto& channel : clip.at("channels")) out.insert(channel.get<std::string>());
    return out;
  };
  const auto before = nlohmann::json::parse(run_marrow({"info", golden("face_v1.mrw"), "--json"}).out);
  EXPECT_EQ(names(nlohmann::json::parse(again.out).at("clips")), names(before.at("clips")));
  EXPECT_GE(names(before.at("clips")).size(), 7u);
}

TEST(CliExport, SaysThatAClipIsAdditive) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "--additive", "wave=rest", "-o", folder / "t.mrw"}).code, 0);
  ASSERT_EQ(run_marrow({"export", folder / "t.mrw", "-o", folder / "t.glb"}).code, 0);
  const nlohmann::json json = json_of(read_text(folder / "t.glb"));
  EXPECT_EQ(json.at("animations").at(0).at("extras").at("additive"), "rest");
  EXPECT_FALSE(json.at("animations").at(1).contains("extras"));
}

TEST(CliExport, FailuresLeaveNothing) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_marrow({"export", folder / "absent.mrw", "-o", folder / "x.glb"}).code, 2);
  EXPECT_EQ(run_marrow({"export", tiny_gltf(), "-o", folder / "x.glb"}).code, 3);
  EXPECT_EQ(run_marrow({"export", golden("tiny_v1.mrw"), "-o", folder / "no/such/x.glb"}).code, 2);
  EXPECT_EQ(run_marrow({"export", golden("tiny_v1.mrw")}).code, 1);
  EXPECT_TRUE(folder.listing().empty());
}

TEST(CliDiff, EqualFiles) {
  const Ran ran = run_marrow({"diff", golden("tiny_v1.mrw"), golden("tiny_v1.mrw")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out + ran.err, "");
  const auto json =
      nlohmann::json::parse(run_marrow({"diff", golden("tiny_v1.mrw"), golden("tiny_v1.mrw"), "--json"}).out);
  EXPECT_EQ(json.at("equal"), true);
  EXPECT_TRUE(json.at("differences").empty());
}

// A source with one thing changed: a joint's name, its place, a vertex's material, a clip.
TEST(CliDiff, FindsWhatWasChanged) {
  const TemporaryFolder folder;
  const auto cook = [&](nlohmann::json gltf, const char* name) {
    write_text(folder / "s.gltf", gltf.dump());
    EXPECT_EQ(run_marrow({"cook", folder / "s.gltf", "-o", folder / name, "--clip-codec", "raw"}).code, 0);
  };
  const nlohmann::json source = nlohmann::json::parse(read_text(tiny_gltf()));
  cook(source, "a.mrw");
  nlohmann::json changed = source;
  const std::size_t joint = source.at("skins").at(0).at("joints").at(1);
  const std::string old = source["nodes"][joint].value("name", "");
  changed["nodes"][joint]["name"] = "elbow of another name";
  changed["animations"][0]["name"] = "greeting";
  cook(changed, "b.mrw");
  const Ran ran = run_marrow({"diff", folder / "a.mrw", folder / "b.mrw", "--json"});
  EXPECT_EQ(ran.code, 6) << ran.err;
  std::set<std::string> kinds;
  const nlohmann::json found = nlohmann::json::parse(ran.out);
  for (const auto& d : found.at("differences")) kinds.insert(d.at("kind"));
  EXPECT_EQ(kinds, (std::set<std::string>{"section", "joint-renamed", "removed", "added"})) << ran.out;
  EXPECT_NE(ran.out.find("\\\"" + old + "\\\" is now"), std::string::npos) << ran.out;
  EXPECT_EQ(run_marrow({"diff", folder / "a.mrw", folder / "absent.mrw"}).code, 2);
  EXPECT_EQ(run_marrow({"diff", folder / "a.mrw"}).code, 1);
}

// One joint moved by a quarter of its unit, below a node that scales by 2: half a metre.
TEST(CliDiff, MeasuresHowFarPosesAre) {
  const TemporaryFolder folder;
  nlohmann::json gltf = nlohmann::json::parse(read_text(tiny_gltf()));
  const std::size_t root = gltf.at("skins").at(0).at("joints").at(0);
  write_text(folder / "a.gltf", gltf.dump());
  auto& at = gltf["nodes"][root];
  if (!at.contains("translation")) at["translation"] = {0, 0, 0};
  at["translation"][1] = at["translation"][1].get<double>() + 0.25;
  write_text(folder / "b.gltf", gltf.dump());
  for (const std::string name : {"a", "b"})
    ASSERT_EQ(
        run_marrow({"cook", folder / (name + ".gltf"), "-o", folder / (name + ".mrw"), "--clip-codec", "raw"}).code, 0);
  const Ran ran = run_marrow({"diff", folder / "a.mrw", folder / "b.mrw", "--json"});
  ASSERT_EQ(ran.code, 6);
  int rest = 0;
  const nlohmann::json found = nlohmann::json::parse(ran.out);
  for (const auto& d : found.at("differences"))
    if (d.at("kind") == "rest-moved") {
      EXPECT_NEAR(d.at("distance_m").get<double>(), 0.5, 1e-6);
      ++rest;
    }
  EXPECT_EQ(rest, 1) << ran.out;
}

}  // namespace
}  // namespace marrow::test
