// Weights that were painted vertex by vertex: what is read, what is refused and where, and where they go.
#include "cook/paint/paint_file.h"

#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

#include "cook/options/options.h"
#include "cook/paint/paint_weights.h"
#include "disk/cook_on_disk.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

namespace fs = std::filesystem;

std::string file_of(const std::string& meshes) {
  return R"({"paintedWeights": 1, "meshes": [)" + meshes + "]}";
}

std::string body(const std::string& vertices) {
  return R"({"name": "hero mesh", "joints": ["hips", "spine"], "vertices": [)" + vertices + "]}";
}

TEST(PaintFile, IsReadAsItIsWritten) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-10, 10);
  PaintedMesh mesh{"a \"name\" \\ with\nall", {"x", "y", "z"}, {}};
  for (int i = 0; i < 50; ++i)
    mesh.vertices.push_back({{any(random), any(random) * 1e-30f, any(random) * 1e20f},
                             {{0, 0.125}, {1, static_cast<double>(0.1f)}, {2, static_cast<double>(0.775f)}}});
  const std::vector<PaintedMesh> both = {mesh, {"other", {}, {}}};
  const std::string text = text_of_painted(both);
  const std::vector<PaintedMesh> read = read_painted("a.json", text);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].name, mesh.name);
  EXPECT_EQ(read[0].joints, mesh.joints);
  ASSERT_EQ(read[0].vertices.size(), 50u);
  for (std::size_t v = 0; v < 50; ++v) {
    EXPECT_EQ(read[0].vertices[v].place, mesh.vertices[v].place);
    ASSERT_EQ(read[0].vertices[v].influences.size(), 3u);
    EXPECT_EQ(static_cast<float>(read[0].vertices[v].influences[1].weight), 0.1f);
  }
  EXPECT_EQ(text_of_painted(read), text);
}

TEST(PaintFile, WeightsAreScaledToOne) {
  const auto read = read_painted("a.json", file_of(body("[0, 0, 0, 1, 0.7495, 0, 0.25]")));
  const auto& influences = read.at(0).vertices.at(0).influences;
  ASSERT_EQ(influences.size(), 2u);
  EXPECT_EQ(influences[0].joint, 0u) << "in order";
  EXPECT_NEAR(influences[0].weight, 0.25 / 0.9995, 1e-9);
  EXPECT_EQ(influences[0].weight + influences[1].weight, 1);
  EXPECT_EQ(read_painted("a.json", file_of(body("[0, 0, 0, 1, 1, 0, 0]"))).at(0).vertices.at(0).influences.size(), 1u);
}

