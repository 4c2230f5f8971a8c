// Damped least squares and Gauss-Newton on one chain: what can be reached is reached, limits hold, what cannot be
// reached degrades without a jump, and nothing degenerate gives a number that is none.
#include <algorithm>
#include <cstdio>

#include "marrow/limits.h"
#include "unit/ik/limit_reference.h"
#include "unit/ik/posed.h"

namespace marrow {
namespace {

using test::PosedSkeleton;
using test::RandomChain;
using test::Vec3;

constexpr IkMethod kJacobian[] = {IkMethod::damped_least_squares, IkMethod::gauss_newton};

const char* jacobian_name(IkMethod method) {
  return method == IkMethod::gauss_newton ? "Gauss-Newton" : "DLS";
}

struct Rate {
  int cases = 0, reached = 0;
  double iterations = 0;
  void add(bool good, const IkReport& report) {
    ++cases;
    reached += good ? 1 : 0;
    iterations += report.iterations;
  }
  double share() const { return static_cast<double>(reached) / cases; }
  void print(const char* what, IkMethod method) const {
    std::printf("%s, %s: %.2f %% of %d, %.2f iterations\n", jacobian_name(method), what, 100 * share(), cases,
                iterations / cases);
  }
};

PosedSkeleton posed(const RandomChain& chain, IkMethod method, const Vec3& target) {
  PosedSkeleton p(chain.skeleton, method);
  p.add_goal(chain.tip, target);
  p.joints = chain.joints;
  p.options.max_iterations = 32;
  p.options.tolerance_m = static_cast<float>(1e-3 * chain.length_m);
  return p;
}

TEST(IkJacobian, ReachesWhatCanBeReached) {
  for (const IkMethod method : kJacobian) {
    test::Random random(11);
    Rate rate;
    for (int i = 0; i < 10000; ++i) {
      const RandomChain chain(random, 4 + i % 9);
      PosedSkeleton p = posed(chain, method, chain.reachable(random));
      const IkReport report = p.solve();
      const double error = p.distance(0);
      EXPECT_NEAR(error, static_cast<double>(report.error_m), 1e-5 * chain.length_m);
      rate.add(error <= 1.0001e-3 * chain.length_m, report);
    }
    rate.print("random targets", method);
    EXPECT_EQ(rate.cases, 10000);
    EXPECT_GE(rate.share(), 0.999);
    EXPECT_LE(rate.iterations / rate.cases, 8.5);
  }
}

TEST(IkJacobian, ReachesThroughScaleThatDiffersByAxis) {
  for (const IkMethod method : kJacobian) {
    test::Random random(12);
    Rate rate;
    for (int i = 0; i < 1000; ++i) {
      const RandomChain straight(random, 4 + i % 9);
      RandomChain chain = straight;
      for (test::TestJoint& j : chain.skeleton.joints) {
        j.scale = {random.between(0.8, 1.25), random.between(0.8, 1.25), random.between(0.8, 1.25)};
      }
      chain.skeleton = test::TestSkeleton(chain.skeleton.joints);
      PosedSkeleton p = posed(chain, method, chain.reachable(random));
      const IkReport report = p.solve();
      EXPECT_NEAR(p.distance(0), static_cast<double>(report.error_m), 1e-5 * chain.length_m);
      rate.add(p.distance(0) <= 1.0001e-3 * chain.length_m, report);
    }
    rate.print("scaled by axis", method);
    EXPECT_EQ(rate.cases, 1000);
    EXPECT_GE(rate.share(), 0.99);
  }
}

// Limits of every kind in turn, about the rest rotation.
LimitDescription random_limit(test::Random& random, const test::TestJoint& joint, int kind) {
  LimitDescription d;
  d.kind = kind == 0 ? LimitKind::hinge : kind == 1 ? LimitKind::cone : LimitKind::euler;
  d.order = kind == 2 ? static_cast<AxisOrder>(random.below(6)) : AxisOrder::xyz;
  const Vec3 axis = test::random_direction(random), across = test::cross(axis, test::random_direction(random));
  for (std::size_t c = 0; c < 4; ++c) d.zero[c] = static_cast<float>(joint.rotation[c]);
  for (std::size_t c = 0; c < 3; ++c) {
    d.axis[c] = static_cast<float>(axis[c]);
    d.across[c] = static_cast<float>(across[c]);
    if (kind == 0 && c > 0) continue;
    d.most_rad[c] = static_cast<float>(random.between(0.3, 1.2));
    d.least_rad[c] = -d.most_rad[c];
  }
  return d;
}

TEST(IkJacobian, NeverBreaksALimit) {
  for (const IkMethod method : kJacobian) {
    test::Random random(13);
    Rate rate;
    double worst = 0;
    int checked = 0;
    for (int i = 0; i < 2000; ++i) {
      const RandomChain chain(random, 4 + i % 9);
      std::vector<LimitDescription> descriptions;
      PosedSkeleton p = posed(chain, method, {0, 0, 0});
      std::vector<SoaTransform> goal_pose = p.local;
      for (const std::uint16_t j : chain.joints) {
        descriptions.push_back(random_limit(random, chain.skeleton.joints[j], i % 4 == 0 ? 0 : 1 + j % 2));
        JointLimit limit;
        ASSERT_EQ(make_limit(descriptions.back(), j, limit), Status::ok);
        p.limits.push_back(limit);
        const test::Quat turned = test::product(chain.skeleton.joints[j].rotation, test::random_turn(random, 3));
        for (std::size_t c = 0; c < 4; ++c) goal_pose[j / 4].rotation[c][j % 4] = static_cast<float>(turned[c]);
      }
      ASSERT_EQ(limit_pose(p.limits, goal_pose), Status::ok);
      const Vec3 target = test::origin_of(test::scene_maps(chain.skeleton, goal_pose.data())[chain.tip]);
      for (std::size_t c = 0; c < 3; ++c) p.goals[0].position[c] = static_cast<float>(target[c]);
      p.options.max_iterations = 64;
      const IkReport report = p.solve();
      if (i % 4 != 0) rate.add(p.distance(0) <= 1.0001e-3 * chain.length_m, report);
      for (std::size_t k = 0; k < chain.joints.size(); ++k, ++checked) {
        const test::Quat q = test::normalised(test::joint_of(p.local.data(), chain.joints[k]).rotation);
        worst = std::max(worst, test::reference_excess(descriptions[k], test::matrix(q)));
      }
    }
    rate.print("cones and Euler boxes", method);
    EXPECT_EQ(rate.cases, 1500);
    EXPECT_GE(checked, 15000);
    EXPECT_GE(rate.share(), 0.99);
    EXPECT_LE(worst, 1e-4);
  }
}

// First-order optimality, by a Jacobian from finite differences in double precision: what Gauss-Newton's rotation
// vectors x have beside the rows of J would be change for nothing.
double share_for_nothing(const PosedSkeleton& p, const RandomChain& chain) {
  const std::size_t n = chain.joints.size();
  std::vector<test::TestJoint> joints = chain.skeleton.joints;
  std::vector<Vec3> x, rows[3];
  for (const std::uint16_t j : chain.joints) {
    const test::Quat from = chain.skeleton.joints[j].rotation,
                     to = test::normalised(test::joint_of(p.local.data(), j).rotation);
    const test::Quat d = test::product({-from[0], -from[1], -from[2], from[3]}, to);
    const double sine = test::length({d[0], d[1], d[2]}), sign = d[3] < 0 ? -1 : 1;
    const double factor = sine > 1e-12 ? 2 * std::atan2(sine, sign * d[3]) / sine * sign : 2;
    x.push_back({d[0] * factor, d[1] * factor, d[2] * factor});
    joints[j].rotation = to;
  }
  const auto tip = [&] {
    std::vector<test::Map> maps;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const test::Map l = test::from_trs(joints[j].translation, joints[j].rotation, joints[j].scale);
      maps.push_back(joints[j].parent < 0 ? l : maps[static_cast<std::size_t>(joints[j].parent)] * l);
    }
    return test::origin_of(maps[chain.tip]);
  };
  for (std::vector<Vec3>& row : rows) row.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    test::Quat& q = joints[chain.joints[k]].rotation;
    const test::Quat was = q;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec3 about = {0, 0, 0};
      about[axis] = 1;
      q = test::product(was, test::axis_angle(about, 1e-5));
      const Vec3 plus = tip();
      q = test::product(was, test::axis_angle(about, -1e-5));
      const Vec3 slope = test::minus(plus, tip());
      for (std::size_t r = 0; r < 3; ++r) rows[r][k][axis] = slope[r];
      q = was;
    }
  }
  // x without its part along the rows, by Gram and Schmidt.
  const auto inner = [&](const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += test::dot(a[k], b[k]);
    return sum;
  };
  const auto take_off = [&](std::vector<Vec3>& v, const std::vector<Vec3>& unit) {
    const double along = inner(v, unit);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t c = 0; c < 3; ++c) v[k][c] -= along * unit[k][c];
  };
  const double before = inner(x, x);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = 0; s < r; ++s) take_off(rows[r], rows[s]);
    const double l = std::sqrt(inner(rows[r], rows[r]));
    for (Vec3& v : rows[r])
      for (double& c : v) c /= l;
    take_off(x, rows[r]);
  }
  return std::sqrt(inner(x, x) / before);
}

