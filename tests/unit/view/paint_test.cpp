// What a brush does to weights: falloff, strokes, mirror images, undo; and where a ray meets a surface.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "paint/canvas.h"
#include "paint/mirror.h"
#include "paint/stroke.h"

namespace marrow::tools {
namespace {

constexpr std::uint32_t kSpine = 0, kLeft = 1, kRight = 2;

void add_group(Canvas& canvas, std::vector<glm::vec3> places) {
  const auto group = static_cast<std::uint32_t>(canvas.groups.size());
  canvas.groups.push_back({"mesh " + std::to_string(group), 0, false, {}, {}});
  for (const glm::vec3& p : places) {
    canvas.group_of.push_back(group);
    canvas.bind.push_back(p);
    canvas.model.emplace_back(p);
    canvas.influences.push_back({{kSpine, 1}});
    canvas.touched.push_back(0);
  }
}

void finish(Canvas& canvas) {
  deform::SkinnedMesh mesh;
  mesh.positions = canvas.model;
  mesh.indices = canvas.corners;
  canvas.surface.emplace_back(mesh);
}

// A band along x from -3 to 3 at this height, a metre wide: places 2 i at (i - 3, y, 0), 2 i + 1 at (i - 3, y, 1). All
// follow the spine.
void add_band(Canvas& canvas, float y) {
  const auto first = static_cast<std::uint32_t>(canvas.bind.size());
  std::vector<glm::vec3> places;
  for (int i = -3; i <= 3; ++i)
    for (int z = 0; z < 2; ++z) places.emplace_back(i, y, z);
  add_group(canvas, places);
  for (std::uint32_t i = 0; i < 6; ++i)
    for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) canvas.corners.push_back(first + 2 * i + corner);
}

Canvas band() {
  Canvas canvas;
  add_band(canvas, 0);
  finish(canvas);
  return canvas;
}

Brush brush(BrushMode mode, float radius, float strength) {
  Brush out;
  out.mode = mode;
  out.radius = radius;
  out.strength = strength;
  return out;
}

// On the place itself, in a triangle that has it.
SurfaceHit on(const Canvas& canvas, std::uint32_t place) {
  SurfaceHit hit;
  hit.place = canvas.bind[place];
  while (canvas.corners[3 * hit.triangle] != place && canvas.corners[3 * hit.triangle + 1] != place &&
         canvas.corners[3 * hit.triangle + 2] != place)
    ++hit.triangle;
  return hit;
}

Edit paint(Canvas& canvas, const Brush& with, std::uint32_t joint, std::vector<std::uint32_t> at,
           std::uint32_t image = kNoPlace, std::span<const std::uint32_t> mirror = {}) {
  Stroke stroke(canvas, with, 0, joint, image == kNoPlace ? joint : image, mirror);
  for (const std::uint32_t place : at) stroke.dab(canvas.bind, on(canvas, place));
  return stroke.edit();
}

double sum_of(const Influences& influences) {
  double sum = 0;
  for (const deform::Influence& i : influences) sum += i.weight;
  return sum;
}

TEST(Brush, FallsOffToItsRadius) {
  EXPECT_DOUBLE_EQ(falloff(0, 2), 1);
  EXPECT_DOUBLE_EQ(falloff(1, 2), 0.5625) << "(1 - 1/4)²";
  EXPECT_DOUBLE_EQ(falloff(2, 2), 0);
  EXPECT_DOUBLE_EQ(falloff(3, 2), 0);
  EXPECT_DOUBLE_EQ(falloff(0, 0), 0) << "nothing is inside";
  EXPECT_DOUBLE_EQ(falloff(0, -1), 0);
  EXPECT_DOUBLE_EQ(falloff(0, std::nan("")), 0);
  EXPECT_DOUBLE_EQ(falloff(std::nan(""), 1), 0);
}

TEST(Brush, AddsSubtractsAndSets) {
  EXPECT_DOUBLE_EQ(painted_weight(brush(BrushMode::add, 1, 0.5f), 0.25, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(painted_weight(brush(BrushMode::add, 1, 1), 0.75, 0.5), 1) << "no more than 1";
  EXPECT_DOUBLE_EQ(painted_weight(brush(BrushMode::subtract, 1, 0.5f), 0.75, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(painted_weight(brush(BrushMode::subtract, 1, 1), 0.25, 0.5), 0);
  EXPECT_DOUBLE_EQ(painted_weight(brush(BrushMode::set, 1, 0.25f), 0.75, 1), 0.25);
  EXPECT_DOUBLE_EQ(painted_weight(brush(BrushMode::set, 1, 0.25f), 0.75, 0.5), 0.5);
}

// From place 6 of the middle: itself at 0, its neighbours along x at 1, across at 1, aslant at √2; radius 2.
TEST(Stroke, OtherJointsShareTheRest) {
  Canvas canvas = band();
  canvas.influences[6] = {{kSpine, 0.375}, {kLeft, 0.25}, {kRight, 0.375}};
  canvas.influences[8] = {{kSpine, 0.75}, {kRight, 0.25}};
  paint(canvas, brush(BrushMode::add, 2, 0.5f), kLeft, {6});
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[6], kLeft), 0.75) << "1/4 + 1/2";
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[6], kSpine), 0.125) << "half of the rest";
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[6], kRight), 0.125);
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[8], kLeft), 0.28125) << "0.5625 / 2";
  EXPECT_NEAR(weight_of(canvas.influences[8], kSpine), 0.71875 * 0.75, 1e-9);
  EXPECT_NEAR(weight_of(canvas.influences[8], kRight), 0.71875 * 0.25, 1e-9);
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[4], kLeft), 0.28125);
  EXPECT_NEAR(weight_of(canvas.influences[9], kLeft), 0.125, 1e-7) << "(1 - 2/4)² / 2";
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[10], kLeft), 0) << "on the rim";
  for (const Influences& influences : canvas.influences) EXPECT_DOUBLE_EQ(sum_of(influences), 1);
}

