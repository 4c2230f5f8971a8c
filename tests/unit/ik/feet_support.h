// A walker of two legs for tests of feet.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "marrow/feet.h"
#include "marrow/local_to_model.h"
#include "support/pose_file.h"
#include "support/poses.h"

namespace marrow::test {

inline Vec3 vec(const float (&v)[3]) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// Two legs of 0.45 + 0.45 m, knees bent forward (z) by 0.3 rad each way, ankles 0.1 m above the soles; joints 0 a root,
// 1 the pelvis, 2 and 3 hips, 4 and 5 knees, 6 and 7 ankles, 8 and 9 toes, 10 the head.
class Walker {
 public:
  explicit Walker(const Map& above = {}) {
    const Quat bend = axis_angle({1, 0, 0}, -0.3), back = axis_angle({1, 0, 0}, 0.6);
    const double hip = 0.1 + 0.9 * std::cos(0.3);
    std::vector<TestJoint> joints = {{-1, {0, 0, 0}},          {0, {0, hip, 0}},         {1, {0.1, 0, 0}, bend},
                                     {1, {-0.1, 0, 0}, bend},  {2, {0, -0.45, 0}, back}, {3, {0, -0.45, 0}, back},
                                     {4, {0, -0.45, 0}, bend}, {5, {0, -0.45, 0}, bend}, {6, {0, -0.05, 0.1}},
                                     {7, {0, -0.05, 0.1}},     {1, {0, 0.6, 0}}};
    // Breadth-first: the head comes with the hips.
    std::vector<TestJoint> sorted(joints.begin(), joints.begin() + 4);
    sorted.push_back(joints[10]);
    for (std::size_t j = 4; j < 10; ++j) {
      sorted.push_back(joints[j]);
      if (sorted.back().parent >= 4) ++sorted.back().parent;
    }
    rest_ = std::make_unique<TestSkeleton>(sorted, std::vector<Map>{above});
    skeleton = rest_->view();
    local.resize(skeleton.soa_size());
    scene.resize(skeleton.joint_count);
    for (std::uint32_t side = 0; side < 2; ++side) {
      legs[side].hip = 2 + side;
      legs[side].knee = 5 + side;
      legs[side].ankle = 7 + side;
      legs[side].sole[1] = -0.1f;
      legs[side].sole[2] = 0.05f;
    }
    feet.feet = legs;
    feet.pelvis = 1;

    pose();
  }
  // The animated pose; `swing` lifts the left ankle and puts it forward.
  void pose(double swing_rad = 0) {
    local = rest_->rest;
    if (swing_rad != 0) {
      const Quat q = axis_angle({1, 0, 0}, -0.3 - swing_rad);
      for (std::size_t i = 0; i < 4; ++i) local[0].rotation[i][2] = static_cast<float>(q[i]);
    }
    EXPECT_EQ(local_to_model(skeleton, local, scene), Status::ok);
  }
  void stand(const Vec3& at, double turn_rad = 0) {
    frame.world_from_model = to_affine(from_trs(at, axis_angle({0, 1, 0}, turn_rad), {1, 1, 1}));
  }
  Status step(float dt_s) {
    frame.dt_s = dt_s;
    return place_feet({skeleton, local, scene}, feet, frame, ground, motion);
  }
  // For so long that all has eased, standing still.
  void settle() {
    for (int i = 0; i < 200; ++i) {
      pose();
      ASSERT_EQ(step(1.0f / 60), Status::ok);
    }
  }
  void floor(std::size_t side, double height, const Vec3& normal = {0, 1, 0}) {
    ground[side].hit = true;
    float sole[3];
    EXPECT_EQ(foot_sole(legs[side], frame.world_from_model, scene, sole), Status::ok);
    for (int i = 0; i < 3; ++i) {
      ground[side].point[i] = i == 1 ? static_cast<float>(height) : sole[i];
      ground[side].normal[i] = static_cast<float>(normal[static_cast<std::size_t>(i)]);
    }
  }
  Map world(std::size_t joint) const { return to_map(frame.world_from_model) * to_map(scene[joint]); }
  Vec3 sole(std::size_t side) const { return point(world(legs[side].ankle), vec(legs[side].sole)); }
  Vec3 pelvis() const { return point(world(1), {0, 0, 0}); }

  Skeleton skeleton;
  std::array<Foot, 2> legs;
  Feet feet;
  FeetFrame frame;
  std::array<FootGround, 2> ground;
  std::array<FootMotion, 2> motion{};
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;

 private:
  std::unique_ptr<TestSkeleton> rest_;
};

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

}  // namespace marrow::test
