// Painting from a file to a file: what is saved is what `marrow cook --paint` makes of it.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <unistd.h>

#include <gtest/gtest.h>

#include "commands/view/opening.h"
#include "common/failure.h"
#include "deform/weights/places.h"
#include "disk/cook_on_disk.h"
#include "disk/files.h"
#include "paint/painting.h"
#include "pose/evaluate.h"
#include "support/places.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;

class PaintingTest : public ::testing::Test {
 protected:
  PaintingTest() : folder_(fs::temp_directory_path() / ("marrow_painting_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~PaintingTest() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  std::string at(const std::string& name) const { return folder_ / name; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return at(name);
  }
  static LoadedFile cook(const std::string& path, const cook::CookOptions& options) {
    const cook::Result cooked = cook::cook_file(path, options);
    AlignedBytes bytes(cooked.file.size());
    std::ranges::copy(cooked.file, bytes.data());
    return load_mrw(path, std::move(bytes));
  }

  fs::path folder_;
};

// Cooked once for all tests.
const File& newt() {
  static const Source source = open_source(test::newt_glb());
  return source.loaded.file;
}

std::uint32_t joint_called(const File& file, const std::string& name) {
  const Skeleton skeleton = file.skeleton(0);
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j)
    if (name == file.text(skeleton.names[j])) return j;
  ADD_FAILURE() << name;
  return 0;
}

// Presses the brush on the rest pose where a ray from +Z at this height meets it.
bool press(Painting& painting, const File& file, const Brush& brush, std::uint32_t joint, glm::vec2 at) {
  Character character(file);
  character.pose({}, 0);
  painting.pose(character);
  const auto hit = painting.hit({{at, 100}, {0, 0, -1}});
  if (!hit) return false;
  painting.begin(brush, 0, joint);
  painting.dab(*hit);
  painting.end();
  return true;
}

Brush wide(BrushMode mode, float strength) {
  Brush brush;
  brush.mode = mode;
  brush.radius = 0.15f;
  brush.strength = strength;
  return brush;
}

// Weights by places of the bind pose: other files have other orders.
class WeightsAt {
 public:
  explicit WeightsAt(const Canvas& canvas) : canvas_(canvas) {
    std::map<std::string, deform::Positions> positions;
    for (std::uint32_t p = 0; p < canvas.bind.size(); ++p) {
      const std::string& mesh = canvas.groups[canvas.group_of[p]].name;
      places_[mesh].push_back(p);
      positions[mesh].emplace_back(canvas.bind[p]);
    }
    for (auto& [mesh, all] : positions) trees_.emplace(mesh, std::move(all));
  }
  const Influences* operator()(const std::string& mesh, const glm::vec3& place) const {
    const auto found = trees_.at(mesh).nearest(glm::dvec3(place), 1e-3);
    return found ? &canvas_.influences[places_.at(mesh)[found->index]] : nullptr;
  }

 private:
  const Canvas& canvas_;
  std::map<std::string, std::vector<std::uint32_t>> places_;
  std::map<std::string, deform::PlaceTree> trees_;
};

// The largest difference of a joint's weight, over all vertices of `a`.
double largest_difference(const Canvas& a, const Canvas& b, std::uint32_t joints) {
  const WeightsAt others(b);
  double largest = 0;
  for (std::size_t p = 0; p < a.bind.size(); ++p) {
    const Influences* const other = others(a.groups[a.group_of[p]].name, a.bind[p]);
    if (other == nullptr) return 1;
    for (std::uint32_t j = 0; j < joints; ++j)
      largest = std::max(largest, std::abs(weight_of(a.influences[p], j) - weight_of(*other, j)));
  }
  return largest;
}