TEST(Stroke, IsAsStrongAsItsStrongestTouch) {
  Canvas once = band(), often = band();
  paint(once, brush(BrushMode::add, 1.5f, 0.5f), kLeft, {6});
  paint(often, brush(BrushMode::add, 1.5f, 0.5f), kLeft, {6, 6, 8, 6});
  EXPECT_DOUBLE_EQ(weight_of(often.influences[6], kLeft), 0.5);
  EXPECT_DOUBLE_EQ(weight_of(often.influences[8], kLeft), 0.5) << "it passed there, too";
  EXPECT_EQ(weight_of(once.influences[4], kLeft), weight_of(often.influences[4], kLeft));
  // A second stroke adds to the first.
  paint(once, brush(BrushMode::add, 1.5f, 0.25f), kLeft, {6});
  EXPECT_DOUBLE_EQ(weight_of(once.influences[6], kLeft), 0.75);
}

TEST(Stroke, WithoutARadiusItTouchesNothing) {
  for (const float radius : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    Canvas canvas = band();
    EXPECT_TRUE(paint(canvas, brush(BrushMode::add, radius, 1), kLeft, {6}).empty());
    EXPECT_EQ(weight_of(canvas.influences[6], kLeft), 0);
  }
}

TEST(Stroke, NoVertexIsLeftWithoutWeight) {
  Canvas canvas = band();
  canvas.influences[6] = {{kLeft, 1}};
  canvas.influences[4] = {{kSpine, 0.25}, {kLeft, 0.75}};
  const Brush all = brush(BrushMode::subtract, 1.25f, 1);
  Stroke stroke(canvas, all, 0, kLeft, kLeft, {});
  stroke.dab(canvas.bind, on(canvas, 6));
  stroke.dab(canvas.bind, on(canvas, 6));
  EXPECT_EQ(stroke.kept(), 1u);
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[6], kLeft), 1);
  EXPECT_NEAR(weight_of(canvas.influences[4], kLeft), 0.75 - std::pow(1 - 1 / 1.5625, 2), 1e-9);
  ASSERT_EQ(stroke.edit().size(), 1u) << "only that";
  EXPECT_EQ(stroke.edit()[0].place, 4u);
}

