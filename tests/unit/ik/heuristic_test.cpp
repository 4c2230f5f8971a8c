// FABRIK and CCD: what can be reached is reached, and what cannot degrades without a jump.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "support/pose_file.h"
#include "unit/ik/solving.h"

namespace marrow {
namespace {

using test::RandomChain;
using test::Solve;
using test::Vec3;

constexpr IkMethod kMethods[] = {IkMethod::fabrik, IkMethod::ccd};

const char* name_of(IkMethod method) {
  return method == IkMethod::fabrik ? "FABRIK" : "CCD";
}

// A chain of `bones` bones of one metre along y from the origin, each joint turned about x by bend_rad.
test::TestSkeleton column(int bones, double bend_rad) {
  std::vector<test::TestJoint> joints;
  for (int i = 0; i <= bones; ++i) {
    joints.push_back({i - 1, {0, i > 0 ? 1.0 : 0.0, 0}, test::axis_angle({1, 0, 0}, i > 0 ? bend_rad : 0)});
  }
  return test::TestSkeleton(joints);
}

std::vector<std::uint16_t> first_joints(int count) {
  std::vector<std::uint16_t> out;
  for (int i = 0; i < count; ++i) out.push_back(static_cast<std::uint16_t>(i));
  return out;
}

bool all_finite(const std::vector<SoaTransform>& pose) {
  const float* f = pose.data()->translation[0];
  return std::all_of(f, f + pose.size() * sizeof(SoaTransform) / sizeof(float),
                     [](float v) { return std::isfinite(v); });
}

TEST(IkHeuristic, ReachesWhatCanBeReached) {
  for (const IkMethod method : kMethods) {
    test::Random random(5);
    int cases = 0, reached = 0, most = 0;
    double iterations = 0;
    for (; cases < 10000; ++cases) {
      const RandomChain chain(random, 4 + cases % 9);
      const Vec3 target = chain.reachable(random, cases % 2 == 0 ? 3.14159 : 1.0);
      Solve solve(chain, method);
      solve.options.tolerance_m = static_cast<float>(9.9e-4 * chain.length_m);
      const IkReport report = solve.to(target);
      const double distance = solve.distance(target);
      reached += distance <= 1e-3 * chain.length_m;
      iterations += report.iterations;
      most = std::max(most, static_cast<int>(report.iterations));
      EXPECT_NEAR(report.error_m, distance, 2e-6 * chain.length_m) << cases;
    }
    EXPECT_EQ(reached, 10000) << name_of(method);
    std::printf("%s: %d of %d reached, %.2f iterations on average, %d at most\n", name_of(method), reached, cases,
                iterations / cases, most);
  }
}

TEST(IkHeuristic, SceneMatricesFollowAndOthersStay) {
  int moved = 0, stayed = 0;
  for (const IkMethod method : kMethods) {
    test::Random random(6);
    for (int i = 0; i < 200; ++i) {
      const RandomChain chain(random, 4 + i % 9);
      Solve solve(chain, method);
      const std::vector<Affine> before = solve.scene;
      solve.to(chain.reachable(random));
      const std::vector<test::Map> maps = test::scene_maps(chain.skeleton, solve.local.data());
      for (std::size_t j = 0; j < maps.size(); ++j) {
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 4; ++c) EXPECT_NEAR(solve.scene[j].rows[r][c], maps[j].rows[r][c], 1e-4);
        if (std::find(chain.joints.begin(), chain.joints.end(), j) != chain.joints.end()) continue;
        const test::TestJoint was = test::joint_of(chain.skeleton.rest.data(), j),
                              is = test::joint_of(solve.local.data(), j);
        EXPECT_EQ(was.rotation, is.rotation);
        EXPECT_EQ(was.translation, is.translation);
        ++stayed;
      }
      moved += std::memcmp(&before[chain.tip], &solve.scene[chain.tip], sizeof(Affine)) != 0;
      EXPECT_EQ(std::memcmp(&before[0], &solve.scene[0], sizeof(Affine)), 0);
    }
  }
  EXPECT_EQ(moved, 400);
  EXPECT_GT(stayed, 1000);
}

TEST(IkHeuristic, WeightNoneKeepsEveryBit) {
  for (const IkMethod method : kMethods) {
    test::Random random(7);
    const RandomChain chain(random, 6);
    Solve solve(chain, method);
    solve.options.weight = 0;
    const std::vector<SoaTransform> local = solve.local;
    const std::vector<Affine> scene = solve.scene;
    solve.to(chain.reachable(random));
    EXPECT_EQ(std::memcmp(local.data(), solve.local.data(), local.size() * sizeof(SoaTransform)), 0);
    EXPECT_EQ(std::memcmp(scene.data(), solve.scene.data(), scene.size() * sizeof(Affine)), 0);
  }
}

TEST(IkHeuristic, WhatIsReachedIsLeftAsItIs) {
  for (const IkMethod method : kMethods) {
    test::Random random(8);
    const RandomChain chain(random, 6);
    Solve solve(chain, method);
    const std::vector<SoaTransform> local = solve.local;
    const IkReport report = solve.to(solve.tip());
    EXPECT_EQ(report.iterations, 0u);
    EXPECT_EQ(report.why, IkStop::reached);
    EXPECT_EQ(std::memcmp(local.data(), solve.local.data(), local.size() * sizeof(SoaTransform)), 0);
  }
}

TEST(IkHeuristic, OutOfReachIsStraightTowardsTheTarget) {
  for (const IkMethod method : kMethods) {
    const test::TestSkeleton rig = column(6, 0.3);
    Solve solve(rig, 6, first_joints(6), method);
    const IkReport report = solve.to({6, 6, 3});
    EXPECT_EQ(report.why, IkStop::stalled);
    EXPECT_NEAR(report.error_m, 9 - 6, 1e-5);
    const std::vector<test::Map> maps = test::scene_maps(rig, solve.local.data());
    for (std::size_t j = 1; j <= 6; ++j) {
      const Vec3 at = test::origin_of(maps[j]);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(at[c], static_cast<double>(j) * (c < 2 ? 6.0 : 3.0) / 9, 1e-5);
    }
  }
}

// The farthest that a joint, or a point a metre from it, moves from one pose to the next.
double farthest_move(const std::vector<Affine>& a, const std::vector<Affine>& b) {
  double farthest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    for (int c = 0; c < 4; ++c) {
      double squared = 0;
      for (int r = 0; r < 3; ++r) {
        double move = a[j].rows[r][3] - b[j].rows[r][3];
        if (c < 3) move += static_cast<double>(a[j].rows[r][c] - b[j].rows[r][c]);
        squared += move * move;
      }
      farthest = std::max(farthest, std::sqrt(squared));
    }
  }
  return farthest;
}

