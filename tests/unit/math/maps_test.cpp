// math.h against maps that are worked out by hand, and against the product in double precision.
#include "marrow/math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace marrow {
namespace {

constexpr float kHalf = 0.70710678f;
// A quarter turn about z, after growing x by 2: (x, y, z) → (-y + 5, 2 x + 6, z + 7).
constexpr JointTransform kQuarter{{5, 6, 7}, {0, 0, kHalf, kHalf}, {2, 1, 1}};
constexpr Affine kQuarterMap{{{0, -1, 0, 5}, {2, 0, 0, 6}, {0, 0, 1, 7}}};

void expect_near(const Affine& a, const Affine& b, float by) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(a.rows[r][c], b.rows[r][c], by) << r << ' ' << c;
}

void expect_point(const float (&v)[3], float x, float y, float z) {
  EXPECT_NEAR(v[0], x, 1e-6f);
  EXPECT_NEAR(v[1], y, 1e-6f);
  EXPECT_NEAR(v[2], z, 1e-6f);
}

TEST(Maps, OfAJointsTransform) {
  expect_near(affine_of(kQuarter), kQuarterMap, 1e-6f);
  expect_near(affine_of({}), {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, 0);
}

TEST(Maps, PointsAndDirections) {
  float v[3] = {1, 2, 3};
  transform_point(kQuarterMap, v, v);
  expect_point(v, 3, 8, 10);
  float d[3];
  transform_direction(kQuarterMap, {1, 2, 3}, d);
  expect_point(d, -2, 2, 3);
}

TEST(Maps, ComposedDoTheSecondFirst) {
  constexpr Affine up{{{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 0, 1, 0}}};
  float v[3];
  transform_point(compose(kQuarterMap, up), {0, 0, 0}, v);
  expect_point(v, 4, 6, 7);
  transform_point(compose(up, kQuarterMap), {0, 0, 0}, v);
  expect_point(v, 5, 7, 7);
}

TEST(Maps, InvertedTakeBack) {
  Affine back;
  ASSERT_EQ(invert(kQuarterMap, back), Status::ok);
  expect_near(back, {{{0, 0.5f, 0, -3}, {-1, 0, 0, 5}, {0, 0, 1, -7}}}, 0);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> number(-1, 1);
  int tried = 0;
  for (const float size : {1e-12f, 0.01f, 1.0f, 1e6f}) {
    for (int i = 0; i < 200; ++i) {
      Affine map{};
      for (auto& row : map.rows)
        for (int c = 0; c < 3; ++c) row[c] = size * (number(random) + (c == &row - map.rows ? 2.0f : 0.0f));
      for (auto& row : map.rows) row[3] = number(random);
      ASSERT_EQ(invert(map, back), Status::ok);
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          double sum = 0;
          for (int k = 0; k < 3; ++k) sum += double{back.rows[r][k]} * double{map.rows[k][c]};
          EXPECT_NEAR(sum, r == c ? 1 : 0, 1e-5) << size;
        }
      }
      ++tried;
    }
  }
  EXPECT_EQ(tried, 800);
}

TEST(Maps, WithoutAnInverseAreRefused) {
  Affine out{{{9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}}};
  const Affine before = out;
  Affine flat = kQuarterMap, wild = kQuarterMap, all_zero{}, far = kQuarterMap;
  flat.rows[2][2] = 0;
  wild.rows[0][1] = std::numeric_limits<float>::quiet_NaN();
  far.rows[0][3] = std::numeric_limits<float>::infinity();
  float v[3] = {9, 9, 9};
  for (const Affine& map : {flat, wild, all_zero}) {
    EXPECT_EQ(invert(map, out), Status::bad_argument);
    EXPECT_EQ(direction_in_joint(map, {1, 0, 0}, v), Status::bad_argument);
  }
  EXPECT_EQ(invert(far, out), Status::bad_argument);
  EXPECT_EQ(direction_in_joint(kQuarterMap, {0, 0, 0}, v), Status::bad_argument);
  EXPECT_EQ(direction_in_joint(kQuarterMap, {std::numeric_limits<float>::infinity(), 0, 0}, v), Status::bad_argument);
  expect_near(out, before, 0);
  expect_point(v, 9, 9, 9);
}

// The joint's x, twice as long, points along y of the model; and its y against x.
TEST(Maps, DirectionsInAJoint) {
  float v[3];
  ASSERT_EQ(direction_in_joint(kQuarterMap, {0, 3, 0}, v), Status::ok);
  expect_point(v, 1, 0, 0);
  ASSERT_EQ(direction_in_joint(kQuarterMap, {1, 2, 0}, v), Status::ok);
  expect_point(v, kHalf, -kHalf, 0);
}

}  // namespace
}  // namespace marrow