TEST(Stroke, StaysOnItsSurfaceUnlessItGoesThrough) {
  Canvas canvas;
  add_band(canvas, 0);
  add_band(canvas, 0.125f);
  finish(canvas);
  Brush with = brush(BrushMode::add, 0.5f, 0.5f);
  paint(canvas, with, kLeft, {6});
  EXPECT_GT(weight_of(canvas.influences[6], kLeft), 0);
  EXPECT_EQ(weight_of(canvas.influences[20], kLeft), 0) << "above it";
  with.through = true;
  paint(canvas, with, kLeft, {6});
  EXPECT_NEAR(weight_of(canvas.influences[20], kLeft), 0.5 * std::pow(1 - 0.0625, 2), 1e-9);
  // What hangs on one joint, or on another skeleton, stays as it is.
  canvas.groups[1].hangs = true;
  canvas.influences[20] = {{kSpine, 1}};
  paint(canvas, with, kLeft, {6});
  EXPECT_EQ(weight_of(canvas.influences[20], kLeft), 0);
  canvas.groups[1] = {"other", 1, false, {}, {}};
  paint(canvas, with, kLeft, {6});
  EXPECT_EQ(weight_of(canvas.influences[20], kLeft), 0);
  // So does one whose skin has not the joint.
  canvas.groups[1] = {"coat", 0, false, {}, {kSpine, kRight}};
  paint(canvas, with, kLeft, {6});
  EXPECT_EQ(weight_of(canvas.influences[20], kLeft), 0);
  paint(canvas, with, kRight, {6});
  EXPECT_GT(weight_of(canvas.influences[20], kRight), 0);
}

// One touch goes half of the way to the mean of four neighbours.
TEST(Stroke, SmoothsTowardsTheNeighbours) {
  Canvas canvas = band();
  canvas.influences[6] = {{kLeft, 1}};
  const auto around = canvas.neighbours(6);
  ASSERT_EQ(std::vector<std::uint32_t>(around.begin(), around.end()), (std::vector<std::uint32_t>{4, 5, 7, 8}));
  canvas.influences[4] = {{kSpine, 0.5}, {kRight, 0.5}};
  paint(canvas, brush(BrushMode::smooth, 0.5f, 0.5f), kLeft, {6});
  EXPECT_NEAR(weight_of(canvas.influences[6], kLeft), 0.5, 1e-9) << "although no other joint moved it";
  EXPECT_NEAR(weight_of(canvas.influences[6], kRight), 0.5 * 0.5 / 4, 1e-9);
  EXPECT_NEAR(weight_of(canvas.influences[6], kSpine), 0.5 * 3.5 / 4, 1e-9);
  EXPECT_DOUBLE_EQ(sum_of(canvas.influences[6]), 1);
}

TEST(Stroke, PaintsTheMirrorImage) {
  Canvas canvas = band();
  const std::vector<std::uint32_t> mirror = mirrored_places(canvas, {0, 0}, 0.01);
  ASSERT_EQ(mirror[2], 10u);
  Brush with = brush(BrushMode::add, 1.5f, 0.5f);
  with.mirror.axis = 0;
  paint(canvas, with, kLeft, {10}, kRight, mirror);
  for (std::uint32_t p = 0; p < canvas.bind.size(); ++p)
    EXPECT_EQ(weight_of(canvas.influences[p], kLeft), weight_of(canvas.influences[mirror[p]], kRight)) << p;
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[10], kLeft), 0.5);
  EXPECT_DOUBLE_EQ(weight_of(canvas.influences[10], kRight), 0);
  // A joint that is its own image gets the stronger of both, not their sum.
  Canvas middle = band();
  paint(middle, brush(BrushMode::add, 1.5f, 0.5f), kLeft, {6, 8}, kLeft, mirror);
  EXPECT_DOUBLE_EQ(weight_of(middle.influences[6], kLeft), 0.5);
  EXPECT_DOUBLE_EQ(weight_of(middle.influences[8], kLeft), 0.5);
  EXPECT_DOUBLE_EQ(weight_of(middle.influences[4], kLeft), 0.5);
}

