// Multi-weight enveloping: the paper's formula by hand, weights that are known, and the figures of a study.
#include "deform/fit/multi_weight.h"

#include <bit>

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

TEST(MultiWeight, IsThePapersFormulaByHand) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 2, 3}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}};
  mesh.joint_count = 2;
  // Row x weighs joint 1's elements (1, 1), (1, 2) and translation, row y a single one, row z takes z from joint 0.
  MultiWeights weights(1);
  weights[0].push_back({0, {glm::dvec4(0), glm::dvec4(0), glm::dvec4(0, 0, 2, 0)}});
  weights[0].push_back({1, {glm::dvec4(0.5, 0.25, 7, 3), glm::dvec4(4, 0, 0, 0), glm::dvec4(0)}});
  // A quarter turn about z and a step: rows (0 -1 0 10), (1 0 0 20), (0 0 1 30).
  const Pose pose = {matrix(turn(0, {0, 0, 1}), {}), matrix(turn(90, {0, 0, 1}), {10, 20, 30})};
  // x: 0.25 · -1 · 2 + 3 · 10; y: 4 · 1 · 1; z: 2 · 1 · 3.
  const glm::dvec3 expected(29.5, 4, 6);
  EXPECT_LT(farthest(at(multi_weight(mesh, weights, 0), pose), {expected}), 1e-12);
  // Elsewhere, seen from the root it is the same.
  const glm::dquat rotation = turn(77, {1, -2, 3});
  const glm::dvec3 translation(30, -20, 5);
  EXPECT_LT(farthest(at(multi_weight(mesh, weights, 0), moved(rotation, translation, pose)),
                     {rotation * expected + translation}),
            1e-12);
}

TEST(MultiWeight, OfOneWeightIsSsd) {
  const SkinnedMesh mesh = cylinder();
  const MultiWeights single = single_weights(mesh);
  for (const std::uint32_t root : {0u, 1u})
    EXPECT_LT(rms(multi_weight(mesh, single, root), ssd(mesh), random_cylinder_poses(5, 1)), 1e-14);
}

// Weights of noise, in the frame of joint 0, wherever the character stands.
TEST(MultiWeight, FitFindsWeightsThatAreKnown) {
  SkinnedMesh mesh = cylinder();
  std::mt19937 random(3);
  MultiWeights known = single_weights(mesh);
  for (auto& vertex : known)
    for (MultiWeight& w : vertex)
      for (glm::dvec4& row : w.rows)
        for (int c = 0; c < 4; ++c) row[c] += 0.2 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
  std::vector<Pose> poses = random_cylinder_poses(40, 1), held = random_cylinder_poses(20, 2);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto x = static_cast<double>(i);
    poses[i] = moved(turn(17 * x, {1, x, 2}), {10 * x, 5, -3 * x}, poses[i]);
  }
  const MultiWeightFit fit =
      fit_multi_weights(mesh, 0, training(poses, 4), multi_weight(mesh, known, 0), {.ridges = {1e-13}});
  EXPECT_LT(rms(multi_weight(mesh, fit.weights, 0), multi_weight(mesh, known, 0), held), 1e-5);
  EXPECT_LT(fit.quality.share, 1e-3);
}

TEST(MultiWeight, FitLeavesSsdWhereItIsRight) {
  const SkinnedMesh mesh = cylinder();
  const MultiWeightFit fit = fit_multi_weights(mesh, 0, training(random_cylinder_poses(20, 1), 4), ssd(mesh));
  EXPECT_LT(rms(multi_weight(mesh, fit.weights, 0), ssd(mesh), random_cylinder_poses(20, 2)), 1e-6);
}

// On poses held out a study found 0.29 of SSD's error against dual quaternions, on other draws of the same poses; here
// it is 0.32, whatever small ridge.
TEST(MultiWeight, ReachesWhatAStudyFoundOnACylinder) {
  const SkinnedMesh mesh = cylinder();
  const Judge judge = [&](const auto& train, const auto& held, const Deformer& truth) -> Judged {
    const MultiWeightFit fit = fit_multi_weights(mesh, 0, train, truth);
    return {fit.quality.share, rms(multi_weight(mesh, fit.weights, 0), truth, held)};
  };
  EXPECT_LT(share_held_out(mesh, judge), 0.35);
}

// A truth with noise of 2 % of the radius, the same whenever a pose is asked for.
Deformer noisy(const Deformer& truth) {
  return [truth](const Pose& pose, Positions& out) {
    truth(pose, out);
    std::uint32_t seed = 1;
    for (int c = 0; c < 3; ++c)
      seed = seed * 31 + static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(pose[1][0][c]) >> 20);
    std::mt19937 random(seed);
    for (glm::dvec3& v : out)
      for (int c = 0; c < 3; ++c) {
        double sum = -6;  // of twelve uniform numbers: nearly normal, variance 1
        for (int i = 0; i < 12; ++i) sum += static_cast<double>(random()) / 4294967296.0;
        v[c] += 0.02 * sum;
      }
  };
}

// Four poses are too few for 24 unknowns a row; without enough regularisation the study's error rose to that of SSD.
TEST(MultiWeight, DoesNotOverfitAFewNoisyPoses) {
  const SkinnedMesh mesh = cylinder();
  const Deformer truth = dual_quaternions(mesh), reference = ssd(mesh);
  double share = 0, unregularised = 0;
  const int seeds = 6;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const auto train = training(random_cylinder_poses(4, seed + 10), 4);
    const std::vector<Pose> held = random_cylinder_poses(100, seed + 20);
    const MultiWeightFit fit = fit_multi_weights(mesh, 0, train, noisy(truth));
    const MultiWeightFit loose = fit_multi_weights(mesh, 0, train, noisy(truth), {.ridges = {1e-9}});
    const double from_ssd = rms(reference, truth, held);
    const double of_this = rms(multi_weight(mesh, fit.weights, 0), truth, held) / from_ssd;
    EXPECT_LT(of_this, 1.01) << seed;
    share += of_this / seeds;
    unregularised += rms(multi_weight(mesh, loose.weights, 0), truth, held) / from_ssd / seeds;
  }
  RecordProperty("share", std::to_string(share));
  RecordProperty("unregularised", std::to_string(unregularised));
  EXPECT_LT(share, 1);
  EXPECT_GT(unregularised, share);
}

}  // namespace
}  // namespace marrow::deform
