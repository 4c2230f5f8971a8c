// A posed skeleton, what inverse kinematics is asked of it, and where that leads by forward kinematics in double
// precision.
#pragma once

#include <gtest/gtest.h>

#include "marrow/limits.h"
#include "unit/ik/chains.h"
#include "unit/ik/limit_reference.h"

namespace marrow::test {

// A posed skeleton and what is asked of it.
struct Solve {
  Solve(const TestSkeleton& rig_, std::uint16_t tip, const std::vector<std::uint16_t>& joints_, IkMethod method)
      : rig(rig_), skeleton(rig.view()), local(rig.rest), scene(skeleton.joint_count), joints(joints_), goals(1) {
    goals[0].joint = tip;
    options.method = method;
    options.max_iterations = 256;
    rest();
  }
  Solve(const RandomChain& chain, IkMethod method) : Solve(chain.skeleton, chain.tip, chain.joints, method) {}

  Pose pose() { return {skeleton, local, scene}; }
  void rest() {
    local = rig.rest;
    ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
  }
  IkReport to(const Vec3& target) {
    for (std::size_t c = 0; c < 3; ++c) goals[0].position[c] = static_cast<float>(target[c]);
    return run();
  }
  IkReport run() {
    problem.goals = goals;
    problem.joints = joints;
    problem.limits = limits;
    scratch.resize(genetic ? ik_genetic_scratch_bytes(skeleton, problem)
                           : ik_scratch_bytes(skeleton, problem, options));
    IkReport report;
    EXPECT_EQ((genetic ? solve_ik_genetic : solve_ik)(pose(), problem, options, scratch, &report), Status::ok);
    return report;
  }
  Vec3 tip() const { return origin_of(scene_maps(rig, local.data())[goals[0].joint]); }
  double distance(const Vec3& target) const { return length(minus(tip(), target)); }

  const TestSkeleton& rig;
  Skeleton skeleton;
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;
  bool genetic = false;
  std::vector<std::uint16_t> joints;
  std::vector<IkGoal> goals;
  std::vector<JointLimit> limits;
  std::vector<std::byte> scratch;
  IkProblem problem;
  IkOptions options;
};

// Limits for the joints of a chain that its rest pose keeps, and a target that can be reached within them.
struct LimitedChain {
  LimitedChain(Random& random, LimitRandom& limit_random, int bones, LimitKind kind) : chain(random, bones) {
    std::vector<TestJoint> posed = chain.skeleton.joints;
    for (const std::uint16_t j : chain.joints) {
      LimitDescription d = any_limit(limit_random, kind, 1.5);
      set(d.zero, product(chain.skeleton.joints[j].rotation, random_turn(random, 0.3)));
      JointLimit limit;
      EXPECT_EQ(make_limit(d, j, limit), Status::ok);
      descriptions.push_back(d);
      limits.push_back(limit);
      const double u = uniform(limit_random, 0, 1), v = uniform(limit_random, 0, 1), w = uniform(limit_random, 0, 1);
      posed[j].rotation = quat(rotation_inside(d, u, v, w));
    }
    target = origin_of(scene_maps(chain.skeleton, TestSkeleton(posed).rest.data())[chain.tip]);
  }
  // By how many radians a pose's joints are outside, at most.
  double excess(const SoaTransform* local) const {
    double worst = 0;
    for (std::size_t i = 0; i < descriptions.size(); ++i) {
      const Quat q = normalised(joint_of(local, chain.joints[i]).rotation);
      worst = std::max(worst, reference_excess(descriptions[i], matrix(q)));
    }
    return worst;
  }

  RandomChain chain;
  std::vector<LimitDescription> descriptions;
  std::vector<JointLimit> limits;
  Vec3 target{};
};

}  // namespace marrow::test
