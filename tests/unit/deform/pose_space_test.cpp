// Pose-space deformation: what interpolation promises, arithmetic by hand, truths that are known.
#include "deform/fit/pose_space.h"

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "deform/rotations.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

TEST(PoseSpace, IsExactInItsExamplesAndTheBindPose) {
  const SkinnedMesh mesh = cylinder();
  const Deformer truth = dual_quaternions(mesh);
  const std::vector<Pose> poses = {cylinder_pose(100 * kDegree, 0), cylinder_pose(0, 120 * kDegree),
                                   cylinder_pose(90 * kDegree, 90 * kDegree),
                                   cylinder_pose(40 * kDegree, 20 * kDegree)};
  PoseSpaceOptions options;
  options.ridge = 1e-14;
  options.most_delta = 1e9;
  options.widths = {0.5};
  const PoseSpaceFit fit = fit_pose_space(mesh, kCylinderParents, training(poses, 1), truth, options);
  ASSERT_EQ(fit.space.examples.size(), poses.size());
  const Deformer got = pose_space(mesh, fit.space);
  for (const Pose& pose : poses) EXPECT_LT(farthest(at(got, pose), at(truth, pose)), 1e-6);
  EXPECT_LT(farthest(at(got, cylinder_pose(0, 0)), mesh.positions), 1e-12);
}

TEST(PoseSpace, MovesWithTheRoot) {
  const SkinnedMesh mesh = cylinder();
  const PoseSpaceFit fit =
      fit_pose_space(mesh, kCylinderParents, training(random_cylinder_poses(12, 1), 4), dual_quaternions(mesh));
  ASSERT_EQ(fit.space.examples.size(), 8u);
  const Deformer got = pose_space(mesh, fit.space);
  const glm::dquat rotation = turn(77, {1, -2, 3});
  const glm::dvec3 translation(30, -20, 5);
  const Pose bent = cylinder_pose(80 * kDegree, 50 * kDegree);
  Positions expected = at(got, bent);
  for (glm::dvec3& v : expected) v = rotation * v + translation;
  EXPECT_LT(farthest(at(got, moved(rotation, translation, bent)), expected), 1e-10);
}

// One vertex, half of whose weight is on a joint that turns: D = sin²(half the angle).
TEST(PoseSpace, InterpolatesByHand) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}};
  mesh.joint_count = 2;
  const auto pose = [](double degrees) {
    return Pose{matrix(turn(0, {0, 0, 1}), {}), matrix(turn(degrees, {0, 0, 1}), {})};
  };
  PoseSpace space;
  space.parents = kCylinderParents;
  space.sigma = 0.5;  // 1 / 2σ² = 2, and half the weight: φ = exp(-D)
  space.examples = {{local_rotations(pose(90), kCylinderParents), {{0, 0, 1}}}};
  const auto height = [&](double degrees) { return at(pose_space(mesh, space), pose(degrees))[0].z; };
  EXPECT_NEAR(height(0), 0, 1e-15);
  EXPECT_NEAR(height(90), 1 - std::exp(-0.5), 1e-12);                      // ½ from the bind pose
  EXPECT_NEAR(height(-90), (1 - std::exp(-0.5)) * std::exp(-1.0), 1e-12);  // half a turn from the example: D is 1
  EXPECT_NEAR(height(180), (1 - std::exp(-1.0)) * std::exp(-0.5), 1e-12);
  EXPECT_NEAR(at(pose_space(mesh, space), pose(90))[0].x, 0.5, 1e-12);
}

TEST(PoseSpace, TakesRotationsRelativeToParents) {
  const Pose pose = {matrix(turn(30, {0, 0, 1}), {1, 2, 3}), matrix(turn(80, {0, 0, 1}), {4, 5, 6}, 3),
                     matrix(turn(100, {0, 0, 1}), {})};
  const auto local = local_rotations(pose, {-1, 0, 0});
  EXPECT_NEAR(std::abs(glm::dot(local[0], turn(0, {0, 0, 1}))), 1, 1e-12) << "the character's own does not count";
  EXPECT_NEAR(std::abs(glm::dot(local[1], turn(50, {0, 0, 1}))), 1, 1e-12);
  EXPECT_NEAR(std::abs(glm::dot(local[2], turn(70, {0, 0, 1}))), 1, 1e-12);
}

