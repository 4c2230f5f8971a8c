// Scenes that took a minute or so while work grew with the square of something: each takes a moment.
#include <cmath>
#include <ctime>
#include <numbers>

#include "cook/prepare/add_skeleton.h"
#include "cook/rig/read_template.h"
#include "deform/rig/auto_skeleton.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

constexpr double kMost_s = 10;  // of processor, of slow ones under sanitizers too

class Stopwatch {
 public:
  ~Stopwatch() { EXPECT_LT(static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC, kMost_s); }

 private:
  std::clock_t start_ = std::clock();
};

LoadedCook cook(SceneDocument& d) {
  const Stopwatch watch;
  return LoadedCook(cook_scene(d.read(), {}));
}

// Triangles at a node.
SceneDocument triangles(const std::vector<float>& positions, const std::vector<std::uint32_t>& indices,
                        const Json& more = Json::object()) {
  SceneDocument d;
  Json attributes = {{"POSITION", d.b.positions(positions)}};
  attributes.update(more);
  d.node("surface");
  d.b.primitive(attributes)["indices"] = d.b.numbers<std::uint32_t>(kU32, "SCALAR", 1, indices);
  return d;
}

std::string codec(const LoadedCook& cooked) {
  return cooked.report["meshes"][0]["codec"];
}

// What looks at all triangles of a vertex for each of them.
TEST(Growth, TrianglesOverTheSameVertices) {
  constexpr std::size_t kCount = 60000;
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < kCount; ++i) indices.insert(indices.end(), {0, 1, 2});
  SceneDocument d = triangles({0, 0, 0, 1, 0, 0, 0, 1, 0}, indices);
  const LoadedCook cooked = cook(d);
  ASSERT_EQ(cooked.file.mesh_count(), 1u);
  EXPECT_EQ(cooked.file.mesh(0).geometry.index_count, 3 * kCount);
  EXPECT_EQ(cooked.file.mesh(0).geometry.vertex_count, 3u);
  EXPECT_EQ(codec(cooked), "meshopt");
}

