// overlay_in_model_space against angles that are added by hand.
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/blend.h"
#include "support/bad_numbers.h"
#include "support/poses.h"

namespace marrow {
namespace {

constexpr double kDegree = 0.017453292519943295;

// Three joints, each on the one before, that turn about z by these degrees.
struct Arm {
  std::uint16_t parents[3] = {kNoJoint, 0, 1};
  Skeleton skeleton;
  std::vector<SoaTransform> pose{1}, layer{1};
  std::vector<Affine> scratch{3};

  Arm(std::initializer_list<double> of_pose, std::initializer_list<double> of_layer) {
    skeleton.joint_count = 3;
    skeleton.root_count = 1;
    skeleton.parents = parents;
    turn(pose, of_pose);
    turn(layer, of_layer);
  }
  static void turn(std::vector<SoaTransform>& local, std::initializer_list<double> degrees) {
    std::uint32_t joint = 0;
    for (const double each : degrees) {
      const double half = each * kDegree / 2;
      const float x = static_cast<float>(joint);
      ASSERT_EQ(set_joint(local, joint++,
                          {{x, 0, 0}, {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))}}),
                Status::ok);
    }
  }
  double degrees(std::uint32_t joint) const {
    JointTransform out;
    EXPECT_EQ(get_joint(pose, joint, out), Status::ok);
    return 2 * std::atan2(static_cast<double>(out.rotation[2]), static_cast<double>(out.rotation[3])) / kDegree;
  }
  void lay_over(float weight, const std::vector<float>& mask) {
    ASSERT_EQ(overlay_in_model_space(skeleton, {layer, weight, mask}, pose, scratch), Status::ok);
  }
  void expect(double first, double second, double third) const {
    EXPECT_NEAR(degrees(0), first, 1e-4);
    EXPECT_NEAR(degrees(1), second, 1e-4);
    EXPECT_NEAR(degrees(2), third, 1e-4);
  }
};

// In model space the pose has 10, 30 and 60 degrees, the layer 40, 30 and 35.
TEST(OverlayInModelSpace, TurnsJointsAsInModelSpace) {
  Arm last({10, 20, 30}, {40, -10, 5});
  last.lay_over(1, {0, 0, 1, 0});
  last.expect(10, 20, 5);  // 35 over 30

  Arm whole({10, 20, 30}, {40, -10, 5});
  whole.lay_over(1, {});
  whole.expect(40, -10, 5);

  Arm half({10, 20, 30}, {40, -10, 5});
  half.lay_over(0.5f, {});
  half.expect(25, 5, 17.5);  // 25, 30, 47.5
}

TEST(OverlayInModelSpace, WhatIsNotMaskedStaysInModelSpace) {
  Arm arm({10, 20, 30}, {40, -10, 5});
  arm.lay_over(1, {1, 0, 0, 0});
  arm.expect(40, -10, 30);  // 40, 30, 60

  test::Poses p(7, 21, 2);
  std::vector<Affine> scratch(21);
  p.out = p.pose[0];
  ASSERT_EQ(overlay_in_model_space(p.skeleton, {p.pose[1], 1, std::vector<float>(4 * p.groups())}, p.out, scratch),
            Status::ok);
  EXPECT_TRUE(p.same(p.out, p.pose[0]));
}

TEST(OverlayInModelSpace, TranslationsAndScalesGoAsInOverlay) {
  test::Poses p(8, 30, 2);
  std::vector<Affine> scratch(30);
  std::vector<SoaTransform> plain = p.pose[0];
  p.out = p.pose[0];
  ASSERT_EQ(overlay(p.skeleton, {p.pose[1], 0.6f, p.masks(1)}, plain), Status::ok);
  ASSERT_EQ(overlay_in_model_space(p.skeleton, {p.pose[1], 0.6f, p.masks(1)}, p.out, scratch), Status::ok);
  for (std::size_t g = 0; g < p.groups(); ++g) {
    EXPECT_EQ(std::memcmp(p.out[g].translation, plain[g].translation, sizeof plain[g].translation), 0);
    EXPECT_EQ(std::memcmp(p.out[g].scale, plain[g].scale, sizeof plain[g].scale), 0);
  }
}

TEST(OverlayInModelSpace, BadCallsWriteNothing) {
  Arm arm({10, 20, 30}, {40, -10, 5});
  const auto refused = [&](const BlendLayer& layer, std::size_t room = 3) {
    EXPECT_EQ(overlay_in_model_space(arm.skeleton, layer, arm.pose, {arm.scratch.data(), room}), Status::bad_argument);
    arm.expect(10, 20, 30);
  };
  const std::vector<float> mask(3, 1.0f);
  for (const float weight : {-0.1f, 1.1f, test::kNan, test::kInfinity}) refused({arm.layer, weight, {}});
  refused({arm.layer, 1, mask});
  refused({{}, 1, {}});
  refused({arm.layer, 1, {}}, 2);
}

}  // namespace
}  // namespace marrow