TEST(PaintFile, WhatIsWrongIsSaidWithItsPlace) {
  struct Bad {
    std::string text, where, rule;
  };
  const Bad all[] = {
      {"", "", "no painted weights"},
      {"\x89PNG", "", "no painted weights"},
      {"[]", "", "no painted weights"},
      {"{\"paintedWeights\": 1", "@", "not JSON"},
      {"{\"meshes\": []}", "", "no \"paintedWeights\""},
      {R"({"paintedWeights": "1", "meshes": []})", "/paintedWeights", "not its version"},
      {R"({"paintedWeights": 2, "meshes": []})", "/paintedWeights", "version 2"},
      {R"({"paintedWeights": 1})", "", "no \"meshes\""},
      {R"({"paintedWeights": 1, "meshes": {}})", "/meshes", "not a list"},
      {file_of("7"), "/meshes/0", "no object"},
      {file_of(R"({"joints": [], "vertices": []})"), "/meshes/0", "no \"name\""},
      {file_of(R"({"name": 3, "joints": [], "vertices": []})"), "/meshes/0/name", "not a text"},
      {file_of(R"({"name": "a", "joints": [1], "vertices": []})"), "/meshes/0/joints/0", "not a text"},
      {file_of(R"({"name": "a", "joints": ["b", "b"], "vertices": []})"), "/meshes/0/joints/1", "joint named twice"},
      {file_of(body("3")), "/meshes/0/vertices/0", "not a vertex"},
      {file_of(body("[0, 0, 0]")), "/meshes/0/vertices/0", "not a vertex"},
      {file_of(body("[0, 0, 0, 0, 1, 1]")), "/meshes/0/vertices/0", "not a vertex"},
      {file_of(body("[0, 0, 0, 0, 1], [0, \"y\", 0, 0, 1]")), "/meshes/0/vertices/1/1", "not a number"},
      {file_of(body("[0, 0, 1e300, 0, 1]")), "/meshes/0/vertices/0/2", "out of range"},
      {file_of(body("[0, 0, 0, 2, 1]")), "/meshes/0/vertices/0/3", "no such joint"},
      {file_of(body("[0, 0, 0, -1, 1]")), "/meshes/0/vertices/0/3", "no such joint"},
      {file_of(body("[0, 0, 0, 0.5, 1]")), "/meshes/0/vertices/0/3", "no such joint"},
      {file_of(body("[0, 0, 0, 0, 0.5, 0, 0.5]")), "/meshes/0/vertices/0/5", "joint named twice"},
      {file_of(body("[0, 0, 0, 0, -0.5, 1, 1.5]")), "/meshes/0/vertices/0/4", "not a weight"},
      {file_of(body("[0, 0, 0, 0, 0.5, 1, 0.25]")), "/meshes/0/vertices/0", "weights sum to 0.75"},
      {file_of(body("[0, 0, 0, 0, 0]")), "/meshes/0/vertices/0", "weights sum to 0"},
  };
  for (const Bad& bad : all) {
    try {
      read_painted("p.json", bad.text);
      ADD_FAILURE() << bad.text << " was read";
    } catch (const tools::Failure& why) {
      EXPECT_EQ(why.code(), bad.rule == "version 2" ? tools::Exit::unsupported : tools::Exit::invalid) << bad.text;
      EXPECT_EQ(why.file(), "p.json");
      EXPECT_TRUE(bad.where == "@" ? why.where().starts_with("@") : why.where() == bad.where)
          << bad.text << ": " << why.where();
      EXPECT_TRUE(why.rule().starts_with(bad.rule)) << bad.text << ": " << why.rule();
    }
  }
}

