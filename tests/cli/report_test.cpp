// What `marrow cook --report` holds.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/process.h"

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
  EXPECT_EQ(types, "SKEL CLIP CLIP GEOM GEOM MESH MESH NAME ");
  EXPECT_LT(sum, bytes);
  EXPECT_GT(sum + 16 * 9 + 32 + 16 * 8, bytes) << "the rest is header, table and padding";

  ASSERT_EQ(r.at("skeletons").size(), 1u);
  EXPECT_EQ(r["skeletons"][0].at("joints"), 3);
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
  for (const auto& clip : r["clips"])
    for (const char* field : {"raw_bytes", "bytes", "max_error_m"}) EXPECT_TRUE(clip.at(field).is_number()) << field;
  ASSERT_EQ(r.at("warnings").size(), 1u);
  EXPECT_EQ(r["warnings"][0].at("pointer"), "/meshes/1/primitives/0");
  EXPECT_EQ(r["warnings"][0].at("rule"), "normals-generated");
  EXPECT_GT(r["warnings"][0].at("text").get<std::string>().size(), 10u);
}

// The report and `marrow info` list a clip's channels.
TEST(Report, Channels) {
  const TemporaryFolder folder;
  const std::string face = std::string(MARROW_SOURCE_DIR) + "/tests/golden/face.gltf";
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

TEST(Report, OnStdoutIsTheSame) {
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw", "--report", folder / "r.json", "--json"});
  ASSERT_EQ(ran.code, 0);
  EXPECT_EQ(nlohmann::json::parse(ran.out), nlohmann::json::parse(read_text(folder / "r.json")));
}

// The warning stands on stderr too, located.
TEST(Report, WarningsAreSaid) {
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder / "t.mrw"});
  EXPECT_NE(ran.err.find(tiny_gltf() + ": /meshes/1/primitives/0: warning: normals-generated: "), std::string::npos)
      << ran.err;
}

}  // namespace
}  // namespace marrow::test
