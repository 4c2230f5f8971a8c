// IkOptions::starts: other poses to start from lead out of the corners that limits make.
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "support/call_errors.h"
#include "unit/ik/solving.h"

namespace marrow {
namespace {

struct Reached {
  int cases = 0, reached = 0;
  double iterations = 0, worst_excess = 0;
};

// Chains of hinges and targets within them, by as many starts.
Reached reach(IkMethod method, std::uint8_t starts, int cases) {
  test::Random random(9);
  test::LimitRandom limit_random(4);
  Reached out;
  for (; out.cases < cases; ++out.cases) {
    const test::LimitedChain limited(random, limit_random, 4 + out.cases % 9, LimitKind::hinge);
    test::Solve solve(limited.chain, method);
    solve.limits = limited.limits;
    solve.options.starts = starts;
    solve.options.tolerance_m = static_cast<float>(9.9e-4 * limited.chain.length_m);
    solve.options.max_iterations = 64;
    const IkReport report = solve.to(limited.target);
    const double distance = solve.distance(limited.target);
    EXPECT_NEAR(report.error_m, distance, 1e-5 * limited.chain.length_m);
    EXPECT_LE(report.iterations, 64u * starts);
    out.reached += distance <= 1e-3 * limited.chain.length_m;
    out.iterations += report.iterations;
    out.worst_excess = std::max(out.worst_excess, limited.excess(solve.local.data()));
  }
  return out;
}

// As C's `= {0}` leaves them.
TEST(IkStarts, OptionsFullOfZerosAreToldWhatSetsThem) {
  test::Random random(9);
  const test::RandomChain chain(random, 4);
  test::Solve solve(chain, IkMethod::ccd);
  solve.to({0, 0, 0});
  const IkOptions zeros = {IkMethod::damped_least_squares, 0, 0, 0, 0, 0, 0, 0};
  test::CallErrors errors;
  EXPECT_EQ(solve_ik(solve.pose(), solve.problem, zeros, solve.scratch), Status::bad_argument);
  const std::vector<test::CallError> told = errors.take();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].condition.find("mrw_ik_options_init"), std::string::npos) << told[0].condition;
}

