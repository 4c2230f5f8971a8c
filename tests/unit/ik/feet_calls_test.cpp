// What calls of feet do with anything: finite results, no allocation, nothing written where they are bad, and the same
// bits everywhere.

#include "support/allocations.h"
#include "support/bad_numbers.h"
#include "unit/ik/feet_support.h"

namespace marrow {
namespace {

using test::kInfinity;
using test::kNan;
using test::same;
using test::Walker;

TEST(Feet, StayFiniteOnAnything) {
  int cases = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    test::Poses p(seed, 40, 2);
    test::Random random(seed);
    Foot foot;
    std::uint32_t line[64] = {39}, count = 1;
    while (line[count - 1] >= p.skeleton.root_count) line[count] = p.skeleton.parents[line[count - 1]], ++count;
    if (count < 3) continue;
    foot.ankle = line[0], foot.knee = line[1], foot.hip = line[count - 1];
    foot.sole[1] = -0.5f;
    Feet feet;
    feet.feet = {&foot, 1};
    feet.pelvis = seed % 2 == 0 ? foot.hip : kNoJoint;
    FootGround ground;
    FootMotion motion = {};
    FeetFrame frame;
    std::vector<Affine> scene(40);
    for (int i = 0; i < 30; ++i, ++cases) {
      p.out = p.pose[static_cast<std::size_t>(i / 4 % 2)];
      if (seed % 5 == 0) p.out[0].scale[1][0] = 0;
      ASSERT_EQ(local_to_model(p.skeleton, p.out, scene), Status::ok);
      ground.hit = random.below(3) > 0;
      ground.planted = random.below(3) > 0;
      for (int k = 0; k < 3; ++k) {
        ground.point[k] = static_cast<float>(random.between(-5, 5));
        ground.normal[k] = random.below(4) == 0 ? 0.0f : static_cast<float>(random.between(-1, 1));
      }
      frame.dt_s = static_cast<float>(random.between(0, 0.3));
      ASSERT_EQ(place_feet({p.skeleton, p.out, scene}, feet, frame, {&ground, 1}, {&motion, 1}), Status::ok) << seed;
      for (std::size_t j = 0; j < 40; ++j) {
        const test::TestJoint t = test::joint_of(p.out.data(), j);
        double squared = 0;
        for (const double x : t.rotation) squared += x * x;
        ASSERT_NEAR(squared, 1, 1e-5) << seed;
        ASSERT_TRUE(std::isfinite(scene[j].rows[0][3] + scene[j].rows[2][1]));
      }
    }
  }
  EXPECT_GT(cases, 1500);
}

TEST(Feet, BadCallsWriteNothing) {
  Walker w;
  w.settle();
  w.pose();
  const std::vector<SoaTransform> local = w.local;
  const std::vector<Affine> scene = w.scene;
  const std::array<FootMotion, 2> motion = w.motion;
  int refused = 0;
  const auto refuses = [&](auto change) {
    const Feet feet = w.feet;
    const FeetFrame frame = w.frame;
    const Foot leg = w.legs[1];
    const FootGround ground = w.ground[1];
    change();
    EXPECT_EQ(place_feet({w.skeleton, w.local, w.scene}, w.feet, w.frame, w.ground, w.motion), Status::bad_argument)
        << refused;
    EXPECT_EQ(std::memcmp(motion.data(), w.motion.data(), sizeof motion), 0) << refused;
    EXPECT_TRUE(same(local, w.local));
    w.feet = feet;
    w.frame = frame;
    w.legs[1] = leg;
    w.ground[1] = ground;
    w.scene = scene;
    ++refused;
  };
  for (const float bad : {kNan, kInfinity, -kInfinity, -1.0f}) {
    refuses([&] { w.frame.dt_s = bad; });
    refuses([&] { w.frame.weight = bad; });
    refuses([&] { w.feet.lower_m = bad; });
    refuses([&] { w.feet.leg_extension = bad; });
    refuses([&] { w.feet.slope_rad = bad; });
    refuses([&] { w.feet.ease_s = bad; });
    refuses([&] { w.legs[1].weight = bad; });
    refuses([&] { w.frame.world_from_model.rows[0][0] = bad; });  // -1: mirrored
    if (bad == -1.0f) continue;
    refuses([&] { w.frame.up[2] = bad; });
    refuses([&] { w.legs[1].sole[0] = bad; });
    refuses([&] { w.legs[1].bend_axis[0] = bad; });
    refuses([&] { w.ground[1].point[0] = bad; });
    refuses([&] { w.ground[1].normal[0] = bad; });
    refuses([&] { w.scene[8].rows[0][3] = bad; });
    refuses([&] { w.scene[3].rows[1][1] = bad; });
    refuses([&] { w.scene[1].rows[1][3] = bad; });
  }
  refuses([&] { w.frame.up[1] = 2; });
  refuses([&] { w.frame.weight = 2; });
  refuses([&] { w.feet.leg_extension = 2; });
  refuses([&] { w.feet.ease_s = 0; });
  refuses([&] { w.legs[1].ankle = 11; });
  refuses([&] { w.legs[1].knee = 5; });
  refuses([&] { w.legs[1].hip = w.legs[1].knee; });
  refuses([&] { w.feet.pelvis = 2; });
  refuses([&] { w.feet.pelvis = 11; });
  // Of the skeleton's 11 joints none is called so; a look at its parent would be far outside.
  for (const std::uint32_t far : {11u, 100u, 0xF0000000u, 0xFFFFFFFFu}) {
    refuses([&] { w.legs[1].hip = far; });
    refuses([&] { w.legs[1].knee = far; });
    refuses([&] { w.legs[1].ankle = far; });
    refuses([&] { w.legs[1] = {.hip = far, .knee = far, .ankle = far}; });
    refuses([&] { w.feet.pelvis = far; });
  }
  EXPECT_EQ(refused, 4 * 8 + 3 * 8 + 9 + 4 * 5);
  EXPECT_EQ(place_feet({w.skeleton, w.local, w.scene}, w.feet, w.frame, {w.ground.data(), 1}, w.motion),
            Status::bad_argument);
  EXPECT_EQ(place_feet({w.skeleton, w.local, w.scene}, w.feet, w.frame, w.ground, {w.motion.data(), 1}),
            Status::bad_argument);
  EXPECT_EQ(place_feet({w.skeleton, {w.local.data(), 1}, w.scene}, w.feet, w.frame, w.ground, w.motion),
            Status::bad_argument);
  EXPECT_EQ(place_feet({w.skeleton, w.local, {w.scene.data(), 10}}, w.feet, w.frame, w.ground, w.motion),
            Status::bad_argument);
  float sole[3];
  EXPECT_EQ(foot_sole(w.legs[0], w.frame.world_from_model, {w.scene.data(), 7}, sole), Status::bad_argument);
}

TEST(Feet, AllocateNothing) {
  Walker w;
  w.floor(0, 0.1);
  int failures = 0;
  const std::size_t before = test::allocation_count();
  for (int i = 0; i < 1000; ++i) {
    w.ground[0].planted = i % 30 < 15;
    w.frame.dt_s = 1.0f / 60;
    failures += place_feet({w.skeleton, w.local, w.scene}, w.feet, w.frame, w.ground, w.motion) != Status::ok;
  }
  EXPECT_EQ(test::allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
}

// The same bits on every processor, with SIMD or without.
TEST(Feet, SameBitsEverywhere) {
  Walker w;
  test::Random random(78);
  std::uint64_t state = test::kHashStart;
  for (int i = 0; i < 200; ++i) {
    w.frame.world_from_model.rows[2][3] = static_cast<float>(random.between(0, 0.0625)) + 0.01f * static_cast<float>(i);
    w.pose();
    for (FootGround& g : w.ground) {
      g.hit = true;
      g.planted = random.below(10) < 7;
      g.point[1] = i / 20 % 2 == 0 ? 0.0f : 0.125f;
      g.normal[0] = static_cast<float>(random.between(-0.5, 0.5));
    }
    ASSERT_EQ(w.step(static_cast<float>(random.between(0, 0.04))), Status::ok);
    state = test::hash(state, w.local.data(), w.local.size() * sizeof(SoaTransform));
    state = test::hash(state, w.scene.data(), w.scene.size() * sizeof(Affine));
  }
  EXPECT_EQ(state, 0xe2a77774ad5d8435u) << std::hex << state;
}

TEST(FootOf, TakesALegByItsRoles) {
  const JointRole roles[] = {{1, Role::left_upper_leg, 0},  {2, Role::left_lower_leg, 0},  {3, Role::left_foot, 0},
                             {5, Role::right_upper_arm, 0}, {6, Role::right_lower_arm, 0}, {9, Role::right_hand, 0}};
  const JointSole soles[] = {{3, 0, {0.25f, -0.5f, 1}}, {9, 0, {0, -1, 0}}};
  Foot foot;
  foot.weight = 0.5f;
  foot.bend_axis[0] = 1;
  ASSERT_EQ(foot_of({roles, {}, soles}, Role::left_foot, foot), Status::ok);
  EXPECT_EQ(foot.hip, 1u);
  EXPECT_EQ(foot.knee, 2u);
  EXPECT_EQ(foot.ankle, 3u);
  EXPECT_EQ(foot.sole[0], 0.25f);
  EXPECT_EQ(foot.sole[1], -0.5f);
  EXPECT_EQ(foot.sole[2], 1.0f);
  EXPECT_EQ(foot.weight, 0.5f);
  EXPECT_EQ(foot.bend_axis[0], 1.0f);
  ASSERT_EQ(foot_of({roles, {}, soles}, Role::right_hand, foot), Status::ok);
  EXPECT_EQ(foot.hip, 5u);
  EXPECT_EQ(foot.knee, 6u);
  EXPECT_EQ(foot.ankle, 9u);
  EXPECT_EQ(foot.sole[1], -1.0f);
}

TEST(FootOf, RefusesWhatIsNoLeg) {
  const JointRole roles[] = {{1, Role::left_upper_leg, 0}, {2, Role::left_lower_leg, 0}, {3, Role::left_foot, 0}};
  const JointSole soles[] = {{3, 0, {0, 0, 0}}};
  Foot foot;
  foot.hip = 77;
  for (const Role role : {Role::none, Role::head, Role::left_toes, Role::right_lower_arm, Role::tail})
    EXPECT_EQ(foot_of({roles, {}, soles}, role, foot), Status::bad_argument);
  EXPECT_EQ(foot_of({roles, {}, soles}, Role::right_foot, foot), Status::mismatch);
  EXPECT_EQ(foot_of({roles, {}, {}}, Role::left_foot, foot), Status::mismatch);
  EXPECT_EQ(foot_of({Span<const JointRole>(roles + 1, 2), {}, soles}, Role::left_foot, foot), Status::mismatch);
  EXPECT_EQ(foot.hip, 77u);
}

}  // namespace
}  // namespace marrow