TEST(History, GoesBackAndOnExactly) {
  Canvas canvas = band();
  canvas.touched[4] = 1;
  const std::vector<Influences> first = canvas.influences;
  History history;
  const auto stroke = [&](std::uint32_t at) {
    Edit edit = paint(canvas, brush(BrushMode::add, 1.5f, 0.5f), kLeft, {at});
    redo(canvas, edit);
    history.add(edit);
  };
  const auto same = [](const std::vector<Influences>& a, const std::vector<Influences>& b) {
    for (std::size_t p = 0; p < a.size(); ++p)
      for (const std::uint32_t joint : {kSpine, kLeft, kRight})
        if (weight_of(a[p], joint) != weight_of(b[p], joint)) return false;
    return true;
  };
  stroke(6);
  const std::vector<Influences> second = canvas.influences;
  EXPECT_EQ(canvas.touched[6], 1);
  history.set_saved();
  stroke(8);
  const std::vector<Influences> third = canvas.influences;
  EXPECT_FALSE(history.saved());
  history.undo(canvas);
  EXPECT_TRUE(same(canvas.influences, second));
  EXPECT_TRUE(history.saved());
  history.undo(canvas);
  history.undo(canvas);
  EXPECT_TRUE(same(canvas.influences, first));
  EXPECT_EQ(canvas.touched[6], 0);
  EXPECT_EQ(canvas.touched[4], 1) << "touched before";
  EXPECT_FALSE(history.saved());
  history.redo(canvas);
  history.redo(canvas);
  history.redo(canvas);
  EXPECT_TRUE(same(canvas.influences, third));
  // What was undone is gone when something else is painted.
  history.undo(canvas);
  history.undo(canvas);
  stroke(2);
  EXPECT_EQ(history.undone(), 0u);
  EXPECT_EQ(history.done(), 1u);
  EXPECT_FALSE(history.saved()) << "what was saved cannot be reached any more";
  history.add({});
  EXPECT_EQ(history.done(), 1u) << "nothing is no stroke";
}

TEST(History, ForgetsTheOldest) {
  Canvas canvas = band();
  History history;
  for (std::size_t i = 0; i < History::kMost + 3; ++i) history.add({{6, false, {{kSpine, 1}}, {{kLeft, 1}}}});
  EXPECT_EQ(history.done(), History::kMost);
  EXPECT_FALSE(history.saved());
  for (std::size_t i = 0; i < History::kMost; ++i) history.undo(canvas);
  EXPECT_FALSE(history.saved()) << "three strokes stay";
}

TEST(Mirror, NamesOfTheOtherSide) {
  const std::pair<const char*, const char*> sides[] = {{"LeftArm", "RightArm"},
                                                       {"mixamorig:RightHand", "mixamorig:LeftHand"},
                                                       {"hand_left", "hand_right"},
                                                       {"forearm.L", "forearm.R"},
                                                       {"forearm.L.001", "forearm.R.001"},
                                                       {"l_thigh", "r_thigh"},
                                                       {"Bip R Foot", "Bip L Foot"},
                                                       {"spine", "spine"},
                                                       {"Lung", "Lung"},
                                                       {"tail_1", "tail_1"},
                                                       {"L", "L"},
                                                       {"", ""}};
  for (const auto& [name, other] : sides) {
    EXPECT_EQ(mirrored_name(name), other);
    EXPECT_EQ(mirrored_name(other), name);
  }
}

TEST(Mirror, JointsByNameThenByPlace) {
  const std::vector<std::string> names = {"root", "arm.L", "arm.R", "ear a", "ear b", "horn"};
  const std::vector<glm::vec3> places = {{0.001f, 0, 0}, {1, 1, 0},      {-1, 0.5f, 0},
                                         {2, 2, 0},      {-2, 2, 0.01f}, {3, 0, 0}};
  const auto image = [&](std::uint32_t joint) { return mirrored_joint(names, places, joint, {0, 0}, 0.05); };
  EXPECT_EQ(image(0), 0u) << "on the plane, all but";
  EXPECT_EQ(image(1), 2u) << "by name, though its arm hangs lower";
  EXPECT_EQ(image(2), 1u);
  EXPECT_EQ(image(3), 4u);
  EXPECT_EQ(image(4), 3u);
  EXPECT_EQ(image(5), 5u) << "there is none";
  EXPECT_EQ(mirrored_joint(names, places, 3, {0, 0.5f}, 0.05), 3u) << "(-1, 2, 0) has no joint";
}