// Weights are stored within 2.5e-4 (docs/cooking/errors.md), here twice: as they were read, and as they were painted.
TEST_F(PaintingTest, WhatIsSavedIsWhatIsCooked) {
  const File& file = newt();
  const std::uint32_t joints = file.skeleton(0).joint_count;
  Painting painting(file, at("newt.paint.json"));
  ASSERT_TRUE(painting.refusal().empty());
  const Canvas before = painting.canvas();
  Brush mirrored = wide(BrushMode::add, 0.6f);
  mirrored.mirror.axis = 0;
  const std::uint32_t left = joint_called(file, "forearm.L"), right = joint_called(file, "forearm.R");
  EXPECT_EQ(painting.image_of(mirrored, 0, left), right);
  const glm::vec2 chest(0.12f, 0.5f);
  ASSERT_TRUE(press(painting, file, mirrored, left, chest));
  mirrored.mode = BrushMode::smooth;
  ASSERT_TRUE(press(painting, file, mirrored, left, {0.05f, 0.55f}));
  ASSERT_TRUE(press(painting, file, wide(BrushMode::set, 0.25f), joint_called(file, "neck"), {0, 0.9f}));
  ASSERT_GT(largest_difference(painting.canvas(), before, joints), 0.5);
  EXPECT_FALSE(painting.saved());
  painting.save();
  EXPECT_TRUE(painting.saved());

  cook::CookOptions options;
  options.clips.raw = true;
  options.prepare.weights.paint.push_back({"", at("newt.paint.json")});
  const LoadedFile cooked = cook(test::newt_glb(), options);
  const Painting again(cooked.file, at("none.paint.json"));
  EXPECT_LT(largest_difference(painting.canvas(), again.canvas(), joints), 6e-4);
  // Both sides alike, as near as the model's own are.
  std::size_t on_both = 0;
  const WeightsAt at_first(before), at_last(again.canvas());
  for (std::size_t p = 0; p < again.canvas().bind.size(); ++p) {
    const glm::vec3& place = again.canvas().bind[p];
    if (place.x < 0.05f || place.x > 0.2f) continue;
    const std::string& mesh = again.canvas().groups[again.canvas().group_of[p]].name;
    const double now = weight_of(again.canvas().influences[p], left);
    const Influences* const was = at_first(mesh, place);
    const Influences* const image = at_last(mesh, {-place.x, place.y, place.z});
    if (was == nullptr || image == nullptr || now < weight_of(*was, left) + 0.1) continue;
    EXPECT_NEAR(now, weight_of(*image, right), 0.01);
    ++on_both;
  }
  EXPECT_GT(on_both, 10u);
  // What is opened again goes on where it was.
  const Painting later(file, at("newt.paint.json"));
  EXPECT_TRUE(later.trouble().empty()) << later.trouble();
  EXPECT_TRUE(later.saved());
  EXPECT_LT(largest_difference(painting.canvas(), later.canvas(), joints), 1e-6);
  EXPECT_TRUE(cook::text_of_painted(later.painted()) == cook::text_of_painted(painting.painted()));
}

// By linear blend skinning, as the runtime does it.
TEST_F(PaintingTest, ThePosedSurfaceIsTheRuntimes) {
  const File& file = newt();
  Painting painting(file, at("newt.paint.json"));
  Character character(file);
  const Play walk = play_together(file, file.find_clip("walk"));
  character.pose(walk, 0.4f);
  painting.pose(character);
  const std::vector<PosedMesh> posed = painting.posed(character);
  float farthest = 0, turned = 0;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    PosedMesh wanted;
    character.skin(m, Deformer::ssd, wanted);
    ASSERT_EQ(wanted.positions.size(), posed[m].positions.size());
    ASSERT_EQ(wanted.normals.size(), posed[m].normals.size());
    for (std::size_t i = 0; i < wanted.positions.size(); ++i)
      farthest = std::max(farthest, std::abs(wanted.positions[i] - posed[m].positions[i]));
    for (std::size_t i = 0; i < wanted.normals.size(); ++i)
      turned = std::max(turned, std::abs(wanted.normals[i] - posed[m].normals[i]));
  }
  EXPECT_LT(farthest, 1e-4f);
  EXPECT_LT(turned, 1e-3f);
}

// tests/golden/tiny.gltf: the arm follows three joints, the hat hangs on the wrist.
TEST_F(PaintingTest, ARigidMeshIsLeftAlone) {
  const Source source = open_source(test::in_golden("tiny.gltf"));
  const File& file = source.loaded.file;
  Painting painting(file, at("t.json"));
  EXPECT_TRUE(painting.refusal().empty());
  Brush all = wide(BrushMode::set, 1);
  all.radius = 100;
  all.through = true;
  const std::uint32_t shoulder = joint_called(file, "shoulder");
  EXPECT_GT(painting.moved_by(0, shoulder), 0u);
  ASSERT_TRUE(press(painting, file, all, shoulder, {-1, 0.1f}) || press(painting, file, all, shoulder, {0, 0.1f}));
  const std::vector<cook::PaintedMesh> painted = painting.painted();
  ASSERT_EQ(painted.size(), 1u);
  EXPECT_EQ(painted[0].name, "arm");
}

