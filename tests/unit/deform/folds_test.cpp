// What is wrong with a posed surface, against hinges whose angles are known.
#include "deform/look/folds.h"

#include <gtest/gtest.h>

#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

// Two triangles with an edge of length 2 along y; the right one turns.
SkinnedMesh hinge() {
  SkinnedMesh mesh;
  mesh.positions = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
  mesh.indices = {0, 1, 2, 1, 0, 3};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}, {{0, 0.5}, {1, 0.5}}, {{0, 1}}, {{1, 1}}};
  mesh.joint_count = 2;
  return mesh;
}

Pose turned(double degrees) {
  return {Matrix(1.0), matrix(turn(degrees, {0, 1, 0}), {})};
}

// Only the hinge has two triangles, so that its angle is all there is.
TEST(Folds, MeasureTheAngleOfAHinge) {
  const SkinnedMesh mesh = hinge();
  const FoldMeter meter(mesh);
  for (const double degrees : {-100.0, -59.0, 0.0, 10.0, 59.0, 61.0, 110.0}) {
    const Folds folds = meter.of(turned(degrees), at(ssd(mesh), turned(degrees)));
    EXPECT_NEAR(folds.bend_rad, std::abs(degrees) * kDegree, 1e-12) << degrees;
    EXPECT_EQ(folds.creased, std::abs(degrees) > 60 ? 1.0 : 0.0) << degrees;
    EXPECT_EQ(folds.flipped, 0u) << degrees;
  }
}

// The angle of the bind pose does not count, and a whole turn leads back to it.
TEST(Folds, MeasureFromTheBindPose) {
  SkinnedMesh mesh = hinge();
  mesh.positions[3] = {std::cos(150 * kDegree), 0, std::sin(150 * kDegree)};
  const FoldMeter meter(mesh);
  EXPECT_NEAR(meter.of(turned(0), mesh.positions).bend_rad, 0, 1e-12);
  // From 150° up to 190°, which is -170°.
  const Positions over = {
      mesh.positions[0], mesh.positions[1], mesh.positions[2], {std::cos(190 * kDegree), 0, std::sin(190 * kDegree)}};
  EXPECT_NEAR(meter.of(turned(0), over).bend_rad, 40 * kDegree, 1e-12);
}

// A strip of two squares; the second rises by its own width, which is a slope of 45°.
TEST(Folds, WeighEdgesByTheirLength) {
  SkinnedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 3, 0}, {1, 3, 0}, {2, 3, 0}};
  mesh.indices = {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4};
  mesh.influences.assign(6, {{0, 0.5}, {1, 0.5}});
  mesh.joint_count = 2;
  Positions raised = mesh.positions;
  raised[2].z = raised[5].z = 1;
  // Inner edges: the middle one, 3 long, turns by 45°; the diagonals, √10 each, stay.
  const double expected = 45 * kDegree * std::sqrt(3 / (3 + 2 * std::sqrt(10.0)));
  EXPECT_NEAR(FoldMeter(mesh).of(turned(0), raised).bend_rad, expected, 1e-12);
}

TEST(Folds, CountWhatFacesBack) {
  const SkinnedMesh mesh = hinge();
  const FoldMeter meter(mesh);
  Positions folded = mesh.positions;
  folded[3] = {-2, 0, 0};
  const Folds folds = meter.of(turned(0), folded);
  EXPECT_EQ(folds.flipped, 1u);
  EXPECT_NEAR(folds.bend_rad, 180 * kDegree, 1e-12);
  EXPECT_EQ(meter.flipped_by_joint(meter.facing(turned(0)), folded), (std::vector<std::size_t>{0, 1}))
      << "its corners follow joint 1 by (0.5 + 0.5 + 1) / 3";
  EXPECT_EQ(meter.flipped_by_joint(meter.facing(turned(0)), mesh.positions), (std::vector<std::size_t>{0, 0}));
  // The edge turns by three times 60°.
  std::vector<double> sums;
  meter.add_at_vertices(turned(0), folded, sums);
  const double expected[] = {1 + 9, 1 + 9, 9, 1 + 9};
  for (std::size_t v = 0; v < 4; ++v) EXPECT_NEAR(sums[v], expected[v], 1e-12);
  // The whole, turned over, has not folded.
  const Pose over = moved(turn(180, {0, 1, 0}), {0, 0, 5}, turned(0));
  EXPECT_EQ(meter.of(over, at(ssd(mesh), over)).flipped, 0u);
}

