// The commands one after the other, as a newcomer types them: cook, info, pose, render.
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "road/reference.h"
#include "support/places.h"

namespace marrow::test {
namespace {

class CliRoad : public ::testing::Test {
 protected:
  CliRoad() {
    const Ran cooked = run_marrow({"cook", tiny_gltf(), "-o", mrw(), "--keep-vertex-order", "--clip-codec", "raw"});
    EXPECT_EQ(cooked.code, 0) << cooked.err;
    EXPECT_TRUE(cooked.complaints().empty()) << cooked.err;
    EXPECT_NE(cooked.out.find("2 clips"), std::string::npos) << cooked.out;
  }
  std::string mrw() const { return folder_ / "tiny.mrw"; }
  // Runs `marrow pose` with more arguments and returns what it wrote.
  std::string pose(const std::string& name, std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"pose", mrw(), "-o", folder_ / name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return read_text(folder_ / name);
  }
  TemporaryFolder folder_;
};

std::vector<Vec3> floats_of(const std::string& bytes) {
  std::vector<Vec3> out(bytes.size() / 12);
  for (std::size_t i = 0; i < out.size(); ++i) {
    float xyz[3];
    std::memcpy(xyz, bytes.data() + i * 12, 12);
    out[i] = {static_cast<double>(xyz[0]), static_cast<double>(xyz[1]), static_cast<double>(xyz[2])};
  }
  return out;
}

double worst_error(const std::vector<Vec3>& got, const std::vector<Vec3>& want) {
  if (got.size() != want.size()) return 1e300;
  double worst = 0;
  for (std::size_t i = 0; i < got.size(); ++i) worst = std::max(worst, length(minus(got[i], want[i])));
  return worst;
}

TEST_F(CliRoad, CookIsQuietAboutAGoodFileAndLeavesNothingElse) {
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"tiny.mrw"});
}

TEST_F(CliRoad, CookingAgainGivesTheSameBytes) {
  const std::string first = read_text(mrw());
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", mrw(), "--keep-vertex-order", "--clip-codec", "raw"}).code, 0);
  EXPECT_TRUE(read_text(mrw()) == first);
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", mrw(), "--keep-vertex-order", "--clip-codec", "raw", "--mesh-codec",
                        "none"})
                .code,
            0);
  EXPECT_TRUE(read_text(mrw()) == read_text(in_golden("tiny_v1.mrw")));
}

TEST_F(CliRoad, InfoSaysWhatIsInside) {
  const Ran text = run_marrow({"info", mrw()});
  EXPECT_EQ(text.code, 0);
  EXPECT_EQ(text.err, "");
  for (const char* word : {"arm", "hat", "wave", "point", "cycles of a Mali-G57"})
    EXPECT_NE(text.out.find(word), std::string::npos) << word;
  const Ran json = run_marrow({"info", mrw(), "--json"});
  ASSERT_EQ(json.code, 0);
  const auto j = nlohmann::json::parse(json.out);
  EXPECT_EQ(j.at("bytes"), read_text(mrw()).size());
  EXPECT_EQ(j.at("skeletons").at(0).at("joints"), 3);
  EXPECT_EQ(j.at("meshes").at(0).at("vertices"), 24);
  EXPECT_EQ(j.at("meshes").at(1).at("triangles"), 4);
  // The surface's own normals cost more than the blend's.
  const nlohmann::json& gpu = j.at("meshes").at(0).at("gpu");
  for (const char* const figure : {"mali_cycles", "adreno_instructions", "videocore_instructions"})
    EXPECT_GT(gpu.at("as").at(figure), gpu.at("ssd").at(figure)) << figure;
  EXPECT_EQ(j.at("clips").at(0).at("name"), "wave");
  EXPECT_EQ(j.at("clips").at(0).at("duration_s"), 1.25);
}

