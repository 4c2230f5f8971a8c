// Spring bones against what springs.h promises: the pendulum, its energy, and what does not depend on the frame rate.
#include <cmath>

#include <gtest/gtest.h>

#include "springs/spring_state.h"
#include "unit/ik/springs_support.h"

namespace marrow {
namespace {

using test::distance;
using test::Pendulum;
using test::Rod;
using test::Vec3;

constexpr double kTurn = 2 * 3.14159265358979;

SpringJoint spring(double frequency_hz, double damping_ratio, double gravity = 0) {
  SpringJoint s;
  s.frequency_hz = static_cast<float>(frequency_hz);
  s.damping_ratio = static_cast<float>(damping_ratio);
  s.gravity = static_cast<float>(gravity);
  return s;
}

Vec3 lane(const float (&v)[3][4], std::size_t i) {
  return {static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
}
Vec3 velocity(const Rod& rod, std::size_t bone) {
  return lane(rod.springs.groups[bone / 4].velocity, bone % 4);
}
void set_motion(Rod& rod, std::size_t bone, const Vec3& direction, const Vec3& velocity) {
  for (std::size_t i = 0; i < 3; ++i) {
    rod.springs.groups[bone / 4].direction[i][bone % 4] = static_cast<float>(direction[i]);
    rod.springs.groups[bone / 4].velocity[i][bone % 4] = static_cast<float>(velocity[i]);
  }
}
// A swing let go at 0.1 rad, without gravity: the linear oscillator, by its closed form.
double oscillator(double frequency_hz, double damping_ratio, double time_s) {
  const double omega = kTurn * frequency_hz, gamma = damping_ratio * omega;
  const double square = omega * omega - gamma * gamma, root = std::sqrt(std::fabs(square));
  if (square > 1e-9)
    return std::exp(-gamma * time_s) * (std::cos(root * time_s) + gamma / root * std::sin(root * time_s));
  return std::exp(-gamma * time_s) * (1 + gamma * time_s);  // critical
}

TEST(Springs, SmallSwingsHaveTheFrequencyAndTheDecay) {
  int cases = 0;
  double worst = 0;
  for (const double hz : {15, 30, 60, 120, 240}) {
    for (const double frequency : {0.5, 2.0, 5.0, 10.0}) {
      for (const double ratio : {0.05, 0.3, 0.7, 1.0}) {
        Rod rod(1, spring(frequency, ratio));
        ASSERT_EQ(rod.step(0), Status::ok);
        const double angle = 0.03;
        set_motion(rod, 0, {std::cos(angle), std::sin(angle), 0}, {0, 0, 0});
        for (int i = 1; i <= 2 * hz; ++i, ++cases) {
          rod.pose();
          ASSERT_EQ(rod.step(static_cast<float>(1 / hz)), Status::ok);
          const double want = angle * oscillator(frequency, ratio, i / hz), got = std::asin(rod.direction(0)[1]);
          worst = std::max(worst, std::fabs(got - want) / angle);
        }
      }
    }
  }
  EXPECT_EQ(cases, 2 * (15 + 30 + 60 + 120 + 240) * 16);
  EXPECT_LT(worst, 0.003);
  std::printf("worst %.5f of the swing\n", worst);
}

// A bone whose joint bobs and whose character turns, with gravity, wind and drag.
struct Ride {
  double frequency_hz, damping_ratio;
  double turn_rad(double t) const { return 0.25 * (1 - std::cos(kTurn * t)); }
  Vec3 place(double t) const { return {0.05 * std::sin(kTurn * t), 0.1 * (1 - std::cos(kTurn * t)), 0.3 * t}; }
  Vec3 animated(double t) const { return {std::cos(turn_rad(t)), 0, -std::sin(turn_rad(t))}; }

  Rod rod() const {
    SpringJoint s = spring(frequency_hz, damping_ratio, 1);
    s.drag = 1;
    Rod out(1, s);
    out.frame.wind[2] = 1;
    return out;
  }
  Pendulum pendulum() const {
    Pendulum p;
    p.frequency_hz = frequency_hz;
    p.damping_ratio = damping_ratio;
    p.drag = 1;
    p.gravity = {0, static_cast<double>(-9.81f), 0};
    p.wind = {0, 0, 1};
    p.animated = [this](double t) { return animated(t); };
    p.joint = [this](double t) { return place(t); };
    return p;
  }
  void pose(Rod& rod, double t) const { rod.pose(place(t), test::axis_angle({0, 1, 0}, turn_rad(t))); }
};

TEST(Springs, RidesAlongLikeThePendulumAtAnyFrameRate) {
  int cases = 0;
  for (const double frequency : {1.0, 1.5, 2.0}) {
    for (const double ratio : {0.1, 0.5, 1.0}) {
      for (const int hz : {15, 30, 60, 120, 240, 0}) {  // 0: irregular
        const Ride ride{frequency, ratio};
        Rod rod = ride.rod();
        Pendulum p = ride.pendulum();
        test::Random random(7);
        double t = 0, worst = 0, swing = 0;
        const auto step = [&] {
          const float dt = hz > 0 ? 1.0f / static_cast<float>(hz) : static_cast<float>(random.between(0.002, 0.033));
          t += static_cast<double>(dt);
          ride.pose(rod, t);
          ASSERT_EQ(rod.step(dt), Status::ok);
        };
        while (t < 0.25) step();
        p.d = rod.direction(0);
        p.u = velocity(rod, 0);
        while (t < 3) {
          const double before = t;
          step();
          p.advance(before, t - before);
          worst = std::max(worst, distance(rod.direction(0), p.d));
          swing = std::max(swing, distance(p.d, p.animated(t)));
          ++cases;
        }
        EXPECT_LT(worst, (hz == 15 ? 0.025 : 0.01) * swing) << frequency << " Hz, " << ratio << " at " << hz << " Hz";
        EXPECT_GT(swing, 0.1);
      }
    }
  }
  EXPECT_GT(cases, 9 * 3 * (15 + 30 + 60 + 120 + 240));
}

// Where a chain is at the end of each 1/15 s, at two frame rates.
TEST(Springs, AChainsPathIsTheSameAt30And120Hz) {
  const auto path = [](int hz) {
    SpringJoint s = spring(2, 0.4, 1);
    Rod rod(6, s, 0.1);
    const Ride ride{2, 0.4};
    std::vector<Vec3> out;
    for (int i = 0; i <= 4 * hz; ++i) {
      const double t = static_cast<double>(i) / hz;
      ride.pose(rod, t);
      EXPECT_EQ(rod.step(i == 0 ? 0.0f : 1.0f / static_cast<float>(hz)), Status::ok);
      if (i % (hz / 15) == 0 && t > 0.5) {
        for (std::size_t b = 0; b < rod.bones(); ++b) out.push_back(test::minus(rod.end(b), rod.place(1)));
      }
    }
    return out;
  };
  const std::vector<Vec3> few = path(30), many = path(120);
  ASSERT_EQ(few.size(), many.size());
  ASSERT_GT(few.size(), 300u);
  double worst = 0;
  for (std::size_t i = 0; i < few.size(); ++i) worst = std::max(worst, distance(few[i], many[i]));
  EXPECT_LT(worst, 0.01 * 0.6) << "of the chain's length";
  std::printf("worst %.5f of the length\n", worst / 0.6);
}

double energy(const Rod& rod, const Vec3& field) {
  const Vec3 u = velocity(rod, 0);
  return test::dot(u, u) / 2 + test::length(field) - test::dot(field, lane(rod.springs.groups[0].direction, 0));
}

TEST(Springs, EnergyNeverGrows) {
  int cases = 0, lost = 0;
  test::Random random(11);
  for (int run = 0; run < 400; ++run) {
    const double frequency = random.between(0, 8), ratio = run % 3 == 0 ? 0 : random.between(0, 1.2);
    const double gravity = run % 2 == 0 ? 0 : 1;
    Rod rod(1, spring(frequency, ratio, gravity));
    ASSERT_EQ(rod.step(0), Status::ok);
    const Vec3 d = test::normalised(Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    const Vec3 any{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    set_motion(rod, 0, d, test::plus(any, d, -test::dot(any, d)));
    const double stiffness = kTurn * frequency * kTurn * frequency;
    const Vec3 field{stiffness, -9.81 * gravity / rod.length_m(), 0};
    const double first = energy(rod, field);
    double before = first;
    for (int i = 0; i < 200; ++i, ++cases) {
      rod.pose();
      ASSERT_EQ(rod.step(static_cast<float>(random.between(0.002, 0.04))), Status::ok);
      const double now = energy(rod, field);
      // Rounding of the direction alone is 6e-8 of the field.
      EXPECT_LE(now, before + 1e-6 * (first + test::length(field))) << run << " at " << i;
      before = now;
    }
    lost += before < 0.5 * first;
  }
  EXPECT_EQ(cases, 400 * 200);
  EXPECT_GT(lost, 200);
}

TEST(Springs, WithoutDampingASwingGoesOn) {
  Rod rod(1, spring(2, 0));
  ASSERT_EQ(rod.step(0), Status::ok);
  set_motion(rod, 0, {std::cos(1.0), std::sin(1.0), 0}, {0, 0, 0});
  double last = 0;
  for (int i = 0; i < 60 * 20; ++i) {
    rod.pose();
    ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    if (i >= 60 * 19) last = std::max(last, std::fabs(std::asin(rod.direction(0)[1])));
  }
  EXPECT_GT(last, 0.9) << "after forty swings";
  EXPECT_LT(last, 1.001);
}

TEST(Springs, AChainComesToRestInItsPose) {
  int cases = 0;
  for (const double ratio : {0.2, 0.5, 1.0}) {
    Rod rod(8, spring(2, ratio), 0.1);
    ASSERT_EQ(rod.step(0), Status::ok);
    test::Random random(3);
    for (std::size_t b = 0; b < rod.bones(); ++b)
      set_motion(rod, b, test::normalised(Vec3{1, random.between(-0.3, 0.3), random.between(-0.3, 0.3)}), {0, 0, 0});
    double most = 0;
    for (int i = 0; i < 60 * 20; ++i) {
      rod.pose();
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
      for (std::size_t b = 0; b < rod.bones(); ++b) most = std::max(most, distance(rod.direction(b), {1, 0, 0}));
    }
    for (std::size_t b = 0; b < rod.bones(); ++b, ++cases)
      EXPECT_LT(distance(rod.direction(b), {1, 0, 0}), 1e-4) << ratio << ", bone " << b;
    if (ratio >= 0.5) {
      EXPECT_LT(most, 1.0) << "no bone swings further than the ones above it";
    }
  }
  EXPECT_EQ(cases, 24);
}

// Without a spring a chain is a rope and hangs down; with one each bone hangs where spring and gravity balance.
TEST(Springs, HangsWhereTheForcesBalance) {
  const double length = 0.1, omega = kTurn * 1.5;
  for (const double frequency : {0.0, 1.5}) {
    Rod rod(5, spring(frequency, 0.7, 1), length);
    for (SpringJoint& s : rod.settings()) s.drag = 2;
    ASSERT_EQ(set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs), Status::ok);
    for (int i = 0; i < 60 * 30; ++i) {
      rod.pose();
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    }
    Vec3 above{1, 0, 0};
    for (std::size_t b = 0; b < rod.bones(); ++b) {
      const double pull = frequency > 0 ? omega * omega : 0;
      const Vec3 want = test::normalised(test::plus(test::times(above, pull), {0, -9.81 / length, 0}));
      EXPECT_LT(distance(rod.direction(b), want), 2e-4) << frequency << " Hz, bone " << b;
      above = rod.direction(b);  // the animated direction goes on straight
    }
  }
}

// A bone held out level against 98.1 / s² of gravity. Where the spring yields, the sine of the angle to the plumb line
// is its limit over that.
TEST(Springs, YieldsToWhatIsMoreThanItMayPull) {
  const double length = 0.1, field = 9.81 / length, omega = kTurn * 1.5;
  for (const int most : {20, 50, 80}) {
    SpringJoint settings = spring(1.5, 0.7, 1);
    settings.most_pull = static_cast<std::uint16_t>(most);
    Rod rod(1, settings, length);
    for (int i = 0; i < 60 * 30; ++i) {
      rod.pose();
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    }
    // At 80 it does not yield: the balance is at 88.8 to 98.1, where it pulls by 65.8.
    const double sine = most == 80 ? omega * omega / std::hypot(omega * omega, field) : most / field;
    EXPECT_LT(distance(rod.direction(0), {sine, -std::sqrt(1 - sine * sine), 0}), 2e-4) << most;
  }
}

// A ride that asks the spring for up to three times what it may.
TEST(Springs, RidesAlongWithALimitLikeThePendulum) {
  for (const int most : {10, 30}) {
    for (const int hz : {30, 60, 240}) {
      const Ride ride{1.5, 0.5};
      Rod rod = ride.rod();
      rod.settings()[0].most_pull = static_cast<std::uint16_t>(most);
      ASSERT_EQ(set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs), Status::ok);
      Pendulum limited = ride.pendulum(), free = limited;
      limited.most_pull = most;
      const double dt = 1.0 / hz;
      double t = 0, worst = 0, swing = 0, apart = 0;
      const auto step = [&] {
        ride.pose(rod, t += dt);
        ASSERT_EQ(rod.step(static_cast<float>(dt)), Status::ok);
      };
      while (t < 0.25) step();
      limited.d = free.d = rod.direction(0);
      limited.u = free.u = velocity(rod, 0);
      while (t < 3) {
        const double before = t;
        step();
        limited.advance(before, dt);
        free.advance(before, dt);
        worst = std::max(worst, distance(rod.direction(0), limited.d));
        swing = std::max(swing, distance(limited.d, limited.animated(t)));
        apart = std::max(apart, distance(limited.d, free.d));
      }
      EXPECT_LT(worst, 0.02 * swing) << most << " at " << hz << " Hz";
      EXPECT_GT(apart, 0.2) << "the limit matters";
    }
  }
}

TEST(Springs, WindBendsAndStillAirBrakes) {
  SpringJoint s = spring(1, 1);
  s.drag = 4;
  Rod rod(1, s);
  rod.frame.wind[1] = 3;
  for (int i = 0; i < 600; ++i) {
    rod.pose();
    ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
  }
  EXPECT_NEAR(rod.direction(0)[1] / rod.direction(0)[0], 4 * 3 / rod.length_m() / (kTurn * kTurn), 1e-4);
  // The same by moving the other way through still air.
  Rod moving(1, s);
  for (int i = 0; i < 600; ++i) {
    moving.pose({0, -3.0 * i / 60, 0});
    ASSERT_EQ(moving.step(1.0f / 60), Status::ok);
  }
  EXPECT_LT(distance(moving.direction(0), rod.direction(0)), 1e-3);
}

// A character carried through the world by its matrix, or by its pose: the same.
TEST(Springs, TheWorldAndThePoseMoveAlike) {
  const Ride ride{2, 0.3};
  Rod posed = ride.rod(), carried = ride.rod();
  int cases = 0;
  for (int i = 0; i <= 120; ++i) {
    const double t = i / 60.0;
    ride.pose(posed, t);
    ASSERT_EQ(posed.step(1.0f / 60), Status::ok);
    carried.frame.world_from_model = posed.scene[0];
    carried.pose();
    ASSERT_EQ(carried.step(1.0f / 60), Status::ok);
    const test::Map world = test::to_map(carried.frame.world_from_model);
    EXPECT_LT(distance(test::direction(world, carried.direction(0)), posed.direction(0)), 2e-5) << i;
    ++cases;
  }
  EXPECT_EQ(cases, 121);
}

}  // namespace
}  // namespace marrow
