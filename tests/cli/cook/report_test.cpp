// What `marrow cook --report` holds.
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

TEST(Report, HoldsEveryField) {
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--report", folder / "r.json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(folder.listing(), (std::vector<std::string>{"r.json", "t.mrw"}));
  const nlohmann::json r = nlohmann::json::parse(read_text(folder / "r.json"));
  EXPECT_EQ(r.at("source").at("file"), tiny_gltf());
  EXPECT_EQ(r.at("source").at("bytes"), read_text(tiny_gltf()).size());

  const std::size_t bytes = read_text(folder / "t.mrw").size();
  EXPECT_EQ(r.at("output").at("bytes"), bytes);
  std::size_t sum = 0;
  std::string types;
  for (const auto& section : r.at("output").at("sections")) {
    sum += section.at("bytes").get<std::size_t>();
    types += section.at("type").get<std::string>() + " ";
  }
  EXPECT_EQ(types, "SKEL CLIP CLIP GEOM GEOM MESH MESH MOTN BNDS NAME ");
  EXPECT_LT(sum, bytes);
  EXPECT_GT(sum + 16 * 9 + 32 + 16 * 8, bytes) << "the rest is header, table and padding";

  ASSERT_EQ(r.at("skeletons").size(), 1u);
  EXPECT_EQ(r["skeletons"][0].at("joints"), 3);
  for (const char* const count : {"joints", "pairs", "soles", "doubted"})
    EXPECT_EQ(r["skeletons"][0].at("roles").at(count), 0) << count;
  EXPECT_TRUE(r["skeletons"][0].at("name").is_string());
  ASSERT_EQ(r.at("meshes").size(), 2u);
  const struct {
    const char* name;
    int vertices, triangles, influences;
  } meshes[] = {{"arm", 24, 40, 3}, {"hat", 5, 4, 1}};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& mesh = r["meshes"][i];
    EXPECT_EQ(mesh.at("name"), meshes[i].name);
    EXPECT_EQ(mesh.at("vertices"), meshes[i].vertices);
    EXPECT_EQ(mesh.at("triangles"), meshes[i].triangles);
    EXPECT_EQ(mesh.at("influences"), meshes[i].influences);
    EXPECT_TRUE(mesh.at("codec").is_string());
    EXPECT_GT(mesh.at("bytes"), 0);
    EXPECT_GE(mesh.at("max_position_error_m"), 0);
  }
  ASSERT_EQ(r.at("clips").size(), 2u);
  EXPECT_EQ(r["clips"][0].at("name"), "wave");
  EXPECT_EQ(r["clips"][0].at("duration_s"), 1.25);
  for (const auto& clip : r["clips"]) {
    for (const char* field : {"raw_bytes", "bytes", "max_error_m", "max_vertex_error_m"})
      EXPECT_TRUE(clip.at(field).is_number()) << field;
    EXPECT_NEAR(clip.at("ratio").get<double>() * clip.at("raw_bytes").get<double>(), clip.at("bytes").get<double>(),
                0.01);
  }
  EXPECT_EQ(r.at("warnings").size(), 0u);
}

// By hand: an edge of the arm or of the hat becomes two, a triangle four.
TEST(Report, SubdividedMeshes) {
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--subdivide", "2", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json meshes = nlohmann::json::parse(ran.out).at("meshes");
  EXPECT_EQ(meshes.at(0).at("source_triangles"), 40);
  EXPECT_EQ(meshes.at(0).at("triangles"), 640);
  EXPECT_EQ(meshes.at(1).at("source_triangles"), 4);
  EXPECT_EQ(meshes.at(1).at("triangles"), 64);
  const Ran none = run_marrow(
      {"cook", tiny_gltf(), "-o", folder / "t.mrw", "--subdivide", "0", "--mwe", "--truth", "dqs", "--json"});
  ASSERT_EQ(none.code, 0) << none.err;
  EXPECT_FALSE(nlohmann::json::parse(none.out).at("meshes").at(0).contains("source_triangles"));
}

// Mistakes are located, in settings too.
TEST(Report, SubdividedMeshesHaveNoOtherDeformers) {
  const TemporaryFolder folder;
  write_text(folder / "s.toml", "mwe = true\ntruth = 'dqs'\n\nsubdivide = '1'\n");
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--settings", folder / "s.toml"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("s.toml: 4:13: --subdivide with --mwe: "), std::string::npos) << ran.err;
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"s.toml"});
}

// The report and `marrow info` list a clip's channels.
TEST(Report, Channels) {
  const TemporaryFolder folder;
  const std::string face = in_golden("face.gltf");
  const Ran cooked = run_marrow({"cook", face, "-o", folder / "f.mrw", "--json"});
  ASSERT_EQ(cooked.code, 0) << cooked.err;
  const nlohmann::json names = {"nodes[2].weights[0]", "nodes[2].weights[1]", "head.bells[1]", "face.smile",
                                "face.blink",          "head.glow",           "mood"};
  EXPECT_EQ(nlohmann::json::parse(cooked.out).at("clips").at(0).at("channels"), names);
  EXPECT_EQ(
      nlohmann::json::parse(run_marrow({"info", folder / "f.mrw", "--json"}).out).at("clips").at(0).at("channels"),
      names);
  const Ran text = run_marrow({"info", folder / "f.mrw"});
  for (const auto& name : names)
    EXPECT_NE(text.out.find("channel \"" + name.get<std::string>() + "\""), std::string::npos) << text.out;
}