// The target goes from a to b in steps; each is solved anew from the rest pose. How much farther than the target does a
// joint move in one step at most?
double worst_ratio(Solve& solve, const Vec3& a, const Vec3& b, int steps, bool from_last = false) {
  std::vector<Affine> last;
  double worst = 0;
  const double step = test::length(test::minus(b, a)) / steps;
  for (int i = 0; i <= steps; ++i) {
    Vec3 target;
    for (std::size_t c = 0; c < 3; ++c) target[c] = a[c] + (b[c] - a[c]) * i / steps;
    if (!from_last) solve.rest();
    solve.to(target);
    if (i > 0) worst = std::max(worst, farthest_move(last, solve.scene) / step);
    last = solve.scene;
  }
  return worst;
}

// The ratio stays what it is as steps become smaller. At full stretch it is the greatest: the height of an arc grows as
// the root of what its chord lacks.
TEST(IkHeuristic, SmallStepsOfATargetAreSmallStepsOfJoints) {
  struct Path {
    const char* name;
    Vec3 from, to;
    double most;
  };
  const Path paths[] = {{"within reach", {1, 2, 0.5}, {-1, 3, 1}, 3},
                        {"through full stretch", {1, 4, 1}, {2, 6, 2}, 30},
                        {"close to full stretch", {1, 4.9, 0.2}, {-1, 4.9, -0.2}, 8},
                        {"past the root", {0.2, -1.0, 0.1}, {0.2, 1, 0.1}, 10},
                        {"through 180 degrees", {0, -2, -1}, {0, -2, 1}, 3},
                        {"through 180 degrees, out of reach", {0, -6, -1}, {0, -6, 1}, 3}};
  const test::TestSkeleton rig = column(5, 0.2);
  std::vector<JointLimit> limits(5);
  for (std::uint16_t joint = 0; joint < 5; ++joint) {
    LimitDescription d;
    d.kind = joint % 2 == 0 ? LimitKind::cone : LimitKind::hinge;
    for (std::size_t c = 0; c < 4; ++c) d.zero[c] = static_cast<float>(rig.joints[joint].rotation[c]);
    for (std::size_t a = 0; a < 3; ++a) d.least_rad[a] = -1.0f, d.most_rad[a] = 1.0f;
    ASSERT_EQ(make_limit(d, joint, limits[joint]), Status::ok);
  }
  int cases = 0;
  for (const IkMethod method : kMethods) {
    for (const Path& path : paths) {
      for (const int steps : {250, 1000, 4000}) {
        Solve solve(rig, 5, first_joints(5), method);
        solve.options.max_iterations = 32;
        solve.options.tolerance_m = 1e-3f;
        EXPECT_LT(worst_ratio(solve, path.from, path.to, steps), path.most) << name_of(method) << path.name << steps;
        if (method != IkMethod::ccd) continue;
        solve.limits = limits;
        EXPECT_LT(worst_ratio(solve, path.from, path.to, steps), 20) << "with limits, " << path.name << steps;
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 6 * 3);
}

// Past the point opposite to the chain's end, in any plane: the end moves as the target does, and joints swing round,
// but do not jump. A jump would be of about the chain's height, a half of its length, at any step.
TEST(IkHeuristic, NothingJumpsWhereTheTargetPassesOpposite) {
  constexpr double kStep_rad = 1e-3;
  int cases = 0;
  for (const IkMethod method : kMethods) {
    for (const double bend_rad : {0.0, 0.2, 0.3}) {
      const test::TestSkeleton rig = column(5, bend_rad);
      Solve solve(rig, 5, first_joints(5), method);
      solve.options.tolerance_m = 1e-4f;
      const Vec3 end = test::normalised(solve.tip()), across = test::normalised(test::cross(end, {1, 0, 0}));
      for (const double far_m : {1.5, 3.0, 4.5, 6.0}) {
        for (int plane = 0; plane < 6; ++plane, ++cases) {
          const double x = std::cos(plane * test::kPi / 6), y = std::sin(plane * test::kPi / 6);
          std::vector<Affine> last;
          double farthest = 0, end_farthest = 0;
          for (int i = -100; i <= 100; ++i) {
            const double c = -std::cos(i * kStep_rad) * far_m, s = std::sin(i * kStep_rad) * far_m;
            solve.rest();
            solve.to({s * x + c * end[0], s * y * across[1] + c * end[1], s * y * across[2] + c * end[2]});
            if (!last.empty()) {
              farthest = std::max(farthest, farthest_move(last, solve.scene));
              double squared = 0;
              for (int r = 0; r < 3; ++r) {
                const double d = solve.scene[5].rows[r][3] - last[5].rows[r][3];
                squared += d * d;
              }
              end_farthest = std::max(end_farthest, std::sqrt(squared));
            }
            last = solve.scene;
          }
          EXPECT_LE(end_farthest, far_m * kStep_rad + 2e-4 + 5e-4) << name_of(method) << bend_rad << ' ' << far_m;
          EXPECT_LE(farthest, 0.15) << name_of(method) << bend_rad << ' ' << far_m << ' ' << plane;
        }
      }
    }
  }
  EXPECT_EQ(cases, 2 * 3 * 4 * 6);
}

TEST(IkHeuristic, FacesThePoleAndPassesIt) {
  const test::TestSkeleton rig = column(4, 0.3);
  for (const IkMethod method : kMethods) {
    Solve solve(rig, 4, first_joints(4), method);
    solve.problem.pole_weight = 1;
    const float pole[3] = {3, 1, 2};
    std::copy(pole, pole + 3, solve.problem.pole);
    const IkReport report = solve.to({1, 2, -1});
    EXPECT_EQ(report.why, IkStop::reached);
    // The middle of the joints off the line is on the pole's side of it, and not beside that.
    const Vec3 line = test::normalised(solve.tip());
    Vec3 middle{};
    for (std::size_t j = 1; j < 4; ++j) {
      const Vec3 at = test::origin_of(test::scene_maps(rig, solve.local.data())[j]);
      for (std::size_t c = 0; c < 3; ++c) middle[c] += at[c];
    }
    const Vec3 plane = test::normalised(test::cross(line, Vec3{3, 1, 2}));
    EXPECT_NEAR(test::dot(middle, plane), 0, 2e-3);
    EXPECT_GT(test::dot(test::cross(plane, line), middle), 0.3);
    // As the target takes the line past the pole, half a turn about it takes 6 degrees to each side.
    for (const int steps : {250, 1000, 4000})
      EXPECT_LT(worst_ratio(solve, {1.5, 0.5, 0.3}, {1.5, 0.5, 1.7}, steps), 60) << name_of(method) << steps;
  }
}

TEST(IkHeuristic, BonesStretchToWhatIsOutOfReach) {
  const test::TestSkeleton rig = column(5, 0.2);
  for (const IkMethod method : kMethods) {
    Solve solve(rig, 5, first_joints(5), method);
    solve.options.stretch = 1.25f;
    IkReport report = solve.to({0, 3, 5});  // 5.83 m away
    EXPECT_EQ(report.why, IkStop::reached);
    EXPECT_NEAR(solve.distance({0, 3, 5}), 0, 1e-4);
    for (std::size_t j = 1; j <= 5; ++j)
      EXPECT_NEAR(test::length(test::joint_of(solve.local.data(), j).translation), std::sqrt(34.0) / 5, 1e-5);
    solve.rest();
    report = solve.to({0, 0, 8});
    EXPECT_EQ(report.why, IkStop::stalled);
    EXPECT_NEAR(report.error_m, 8 - 5 * 1.25, 1e-4);
    EXPECT_LT(worst_ratio(solve, {1, 4, 1}, {2, 8, 2}, 4000), 30);
  }
}

TEST(IkHeuristic, BonesShrinkToWhatIsTooNear) {
  test::TestSkeleton rig({{-1}, {0, {0, 3, 0}, test::axis_angle({1, 0, 0}, 2.5)}, {1, {0, 1, 0}}, {2, {0, 1, 0}}});
  for (const IkMethod method : kMethods) {
    Solve solve(rig, 3, first_joints(3), method);
    IkReport report = solve.to({0, 0.75, 0});  // at least 3 - 1 - 1 away
    EXPECT_NEAR(report.error_m, 0.25, 1e-2);
    solve.rest();
    solve.options.stretch = 1.5f;
    report = solve.to({0, 0.75, 0});
    EXPECT_NEAR(report.error_m, 0, 1e-2);
  }
}

TEST(IkHeuristic, StiffJointsStayAndScalesAreMinded) {
  int reached = 0;
  for (const IkMethod method : kMethods) {
    test::Random random(12);
    for (int i = 0; i < 200; ++i) {
      RandomChain chain(random, 6);
      for (test::TestJoint& j : chain.skeleton.joints)
        j.scale = {random.between(0.7, 1.4), random.between(0.7, 1.4), random.between(0.7, 1.4)};
      const Vec3 target = chain.reachable(random);
      const test::TestSkeleton rig(chain.skeleton.joints);
      Solve solve(rig, chain.tip, chain.joints, method);
      solve.options.tolerance_m = 1e-3f;
      const std::vector<float> stiffness = {0, 0.5f, 1, 0, 0.2f, 0};
      if (i % 2 == 0) solve.problem.stiffness = stiffness;
      const IkReport report = solve.to(target);
      EXPECT_NEAR(report.error_m, solve.distance(target), 1e-5);
      reached += report.why == IkStop::reached;
      if (i % 2 == 0) {
        const std::size_t stiff = chain.joints[2];
        EXPECT_EQ(test::joint_of(solve.local.data(), stiff).rotation, test::joint_of(rig.rest.data(), stiff).rotation);
      }
    }
  }
  EXPECT_GE(reached, 380);  // of 400: with other lengths, and a joint less, not all can be
  std::printf("%d of 400 reached\n", reached);
}

TEST(IkHeuristic, ManyGoalsAndRotations) {
  // A trunk of three joints with two arms of three; hands that are to be turned.
  std::vector<test::TestJoint> joints = {{-1}, {0, {0, 1, 0}}, {1, {0, 1, 0}}};
  joints.push_back({2, {0.5, 0.5, 0}, test::axis_angle({0, 0, 1}, 0.4)});
  joints.push_back({2, {-0.5, 0.5, 0}, test::axis_angle({0, 0, 1}, -0.4)});
  for (int i = 3; i < 9; ++i) joints.push_back({i, {i % 2 == 1 ? 0.7 : -0.7, 0, 0}, test::axis_angle({0, 1, 0}, 0.3)});
  const test::TestSkeleton rig(joints);
  for (const IkMethod method : kMethods) {
    Solve solve(rig, 9, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, method);
    solve.goals.resize(2);
    solve.goals[1].joint = 10;
    const Vec3 targets[2] = {{1.2, 2, 1}, {-0.8, 3, 1.2}};
    const test::Quat turned = test::axis_angle({1, 1, 0}, 0.7);
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t c = 0; c < 3; ++c) solve.goals[k].position[c] = static_cast<float>(targets[k][c]);
      for (std::size_t c = 0; c < 4; ++c) solve.goals[k].rotation[c] = static_cast<float>(turned[c]);
      solve.goals[k].rotation_weight = 0.5f;
    }
    solve.options.tolerance_m = 1e-3f;
    const IkReport report = solve.run();
    EXPECT_EQ(report.why, IkStop::reached) << name_of(method) << report.error_m << ' ' << report.iterations;
    const std::vector<test::Map> maps = test::scene_maps(rig, solve.local.data());
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LT(test::length(test::minus(test::origin_of(maps[9 + k]), targets[k])), 1.1e-3);
      const Vec3 x = test::direction(maps[9 + k], {1, 0, 0}),
                 want = test::direction(test::from_trs({}, turned, {1, 1, 1}), {1, 0, 0});
      EXPECT_LT(test::angle_deg(x, want), 0.2);
    }
  }
}