TEST_F(CliRoad, PoseWritesWhatTheReferenceSays) {
  const Reference reference(tiny_gltf());
  const double most = 1e-4 * reference.diagonal();
  EXPECT_LT(worst_error(floats_of(pose("rest.bin", {})), reference.rest().positions), most);
  int cases = 0;
  for (const char* time : {"0", "0.25", "0.5", "0.75", "1.25", "7"}) {
    const ReferencePose want = reference.at(0, std::stod(time));
    for (const char* deformer : {"ssd", "as"}) {
      const std::string got = pose("p.bin", {"--clip", "wave", "--time", time, "--deformer", deformer});
      EXPECT_LT(worst_error(floats_of(got), want.positions), most) << time << ' ' << deformer;
      ++cases;
    }
    const std::vector<Vec3> rigid = floats_of(pose("p.bin", {"--clip", "wave", "--time", time, "--deformer", "rigid"}));
    ASSERT_EQ(rigid.size(), want.rigid.size());
    for (std::size_t v = 0; v < rigid.size(); ++v) {
      if (!want.rigid_unique[v]) continue;
      EXPECT_LT(length(minus(rigid[v], want.rigid[v])), most) << v;
    }
  }
  EXPECT_EQ(cases, 12);
}

TEST_F(CliRoad, InfoTellsCodedClipsFromRawOnes) {
  const std::string dance = in_golden("dance_v1.mrw");
  EXPECT_NE(run_marrow({"info", dance}).out.find("12 tracks, segments, reaches "), std::string::npos);
  EXPECT_NE(run_marrow({"info", mrw()}).out.find("tracks, raw, reaches "), std::string::npos);
}

TEST_F(CliRoad, ClipsGoByNameAndByIndex) {
  EXPECT_EQ(pose("a.bin", {"--clip", "point"}), pose("b.bin", {"--clip", "1"}));
  EXPECT_NE(pose("a.bin", {"--clip", "point"}), pose("b.bin", {}));
}

TEST_F(CliRoad, ObjHoldsTheSameVerticesAndAllTriangles) {
  const std::vector<Vec3> want = floats_of(pose("p.bin", {"--clip", "wave", "--time", "0.7"}));
  std::istringstream obj(pose("p.obj", {"--clip", "wave", "--time", "0.7"}));
  std::vector<Vec3> vertices;
  std::size_t faces = 0;
  for (std::string line; std::getline(obj, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vec3 v{};
      ASSERT_TRUE(words >> v[0] >> v[1] >> v[2]) << line;
      vertices.push_back(v);
    } else if (kind == "f") {
      std::size_t corners = 0;
      for (std::string corner; words >> corner; ++corners) {
        const unsigned long vertex = std::stoul(corner);
        EXPECT_TRUE(vertex >= 1 && vertex <= vertices.size()) << line;
      }
      EXPECT_EQ(corners, 3u);
      ++faces;
    }
  }
  EXPECT_EQ(faces, 44u);
  EXPECT_LT(worst_error(vertices, want), 1e-6);
}

TEST_F(CliRoad, WithoutTheKeptOrderAllVerticesAreStillThere) {
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", mrw()}).code, 0);
  EXPECT_EQ(pose("p.bin", {}).size(), 29u * 12);
}

#ifdef MARROW_HAS_GLES
// Width and height in a PNG's header, or zeros if it is none.
std::pair<unsigned, unsigned> png_size(const std::string& png) {
  if (png.size() < 24 || png.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) return {0, 0};
  const auto number = [&](std::size_t at) {
    unsigned n = 0;
    for (std::size_t i = at; i < at + 4; ++i) n = n << 8 | static_cast<unsigned char>(png[i]);
    return n;
  };
  return {number(16), number(20)};
}

TEST_F(CliRoad, RenderWritesAPicture) {
  const std::vector<std::string> common = {"render", mrw(), "--clip", "wave", "--time", "0.5", "--size", "96x64", "-o"};
  const std::vector<std::vector<std::string>> variants = {
      {"--path", "cpu", "--deformer", "ssd"},      {"--path", "cpu", "--deformer", "as"},
      {"--path", "cpu", "--deformer", "rigid"},    {"--path", "ubo", "--deformer", "ssd"},
      {"--path", "ubo", "--deformer", "as"},       {"--heatmap", "ssd:as"},
      {"--normals", "blended", "--deformer", "as"}};
  std::size_t pictures = 0;
  for (const auto& variant : variants) {
    const std::string png = folder_ / ("p" + std::to_string(pictures) + ".png");
    std::vector<std::string> arguments = common;
    arguments.push_back(png);
    arguments.insert(arguments.end(), variant.begin(), variant.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(png_size(read_text(png)), std::make_pair(96u, 64u)) << variant[1];
    ++pictures;
  }
  EXPECT_EQ(folder_.listing().size(), 1 + pictures);
}
#endif

}  // namespace
}  // namespace marrow::test
