// A posed skeleton and what is asked of it: the set-up of tests of the Jacobian solvers.
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "support/aligned.h"
#include "unit/ik/chains.h"

namespace marrow::test {

struct PosedSkeleton {
  PosedSkeleton(const TestSkeleton& rig_, IkMethod method) : rig(rig_), skeleton(rig.view()) {
    options.method = method;
    rest();
  }

  void rest() {
    local = rig.rest;
    scene.resize(skeleton.joint_count);
    EXPECT_EQ(local_to_model(skeleton, local, scene), Status::ok);
  }
  Pose pose() { return {skeleton, local, scene}; }
  IkGoal& add_goal(std::uint16_t joint, const Vec3& position) {
    goals.emplace_back();
    goals.back().joint = joint;
    for (std::size_t c = 0; c < 3; ++c) goals.back().position[c] = static_cast<float>(position[c]);
    return goals.back();
  }
  void bind() {
    problem.goals = goals;
    problem.joints = joints;
    problem.stiffness = stiffness;
    problem.limits = limits;
  }
  Status try_solve(IkReport* report = nullptr) {
    bind();
    AlignedBlock scratch(ik_scratch_bytes(skeleton, problem, options));
    return solve_ik(pose(), problem, options, scratch, report);
  }
  IkReport solve() {
    IkReport report;
    EXPECT_EQ(try_solve(&report), Status::ok);
    return report;
  }
  std::vector<Map> maps() const { return scene_maps(rig, local.data()); }
  double distance(std::size_t goal) const {
    const IkGoal& g = goals[goal];
    const Vec3 at = point(maps()[g.joint], {g.offset[0], g.offset[1], g.offset[2]});
    return length(minus(at, {g.position[0], g.position[1], g.position[2]}));
  }
  bool is_finite() const {
    double sum = 0;
    for (const SoaTransform& t : local)
      for (const auto& row : t.rotation)
        for (const float f : row) sum += static_cast<double>(f);
    for (const Affine& a : scene)
      for (const auto& row : a.rows)
        for (const float f : row) sum += static_cast<double>(f);
    return std::isfinite(sum);
  }

  const TestSkeleton& rig;
  Skeleton skeleton;
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;
  std::vector<IkGoal> goals;
  std::vector<std::uint16_t> joints;
  std::vector<float> stiffness;
  std::vector<JointLimit> limits;
  IkProblem problem;
  IkOptions options;
};

// The largest angle between the rotations of two poses.
inline double largest_turn(const TestSkeleton& rig, const SoaTransform* a, const SoaTransform* b) {
  double most = 0;
  for (std::size_t j = 0; j < rig.joints.size(); ++j) {
    const Quat p = normalised(joint_of(a, j).rotation), q = normalised(joint_of(b, j).rotation);
    const Quat d = product({-p[0], -p[1], -p[2], p[3]}, q);
    most = std::fmax(most, 2 * std::atan2(length({d[0], d[1], d[2]}), std::fabs(d[3])));
  }
  return most;
}

// A chain along +y: joints 0 … bones - 1 turn, `bones` is the tip; each bone `bone_m` long, bent by bend_rad about z.
inline TestSkeleton bent_chain(int bones, double bone_m, double bend_rad, const Vec3& scale = {1, 1, 1}) {
  std::vector<TestJoint> all;
  for (int i = 0; i <= bones; ++i) {
    TestJoint j;
    j.parent = i - 1;
    if (i > 0) j.translation = {0, bone_m, 0};
    if (i > 0) j.rotation = axis_angle({0, 0, 1}, bend_rad);
    j.scale = scale;
    all.push_back(j);
  }
  return TestSkeleton(all);
}

inline std::vector<std::uint16_t> first_joints(int count) {
  std::vector<std::uint16_t> out;
  for (int i = 0; i < count; ++i) out.push_back(static_cast<std::uint16_t>(i));
  return out;
}

}  // namespace marrow::test