TEST(Mirror, PlacesWithoutAnImage) {
  Canvas canvas;
  add_group(canvas, {{1, 0, 0}, {-1, 0, 0.001f}, {2, 0, 0}, {0, 1, 0}});
  finish(canvas);
  EXPECT_EQ(mirrored_places(canvas, {0, 0}, 0.01), (std::vector<std::uint32_t>{1, 0, kNoPlace, 3}));
  EXPECT_EQ(mirrored_places(canvas, {0, 1.5f}, 0.01), (std::vector<std::uint32_t>{2, kNoPlace, 0, kNoPlace}));
}

Affine moved_up(float by) {
  return {{{1, 0, 0, 0}, {0, 1, 0, by}, {0, 0, 1, 0}}};
}

// Joint 0 rests elsewhere than it was bound; 1 and 2 as they were bound, in the place of the mesh. So 3 would be, too.
TEST(Canvas, JointsThatMeshesDoNotFollowAreBoundAsTheOthers) {
  CanvasGroup group;
  const auto up = [](float by) { return glm::translate(glm::mat4(1), glm::vec3(0, by, 0)); };
  group.inverse_bind = {{0, up(7)}, {1, up(-1)}, {2, up(-2)}};
  const std::vector<Affine> rest = {moved_up(0), moved_up(1), moved_up(2), moved_up(3)};
  const std::vector<glm::mat4> binds = bind_matrices(group, rest);
  ASSERT_EQ(binds.size(), 4u);
  EXPECT_EQ(binds[0], up(7)) << "known";
  EXPECT_EQ(binds[2], up(-2));
  EXPECT_EQ(binds[3], up(-3));
}

TEST(Ray, MeetsTheFirstTriangle) {
  const std::vector<glm::vec3> places = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, -2}, {4, 0, -2}, {0, 4, -2}};
  const std::vector<std::uint32_t> corners = {3, 4, 5, 0, 1, 2};
  const auto front = first_hit({{1, 1, 5}, {0, 0, -1}}, places, corners);
  ASSERT_TRUE(front.has_value());
  EXPECT_EQ(front->triangle, 1u) << "the nearer, though it comes later";
  EXPECT_EQ(front->place, glm::vec3(1, 1, 0));
  EXPECT_EQ(front->normal, glm::vec3(0, 0, 1));
  const auto back = first_hit({{1, 1, -5}, {0, 0, 1}}, places, corners);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->triangle, 0u);
  EXPECT_EQ(back->normal, glm::vec3(0, 0, -1)) << "on the ray's side";
  EXPECT_FALSE(first_hit({{3, 3, 5}, {0, 0, -1}}, places, corners)) << "beyond the long edge";
  EXPECT_FALSE(first_hit({{1, 1, 5}, {0, 0, 1}}, places, corners)) << "behind";
  EXPECT_FALSE(first_hit({{0, 0, 5}, {0, 0, -1}}, places, std::vector<std::uint32_t>{0, 0, 1})) << "no area";
}

// A camera at (0, 0, 10) that sees 90°: at the right edge of the picture the ray leaves at 45°.
TEST(Ray, GoesThroughThePicture) {
  const glm::mat4 clip_from_model = glm::perspective(1.5707963f, 1.0f, 1.0f, 100.0f) *
                                    glm::lookAt(glm::vec3(0, 0, 10), glm::vec3(0), glm::vec3(0, 1, 0));
  const Ray middle = ray_through(clip_from_model, {0, 0}), edge = ray_through(clip_from_model, {1, 0});
  EXPECT_NEAR(glm::distance(middle.from, glm::vec3(0, 0, 9)), 0, 1e-4f);
  EXPECT_NEAR(glm::distance(middle.along, glm::vec3(0, 0, -1)), 0, 1e-5f);
  EXPECT_NEAR(glm::distance(edge.along, std::sqrt(0.5f) * glm::vec3(1, 0, -1)), 0, 1e-4f);
}

}  // namespace
}  // namespace marrow::tools
