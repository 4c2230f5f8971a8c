#include "deform/helpers/never_worse.h"

#include <limits>

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "deform/helpers/never_worse.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

// A vertex half way between joints 0 and 1, one half way between 0 and 2, one that follows joint 0.
SkinnedMesh fork() {
  SkinnedMesh mesh;
  mesh.joint_count = 3;
  mesh.positions = {{1, 1, 0}, {1, 2, 0}, {0, 1, 0}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}, {{0, 0.5}, {2, 0.5}}, {{0, 1}}};
  return mesh;
}

// The first two follow helpers alone.
Coordinates on_helpers(const SkinnedMesh& mesh) {
  return {lift({{3, 1.0}}, mesh.positions[0]), lift({{4, 1.0}}, mesh.positions[1]),
          lift({{0, 1.0}}, mesh.positions[2])};
}

// Joint j turned by a right angle about z through the origin.
Pose bent(std::uint32_t j) {
  Pose pose(3, Matrix(1.0));
  pose[j] = matrix(turn(90, {0, 0, 1}), {0, 0, 0});
  return pose;
}

std::vector<char> back(const SkinnedMesh& mesh, const std::vector<Helper>& helpers, const std::vector<Pose>& poses,
                       const Deformer& truth) {
  return better_by_ssd(
      mesh, on_helpers(mesh), helpers, poses.size(), [&](std::size_t i) { return poses[i]; }, truth);
}

TEST(BetterBySsd, IsNothingThatHelpersMend) {
  const SkinnedMesh mesh = fork();
  const std::vector<Helper> helpers = {{0, 1, 0.5, {0, 0, 0}, true}, {0, 2, 0.5, {0, 0, 0}, true}};
  EXPECT_EQ(back(mesh, helpers, {bent(1), bent(2), bent(0)}, dual_quaternions(mesh)), (std::vector<char>{0, 0, 0}));
}

// About a centre ten away the second helper goes far off, by hand: R (c - m) with c (10, 0, 0) at 45° goes to the mean
// of where both take it, (5, 5, 0), and so the vertex (1, 2, 0) to (-2.8, 0.05, 0) instead of (-0.7, 2.1, 0).
TEST(BetterBySsd, IsTheSetOfJointsThatIsWorse) {
  const SkinnedMesh mesh = fork();
  const std::vector<Helper> helpers = {{0, 1, 0.5, {0, 0, 0}, true}, {0, 2, 0.5, {10, 0, 0}, false}};
  EXPECT_EQ(back(mesh, helpers, {bent(1), bent(2)}, dual_quaternions(mesh)), (std::vector<char>{0, 1, 0}));
  EXPECT_EQ(back(mesh, helpers, {bent(1)}, dual_quaternions(mesh)), (std::vector<char>{0, 0, 0}))
      << "where the second does not turn it does no harm";
}

TEST(BetterBySsd, TakesNoPoseWhoseTruthIsNotFinite) {
  const SkinnedMesh mesh = fork();
  const std::vector<Helper> helpers = {{0, 1, 0.5, {0, 0, 0}, true}, {0, 2, 0.5, {10, 0, 0}, false}};
  const Deformer nowhere = [](const Pose&, Positions& out) {
    out.assign(3, glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  };
  EXPECT_EQ(back(mesh, helpers, {bent(1), bent(2)}, nowhere), (std::vector<char>{0, 0, 0}));
  EXPECT_EQ(back(mesh, helpers, {}, nowhere), (std::vector<char>{0, 0, 0}));
  EXPECT_TRUE(better_by_ssd(
                  SkinnedMesh(), {}, {}, 1, [](std::size_t) { return Pose(); }, nowhere)
                  .empty());
}

// A vertex that is drawn out as soon as the joints part. It and its rings go back, what is far from it does not.
TEST(UglierThanSsd, IsWhatSticksOut) {
  const SkinnedMesh mesh = cylinder();
  Coordinates coordinates = lift(mesh);
  const auto back = [&] {
    const std::vector<Pose> poses = {kBent, cylinder_pose(0, 60 * kDegree), cylinder_pose(0, 0)};
    return uglier_than_ssd(mesh, coordinates, lift(mesh), {}, poses);
  };
  const Ugliness plain = back();
  for (const double share : plain.goes_back) ASSERT_EQ(share, 0);
  std::size_t spike = 0;
  while (std::abs(mesh.positions[spike].x) > 0.2) ++spike;
  for (const double sign : {1.0, -1.0})
    coordinates[spike][sign > 0 ? 0 : 1].q += glm::dvec4(mesh.positions[spike] * glm::dvec3(0, 3, 3) * sign, 0);
  const Ugliness spiky = back();
  EXPECT_GT(spiky.total, plain.total);
  const std::vector<double>& shares = spiky.goes_back;
  EXPECT_GT(shares[spike], 0.9);
  std::size_t none = 0;
  for (std::size_t v = 0; v < shares.size(); ++v) {
    if (std::abs(mesh.positions[v].x - mesh.positions[spike].x) < 3) continue;
    EXPECT_EQ(shares[v], 0);
    ++none;
  }
  EXPECT_GT(none, 700u);
}

// A vertex that is thrown 40 times as far out as the joints part, in frames that joint 1 turns through by 10, 20 and 40
// degrees. Where nothing moves, or all as fast, nothing jumps.
TEST(JumpsMoreThanSsd, IsWhatIsThrown) {
  const SkinnedMesh mesh = cylinder();
  Coordinates coordinates = lift(mesh);
  const std::vector<FramesInARow> frames = {
      {cylinder_pose(10 * kDegree, 0), cylinder_pose(20 * kDegree, 0), cylinder_pose(40 * kDegree, 0)},
      {cylinder_pose(0, 0), cylinder_pose(0, 0), cylinder_pose(0, 0)}};
  for (const double share : jumps_more_than_ssd(mesh, coordinates, lift(mesh), {}, frames)) ASSERT_EQ(share, 0);
  std::size_t thrown = 0;
  while (std::abs(mesh.positions[thrown].x) > 0.2) ++thrown;
  for (const double sign : {1.0, -1.0})
    coordinates[thrown][sign > 0 ? 0 : 1].q += glm::dvec4(mesh.positions[thrown] * glm::dvec3(0, 40, 40) * sign, 0);
  const std::vector<double> back = jumps_more_than_ssd(mesh, coordinates, lift(mesh), {}, frames);
  EXPECT_GT(back[thrown], 0.8);
  std::size_t none = 0;
  for (std::size_t v = 0; v < back.size(); ++v) none += back[v] == 0 ? 1 : 0;
  EXPECT_GT(none, 700u);
  for (const double share : jumps_more_than_ssd(mesh, coordinates, lift(mesh), {}, {frames[1]})) EXPECT_EQ(share, 0);
  EXPECT_EQ(jumps_more_than_ssd(mesh, coordinates, lift(mesh), {}, {})[thrown], 0);
}

}  // namespace
}  // namespace marrow::deform
