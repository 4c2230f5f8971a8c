// The offline deformers, against what their papers promise and hand arithmetic.
#include "deform/deformers.h"
#include "deform/surface.h"

#include <gtest/gtest.h>

#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

std::vector<std::pair<const char*, Deformer>> all(const SkinnedMesh& mesh) {
  return {{"rigid", rigid(mesh)},
          {"ssd", ssd(mesh)},
          {"dual quaternions", dual_quaternions(mesh)},
          {"centres of rotation", centres_of_rotation(mesh)},
          {"delta mush", delta_mush(mesh)},
          {"delta mush over dual quaternions", delta_mush(mesh, {}, dual_quaternions(mesh))},
          {"delta mush, cotangents", delta_mush(mesh, {30, 1.0, EdgeWeights::cotangent})}};
}

TEST(Deformers, KeepTheBindPose) {
  const SkinnedMesh mesh = cylinder();
  for (const auto& [name, deformer] : all(mesh))
    EXPECT_LT(farthest(at(deformer, cylinder_pose(0, 0)), mesh.positions), 1e-12) << name;
}

TEST(Deformers, MoveWithTheRoot) {
  const SkinnedMesh mesh = cylinder();
  const glm::dquat rotation = turn(77, {1, -2, 3});
  const glm::dvec3 translation(30, -20, 5);
  for (const auto& [name, deformer] : all(mesh)) {
    Positions expected = at(deformer, kBent);
    for (glm::dvec3& v : expected) v = rotation * v + translation;
    EXPECT_LT(farthest(at(deformer, moved(rotation, translation, kBent)), expected), 1e-10) << name;
  }
}

TEST(Deformers, FollowOneJointRigidly) {
  const SkinnedMesh mesh = cylinder();
  std::size_t counted = 0;
  for (const auto& [name, deformer] : all(mesh)) {
    const bool smooths = std::string(name).starts_with("delta");
    const Positions now = at(deformer, kBent);
    for (std::size_t v = 0; v < now.size(); ++v) {
      // Far enough from the ramp, smoothing does not reach.
      if (mesh.influences[v].size() != 1 || (smooths && std::abs(mesh.positions[v].x) < 4.9)) continue;
      const Matrix& m = kBent[mesh.influences[v][0].joint];
      EXPECT_LT(glm::length(now[v] - transform(m, mesh.positions[v])), smooths ? 1e-3 : 1e-12) << name;
      ++counted;
    }
  }
  EXPECT_GT(counted, 4000u);
}

// What linear blending has wrung out smoothing does not bring back; what is whole stays so.
TEST(Deformers, DeltaMushSmoothsWhatItIsOver) {
  const SkinnedMesh mesh = cylinder();
  const auto waist = [&](const Deformer& deformer) {
    double out = 1;
    for (const glm::dvec3& p : at(deformer, cylinder_pose(0, 170 * kDegree)))
      if (std::abs(p.x) < 4) out = std::min(out, std::hypot(p.y, p.z));
    return out;
  };
  EXPECT_LT(waist(delta_mush(mesh)), 0.3);
  EXPECT_GT(waist(delta_mush(mesh, {}, dual_quaternions(mesh))), 0.7);
}

// Half of a quarter turn is an eighth; the screw's axis is the joint's.
TEST(DualQuaternions, MeetHalfWay) {
  SkinnedMesh mesh;
  mesh.positions = {{2, 0, 1}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}};
  mesh.joint_count = 2;
  const Pose pose = {matrix(turn(0, {0, 0, 1}), {0, 0, 0}), matrix(turn(90, {0, 0, 1}), {0, 0, 4})};
  const double half = std::sqrt(2.0);
  EXPECT_LT(farthest(at(dual_quaternions(mesh), pose), {{half, half, 3}}), 1e-12);
  // Linear blending cuts the corner.
  EXPECT_LT(farthest(at(ssd(mesh), pose), {{1, 1, 3}}), 1e-12);
}

TEST(DualQuaternions, TakeTheShorterWay) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}};
  mesh.joint_count = 2;
  const Pose pose = {matrix(turn(170, {0, 0, 1}), {}), matrix(turn(190, {0, 0, 1}), {})};
  EXPECT_LT(farthest(at(dual_quaternions(mesh), pose), {{-1, 0, 0}}), 1e-12);
}