TEST(IkStarts, LeadOutOfCorners) {
  struct Row {
    IkMethod method;
    int one, two, eight;  // of 500, at least
  };
  const Row rows[] = {{IkMethod::fabrik, 420, 450, 480},
                      {IkMethod::ccd, 430, 455, 490},
                      {IkMethod::damped_least_squares, 450, 470, 490},
                      {IkMethod::gauss_newton, 400, 435, 475}};
  int cases = 0;
  for (const Row& row : rows) {
    const Reached one = reach(row.method, 1, 500), two = reach(row.method, 2, 500), eight = reach(row.method, 8, 500);
    EXPECT_GE(one.reached, row.one);
    EXPECT_GE(two.reached, row.two);
    EXPECT_GE(eight.reached, row.eight);
    for (const Reached& r : {one, two, eight}) {
      EXPECT_LE(r.worst_excess, 1e-4);
      std::printf("method %d: %d of %d, %.1f iterations\n", static_cast<int>(row.method), r.reached, r.cases,
                  r.iterations / r.cases);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 12);
}

// A target out of reach, with a pelvis that travels: the best of all starts is kept, as if it had been the only one.
TEST(IkStarts, TheBestIsKept) {
  int better = 0, cases = 0;
  for (const IkMethod method : {IkMethod::ccd, IkMethod::damped_least_squares}) {
    test::Random random(9);
    test::LimitRandom limit_random(4);
    for (int i = 0; i < 100; ++i, ++cases) {
      const test::LimitedChain limited(random, limit_random, 6, LimitKind::hinge);
      test::Solve solve(limited.chain, method);
      solve.limits = limited.limits;
      solve.options.max_iterations = 32;
      solve.problem.root_travel_m = 0.05f;
      const test::Vec3 target = {3 * limited.target[0], 3 * limited.target[1], 3 * limited.target[2]};
      const float one = solve.to(target).error_m;
      solve.rest();
      solve.options.starts = 4;
      const IkReport four = solve.to(target);
      EXPECT_LE(four.error_m, one);
      EXPECT_NEAR(four.error_m, solve.distance(target), 1e-5 * limited.chain.length_m);
      better += four.error_m < 0.999f * one;
    }
  }
  EXPECT_EQ(cases, 200);
  EXPECT_GE(better, 10);
}

// Bones become longer once: by the distance over the chain's length, whichever start is kept.
TEST(IkStarts, StretchOnce) {
  int better = 0, cases = 0;
  for (const IkMethod method : {IkMethod::fabrik, IkMethod::ccd}) {
    test::Random random(9);
    test::LimitRandom limit_random(4);
    for (int i = 0; i < 50; ++i, ++cases) {
      const test::LimitedChain limited(random, limit_random, 6, LimitKind::hinge);
      test::Solve solve(limited.chain, method);
      const std::vector<test::Map> maps = test::scene_maps(limited.chain.skeleton, solve.local.data());
      const test::Vec3 root = test::origin_of(maps[limited.chain.joints[0]]);
      const double far = 1.25 * limited.chain.length_m;
      const test::Vec3 target = {root[0] + far, root[1], root[2]};
      solve.limits = limited.limits;
      solve.options.max_iterations = 32;
      solve.options.stretch = i % 2 == 0 ? 2.0f : 1.125f;
      const float one = solve.to(target).error_m;
      solve.rest();
      solve.options.starts = 4;
      const IkReport four = solve.to(target);
      EXPECT_NEAR(four.error_m, solve.distance(target), 1e-5 * limited.chain.length_m);
      const std::uint16_t joint = limited.chain.joints[1];
      const test::Vec3 was = limited.chain.skeleton.joints[joint].translation,
                       is = test::joint_of(solve.local.data(), joint).translation;
      EXPECT_NEAR(test::length(is) / test::length(was), i % 2 == 0 ? 1.25 : 1.125, 1e-5);
      better += four.error_m < 0.999f * one;
    }
  }
  EXPECT_EQ(cases, 100);
  EXPECT_GE(better, 10);
}

TEST(IkStarts, ChangeNothingWhereOneReaches) {
  int cases = 0;
  for (const IkMethod method : {IkMethod::fabrik, IkMethod::gauss_newton}) {
    test::Random random(12);
    for (int i = 0; i < 50; ++i, ++cases) {
      const test::RandomChain chain(random, 6);
      const test::Vec3 target = chain.reachable(random);
      test::Solve one(chain, method), many(chain, method);
      many.options.starts = 255;
      EXPECT_EQ(one.to(target).iterations, many.to(target).iterations);
      EXPECT_EQ(std::memcmp(one.local.data(), many.local.data(), one.local.size() * sizeof(SoaTransform)), 0);
    }
  }
  EXPECT_EQ(cases, 100);
}

// What is named alone does the same.
TEST(IkStarts, NamedSolversAreTheSame) {
  int cases = 0;
  for (const IkMethod method :
       {IkMethod::fabrik, IkMethod::ccd, IkMethod::damped_least_squares, IkMethod::gauss_newton}) {
    test::Random random(12);
    const test::RandomChain chain(random, 6);
    const test::Vec3 target = chain.reachable(random);
    test::Solve any(chain, method), named(chain, method);
    any.to(target);
    for (std::size_t c = 0; c < 3; ++c) named.goals[0].position[c] = static_cast<float>(target[c]);
    named.problem.goals = named.goals;
    named.problem.joints = named.joints;
    named.scratch.resize(any.scratch.size());
    const bool is_chain = method == IkMethod::fabrik || method == IkMethod::ccd;
    const auto good = is_chain ? solve_ik_chain : solve_ik_body, bad = is_chain ? solve_ik_body : solve_ik_chain;
    EXPECT_EQ(bad(named.pose(), named.problem, named.options, named.scratch, nullptr), Status::bad_argument);
    EXPECT_EQ(std::memcmp(chain.skeleton.rest.data(), named.local.data(), named.local.size() * sizeof(SoaTransform)),
              0);
    EXPECT_EQ(good(named.pose(), named.problem, named.options, named.scratch, nullptr), Status::ok);
    EXPECT_EQ(std::memcmp(any.local.data(), named.local.data(), any.local.size() * sizeof(SoaTransform)), 0);
    ++cases;
  }
  EXPECT_EQ(cases, 4);
}

TEST(IkStarts, NoneIsRefused) {
  test::Random random(12);
  const test::RandomChain chain(random, 6);
  test::Solve solve(chain, IkMethod::ccd);
  solve.to({1, 0, 0});
  solve.options.starts = 0;
  EXPECT_EQ(solve_ik(solve.pose(), solve.problem, solve.options, solve.scratch), Status::bad_argument);
}

}  // namespace
}  // namespace marrow