TEST(IkJacobian, GaussNewtonChangesThePoseAsLittleAsMayBe) {
  double mean[2] = {0, 0};
  int cases = 0;
  for (int i = 0; i < 300; ++i, ++cases) {
    for (int m = 0; m < 2; ++m) {
      test::Random random(1000 + static_cast<std::uint64_t>(i));
      const RandomChain chain(random, 4 + i % 9);
      PosedSkeleton p = posed(chain, kJacobian[m], chain.reachable(random, 0.8));
      p.options.max_iterations = 200;
      p.options.tolerance_m = static_cast<float>(1e-5 * chain.length_m);
      p.solve();
      EXPECT_LE(p.distance(0), 2e-5 * chain.length_m);
      mean[m] += share_for_nothing(p, chain) / 300;
    }
  }
  std::printf("share of the change that does not serve the goal: DLS %.3f, Gauss-Newton %.3f\n", mean[0], mean[1]);
  EXPECT_EQ(cases, 300);
  EXPECT_LE(mean[1], 0.08);
  EXPECT_GE(mean[0], 2 * mean[1]);  // so that the measure measures
}

TEST(IkJacobian, GetsOutOfAStraightLine) {
  int cases = 0;
  for (const IkMethod method : kJacobian) {
    for (const int bones : {2, 3, 8}) {
      for (const double at : {0.99, 0.9, 0.5, 0.1, 0.0, -0.3, -0.9}) {
        const test::TestSkeleton rig = test::bent_chain(bones, 1.0 / bones, 0);
        PosedSkeleton p(rig, method);
        p.add_goal(static_cast<std::uint16_t>(bones), {0, at, 0});
        p.joints = test::first_joints(bones);
        p.options.max_iterations = 32;
        p.options.tolerance_m = 1e-3f;
        p.solve();
        EXPECT_LE(p.distance(0), 1.001e-3) << jacobian_name(method) << ", " << bones << " bones to " << at;
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 42);
}

TEST(IkJacobian, PointsAtWhatIsOutOfReach) {
  int cases = 0;
  for (const IkMethod method : kJacobian) {
    for (const double far : {1.01, 1.2, 3.0, 100.0}) {
      for (const double angle : {0.0, 0.5, 1.5}) {
        const test::TestSkeleton rig = test::bent_chain(6, 1.0 / 6, 0.2);
        PosedSkeleton p(rig, method);
        const Vec3 best = {std::sin(angle), std::cos(angle), 0};
        p.add_goal(6, {best[0] * far, best[1] * far, 0});
        p.joints = test::first_joints(6);
        p.options.max_iterations = 32;
        EXPECT_NE(p.solve().why, IkStop::reached);
        EXPECT_LE(test::length(test::minus(test::origin_of(p.maps()[6]), best)), 2e-3) << far << " " << angle;
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 24);
}

// How far the joints turn at most between neighbouring moments of a path of the target, each solved from the same pose,
// or, `warm`, from the last result.
template <class Path>
double roughest(IkMethod method, int moments, bool warm, Path&& path) {
  const test::TestSkeleton rig = test::bent_chain(6, 1.0 / 6, 0.2);
  PosedSkeleton p(rig, method);
  p.add_goal(6, {0, 0, 0});
  p.joints = test::first_joints(6);
  double worst = 0;
  std::vector<SoaTransform> before;
  for (int i = 0; i < moments; ++i) {
    const Vec3 target = path(static_cast<double>(i) / (moments - 1));
    for (std::size_t c = 0; c < 3; ++c) p.goals[0].position[c] = static_cast<float>(target[c]);
    if (!warm) p.rest();
    p.solve();
    if (i > (warm ? 5 : 0)) worst = std::max(worst, test::largest_turn(rig, before.data(), p.local.data()));
    before = p.local;
  }
  return worst;
}

TEST(IkJacobian, NothingPops) {
  for (const IkMethod method : kJacobian) {
    SCOPED_TRACE(jacobian_name(method));
    // Outward through full stretch, by 0.2 mm. There a bend of φ is worth φ² / 2 of length, so that 0.02 is √(2 ·
    // 2e-4).
    const auto outward = [](double t) {
      return Vec3{0.6 * (0.8 + 0.4 * t), 0.64 * (0.8 + 0.4 * t), 0.48 * (0.8 + 0.4 * t)};
    };
    EXPECT_LE(roughest(method, 2001, false, outward), 0.04);
    // Round the base by 1.6 mrad, past the point behind it.
    const auto round = [](double t) { return Vec3{0.7 * std::sin(6.2831853 * t), 0.7 * std::cos(6.2831853 * t), 0.1}; };
    EXPECT_LE(roughest(method, 4001, false, round), 0.04);
    EXPECT_LE(roughest(method, 4001, true, round), 0.01);
  }
}

TEST(IkJacobian, NothingDegenerateIsNotFinite) {
  int cases = 0;
  for (const IkMethod method : kJacobian) {
    test::Random random(15);
    for (int i = 0; i < 3000; ++i) {
      const int bones = 1 + i % 6;
      std::vector<test::TestJoint> all;
      for (int j = 0; j <= bones; ++j) {
        test::TestJoint t;
        t.parent = j - 1;
        const auto number = [&] {
          constexpr double kNumbers[] = {0, 0, 1, -1, 0.5, 1e-20, 1e3, 1e-3};
          return kNumbers[random.below(8)];
        };
        t.translation = {number(), number(), number()};
        t.scale = random.below(2) == 0 ? Vec3{1, 1, 1} : Vec3{number(), number(), number()};
        if (random.below(2) == 0) t.rotation = random.rotation();
        all.push_back(t);
      }
      const test::TestSkeleton rig(all);
      PosedSkeleton p(rig, method);
      p.joints = test::first_joints(bones);
      const std::uint16_t tip = static_cast<std::uint16_t>(bones);
      const Vec3 somewhere = {random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
      const Vec3 its_own = test::origin_of(test::to_map(p.scene[tip])),
                 base = test::origin_of(test::to_map(p.scene[0]));
      const Vec3 targets[] = {somewhere, its_own, base, {1e12, -1e14, 1e3}, {1e-30, 0, 0}};
      IkGoal& goal = p.add_goal(tip, targets[random.below(5)]);
      if (random.below(3) == 0) goal.rotation_weight = 1;
      if (random.below(3) == 0) goal.position_weight = random.below(2) == 0 ? 0.0f : 100.0f;
      if (random.below(3) == 0) p.problem.root_travel_m = 1;
      if (random.below(3) == 0) p.options.tolerance_m = 0;
      if (random.below(3) == 0) p.options.damping = 0;
      const IkReport report = p.solve();
      EXPECT_TRUE(p.is_finite()) << "case " << i;
      EXPECT_FALSE(std::isnan(report.error_m)) << "case " << i;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 6000);
}

}  // namespace
}  // namespace marrow