TEST(IkHeuristic, LimitsAreKeptWhateverTheTarget) {
  for (const IkMethod method : kMethods) {
    for (const LimitKind kind : test::kAllKinds) {
      test::Random random(9);
      test::LimitRandom limit_random(4);
      int cases = 0, reached = 0;
      double worst = 0, iterations = 0;
      for (; cases < 1000; ++cases) {
        const test::LimitedChain limited(random, limit_random, 4 + cases % 9, kind);
        Solve solve(limited.chain, method);
        solve.limits = limited.limits;
        solve.options.tolerance_m = static_cast<float>(1e-3 * limited.chain.length_m);
        solve.options.max_iterations = 64;
        const IkReport report = solve.to(limited.target);
        reached += report.why == IkStop::reached;
        iterations += report.iterations;
        worst = std::max(worst, limited.excess(solve.local.data()));
        solve.to({limited.target[0] * 3, -limited.target[1], 9});  // most often out of reach
        worst = std::max(worst, limited.excess(solve.local.data()));
      }
      EXPECT_LE(worst, 1e-4);
      EXPECT_GE(reached, kind == LimitKind::hinge ? 840 : 965) << name_of(method);
      std::printf("%s, limits of kind %d: %d of %d reached, %.1f iterations on average, outside by %.1e at most\n",
                  name_of(method), static_cast<int>(kind), reached, cases, iterations / cases, worst);
    }
  }
}