// Four vertices, of SceneDocument::skin().
class PaintPlaces : public ::testing::Test {
 protected:
  PaintPlaces() : folder_(fs::temp_directory_path() / ("marrow_places_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    d_.character("hero", 0);
  }
  ~PaintPlaces() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  // A row of the file for a vertex of the scene, moved by so much along x.
  static std::string row(const RawScene& scene, std::size_t vertex, const std::string& weights, double off = 0) {
    const glm::vec3 p = scene.meshes[0].primitives[0].positions[vertex];
    return "[" + std::to_string(static_cast<double>(p.x) + off) + ", " + std::to_string(p.y) + ", " +
           std::to_string(p.z) + ", " + weights + "]";
  }
  RawScene painted(const std::string& text, bool must_fit = true) {
    RawScene scene = d_.read();
    paint_places(scene, "p.json", read_painted("p.json", text), must_fit, notes_);
    return scene;
  }
  bool warned(const std::string& rule, const std::string& words) const {
    return std::ranges::any_of(notes_.warnings, [&](const RawWarning& w) {
      return w.rule == rule && w.text.find(words) != std::string::npos;
    });
  }

  fs::path folder_;
  SceneDocument d_;
  Notes notes_;
};

TEST_F(PaintPlaces, VerticesAreKnownByWhereTheyAre) {
  const RawScene before = d_.read();
  const RawScene scene = painted(file_of(R"({"name": "hero mesh", "joints": ["arm", "hips"], "vertices": [)" +
                                         row(before, 2, "1, 0.75, 0, 0.25") + ", " + row(before, 0, "0, 1") + "]}"));
  EXPECT_NEAR(weight_of(scene, 2, 3), 0.25, 1e-6) << "of the arm, the skin's last joint";
  EXPECT_NEAR(weight_of(scene, 2, 0), 0.75, 1e-6);
  EXPECT_NEAR(weight_of(scene, 0, 3), 1, 1e-6);
  for (const std::size_t other : {1u, 3u})
    for (const std::uint32_t joint : {0u, 1u, 2u, 3u})
      EXPECT_EQ(weight_of(scene, other, joint), weight_of(before, other, joint)) << "not painted";
  EXPECT_TRUE(notes_.warnings.empty());
}

TEST_F(PaintPlaces, WhatIsOffTheMeshIsCounted) {
  const RawScene before = d_.read();
  double side = 0;
  for (const glm::vec3& a : before.meshes[0].primitives[0].positions)
    for (const glm::vec3& b : before.meshes[0].primitives[0].positions)
      for (int c = 0; c < 3; ++c) side = std::max(side, static_cast<double>(std::abs(a[c] - b[c])));
  const RawScene scene =
      painted(file_of(body(row(before, 2, "1, 1", 0.0009 * side) + ", " + row(before, 0, "1, 1", 0.0011 * side))));
  EXPECT_NEAR(weight_of(scene, 2, 1), 1, 1e-6) << "within a thousandth of the longest side";
  EXPECT_EQ(weight_of(scene, 0, 1), weight_of(before, 0, 1));
  EXPECT_TRUE(warned("paint-off-the-mesh", "1 of 2 vertices"));
}

TEST_F(PaintPlaces, WhatFitsNothingIsRefused) {
  const RawScene scene = d_.read();
  const auto refused = [&](const std::string& text, const std::string& where, const std::string& words) {
    try {
      painted(text);
      ADD_FAILURE() << text;
    } catch (const tools::Failure& why) {
      EXPECT_EQ(why.code(), tools::Exit::invalid);
      EXPECT_EQ(why.file(), "p.json");
      EXPECT_EQ(why.where(), where);
      EXPECT_NE(std::string(why.what()).find(words), std::string::npos) << why.what();
    }
  };
  const std::string other = R"({"name": "hero mash", "joints": [], "vertices": []})";
  refused(file_of(body("") + ", " + other), "/meshes/1", "did you mean \"hero mesh\"");
  refused(file_of(R"({"name": "hero mesh", "joints": ["hips", "spin"], "vertices": []})"), "/meshes/0/joints/1",
          "did you mean \"spine\"");
  // Of a rule for many files.
  painted(file_of(other), false);
  EXPECT_TRUE(warned("rule-fits-nothing", "none of its meshes"));
  notes_.warnings.clear();
  painted(file_of(body("") + ", " + other), false);
  EXPECT_TRUE(notes_.warnings.empty());
}

// A mask behind it goes over it, one before it is gone.
TEST_F(PaintPlaces, RulesGoOneAfterTheOther) {
  const RawScene before = d_.read();
  const std::string path = write("p.json", file_of(body(row(before, 0, "1, 1"))));
  WeightOptions options;
  options.paint.push_back({"", path});
  options.paint.push_back({"", write("q.json", file_of(body(row(before, 0, "0, 0.5, 1, 0.5"))))});
  CookOptions asked;
  asked.prepare.weights = options;
  const RawScene scene = paint_weights(d_.read(), with_named_files(asked).prepare.weights.paint, notes_);
  EXPECT_NEAR(weight_of(scene, 0, 0), 0.5, 1e-6);
  asked.prepare.weights.paint.push_back({"", folder_ / "missing.json"});
  EXPECT_THROW(with_named_files(asked), tools::Failure);
}

TEST(PaintFile, IsAnOption) {
  const auto given = [](const std::string& text) { return options_of("--paint " + text).prepare.weights.paint.at(0); };
  EXPECT_EQ(given("art/a=b.json").joint, "");
  EXPECT_EQ(given("art/a=b.json").file, "art/a=b.json");
  EXPECT_EQ(given("head=head.png").joint, "head");
}

}  // namespace
}  // namespace marrow::cook