// SSD with deltas that are a Gaussian of the same kind round two poses.
TEST(PoseSpace, FitFindsDeltasThatAreKnown) {
  const SkinnedMesh mesh = cylinder();
  const std::vector<Pose> poses = {cylinder_pose(100 * kDegree, 10 * kDegree),
                                   cylinder_pose(20 * kDegree, 110 * kDegree)};
  PoseSpace known;
  known.parents = kCylinderParents;
  for (const Pose& pose : poses) {
    PoseSpaceExample e{local_rotations(pose, kCylinderParents), {}};
    for (const glm::dvec3& v : mesh.positions) e.deltas.push_back(0.1 * glm::dvec3(v.y, 0.5, v.z * v.x));
    known.examples.push_back(e);
  }
  // The width that the fit will take: the root mean square distance from an example to the next or the bind pose, over
  // the vertices that follow joint 1. Of these two examples it is a few tenths.
  PoseSpaceOptions options;
  options.ridge = 1e-14;
  options.most_delta = 1e9;
  options.widths = {1};
  const PoseSpaceFit width =
      fit_pose_space(mesh, kCylinderParents, training(poses, 1), dual_quaternions(mesh), options);
  known.sigma = width.space.sigma;
  EXPECT_GT(known.sigma, 0.2);
  EXPECT_LT(known.sigma, 0.8);
  const Deformer truth = pose_space(mesh, known);
  const PoseSpaceFit fit = fit_pose_space(mesh, kCylinderParents, training(poses, 1), truth, options);
  ASSERT_EQ(fit.space.examples.size(), 2u);
  EXPECT_LT(rms(pose_space(mesh, fit.space), truth, random_cylinder_poses(20, 2)), 1e-6);
}

TEST(PoseSpace, FitLeavesSsdWhereItIsRight) {
  const SkinnedMesh mesh = cylinder();
  const PoseSpaceFit fit = fit_pose_space(mesh, kCylinderParents, training(random_cylinder_poses(10, 1), 5), ssd(mesh));
  EXPECT_EQ(fit.space.examples.size(), 0u);
  EXPECT_EQ(fit.quality.share, 1);
}

// A blend of opposite half turns has no volume: nothing can be said there, and nothing blows up.
TEST(PoseSpace, LeavesOutWhatCannotGoBackToTheBindPose) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 1, 0}, {1, 1, 1}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}, {{1, 1.0}}};
  mesh.joint_count = 2;
  const Pose pose = {matrix(turn(0, {0, 0, 1}), {}), matrix(turn(180, {0, 0, 1}), {})};
  const Deformer truth = [](const Pose&, Positions& out) { out = {{5, 5, 5}, {-1, -1, 2}}; };
  const PoseSpaceFit fit =
      fit_pose_space(mesh, kCylinderParents, training({pose}, 1), truth, {.ridge = 1e-14, .most_delta = 10});
  ASSERT_EQ(fit.space.examples.size(), 1u);
  EXPECT_EQ(fit.space.examples[0].deltas[0], glm::dvec3(0));
  EXPECT_LT(glm::length(at(pose_space(mesh, fit.space), pose)[1] - glm::dvec3(-1, -1, 2)), 1e-9);
}

TEST(PoseSpace, BeatsSsdOnPosesHeldOut) {
  const SkinnedMesh mesh = cylinder();
  const Judge judge = [&](const auto& train, const auto& held, const Deformer& truth) -> Judged {
    const PoseSpaceFit fit = fit_pose_space(mesh, kCylinderParents, train, truth);
    return {fit.quality.share, rms(pose_space(mesh, fit.space), truth, held)};
  };
  EXPECT_LT(share_held_out(mesh, judge), 0.5);
}

TEST(PoseSpace, DeltasStayShort) {
  const SkinnedMesh mesh = cylinder();
  for (const double most : {0.1, 0.02}) {
    PoseSpaceOptions options;
    options.most_delta = most;
    const PoseSpaceFit fit = fit_pose_space(mesh, kCylinderParents, training(random_cylinder_poses(12, 1), 4),
                                            dual_quaternions(mesh), options);
    double longest = 0;
    for (const PoseSpaceExample& e : fit.space.examples)
      for (const glm::dvec3& d : e.deltas) longest = std::max(longest, glm::length(d));
    EXPECT_GT(longest, 0);
    EXPECT_LE(longest, most * diagonal(mesh));
    EXPECT_LT(fit.quality.share, 1);
  }
}

TEST(PoseSpace, FitIsTheSameEveryTime) {
  const SkinnedMesh mesh = cylinder();
  const auto once = [&] {
    return fit_pose_space(mesh, kCylinderParents, training(random_cylinder_poses(10, 1), 5), dual_quaternions(mesh));
  };
  const PoseSpaceFit a = once(), b = once();
  ASSERT_EQ(a.chosen, b.chosen);
  ASSERT_GT(a.chosen.size(), 0u);
  EXPECT_EQ(a.space.sigma, b.space.sigma);
  for (std::size_t k = 0; k < a.chosen.size(); ++k) EXPECT_EQ(a.space.examples[k].deltas, b.space.examples[k].deltas);
}

}  // namespace
}  // namespace marrow::deform