TEST(IkHeuristic, BadCallsAreRefusedAndWriteNothing) {
  const test::TestSkeleton rig = column(3, 0.2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  int cases = 0;
  for (const IkMethod method : kMethods) {
    Solve good(rig, 3, first_joints(3), method);
    good.to({1, 1, 1});
    const auto refuse = [&](auto spoil) {
      Solve bad(rig, 3, first_joints(3), method);
      for (float& c : bad.goals[0].position) c = 1;
      bad.problem.goals = bad.goals;
      bad.problem.joints = bad.joints;
      std::vector<std::byte> scratch = good.scratch;
      spoil(bad, scratch);
      IkReport report{-1, 77, IkStop::iterations};
      EXPECT_EQ(solve_ik(bad.pose(), bad.problem, bad.options, scratch, &report), Status::bad_argument);
      EXPECT_EQ(report.iterations, 77u);
      EXPECT_EQ(std::memcmp(bad.local.data(), rig.rest.data(), rig.rest.size() * sizeof(SoaTransform)), 0);
      ++cases;
    };
    refuse([](Solve& s, auto&) { s.options.stretch = 0.5f; });
    refuse([&](Solve& s, auto&) { s.options.stretch = nan; });
    refuse([&](Solve& s, auto&) { s.problem.pole[1] = nan; });
    refuse([](Solve& s, auto&) { s.problem.pole_weight = 1.5f; });
    refuse([](Solve&, auto& scratch) { scratch.pop_back(); });
    JointLimit limits[2];
    LimitDescription free_twist;
    free_twist.kind = LimitKind::hinge;
    ASSERT_EQ(make_limit(free_twist, 2, limits[0]), Status::ok);
    ASSERT_EQ(make_limit(free_twist, 1, limits[1]), Status::ok);
    refuse([&](Solve& s, auto&) { s.problem.limits = {limits, 2}; });  // not ascending
  }
  EXPECT_EQ(cases, 2 * 6);
}

std::uint64_t hash_of_solves(IkMethod method) {
  test::Random random(77);
  std::uint64_t hash = test::kHashStart;
  for (int i = 0; i < 200; ++i) {
    const RandomChain chain(random, 4 + i % 9);
    Solve solve(chain, method);
    solve.options.stretch = 1.1f;
    solve.problem.pole_weight = i % 3 == 0 ? 0.75f : 0.0f;
    std::vector<JointLimit> limits;
    for (const std::uint16_t j : chain.joints) {
      LimitDescription d;
      d.kind = test::kAllKinds[(i + j) % 3];
      for (int a = 0; a < 3; ++a) d.least_rad[a] = -1.25f, d.most_rad[a] = 1.25f;
      for (std::size_t c = 0; c < 4; ++c) d.zero[c] = static_cast<float>(chain.skeleton.joints[j].rotation[c]);
      JointLimit limit;
      EXPECT_EQ(make_limit(d, j, limit), Status::ok);
      if (i % 2 == 0) solve.limits.push_back(limit);
    }
    const Vec3 target = chain.reachable(random);
    solve.to({target[0] * (1 + i % 5 / 4), target[1], target[2]});
    hash = test::hash(hash, solve.local.data(), solve.local.size() * sizeof(SoaTransform));
    hash = test::hash(hash, solve.scene.data(), solve.scene.size() * sizeof(Affine));
  }
  return hash;
}

// The same on every processor, with SIMD or without.
TEST(IkHeuristic, Bits) {
  EXPECT_EQ(hash_of_solves(IkMethod::fabrik), 7908087629984035126u);
  EXPECT_EQ(hash_of_solves(IkMethod::ccd), 9619543779493431939u);
}

// What must not give NaN: bones of no length, targets at joints, chains on a line, odd scales, far targets, no size at
// all.
TEST(IkHeuristic, NothingBecomesInfiniteOrNotANumber) {
  int cases = 0;
  for (const IkMethod method : kMethods) {
    for (const double length : {1.0, 0.0, 1e-20, 1e12}) {
      for (const Vec3& scale : {Vec3{1, 1, 1}, Vec3{0, 0, 0}, Vec3{1, 0, 1}, Vec3{2, 0.5, -1}, Vec3{1e-12, 1, 1}}) {
        std::vector<test::TestJoint> joints;
        for (int i = 0; i <= 5; ++i) joints.push_back({i - 1, {0, i == 3 ? 0 : length, 0}, {0, 0, 0, 1}, scale});
        const test::TestSkeleton rig(joints);
        for (const Vec3& target : {Vec3{0, 0, 0}, Vec3{0, 2, 0}, Vec3{0, -1, 0}, Vec3{0, 9, 0}, Vec3{1e14, -1e14, 1e14},
                                   Vec3{1e-20, 1e-20, 0}}) {
          for (const float stretch : {1.0f, 1.5f}) {
            Solve solve(rig, 5, first_joints(5), method);
            solve.options.stretch = stretch;
            solve.problem.pole_weight = cases % 2 == 0 ? 1.0f : 0.0f;
            const IkReport report = solve.to(target);
            EXPECT_TRUE(all_finite(solve.local)) << cases;
            EXPECT_TRUE(std::isfinite(report.error_m)) << cases;
            ++cases;
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 2 * 4 * 5 * 6 * 2);
}

}  // namespace
}  // namespace marrow
