#include "deform/half_joints.h"

#include <gtest/gtest.h>

#include "marrow/palette.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

double apart(const Matrix& a, const Matrix& b) {
  double worst = 0;
  for (int c = 0; c < 4; ++c) worst = std::max(worst, glm::length(a[c] - b[c]));
  return worst;
}

TEST(HalfWay, EndsAtParentAndJoint) {
  const Matrix parent = matrix(turn(40, {1, 2, 3}), {1, 2, 3}, 1.5),
               joint = matrix(turn(140, {3, -1, 0}), {0, 5, 1}, 0.7);
  EXPECT_LT(apart(half_way(parent, joint, {4, 5, 6}, 0), parent), 1e-12);
  EXPECT_LT(apart(half_way(parent, joint, {4, 5, 6}, 1), joint), 1e-12);
}

// A quarter turn about a joint at x = 2: half of it is an eighth about the same place.
TEST(HalfWay, TurnsHalfAboutTheJoint) {
  const glm::dvec3 centre(2, 0, 0);
  const auto about = [&](double degrees) {
    const glm::dquat q = turn(degrees, {0, 0, 1});
    return matrix(q, centre - q * centre);
  };
  EXPECT_LT(apart(half_way(about(0), about(90), centre, 0.5), about(45)), 1e-12);
  EXPECT_LT(apart(half_way(about(0), about(90), centre, 1.0 / 3), about(30)), 1e-12);
  EXPECT_LT(apart(half_way(about(20), about(-70), centre, 0.5), about(-25)), 1e-12);
}

// Where the character is, and mirrored, makes no difference.
TEST(HalfWay, MovesWithTheRoot) {
  const Pose pose = {matrix(turn(10, {1, 0, 0}), {1, 0, 0}), matrix(turn(100, {0, 1, 1}), {0, 1, 0})};
  const Matrix between = half_way(pose[0], pose[1], {1, 1, 1}, 0.5);
  const Pose there = moved(turn(200, {1, 1, 0}), {7, 8, 9}, pose);
  EXPECT_LT(apart(half_way(there[0], there[1], {1, 1, 1}, 0.5), moved(turn(200, {1, 1, 0}), {7, 8, 9}, {between})[0]),
            1e-12);
}

Affine to_affine(const Matrix& m) {
  Affine out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) out.rows[r][c] = static_cast<float>(m[c][r]);
  return out;
}

Matrix to_matrix(const Affine& a) {
  Matrix out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) out[c][r] = static_cast<double>(a.rows[r][c]);
  return out;
}

// The runtime's, which blends dual quaternions: the same where both take the centre to one place.
TEST(HalfWay, IsWhatTheRuntimeMakes) {
  std::mt19937 random(11);
  const auto some = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  const std::vector<std::uint16_t> joints = {0, 1};
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 centre(some(), some(), some());
    const glm::dvec3 place(some(), some(), some());
    Matrix m[2];
    for (Matrix& part : m) {
      part = matrix(turn(180 * some(), {some(), some(), some()}), {some(), some(), some()}, 1.5 + some());
      if (i % 3 == 0) part[0] *= -1.0;           // mirrored
      if (i % 5 == 0) part[1] += part[0] * 0.2;  // sheared
      part[3] = place - linear_of(part) * centre;
    }
    // bind takes the centre to the origin, so the scene's matrices are as follows.
    const Matrix from_bind = matrix(turn(0, {0, 0, 1}), -centre);
    std::vector<Affine> scene;
    for (const Matrix& part : m)
      scene.push_back(to_affine({part[0], part[1], part[2], part[3] + linear_of(part) * centre}));
    const std::vector<Affine> bind(2, to_affine(from_bind));
    std::vector<Affine> out(3);
    const float share = 0.5f;
    ASSERT_EQ(build_palette(joints, bind, scene, out, std::vector<Helper>{{0, 1, share}}), Status::ok);
    const Matrix want = half_way(m[0], m[1], centre, static_cast<double>(share));
    EXPECT_LT(apart(to_matrix(out[2]), want), 2e-5) << i;
  }
}

TEST(AddHalfJoints, WhereAVertexFollowsJointAndParent) {
  const glm::dvec4 q(1, 2, 3, 0.5);
  Coordinates candidates = {{{0, q}}, {{0, q}, {1, q}}, {{0, q}, {2, q}}, {{0, q}, {1, q}, {2, q}}};
  const std::vector<HalfJoint> out = add_half_joints({-1, 0, 1}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 2, candidates);
  ASSERT_EQ(out.size(), 4u);
  EXPECT_EQ(out[0].joint, 1u);
  EXPECT_EQ(out[0].parent, 0u);
  EXPECT_NEAR(out[0].share, 1.0 / 3, 1e-12);
  EXPECT_NEAR(out[1].share, 2.0 / 3, 1e-12);
  EXPECT_EQ(out[2].joint, 2u);
  EXPECT_EQ(out[2].parent, 1u);
  EXPECT_EQ(out[2].centre, glm::dvec3(2, 0, 0));
  const std::vector<std::vector<std::uint32_t>> follow = {{0}, {0, 1, 3, 4}, {0, 2}, {0, 1, 2, 3, 4, 5, 6}};
  for (std::size_t v = 0; v < 4; ++v) {
    ASSERT_EQ(candidates[v].size(), follow[v].size()) << v;
    for (std::size_t i = 0; i < follow[v].size(); ++i) {
      EXPECT_EQ(candidates[v][i].joint, follow[v][i]);
      EXPECT_EQ(candidates[v][i].q, follow[v][i] < 3 ? q : glm::dvec4(0));
    }
  }
}

}  // namespace
}  // namespace marrow::deform