TEST(DualQuaternions, BlendScaleLinearly) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 2, 3}};
  mesh.influences = {{{0, 0.25}, {1, 0.75}}};
  mesh.joint_count = 2;
  const Pose pose = {matrix(turn(0, {0, 0, 1}), {}, 1), matrix(turn(0, {0, 0, 1}), {}, 2)};
  EXPECT_LT(farthest(at(dual_quaternions(mesh), pose), {{1.75, 3.5, 5.25}}), 1e-12);
}

// A twisted cylinder keeps its radius by both methods, and wrings under linear blending.
TEST(Deformers, OnlyLinearBlendingWringsACylinder) {
  const SkinnedMesh mesh = cylinder();
  const Pose twisted = cylinder_pose(0, 120 * kDegree);
  const auto least_radius = [&](const Deformer& deformer) {
    const Positions now = at(deformer, twisted);
    double least = 1e9;
    for (std::size_t v = 0; v < 2000; ++v) least = std::min(least, std::hypot(now[v].y, now[v].z));
    return least;
  };
  EXPECT_NEAR(least_radius(dual_quaternions(mesh)), 1, 1e-12);
  EXPECT_NEAR(least_radius(centres_of_rotation(mesh)), 1, 1e-3);
  EXPECT_LT(least_radius(ssd(mesh)), 0.55);
}

// The volumes that a study of this cylinder found for linear blending: 0.950, 0.902, 0.925.
TEST(Ssd, LosesTheVolumeThatAStudyFound) {
  const SkinnedMesh mesh = cylinder();
  const double whole = volume(mesh.positions, mesh.indices);
  const auto share = [&](double bend, double twist) {
    return volume(at(ssd(mesh), cylinder_pose(bend * kDegree, twist * kDegree)), mesh.indices) / whole;
  };
  EXPECT_NEAR(share(120, 0), 0.950, 1e-3);
  EXPECT_NEAR(share(0, 120), 0.902, 1e-3);
  EXPECT_NEAR(share(120, 120), 0.925, 1e-3);
}

// By symmetry centres lie on the axis; the weights of a ring are alike, so its centre is near its middle.
TEST(RotationCentres, LieOnTheAxisOfACylinder) {
  const SkinnedMesh mesh = cylinder();
  const Positions centres = rotation_centres(mesh);
  std::size_t counted = 0;
  for (std::size_t v = 0; v < centres.size(); ++v) {
    if (mesh.influences[v].size() == 1) {
      EXPECT_EQ(centres[v], mesh.positions[v]);
      continue;
    }
    ++counted;
    EXPECT_LT(std::hypot(centres[v].y, centres[v].z), 0.02);
    if (std::abs(mesh.positions[v].x) < 1) {
      EXPECT_NEAR(centres[v].x, mesh.positions[v].x, 0.2);
    }
  }
  EXPECT_EQ(counted, 14u * 40u);
}

// Equation 1 there, summed over all triangles and pairs for one vertex.
TEST(RotationCentres, AreThePapersIntegral) {
  SkinnedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 3}};
  mesh.indices = {0, 1, 2, 1, 3, 2};
  mesh.influences = {{{0, 0.5}, {1, 0.3}, {2, 0.2}}, {{0, 0.4}, {1, 0.6}}, {{1, 0.5}, {2, 0.5}}, {{0, 0.1}, {2, 0.9}}};
  mesh.joint_count = 3;
  const auto dense = [&](std::size_t v) {
    std::array<double, 3> w{};
    for (const Influence& i : mesh.influences[v]) w[i.joint] = i.weight;
    return w;
  };
  glm::dvec3 sum(0);
  double total = 0;
  const std::array<double, 3> p = dense(0);
  for (std::size_t t = 0; t < 6; t += 3) {
    const std::uint32_t* const c = &mesh.indices[t];
    std::array<double, 3> q{};
    for (int i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) q[j] += dense(c[i])[j] / 3;
    const glm::dvec3 &a = mesh.positions[c[0]], &b = mesh.positions[c[1]], &d = mesh.positions[c[2]];
    const double area = glm::length(glm::cross(b - a, d - a)) / 2;
    double alike = 0;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        if (j != k) alike += p[j] * p[k] * q[j] * q[k] * std::exp(-std::pow(p[j] * q[k] - p[k] * q[j], 2) / 0.01);
    sum += (a + b + d) / 3.0 * alike * area;
    total += alike * area;
  }
  EXPECT_LT(glm::length(rotation_centres(mesh)[0] - sum / total), 1e-12);
}