// `--additive` is in the report and in `marrow info`; ordinary clips stay as they are.
TEST(Report, AdditiveClips) {
  const TemporaryFolder folder;
  const Ran cooked = run_marrow({"cook", tiny_gltf(), "--additive", "wa*=point", "-o", folder / "t.mrw", "--json"});
  ASSERT_EQ(cooked.code, 0) << cooked.err;
  const nlohmann::json report = nlohmann::json::parse(cooked.out);
  EXPECT_EQ(report.at("clips").at(0).at("additive"), "point");
  EXPECT_TRUE(report.at("clips").at(1).at("additive").is_null());
  const nlohmann::json info = nlohmann::json::parse(run_marrow({"info", folder / "t.mrw", "--json"}).out);
  EXPECT_EQ(info.at("clips").at(0).at("additive"), true);
  EXPECT_EQ(info.at("clips").at(0).at("reference"), "own");
  EXPECT_EQ(info.at("clips").at(1).at("additive"), false);
  EXPECT_NE(run_marrow({"info", folder / "t.mrw"}).out.find(", additive over a reference of its own"),
            std::string::npos);
}

// Laid on its reference, which is what `marrow pose` shows of it, an additive clip is the clip that it was made from.
TEST(Report, AnAdditiveClipOnItsReferenceIsTheClip) {
  const TemporaryFolder folder;
  int compared = 0;
  for (const std::string reference : {"", "=rest", "=point", "=first"}) {
    std::vector<std::string> cook = {"cook", tiny_gltf(), "--keep-vertex-order", "-o", folder / "a.mrw"};
    ASSERT_EQ(run_marrow(cook).code, 0);
    cook.back() = folder / "b.mrw";
    cook.insert(cook.end(), {"--additive", "wave" + reference, "--additive", "point=rest"});
    ASSERT_EQ(run_marrow(cook).code, 0);
    std::string bytes[2];
    for (const int i : {0, 1}) {
      const std::string name = i == 0 ? "a" : "b";
      ASSERT_EQ(run_marrow({"pose", folder / (name + ".mrw"), "--clip", "wave", "--time", "0.4", "-o",
                            folder / (name + ".bin")})
                    .code,
                0);
      bytes[i] = read_text(folder / (name + ".bin"));
    }
    ASSERT_EQ(bytes[0].size(), bytes[1].size());
    for (std::size_t at = 0; at < bytes[0].size(); at += 4, ++compared) {
      float a = 0, b = 0;
      std::memcpy(&a, &bytes[0][at], 4);
      std::memcpy(&b, &bytes[1][at], 4);
      ASSERT_NEAR(a, b, 1e-5f) << reference;
    }
  }
  EXPECT_GT(compared, 4 * 3 * 24);
}

TEST(Report, AdditiveMistakes) {
  const TemporaryFolder folder;
  int refused = 0;
  for (const char* rule : {"none", "wave=none", "=rest", "wave=", "w?"}) {
    const Ran ran = run_marrow({"cook", tiny_gltf(), "--additive", rule, "-o", folder / "t.mrw"});
    refused += ran.code == 1 && ran.complaints().size() == 1 && ran.err.find("--additive: ") != std::string::npos;
  }
  EXPECT_EQ(refused, 5);
  EXPECT_TRUE(folder.listing().empty());
}

TEST(Report, OnStdoutIsTheSame) {
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--report", folder / "r.json", "--json"});
  ASSERT_EQ(ran.code, 0);
  EXPECT_EQ(nlohmann::json::parse(ran.out), nlohmann::json::parse(read_text(folder / "r.json")));
}

// In the report, and the first of each rule on stderr too, located.
TEST(Report, WarningsAreSaid) {
  const TemporaryFolder folder;
  const std::string looks = in_golden("looks.gltf");
  const Ran ran = run_marrow({"cook", looks, "-o", folder / "t.mrw", "--report", folder / "r.json"});
  const nlohmann::json r = nlohmann::json::parse(read_text(folder / "r.json"));
  ASSERT_EQ(r.at("warnings").size(), 4u);
  for (const auto& warning : r["warnings"]) EXPECT_GT(warning.at("text").get<std::string>().size(), 10u);
  for (const auto& [i, end] : {std::pair(0u, " (1 of 3; --report lists all)\n"), std::pair(3u, "\n")}) {
    const std::string where = r["warnings"][i].at("pointer"), rule = r["warnings"][i].at("rule"),
                      text = r["warnings"][i].at("text");
    EXPECT_NE(ran.err.find(looks + ": " + where + ": warning: " + rule + ": " + text + end), std::string::npos)
        << ran.err;
  }
  EXPECT_EQ(r["warnings"][0].at("pointer"), "/meshes/0/primitives/0/attributes/TEXCOORD_0");
  EXPECT_EQ(r["warnings"][0].at("rule"), "extra-uvs-dropped");
}

// One line a rule on stderr, all of them in the report.
TEST(Report, WarningsOfOneRuleAreOneLine) {
  const TemporaryFolder folder;
  const std::string gltf = folder / "t.gltf";
  write_triangle(gltf, folder / "t.bin", 1);
  std::string extensions;
  for (int i = 0; i < 50; ++i) extensions += (i > 0 ? ",\"EXT_" : "\"EXT_") + std::to_string(i) + '"';
  write_text(gltf, "{\"extensionsUsed\":[" + extensions + "]," + read_text(gltf).substr(1));
  const Ran ran = run_marrow({"cook", gltf, "-o", folder / "t.mrw", "--report", folder / "r.json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, gltf +
                         ": /extensionsUsed/0: warning: extension-ignored: EXT_0 is optional and left out "
                         "(1 of 50; --report lists all)\n");
  EXPECT_EQ(nlohmann::json::parse(read_text(folder / "r.json")).at("warnings").size(), 50u);
}

}  // namespace
}  // namespace marrow::test
