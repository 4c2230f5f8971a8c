// Lines for a debug view: where they are, by hand arithmetic and the C library's sines, and what is left out.
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/debug_lines.h"
#include "marrow/limits.h"

namespace marrow {
namespace {

constexpr float kPi = 3.14159265f;

// A root at (0, 1, 0) that is scaled by 2, and a joint one above it.
class DebugLinesTest : public ::testing::Test {
 protected:
  DebugLinesTest() {
    skeleton_.joint_count = 2;
    skeleton_.root_count = 1;
    skeleton_.model_from_root = &above_;
    skeleton_.parents = parents_;
    for (auto& w : local_[0].rotation[3]) w = 1;
    lines_.room = room_;
  }
  void expect_at(const float (&point)[3], float x, float y, float z) const {
    EXPECT_NEAR(point[0], x, 1e-5f);
    EXPECT_NEAR(point[1], y, 1e-5f);
    EXPECT_NEAR(point[2], z, 1e-5f);
  }
  static bool is(const DebugLine& line, const std::uint8_t (&colour)[4]) {
    return std::equal(line.colour, line.colour + 4, colour);
  }

  const std::uint16_t parents_[2] = {kNoJoint, 0};
  Affine above_ = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  Skeleton skeleton_;
  SoaTransform local_[1] = {};
  Affine scene_[2] = {{{{2, 0, 0, 0}, {0, 2, 0, 1}, {0, 0, 2, 0}}}, {{{2, 0, 0, 0}, {0, 2, 0, 2}, {0, 0, 2, 0}}}};
  DebugLine room_[256];
  DebugLines lines_;
};

TEST_F(DebugLinesTest, Joints) {
  ASSERT_EQ(joint_lines(skeleton_, scene_, 0, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 1u);
  expect_at(room_[0].from, 0, 1, 0);
  expect_at(room_[0].to, 0, 2, 0);
  EXPECT_TRUE(is(room_[0], kBoneColour));
  ASSERT_EQ(joint_lines(skeleton_, scene_, 0.5f, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 1u + 1 + 6) << "appended";
  expect_at(room_[1].to, 0.5f, 1, 0);  // whatever the scale
  expect_at(room_[3].to, 0, 1, 0.5f);
  EXPECT_TRUE(is(room_[2], kAxisColours[1]));
}

TEST_F(DebugLinesTest, AHingesArc) {
  LimitDescription d;
  d.kind = LimitKind::hinge;
  d.least_rad[0] = -kPi / 2;
  d.most_rad[0] = kPi / 2;
  JointLimit limit;
  ASSERT_EQ(make_limit(d, 1, limit), Status::ok);
  ASSERT_EQ(limit_lines(skeleton_, {&limit, 1}, local_, scene_, 0.25f, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 16u + 2 + 1);
  expect_at(room_[0].from, 0, 2, 0);
  expect_at(room_[0].to, 0, 2, -0.25f);  // y, turned back by 90° about x
  expect_at(room_[17].to, 0, 2, 0.25f);
  for (std::size_t i = 1; i < 18; ++i) {
    const float* const p = room_[i].to;
    EXPECT_NEAR(std::hypot(p[0], p[1] - 2, p[2]), 0.25f, 1e-5f);
    EXPECT_NEAR(p[0], 0, 1e-6f);
  }
  expect_at(room_[18].to, 0, 2.25f, 0);
  EXPECT_TRUE(is(room_[18], kInsideColour));
  const float half = 0.6f * kPi / 2;  // 108°: outside
  local_[0].rotation[0][1] = std::sin(half);
  local_[0].rotation[3][1] = std::cos(half);
  ASSERT_EQ(limit_lines(skeleton_, {&limit, 1}, local_, scene_, 0.25f, lines_), Status::ok);
  EXPECT_TRUE(is(room_[19 + 18], kOutsideColour));
  expect_at(room_[19 + 18].to, 0, 2 + 0.25f * std::cos(2 * half), 0.25f * std::sin(2 * half));
}

TEST_F(DebugLinesTest, AConesRim) {
  LimitDescription d;
  d.kind = LimitKind::cone;
  const float about_y = 0.5f, about_z = 1.0f;
  d.most_rad[0] = 0.1f;
  d.most_rad[1] = about_y;
  d.most_rad[2] = about_z;
  d.least_rad[1] = -about_y;
  d.least_rad[2] = -about_z;
  JointLimit limit;
  ASSERT_EQ(make_limit(d, 1, limit), Status::ok);
  ASSERT_EQ(limit_lines(skeleton_, {&limit, 1}, local_, scene_, 1, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 16u + 4 + 1);
  expect_at(room_[0].to, std::cos(about_y), 2, -std::sin(about_y));
  expect_at(room_[5].to, std::cos(about_z), 2 + std::sin(about_z), 0);  // a quarter round, the next spoke
  std::size_t spokes = 0;
  for (std::size_t i = 0; i < 20; ++i) spokes += room_[i].from[0] == 0;
  EXPECT_EQ(spokes, 4u);
  expect_at(room_[20].to, 1, 2, 0);
}

// Each arc's ends are the limit's own ends: a rotation there is inside, one a hundredth further is not.
TEST_F(DebugLinesTest, EulerArcsInTheirOrder) {
  LimitDescription d;
  d.kind = LimitKind::euler;
  d.order = AxisOrder::zxy;
  for (int i = 0; i < 3; ++i) {
    d.least_rad[i] = -0.1f * static_cast<float>(i + 1);
    d.most_rad[i] = 0.2f * static_cast<float>(i + 1);
  }
  JointLimit limit;
  ASSERT_EQ(make_limit(d, 1, limit), Status::ok);
  ASSERT_EQ(limit_lines(skeleton_, {&limit, 1}, local_, scene_, 1, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 3u * 17);
  // The first factor turns about z, from -0.1 to 0.2: x moves in the x-y plane.
  EXPECT_TRUE(is(room_[0], kAxisColours[2]));
  expect_at(room_[0].from, std::cos(0.1f), 2 - std::sin(0.1f), 0);
  expect_at(room_[15].to, std::cos(0.2f), 2 + std::sin(0.2f), 0);
  // The second about x, from -0.2 to 0.4: y moves.
  EXPECT_TRUE(is(room_[17], kAxisColours[0]));
  expect_at(room_[17].from, 0, 2 + std::cos(0.2f), -std::sin(0.2f));
  // The third about y, from -0.3 to 0.6: z moves.
  EXPECT_TRUE(is(room_[34], kAxisColours[1]));
  expect_at(room_[34 + 15].to, std::sin(0.6f), 2, std::cos(0.6f));
}

TEST_F(DebugLinesTest, Goals) {
  IkGoal goals[2];
  goals[0].joint = goals[1].joint = 1;
  goals[0].offset[0] = 0.5f;  // at (1, 2, 0) in the scene
  goals[0].position[0] = 1;
  goals[0].position[1] = 2;
  goals[1].position[2] = 3;
  goals[1].rotation_weight = 1;
  goals[1].rotation[2] = goals[1].rotation[3] = std::sqrt(0.5f);  // x looks along y
  ASSERT_EQ(goal_lines(skeleton_, goals, scene_, 0.1f, 0.01f, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 8u);
  EXPECT_TRUE(is(room_[0], kInsideColour));
  expect_at(room_[0].from, 0.9f, 2, 0);
  expect_at(room_[4].to, 0, 0.1f, 3);
  EXPECT_TRUE(is(room_[7], kOutsideColour));
  expect_at(room_[7].from, 0, 2, 0);
  expect_at(room_[7].to, 0, 0, 3);
}

TEST_F(DebugLinesTest, SpringsAndColliders) {
  SpringJoint joints[2];
  joints[1].joint = 1;
  SpringChain chain{joints, {0, 0, 0.5f}};
  ASSERT_EQ(spring_lines(skeleton_, {&chain, 1}, scene_, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 2u);
  expect_at(room_[1].to, 0, 2, 1);
  SpringCollider colliders[2];
  colliders[0].radius_m = 0.5f;
  colliders[1].joint = 1;
  colliders[1].to[0] = 1;
  lines_.count = 0;
  ASSERT_EQ(collider_lines(skeleton_, colliders, scene_, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 48u + 100);
  for (std::size_t i = 0; i < 48; ++i) {
    const float* const p = room_[i].to;
    EXPECT_NEAR(std::hypot(p[0], p[1] - 1, p[2]), 1, 1e-4f) << "twice as large in the scene";
  }
  for (std::size_t i = 144; i < 148; ++i) {
    EXPECT_NEAR(room_[i].from[0], 0, 1e-5f);
    EXPECT_NEAR(room_[i].to[0], 2, 1e-5f);
    EXPECT_NEAR(std::hypot(room_[i].to[1] - 2, room_[i].to[2]), 0.2f, 1e-5f);
  }
}

TEST_F(DebugLinesTest, BoundsHaveTwelveEdges) {
  const Bounds bounds = {{-1, -2, -3}, {1, 2, 3}, 4};
  ASSERT_EQ(bounds_lines(bounds, lines_), Status::ok);
  ASSERT_EQ(lines_.count, 60u);
  std::set<std::vector<float>> edges;
  for (std::size_t i = 0; i < 12; ++i) {
    int differ = 0;
    for (int c = 0; c < 3; ++c) {
      differ += room_[i].from[c] != room_[i].to[c];
      EXPECT_EQ(std::abs(room_[i].from[c]), static_cast<float>(c + 1));
    }
    EXPECT_EQ(differ, 1);
    edges.insert(
        {room_[i].from[0], room_[i].from[1], room_[i].from[2], room_[i].to[0], room_[i].to[1], room_[i].to[2]});
  }
  EXPECT_EQ(edges.size(), 12u);
  for (std::size_t i = 12; i < 60; ++i)
    EXPECT_NEAR(std::hypot(room_[i].to[0], room_[i].to[1], room_[i].to[2]), 4, 1e-4f);
  ASSERT_EQ(bounds_lines(Bounds{}, lines_), Status::ok);
  EXPECT_EQ(lines_.count, 60u) << "nothing is known";
}

TEST_F(DebugLinesTest, WhatHasNoRoomIsCounted) {
  lines_.room = {room_, 3};
  ASSERT_EQ(joint_lines(skeleton_, scene_, 1, lines_), Status::ok);
  EXPECT_EQ(lines_.count, 3u);
  EXPECT_EQ(lines_.left_out, 4u);
  lines_ = {room_, 0, 0};
  scene_[1].rows[0][3] = INFINITY;
  ASSERT_EQ(joint_lines(skeleton_, scene_, 0, lines_), Status::ok);
  EXPECT_EQ(lines_.count, 0u);
  EXPECT_EQ(lines_.left_out, 1u);
}

}  // namespace
}  // namespace marrow