// The hat's skin is not there; the arm's has three joints, of which one is taken away.
TEST_F(PaintingTest, AMeshFollowsJointsOfItsSkin) {
  Source source = open_source(test::in_golden("tiny.gltf"));
  ASSERT_EQ(source.skins, (SkinJoints{{"arm", {"shoulder", "elbow", "wrist"}}}));
  source.skins["arm"].erase("wrist");
  const File& file = source.loaded.file;
  Painting painting(file, at("t.json"), source.skins);
  const std::uint32_t wrist = joint_called(file, "wrist"), elbow = joint_called(file, "elbow");
  EXPECT_EQ(painting.without(0, wrist), "arm");
  EXPECT_EQ(painting.without(0, elbow), "");
  Brush all = wide(BrushMode::set, 1);
  all.radius = 100;
  ASSERT_TRUE(press(painting, file, all, wrist, {-2.5f, 0.1f}));
  EXPECT_EQ(painting.changed(), 0u);
  ASSERT_TRUE(press(painting, file, all, elbow, {-2.5f, 0.1f}));
  EXPECT_GT(painting.changed(), 0u);
}

TEST_F(PaintingTest, WhatCannotBePaintedSaysWhy) {
  const std::string cube = write("cube.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "name": "cube"}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
    "max": [1, 1, 0]}], "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri":
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const Source rigid = open_source(cube);
  EXPECT_NE(Painting(rigid.loaded.file, at("c.json")).refusal().find("without a skin"), std::string::npos);
  cook::CookOptions helpers;
  helpers.learn.helpers = 4;
  helpers.clips.raw = true;
  const LoadedFile cooked = cook(test::newt_glb(), helpers);
  EXPECT_NE(Painting(cooked.file, at("h.json")).refusal().find("helpers"), std::string::npos);
}

TEST_F(PaintingTest, AFileThatCannotBeWrittenSaysWhy) {
  const Source source = open_source(test::in_golden("tiny.gltf"));
  Painting nowhere(source.loaded.file, at("no/such/folder/t.json"));
  try {
    nowhere.save();
    FAIL() << "it was saved";
  } catch (const Failure& why) {
    EXPECT_EQ(why.code(), Exit::io);
    EXPECT_NE(std::string(why.what()).find("no/such/folder"), std::string::npos) << why.what();
  }
  EXPECT_EQ(nowhere.saved(), true) << "nothing was painted";
}

// A file that is something else, or another character's, is never written over.
TEST_F(PaintingTest, NothingElseIsWrittenOver) {
  const Source source = open_source(test::in_golden("tiny.gltf"));
  const std::string others[] = {
      "{\"a\": 1}", "no JSON", "",
      R"({"paintedWeights": 1, "meshes": [{"name": "arm", "joints": ["tail"], "vertices": [[0, 0, 0, 0, 1]]}]})"};
  for (const std::string& text : others) {
    const std::string path = write("other.json", text);
    Painting painting(source.loaded.file, path);
    EXPECT_NE(painting.trouble().find("other.json"), std::string::npos) << text;
    EXPECT_THROW(painting.save(), Failure) << text;
    const AlignedBytes bytes = read_file(path);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), text);
  }
}

// Meshes that this file has not stay in what is saved.
TEST_F(PaintingTest, MeshesOfOthersAreKept) {
  const Source source = open_source(test::in_golden("tiny.gltf"));
  const std::string path = write(
      "t.json", R"({"paintedWeights": 1, "meshes": [{"name": "coat", "joints": ["hem"], "vertices": [[1, 2, 3, 0, 1]]},
      {"name": "arm", "joints": ["wrist"], "vertices": [[0.25, 0, 0, 0, 1]]}]})");
  Painting painting(source.loaded.file, path);
  ASSERT_TRUE(painting.trouble().empty()) << painting.trouble();
  const std::uint32_t wrist = joint_called(source.loaded.file, "wrist");
  const Influences* const corner = WeightsAt(painting.canvas())("arm", {0.25f, 0, 0});
  ASSERT_NE(corner, nullptr);
  EXPECT_EQ(weight_of(*corner, wrist), 1);
  painting.save();
  const Painting again(source.loaded.file, path);
  ASSERT_EQ(again.painted().size(), 2u);
  EXPECT_EQ(again.painted()[1].name, "coat");
}

TEST(PaintFile, StandsBesideTheCharacter) {
  EXPECT_EQ(paint_file_beside("art/hero.glb"), "art/hero.paint.json");
  EXPECT_EQ(paint_file_beside("hero.v2.mrw"), "hero.v2.paint.json");
}

}  // namespace
}  // namespace marrow::tools
