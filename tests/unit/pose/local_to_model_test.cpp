// local_to_model against products of matrices in double precision.
#include <vector>

#include <gtest/gtest.h>

#include "support/rig.h"

namespace marrow {
namespace {

using test::Map;
using test::TestJoint;
using test::TestSkeleton;

void expect_map(const Affine& got, const Map& want, double tolerance) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(static_cast<double>(got.rows[r][c]), want.rows[r][c], tolerance) << r << ' ' << c;
}

std::vector<Map> expected(const TestSkeleton& skeleton) {
  std::vector<Map> out;
  std::size_t root = 0;
  for (const TestJoint& j : skeleton.joints) {
    const Map above = j.parent < 0 ? skeleton.above[root++] : out[static_cast<std::size_t>(j.parent)];
    out.push_back(above * test::from_trs(j.translation, j.rotation, j.scale));
  }
  return out;
}

TEST(LocalToModel, ATurnedElbowByHand) {
  const double h = 0.7071067811865476;
  // Upper arm one metre up; elbow turned a quarter about z and doubled in x; the hand half a metre along the elbow's y.
  const TestSkeleton skeleton({{-1, {0, 1, 0}, {0, 0, 0, 1}, {1, 1, 1}},
                               {0, {0, 2, 0}, {0, 0, h, h}, {2, 1, 1}},
                               {1, {0.25, 0.5, 0}, {0, 0, 0, 1}, {1, 1, 1}}});
  std::vector<Affine> out(3);
  ASSERT_EQ(local_to_model(skeleton.view(), skeleton.rest, out), Status::ok);
  expect_map(out[0], {{{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 0, 1, 0}}}, 1e-6);
  expect_map(out[1], {{{0, -1, 0, 0}, {2, 0, 0, 3}, {0, 0, 1, 0}}}, 1e-6);
  expect_map(out[2], {{{0, -1, 0, -0.5}, {2, 0, 0, 3.5}, {0, 0, 1, 0}}}, 1e-6);
}

TEST(LocalToModel, WhatStandsAboveEachRootCounts) {
  Map left, right;
  left.rows[0][3] = -5;
  right = test::from_trs({5, 0, 0}, test::axis_angle({0, 1, 0}, 1), {-1, 3, 1});  // mirrored and uneven
  const TestSkeleton skeleton({{-1, {1, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}},
                               {-1, {0, 2, 0}, test::axis_angle({1, 0, 0}, 0.5), {1, 1, 2}},
                               {0, {0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1}},
                               {1, {0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1}}},
                              {left, right});
  std::vector<Affine> out(4);
  ASSERT_EQ(local_to_model(skeleton.view(), skeleton.rest, out), Status::ok);
  const std::vector<Map> want = expected(skeleton);
  for (std::size_t j = 0; j < 4; ++j) expect_map(out[j], want[j], 1e-5);
}

// Every remainder of the joint count by four, and forests deep enough to show accumulating error.
TEST(LocalToModel, AnyNumberOfJoints) {
  int joints = 0;
  for (std::size_t count = 2; count <= 41; ++count) {
    const test::TestCharacter character = test::make_character(count, count, 1, false);
    std::vector<Affine> out(count);
    ASSERT_EQ(local_to_model(character.skeleton.view(), character.skeleton.rest, out), Status::ok);
    const std::vector<Map> want = expected(character.skeleton);
    for (std::size_t j = 0; j < count; ++j, ++joints) expect_map(out[j], want[j], 1e-5);
  }
  EXPECT_EQ(joints, 40 * 43 / 2);
}

}  // namespace
}  // namespace marrow
