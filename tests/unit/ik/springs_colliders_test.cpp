// Spring bones and what they touch.
#include <cmath>

#include <gtest/gtest.h>

#include "springs/spring_state.h"
#include "unit/ik/springs_support.h"

namespace marrow {
namespace {

using test::distance;
using test::Rod;
using test::soft;
using test::Vec3;

double distance_to(const SpringCollider& c, const Vec3& p) {
  Vec3 from, along;
  for (std::size_t i = 0; i < 3; ++i) {
    from[i] = static_cast<double>(c.from[i]);
    along[i] = static_cast<double>(c.to[i]) - from[i];
  }
  const double square = test::dot(along, along);
  const double t = square > 0 ? std::fmin(1, std::fmax(0, test::dot(test::minus(p, from), along) / square)) : 0;
  return distance(p, test::plus(from, along, t));
}

// A rod that falls on a ball, or on a bar, and comes to rest there. The collider is bound to joint 0, at the origin.
TEST(SpringColliders, NoEndRestsInside) {
  int cases = 0, touching = 0;
  test::Random random(5);
  for (int run = 0; run < 200; ++run) {
    SpringJoint s = soft();
    s.frequency_hz = 0.5f;
    s.damping_ratio = 1;
    s.radius_m = 0.02f;
    Rod rod(4, s, 0.15);
    std::vector<SpringCollider> colliders(1 + random.below(2));
    for (SpringCollider& c : colliders) {
      const double x = random.between(0, 0.25), z = random.between(-0.06, 0.06);
      c.radius_m = static_cast<float>(random.between(0.04, 0.1));
      const float at[3] = {static_cast<float>(x), -0.2f, static_cast<float>(z)};
      for (int i = 0; i < 3; ++i) c.from[i] = c.to[i] = at[i];
      if (run % 2 == 1) c.from[2] -= 0.3f, c.to[2] += 0.3f;
    }
    rod.frame.colliders = colliders;
    for (int i = 0; i < 60 * 8; ++i) {
      rod.pose();
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    }
    for (std::size_t b = 0; b < rod.bones(); ++b) {
      double deepest = 1;
      for (const SpringCollider& c : colliders) {
        const double clear = static_cast<double>(c.radius_m) + static_cast<double>(0.02f);
        const double out = distance_to(c, rod.end(b));
        // A bone whose joint is held too deep inside cannot get out.
        if (distance_to(c, rod.place(b + 1)) < clear - rod.length_m()) continue;
        deepest = std::min(deepest, (out - clear) / clear);
        ++cases;
      }
      EXPECT_GT(deepest, -1e-3) << run << ", bone " << b;
      touching += deepest < 1e-3;
    }
  }
  EXPECT_GT(cases, 1000);
  EXPECT_GT(touching, 150);
}

TEST(SpringColliders, EnergyDoesNotGrowOnABall) {
  SpringJoint s = soft();
  s.drag = 0;
  s.damping_ratio = 0;
  s.radius_m = 0.02f;
  int cases = 0, touches = 0;
  test::Random random(8);
  for (int run = 0; run < 60; ++run) {
    Rod rod(1, s);
    SpringCollider ball;
    ball.from[0] = ball.to[0] = 0.2f;
    ball.from[1] = ball.to[1] = static_cast<float>(random.between(-0.3, -0.1));
    ball.from[2] = ball.to[2] = static_cast<float>(random.between(-0.1, 0.1));
    rod.frame.colliders = {&ball, 1};
    ASSERT_EQ(rod.step(0), Status::ok);
    const double omega = 2 * M_PI * 1.5;
    const Vec3 field{omega * omega, static_cast<double>(-9.81f) / rod.length_m(), 0};
    double before = 1e9, first = 0;
    for (int i = 0; i < 240; ++i, ++cases) {
      rod.pose();
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
      const SpringGroup& g = *rod.springs.groups;
      const Vec3 u{static_cast<double>(g.velocity[0][0]), static_cast<double>(g.velocity[1][0]),
                   static_cast<double>(g.velocity[2][0])};
      const double now = test::dot(u, u) / 2 + test::length(field) - test::dot(field, rod.direction(0));
      EXPECT_LE(now, before + 1e-5 * test::length(field)) << run << " at " << i;
      if (i == 0) first = now;
      EXPECT_LE(now, first + 1e-5 * test::length(field)) << "over all";
      before = now;
      touches += distance_to(ball, rod.end(0)) < 1.0001 * static_cast<double>(ball.radius_m + 0.02f);
    }
  }
  EXPECT_EQ(cases, 60 * 240);
  EXPECT_GT(touches, 500);
}

TEST(SpringColliders, AreMetByTheChainsThatSaySo) {
  SpringJoint s = soft();
  s.radius_m = 0.02f;
  SpringCollider balls[2];
  balls[1].from[0] = balls[1].to[0] = 0.2f;  // in the bone's way
  balls[1].radius_m = 0.1f;
  balls[0].from[0] = balls[0].to[0] = -5;
  for (const std::uint64_t met : {0u, 1u, 2u, 3u}) {
    Rod rod(1, s);
    SpringChain chain = rod.chain();
    chain.colliders = met;
    ASSERT_EQ(set_springs(rod.skeleton, {&chain, 1}, rod.springs), Status::ok);
    rod.frame.gravity[1] = 0;
    rod.frame.colliders = balls;
    for (int i = 0; i < 60; ++i) {
      rod.pose();
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
    }
    if ((met & 2) != 0) {
      EXPECT_GT(distance_to(balls[1], rod.end(0)), 0.1199) << met;
    } else {
      EXPECT_NEAR(rod.direction(0)[0], 1, 1e-6) << met;
    }
  }
}

TEST(SpringColliders, MoveWithTheirJointAndScaleWithTheWorld) {
  SpringJoint s = soft();
  s.radius_m = 0.02f;
  Rod rod(1, s);
  SpringCollider ball;
  ball.from[0] = ball.to[0] = 0.2f;
  ball.radius_m = 0.05f;
  rod.frame.colliders = {&ball, 1};
  int cases = 0;
  for (const float scale : {1.0f, 2.0f}) {
    reset_springs(rod.springs);
    for (int i = 0; i < 3; ++i) rod.frame.world_from_model.rows[i][i] = scale;
    for (int i = 0; i < 180; ++i, ++cases) {
      ball.from[1] = ball.to[1] = static_cast<float>(0.15 - 0.001 * i);  // pushes the bone down
      rod.pose();
      ASSERT_EQ(rod.step(1.0f / 60), Status::ok);
      const double clear = static_cast<double>(0.05f * scale) + static_cast<double>(0.02f);
      EXPECT_GT(distance_to(ball, rod.end(0)) * static_cast<double>(scale), clear * (1 - 1e-3)) << i;
    }
    EXPECT_LT(rod.direction(0)[1], -0.2);
  }
  EXPECT_EQ(cases, 360);
}

}  // namespace
}  // namespace marrow
