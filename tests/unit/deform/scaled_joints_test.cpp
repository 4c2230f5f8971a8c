// What dual quaternions and centres of rotation make of joints that scale, by hand arithmetic; and the rotations that
// they take out of matrices.
#include <limits>

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "deform/rotations.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

const Pose kTurned = cylinder_pose(70 * kDegree, 40 * kDegree);

// A matrix before every joint's.
Pose before(const glm::dmat3& linear, const glm::dvec3& translation, Pose pose) {
  for (Matrix& m : pose) {
    for (int c = 0; c < 4; ++c) m[c] = linear * m[c];
    m[3] += translation;
  }
  return pose;
}

Matrix about(const glm::dvec3& centre, const glm::dmat3& linear) {
  return {linear[0], linear[1], linear[2], centre - linear * centre};
}

glm::dmat3 diagonal_of(double x, double y, double z) {
  return {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
}

// One vertex between two joints.
SkinnedMesh half_of_each(const glm::dvec3& at) {
  SkinnedMesh mesh;
  mesh.positions = {at};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}};
  mesh.joint_count = 2;
  return mesh;
}

std::vector<std::pair<const char*, Deformer>> both(const SkinnedMesh& mesh) {
  return {{"dual quaternions", dual_quaternions(mesh)}, {"centres of rotation", centres_of_rotation(mesh)}};
}

// Stretched along an axis that is none of the mesh's, and not turned: Gram and Schmidt would find a turn.
TEST(ScaledJoints, WithoutRotationAreBlendedLinearly) {
  const SkinnedMesh mesh = cylinder();
  const glm::dmat3 turned = glm::mat3_cast(turn(35, {1, 2, 3}));
  const Matrix stretched = about({0.5, 0.2, -0.1}, turned * diagonal_of(2, 0.7, 1.1) * glm::transpose(turned));
  const Pose pose = {cylinder_pose(0, 0)[0], stretched};
  for (const auto& [name, deformer] : both(mesh))
    EXPECT_LT(farthest(at(deformer, pose), at(ssd(mesh), pose)), 1e-12) << name;
}

// A joint turns a quarter about z and scales by 2, about its place c; a vertex at c + d, d = x, follows it by half. In
// complex numbers, with A = (1 - i tan 22.5°) / 2 what half of such a turn takes of a displacement:
// d + A (2 i d - d) = (√2 - 1/2) + i (√2 + 1) / 2. Where c is makes no difference.
TEST(ScaledJoints, TurnAVertexAboutItsOwnJoint) {
  for (const glm::dvec3& c : {glm::dvec3(0), glm::dvec3(5, 0, 0), glm::dvec3(-3, 70, 11)}) {
    const SkinnedMesh mesh = half_of_each(c + glm::dvec3(1, 0, 0));
    const Pose pose = {Matrix(1.0), about(c, glm::mat3_cast(turn(90, {0, 0, 1})) * 2.0)};
    const double root = std::sqrt(2.0);
    EXPECT_LT(farthest(at(dual_quaternions(mesh), pose), {c + glm::dvec3(root - 0.5, (root + 1) / 2, 0)}), 1e-12);
  }
}

// What lies on the joint stays there: both joints take it to one place.
TEST(ScaledJoints, LeaveTheirOwnPlace) {
  const glm::dvec3 c(5, -2, 1);
  const SkinnedMesh mesh = half_of_each(c);
  const Pose pose = {Matrix(1.0), about(c, glm::mat3_cast(turn(130, {1, 0, 1})) * diagonal_of(2, 3, 0.1))};
  for (const auto& [name, deformer] : both(mesh)) EXPECT_LT(farthest(at(deformer, pose), {c}), 1e-12) << name;
}

TEST(ScaledJoints, OfEqualScaleScaleTheWhole) {
  const SkinnedMesh mesh = cylinder();
  const glm::dvec3 translation(3, -4, 5);
  for (const auto& [name, deformer] : both(mesh)) {
    Positions expected = at(deformer, kTurned);
    for (glm::dvec3& v : expected) v = v * 2.0 + translation;
    EXPECT_LT(farthest(at(deformer, before(diagonal_of(2, 2, 2), translation, kTurned)), expected), 1e-12) << name;
  }
}

