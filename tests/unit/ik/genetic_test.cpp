// The genetic solver: it reaches what others do not, and chance is the same everywhere.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "support/pose_file.h"
#include "unit/ik/solving.h"

namespace marrow {
namespace {

struct Evolved : test::Solve {
  explicit Evolved(const test::RandomChain& chain) : Solve(chain, IkMethod::ccd) {
    genetic = true;
    options.max_iterations = 100;
    options.tolerance_m = static_cast<float>(9.9e-4 * chain.length_m);
  }
};

TEST(IkGenetic, ReachesWhatCanBeReachedWithinLimits) {
  for (const LimitKind kind : test::kAllKinds) {
    test::Random random(9);
    test::LimitRandom limit_random(4);
    int cases = 0, reached = 0, most = 0;
    double worst = 0, generations = 0;
    for (; cases < 500; ++cases) {
      const test::LimitedChain limited(random, limit_random, 4 + cases % 9, kind);
      Evolved solve(limited.chain);
      solve.limits = limited.limits;
      solve.options.seed = static_cast<std::uint32_t>(cases);
      const IkReport report = solve.to(limited.target);
      const double distance = solve.distance(limited.target);
      reached += distance <= 1e-3 * limited.chain.length_m;
      EXPECT_NEAR(report.error_m, distance, 2e-6 * limited.chain.length_m);
      generations += report.iterations;
      most = std::max(most, static_cast<int>(report.iterations));
      worst = std::max(worst, limited.excess(solve.local.data()));
    }
    EXPECT_EQ(reached, 500);
    EXPECT_LE(worst, 1e-4);
    std::printf(
        "limits of kind %d: %d of %d reached, %.2f generations on average, %d at most, outside by %.1e at most\n",
        static_cast<int>(kind), reached, cases, generations / cases, most, worst);
  }
}

TEST(IkGenetic, ReachesWithoutLimits) {
  test::Random random(5);
  int reached = 0;
  for (int i = 0; i < 500; ++i) {
    const test::RandomChain chain(random, 4 + i % 9);
    const test::Vec3 target = chain.reachable(random);
    Evolved solve(chain);
    solve.to(target);
    reached += solve.distance(target) <= 1e-3 * chain.length_m;
  }
  EXPECT_EQ(reached, 500);
}

TEST(IkGenetic, TheSameSeedIsTheSameResult) {
  test::Random random(5);
  const test::RandomChain chain(random, 7);
  const test::Vec3 target = chain.reachable(random);
  std::vector<SoaTransform> poses[3];
  for (std::size_t i = 0; i < 3; ++i) {
    Evolved solve(chain);
    solve.options.seed = i < 2 ? 11 : 12;
    solve.to(target);
    poses[i] = solve.local;
  }
  const std::size_t size = poses[0].size() * sizeof(SoaTransform);
  EXPECT_EQ(std::memcmp(poses[0].data(), poses[1].data(), size), 0);
  EXPECT_NE(std::memcmp(poses[0].data(), poses[2].data(), size), 0);
}

TEST(IkGenetic, OutOfReachComesAsNearAsItCan) {
  test::Random random(6);
  const test::RandomChain chain(random, 5);
  Evolved solve(chain);
  const std::vector<test::Map> maps = test::scene_maps(chain.skeleton, solve.local.data());
  const test::Vec3 root = test::origin_of(maps[chain.joints[0]]);
  const double far = 2 * chain.length_m;
  const IkReport report = solve.to({root[0] + far, root[1], root[2]});
  EXPECT_EQ(report.why, IkStop::iterations);
  EXPECT_EQ(report.iterations, 100u);
  EXPECT_NEAR(report.error_m, chain.length_m, 0.01 * chain.length_m);
  solve.rest();
  solve.options.starts = 0;
  EXPECT_EQ(solve.to({root[0] + far, root[1], root[2]}).iterations, 100u);
  solve.rest();
  solve.options.starts = 3;
  EXPECT_EQ(solve.to({root[0] + far, root[1], root[2]}).iterations, 100u) << "starts have no meaning";
}

TEST(IkGenetic, WeightNoneKeepsEveryBitAndShortMemoryIsRefused) {
  test::Random random(7);
  const test::RandomChain chain(random, 6);
  Evolved solve(chain);
  solve.options.weight = 0;
  const std::vector<SoaTransform> local = solve.local;
  solve.to(chain.reachable(random));
  EXPECT_EQ(std::memcmp(local.data(), solve.local.data(), local.size() * sizeof(SoaTransform)), 0);
  solve.options.weight = 1;
  Span<std::byte> less(solve.scratch.data(), solve.scratch.size() - 1);
  EXPECT_EQ(solve_ik_genetic(solve.pose(), solve.problem, solve.options, less), Status::bad_argument);
  EXPECT_EQ(std::memcmp(local.data(), solve.local.data(), local.size() * sizeof(SoaTransform)), 0);
}

// The same on every processor, with SIMD or without.
TEST(IkGenetic, Bits) {
  test::Random random(8);
  std::uint64_t hash = test::kHashStart;
  for (int i = 0; i < 40; ++i) {
    const test::RandomChain chain(random, 4 + i % 9);
    Evolved solve(chain);
    solve.options.tolerance_m = 1e-6f;
    solve.options.max_iterations = 4;
    solve.options.seed = static_cast<std::uint32_t>(i);
    solve.to(chain.reachable(random));
    hash = test::hash(hash, solve.local.data(), solve.local.size() * sizeof(SoaTransform));
  }
  EXPECT_EQ(hash, 521358353753472248u);
}

}  // namespace
}  // namespace marrow