TEST(Folds, LookWhereWeightsBlend) {
  SkinnedMesh mesh = hinge();
  for (std::size_t v = 0; v < 4; ++v) mesh.influences[v] = {{0, 0.995}, {1, 0.005}};
  EXPECT_EQ(FoldMeter(mesh).of(turned(0), at(ssd(hinge()), turned(50))).bend_rad, 0);
}

TEST(Folds, SayNothingOfWhatIsNotFinite) {
  const SkinnedMesh mesh = hinge();
  Positions bad = mesh.positions;
  bad[0].x = std::nan("");
  EXPECT_EQ(FoldMeter(mesh).of(turned(0), bad).bend_rad, 0);
  EXPECT_EQ(FoldMeter({}).of(Pose{}, {}).flipped, 0u);
}

// A vertex that follows joint 1 by three quarters.
SkinnedMesh one_vertex() {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}};
  mesh.influences = {{{0, 0.25}, {1, 0.75}}};
  mesh.joint_count = 2;
  return mesh;
}

std::array<Positions, 3> places(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return {Positions{a}, Positions{b}, Positions{c}};
}

// Of 3 t² the second difference is 6, of what joints carry none.
TEST(Folds, JumpsAreSecondDifferencesBesideTheJoint) {
  const Pose still = {Matrix(1.0), Matrix(1.0)};
  const auto at_time = [](double t) { return glm::dvec3(t, 3 * t * t, 1); };
  EXPECT_DOUBLE_EQ(largest_jump(one_vertex(), {still, still, still}, places(at_time(4), at_time(5), at_time(6))), 6);
  // Joint 1 stops from one frame to the next, as does what it carries: 100 m, then none.
  const Pose there = {Matrix(1.0), matrix(turn(0, {0, 0, 1}), {100, 0, 0})};
  EXPECT_EQ(largest_jump(one_vertex(), {still, there, there}, places({1, 0, 0}, {101, 0, 0}, {101, 0, 0})), 0);
  // Half a metre that it is behind for a frame counts twice.
  EXPECT_DOUBLE_EQ(largest_jump(one_vertex(), {still, there, there}, places({1, 0, 0}, {100.5, 0, 0}, {101, 0, 0})), 1);
}

// Joint 1 turns by 90° a frame. What turns with it does not jump. What stays at (1, 0, 0) is, seen from it, at
// (1, 0, 0), (0, -1, 0) and (-1, 0, 0): a second difference of (0, 2, 0). A joint twice as large sees it half as far.
TEST(Folds, JumpsAreSeenFromAJointThatTurns) {
  const auto frames = [](double scale) {
    FramesInARow out;
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = {Matrix(1.0), matrix(turn(90.0 * static_cast<double>(k), {0, 0, 1}), {}, scale)};
    return out;
  };
  EXPECT_NEAR(largest_jump(one_vertex(), frames(1), places({1, 0, 0}, {0, 1, 0}, {-1, 0, 0})), 0, 1e-15);
  EXPECT_NEAR(largest_jump(one_vertex(), frames(1), places({1, 0, 0}, {1, 0, 0}, {1, 0, 0})), 2, 1e-15);
  EXPECT_NEAR(largest_jump(one_vertex(), frames(2), places({1, 0, 0}, {1, 0, 0}, {1, 0, 0})), 1, 1e-15);
  EXPECT_EQ(largest_jump(one_vertex(), frames(0), places({1, 0, 0}, {1, 0, 0}, {1, 0, 0})), 0) << "no inverse";
  SkinnedMesh loose = one_vertex();
  loose.influences = {{}};
  EXPECT_EQ(largest_jump(loose, frames(1), places({1, 0, 0}, {1, 0, 0}, {1, 0, 0})), 0);
}

}  // namespace
}  // namespace marrow::deform
