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

// Of 3 t² the second difference is 6.
TEST(Folds, JumpsAreSecondDifferences) {
  const auto at_time = [](double t) { return Positions{{t, 0, 0}, {0, 3 * t * t, 1}}; };
  EXPECT_DOUBLE_EQ(largest_jump(at_time(4), at_time(5), at_time(6)), 6);
}

}  // namespace
}  // namespace marrow::deform