TEST(ScaledJoints, ThatAllMirrorMirrorTheWhole) {
  const SkinnedMesh mesh = cylinder();
  for (const auto& [name, deformer] : both(mesh)) {
    Positions expected = at(deformer, kTurned);
    for (glm::dvec3& v : expected) v.x = -v.x;
    EXPECT_LT(farthest(at(deformer, before(diagonal_of(-1, 1, 1), {0, 0, 0}, kTurned)), expected), 1e-12) << name;
  }
}

// Half way to a mirror image lies the mirror.
TEST(ScaledJoints, ThatMirrorMeetInTheMirror) {
  const SkinnedMesh mesh = half_of_each({3, 4, 5});
  const Pose pose = {Matrix(1.0), about({1, 7, 7}, diagonal_of(-1, 1, 1))};
  for (const auto& [name, deformer] : both(mesh)) EXPECT_LT(farthest(at(deformer, pose), {{1, 4, 5}}), 1e-12) << name;
}

// A mesh does not know where its origin is.
TEST(ScaledJoints, DoNotDependOnTheOrigin) {
  const SkinnedMesh mesh = cylinder();
  const glm::dvec3 away(100, -50, 30);
  SkinnedMesh other = mesh;
  for (glm::dvec3& v : other.positions) v += away;
  Pose pose = kTurned;
  for (int c = 0; c < 3; ++c) pose[1][c] *= 1.5;
  Pose same = pose;
  for (Matrix& m : same) m[3] -= linear_of(m) * away;
  EXPECT_LT(farthest(at(dual_quaternions(other), same), at(dual_quaternions(mesh), pose)), 1e-12);
  EXPECT_LT(farthest(at(centres_of_rotation(other), same), at(centres_of_rotation(mesh), pose)), 1e-12);
}

TEST(ScaledJoints, OfScale0GiveFinitePlaces) {
  const SkinnedMesh mesh = cylinder();
  for (const glm::dmat3& linear : {diagonal_of(0, 0, 0), diagonal_of(1, 0, 0), diagonal_of(1e-200, 1e-200, 1e-200)})
    for (const auto& [name, deformer] : both(mesh))
      EXPECT_TRUE(is_finite(at(deformer, {kTurned[1], about({1, 2, 3}, linear)}))) << name;
}

TEST(NearestRotation, IsTheRotationOfAStretch) {
  const glm::dmat3 rotation = glm::mat3_cast(turn(100, {3, -1, 2})), axes = glm::mat3_cast(turn(20, {1, 1, 0}));
  std::size_t counted = 0;
  for (const double least : {1.0, 0.3, 1e-2, 1e-4}) {
    for (const double size : {1e-20, 1.0, 1e20}) {
      const glm::dmat3 m = rotation * axes * (diagonal_of(1, least, 0.5 + least) * size) * glm::transpose(axes);
      EXPECT_TRUE(has_rotation(m));
      for (const glm::dmat3& found : {nearest_rotation(m), nearest_rotation(-m)})
        for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(found[c] - rotation[c]), 1e-11) << least << ' ' << size;
      ++counted;
    }
  }
  EXPECT_EQ(counted, 12u);
}

TEST(NearestRotation, IsTheIdentityWhereThereIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const glm::dmat3& m : {diagonal_of(0, 0, 0), diagonal_of(1, 1, 0), diagonal_of(1, 1, 1e-8),
                              diagonal_of(1, nan, 1), diagonal_of(1, infinity, 1), diagonal_of(1e200, 1e200, 1e200)}) {
    EXPECT_FALSE(has_rotation(m));
    EXPECT_EQ(nearest_rotation(m), glm::dmat3(1.0));
  }
}

}  // namespace
}  // namespace marrow::deform
