// A mesh that `marrow cook --palette` splits is one again for whoever asks for the source's vertices.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

const std::string kNewt = newt_glb();

// Exit code. Clips stay raw: nothing here depends on them, and coding them takes most of the time.
int cook(const std::string& mrw, std::vector<std::string> options) {
  options.insert(options.begin(), {"cook", kNewt, "-o", mrw, "--clip-codec", "raw"});
  return run_marrow(options).code;
}

// Lines of a text that begin with this.
std::size_t lines(const std::string& text, const std::string& start) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
    count += text.compare(at, start.size(), start) == 0 ? 1u : 0u;
    if (text.find('\n', at) == std::string::npos) break;
  }
  return count;
}

TEST(SplitProgram, PosesInTheSourcesOrder) {
  const TemporaryFolder folder;
  for (const char* const entries : {"24", "32767"}) {
    const std::string mrw = folder / (std::string(entries) + ".mrw");
    ASSERT_EQ(cook(mrw, {"--keep-vertex-order", "--palette", entries}), 0);
    for (const char* const form : {".bin", ".obj"}) {
      const Ran ran =
          run_marrow({"pose", mrw, "--clip", "1", "--time", "0.4", "-o", folder / (entries + std::string(form))});
      ASSERT_EQ(ran.code, 0) << ran.err;
    }
  }
  const std::string parts = read_text(folder / "24.bin");
  EXPECT_GT(parts.size(), 12u * 8000);
  EXPECT_TRUE(parts == read_text(folder / "32767.bin"));
  const std::string a = read_text(folder / "24.obj"), b = read_text(folder / "32767.obj");
  for (const char* const start : {"o ", "v ", "vn ", "f "}) EXPECT_EQ(lines(a, start), lines(b, start)) << start;
  EXPECT_EQ(lines(a, "o "), 6u);

  const nlohmann::json info = nlohmann::json::parse(run_marrow({"info", "--json", folder / "24.mrw"}).out);
  EXPECT_EQ(info["meshes"].size(), 8u);
  EXPECT_EQ(info["meshes"][0]["next_part"], false);
  EXPECT_EQ(info["meshes"][1]["next_part"], true);
}

// Without the source's order vertices stand part by part, and triangles still find theirs.
TEST(SplitProgram, PosesInTheFilesOrder) {
  const TemporaryFolder folder;
  ASSERT_EQ(cook(folder / "n.mrw", {"--palette", "24", "--report", folder / "r.json"}), 0);
  ASSERT_EQ(run_marrow({"pose", folder / "n.mrw", "-o", folder / "n.obj"}).code, 0);
  const nlohmann::json report = nlohmann::json::parse(read_text(folder / "r.json"));
  std::size_t vertices = 0, triangles = 0;
  for (const auto& mesh : report["meshes"]) {
    vertices += mesh["vertices"].get<std::size_t>();
    triangles += mesh["triangles"].get<std::size_t>();
  }
  const std::string obj = read_text(folder / "n.obj");
  EXPECT_EQ(lines(obj, "v "), vertices);
  EXPECT_EQ(lines(obj, "f "), triangles);
  EXPECT_EQ(lines(obj, "o "), 6u);
  EXPECT_NE(obj.find(" " + std::to_string(vertices) + "//" + std::to_string(vertices)), std::string::npos)
      << "the last vertex has a triangle";
}

TEST(SplitProgram, TooSmallAPaletteIsRefused) {
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"cook", kNewt, "-o", folder / "n.mrw", "--palette", "23"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("--palette: \"23\" is out of range: give a number from 24 to 32767"), std::string::npos)
      << ran.err;
  EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace marrow::test