// Vertices at three places that differ by their colours, which Draco merges by place.
TEST(Growth, TrianglesAtOnePlace) {
  constexpr std::uint32_t kCount = 40000;
  std::vector<float> positions;
  std::vector<std::uint8_t> colours;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    positions.insert(positions.end(), {0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const auto byte = [&](std::uint32_t shift) { return static_cast<std::uint8_t>(i >> shift & 255u); };
      colours.insert(colours.end(), {byte(0), byte(8), byte(16), 255});
      indices.push_back(3 * i + corner);
    }
  }
  SceneDocument d = triangles(positions, indices);
  d.b.root["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
      d.b.numbers<std::uint8_t>(kU8, "VEC4", 4, colours, {{"normalized", true}});
  const LoadedCook cooked = cook(d);
  EXPECT_EQ(cooked.file.mesh(0).geometry.index_count, 3 * kCount);
  EXPECT_EQ(cooked.file.mesh(0).geometry.vertex_count, 3 * kCount);
}

// A UV of 30 000 takes 24 bits of 1/512, for which Draco's tables have 2²⁴ entries; one of 30 takes 14.
TEST(Growth, AFarUvIsNotForDraco) {
  for (const float far : {30.0f, 30000.0f}) {
    SceneDocument d = triangles({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2});
    d.b.root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        d.b.numbers<float>(kF32, "VEC2", 2, {0, 0, far, 0, 0, 1});
    const LoadedCook cooked = cook(d);
    EXPECT_EQ(codec(cooked), far < 1000 ? "draco" : "meshopt");
    const Geometry g = cooked.file.mesh(0).geometry;
    float farthest = 0;
    for (std::uint32_t slot = 0; slot < g.slot_count; ++slot) farthest = std::max(farthest, g.uvs[2 * slot]);
    EXPECT_NEAR(farthest, far, 1e-3f);
  }
}

// Each of a scene's skeletons, which one animation moves, is measured alone: its box is where its own mesh goes.
TEST(Growth, SkeletonsThatMoveTogether) {
  constexpr int kCount = 300;
  SceneDocument d;
  std::vector<int> joints;
  for (int i = 0; i < kCount; ++i) joints.push_back(d.node("joint " + std::to_string(i), -1, {0, 0, 0}));
  for (int i = 0; i < kCount; ++i) d.skin("skin " + std::to_string(i), {joints[static_cast<std::size_t>(i)]});
  d.clip("go");
  for (int i = 0; i < kCount; ++i) d.carry(joints[static_cast<std::size_t>(i)], {0, 1});
  const LoadedCook cooked = cook(d);
  ASSERT_EQ(cooked.file.skeleton_count(), static_cast<std::uint32_t>(kCount));
  ASSERT_EQ(cooked.file.clip_count(), static_cast<std::uint32_t>(kCount));
  for (const std::uint32_t i : {0u, 150u, 299u}) {
    const Bounds box = cooked.file.bounds(i, i);
    ASSERT_FALSE(box.is_empty());
    // Vertices (i, i², 0) to i = 3, carried from x = 0 to 1, y by 1/8.
    EXPECT_NEAR(box.box_min[0], 0, 0.1);
    EXPECT_NEAR(box.box_max[0], 4, 0.2);
    EXPECT_NEAR(box.box_max[1], 9.125, 0.2);
    EXPECT_TRUE(cooked.file.bounds(i, (i + 1) % kCount).is_empty());
    EXPECT_EQ(cooked.report["clips"][i]["bounds"][0]["mesh"], i);
  }
}

// A chain, each of whose joints moves all below it.
TEST(Growth, JointsOneBelowTheOther) {
  constexpr int kCount = 1500;
  SceneDocument d;
  d.clip("go");
  for (int i = 0, parent = -1; i < kCount; ++i) {
    parent = d.node("joint " + std::to_string(i), parent, {0.001f, 0, 0});
    d.turn(parent, {0, 0.5f, 1});
  }
  d.prop(kCount - 1);
  const LoadedCook cooked = cook(d);
  ASSERT_EQ(cooked.file.clip_count(), 1u);
  EXPECT_EQ(cooked.file.clip(0).tracks.size, static_cast<std::size_t>(kCount));
  EXPECT_EQ(cooked.report["clips"][0]["raw_because"], "its joints hang too deep, one below the other");
}

// A star of eight points has candidates for every joint of a quadruped, but no two of them go together.
TEST(Growth, ASkeletonThatIsSearchedForInVain) {
  constexpr double kRadii[] = {0.5, 1, 0.3, 1.2, 0.5, 1, 1, 0.3}, kHeight = 1.6486781423948271;
  constexpr std::uint32_t kPoints = 8;
  std::vector<float> positions;
  const auto add = [&](double x, double y, double z) {
    for (const double c : {x, y, z}) positions.push_back(static_cast<float>(c));
  };
  for (const double y : {0.0, kHeight})
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const double turn = 2 * std::numbers::pi * i / kPoints;
      add(kRadii[i] * std::cos(turn), y, kRadii[i] * std::sin(turn));
    }
  add(0, -0.05, 0);
  add(0, kHeight + 0.05, 0);
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const std::uint32_t j = (i + 1) % kPoints, up = i + kPoints, up_j = j + kPoints;
    indices.insert(indices.end(), {i, up, j, j, up, up_j, 2 * kPoints, i, j, 2 * kPoints + 1, up_j, up});
  }
  SceneDocument d = triangles(positions, indices);
  const Stopwatch watch;
  Notes notes;
  expect_failure([&] { add_skeleton(d.read(), "quadruped", parse_template("", builtin_template("quadruped")), notes); },
                 Exit::invalid, "/meshes", "template-does-not-fit");
}

}  // namespace
}  // namespace marrow::cook