TEST(DeltaMush, WithoutSmoothingIsSsd) {
  const SkinnedMesh mesh = cylinder();
  EXPECT_LT(farthest(at(delta_mush(mesh, {0, 0.5}), kBent), at(ssd(mesh), kBent)), 1e-12);
}

// One step by hand on a pyramid whose base is a border: the tip goes half way to the mean of its neighbours, its detail
// back along the normal.
TEST(DeltaMush, PutsDetailBackInTheFrameOfTheSurface) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 2}};
  mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  mesh.influences = {{{0, 1.0}}, {{0, 1.0}}, {{0, 1.0}}, {{0, 1.0}}, {{1, 1.0}}};
  mesh.joint_count = 2;
  const Pose raised = {matrix(turn(0, {0, 0, 1}), {}), matrix(turn(0, {0, 0, 1}), {0, 0, 1})};
  // Smoothed the tip is at 1.5 instead of 1; the detail is 1 upward. Borders stay.
  Positions expected = mesh.positions;
  expected[4] = {0, 0, 2.5};
  EXPECT_LT(farthest(at(delta_mush(mesh, {1, 0.5}), raised), expected), 1e-12);
}

TEST(DeltaMush, SoftensWhereSsdCreases) {
  const SkinnedMesh mesh = cylinder();
  const Pose bent = cylinder_pose(100 * kDegree, 0);
  const auto longest_edge = [&](const Positions& p) {
    double longest = 0;
    for (std::size_t i = 0; i + 40 < 2000; ++i) longest = std::max(longest, glm::length(p[i] - p[i + 40]));
    return longest;
  };
  EXPECT_LT(longest_edge(at(delta_mush(mesh, {30, 1.0}), bent)), 0.9 * longest_edge(at(ssd(mesh), bent)));
}

// The same pyramid. Its sides have an area of 2 √2 √(h² + 1/2) at a height of h, 2 at first, 2 (1 - step) after a step.
TEST(DeltaMush, ShortensStepsThatLeaveTooLittle) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 2}};
  mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  mesh.influences.assign(5, {{0, 1.0}});
  mesh.joint_count = 1;
  EXPECT_NEAR(area_kept(mesh, {1, 0.5}), std::sqrt(1.5 / 4.5), 1e-12);
  EXPECT_EQ(with_least_area(mesh, {1, 0.5}).step, 0.5);
  // A step of 1 leaves a third, of 7/8 .354, of 49/64 .39992, of 343/512 .456.
  EXPECT_NEAR(area_kept(mesh, {1, 1.0}), 1.0 / 3, 1e-12);
  EXPECT_EQ(with_least_area(mesh, {1, 1.0}).step, 343.0 / 512);
  EXPECT_EQ(with_least_area(mesh, {1, 1.0}).iterations, 1);
}

TEST(DeltaMush, KeepsItsStepsOnAMeshWithoutArea) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  mesh.indices = {0, 1, 2};
  mesh.influences.assign(3, {{0, 1.0}});
  mesh.joint_count = 1;
  EXPECT_EQ(area_kept(mesh, {}), 1);
  EXPECT_EQ(with_least_area(mesh, {}).step, DeltaMushOptions().step);
}

TEST(Surface, FindsNeighboursAndBorders) {
  SkinnedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.influences.assign(5, {{0, 1.0}});
  mesh.joint_count = 1;
  const Surface surface(mesh);
  EXPECT_EQ(surface.neighbours(0).size(), 3u);
  EXPECT_EQ(surface.neighbours(1).size(), 2u);
  EXPECT_TRUE(surface.neighbours(4).empty());
  for (std::size_t v = 0; v < 4; ++v) EXPECT_TRUE(surface.on_border(v));
  // The diagonal lies opposite two right angles: it counts nothing. The sides lie opposite 45°.
  const Surface by_angle(mesh, EdgeWeights::cotangent);
  EXPECT_NEAR(by_angle.weights(0)[0], 0.5, 1e-12);
  EXPECT_NEAR(by_angle.weights(0)[1], 0.0, 1e-12);
  EXPECT_NEAR(by_angle.weights(0)[2], 0.5, 1e-12);
}

}  // namespace
}  // namespace marrow::deform
