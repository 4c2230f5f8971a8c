// Several goals at once: places and rotations, priorities, the whole body; and how solve_ik() is called.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>

#include "marrow/limits.h"
#include "support/pose_file.h"
#include "unit/ik/posed.h"

namespace marrow {
namespace {

using test::PosedSkeleton;
using test::Quat;
using test::RandomChain;
using test::Vec3;

constexpr IkMethod kBoth[] = {IkMethod::damped_least_squares, IkMethod::gauss_newton};
constexpr std::uint16_t kPelvis = 0, kHead = 9, kLeftFoot = 14, kRightFoot = 15, kLeftHand = 18, kRightHand = 19;

// A person of 1.8 m, metres: joint, parent, place.
test::TestSkeleton person() {
  struct Row {
    int parent;
    Vec3 scene;
  };
  const Row rows[] = {{-1, {0, 1, 0}},            // pelvis
                      {0, {0, 1.12, 0}},          // spine, and two more
                      {0, {0.1, 0.95, 0}},        // left hip
                      {0, {-0.1, 0.95, 0}},       // right hip
                      {1, {0, 1.25, -0.01}},      //
                      {2, {0.1, 0.52, 0.02}},     // left knee
                      {3, {-0.1, 0.52, 0.02}},    // right knee
                      {4, {0, 1.4, -0.02}},       // chest
                      {7, {0, 1.55, -0.02}},      // neck
                      {8, {0, 1.68, 0}},          // head
                      {7, {0.05, 1.5, 0}},        // left collar bone
                      {7, {-0.05, 1.5, 0}},       // right collar bone
                      {10, {0.2, 1.48, 0}},       // left shoulder
                      {11, {-0.2, 1.48, 0}},      // right shoulder
                      {5, {0.1, 0.1, 0}},         // left foot
                      {6, {-0.1, 0.1, 0}},        // right foot
                      {12, {0.45, 1.4, -0.05}},   // left elbow
                      {13, {-0.45, 1.4, -0.05}},  // right elbow
                      {16, {0.65, 1.35, 0.05}},   // left hand
                      {17, {-0.65, 1.35, 0.05}}};
  std::vector<test::TestJoint> joints;
  for (const Row& row : rows) {
    test::TestJoint j;
    j.parent = row.parent;
    j.translation = row.parent < 0 ? row.scene : test::minus(row.scene, rows[row.parent].scene);
    joints.push_back(j);
  }
  return test::TestSkeleton(joints);
}

std::vector<std::uint16_t> all_joints(const test::TestSkeleton& rig) {
  return test::first_joints(static_cast<int>(rig.joints.size()));
}

Quat scene_rotation(const PosedSkeleton& p, std::uint16_t joint) {
  Quat q = {0, 0, 0, 1};
  for (int j = joint; j >= 0; j = p.rig.joints[static_cast<std::size_t>(j)].parent)
    q = test::product(test::normalised(test::joint_of(p.local.data(), static_cast<std::size_t>(j)).rotation), q);
  return q;
}

double angle(const Quat& a, const Quat& b) {
  const Quat d = test::product({-a[0], -a[1], -a[2], a[3]}, b);
  return 2 * std::atan2(test::length({d[0], d[1], d[2]}), std::fabs(d[3]));
}

TEST(IkGoals, APlaceAndARotationAtOnce) {
  for (const IkMethod method : kBoth) {
    test::Random random(21);
    int reached = 0, cases = 0;
    for (int i = 0; i < 1000; ++i, ++cases) {
      const RandomChain chain(random, 4 + i % 9);
      PosedSkeleton p(chain.skeleton, method);
      PosedSkeleton wanted(chain.skeleton, method);
      for (const std::uint16_t j : chain.joints) {
        const Quat q = test::product(chain.skeleton.joints[j].rotation, test::random_turn(random, 1.5));
        for (std::size_t c = 0; c < 4; ++c) wanted.local[j / 4].rotation[c][j % 4] = static_cast<float>(q[c]);
      }
      const Quat rotation = scene_rotation(wanted, chain.tip);
      IkGoal& goal = p.add_goal(chain.tip, test::origin_of(wanted.maps()[chain.tip]));
      for (std::size_t c = 0; c < 4; ++c) goal.rotation[c] = static_cast<float>(rotation[c]);
      goal.rotation_weight = 1;
      p.joints = chain.joints;
      p.options.max_iterations = 64;
      p.options.tolerance_m = static_cast<float>(1e-3 * chain.length_m);
      const IkReport report = p.solve();
      const double place = p.distance(0), turn = angle(scene_rotation(p, chain.tip), rotation);
      EXPECT_NEAR(std::hypot(place, turn), static_cast<double>(report.error_m), 1e-5 * chain.length_m);
      reached += std::hypot(place, turn) <= 1.001e-3 * chain.length_m ? 1 : 0;
    }
    std::printf("place and rotation: %d of %d\n", reached, cases);
    EXPECT_EQ(cases, 1000);
    EXPECT_GE(reached, 990);
  }
}

TEST(IkGoals, LessUrgentOnesDoNotDisturb) {
  for (const IkMethod method : kBoth) {
    // One joint cannot be in two places; its neighbour can still come nearer.
    const test::TestSkeleton rig = test::bent_chain(8, 0.25, 0.15);
    PosedSkeleton p(rig, method);
    p.joints = test::first_joints(8);
    p.options.max_iterations = 64;
    p.add_goal(8, {0.5, 1.2, 0});
    p.add_goal(8, {-0.5, 1.2, 0}).priority = 3;
    p.solve();
    EXPECT_LE(p.distance(0), 1e-3);
    EXPECT_NEAR(p.distance(1), 1, 2e-3);
    p.goals[1].joint = 4;
    p.rest();
    p.solve();
    EXPECT_LE(p.distance(0), 1e-3);
    EXPECT_NEAR(p.distance(1), 0.3, 2e-3);  // 1.3 m away, and four bones make 1 m
    // The same two as equals meet half way; of twice the weight, the error is a quarter.
    p.goals[1].joint = 8;
    p.goals[1].priority = 0;
    p.rest();
    p.solve();
    EXPECT_NEAR(p.distance(0), p.distance(1), 2e-2);
    p.goals[0].position_weight = 2;
    p.rest();
    p.solve();
    EXPECT_NEAR(4 * p.distance(0), p.distance(1), 4e-2);
  }
}

TEST(IkGoals, TheWholeBodyFollowsHandsFeetAndHead) {
  const test::TestSkeleton rig = person();
  const std::uint16_t ends[] = {kLeftHand, kRightHand, kLeftFoot, kRightFoot, kHead};
  for (const IkMethod method : kBoth) {
    test::Random random(22);
    double iterations = 0, worst = 0;
    int cases = 0;
    for (; cases < 500; ++cases) {
      PosedSkeleton wanted(rig, method), p(rig, method);
      for (std::size_t j = 0; j < rig.joints.size(); ++j) {
        const Quat q = test::random_turn(random, 0.6);
        for (std::size_t c = 0; c < 4; ++c) wanted.local[j / 4].rotation[c][j % 4] = static_cast<float>(q[c]);
      }
      for (std::size_t c = 0; c < 3; ++c)
        wanted.local[0].translation[c][0] += static_cast<float>(random.between(-0.2, 0.2));
      const std::vector<test::Map> maps = wanted.maps();
      for (const std::uint16_t end : ends) p.add_goal(end, test::origin_of(maps[end]));
      p.joints = all_joints(rig);
      p.problem.root_travel_m = 0.5f;
      p.options.tolerance_m = 1e-3f;
      iterations += p.solve().iterations;
      for (std::size_t g = 0; g < 5; ++g) worst = std::max(worst, p.distance(g));
    }
    std::printf("whole body: %.2f iterations, %.5f m off at worst\n", iterations / cases, worst);
    EXPECT_LE(worst, 1.01e-3);
    EXPECT_LE(iterations / cases, 8);
  }
}

// A hand that moves by 1 mm a frame, solved each time from the same pose, as over an animation: in and out of reach.
TEST(IkGoals, TheWholeBodyMovesSmoothly) {
  const test::TestSkeleton rig = person();
  for (const IkMethod method : kBoth) {
    PosedSkeleton p(rig, method);
    const std::vector<test::Map> maps = p.maps();
    for (const std::uint16_t end : {kLeftHand, kRightHand, kLeftFoot, kRightFoot, kHead})
      p.add_goal(end, test::origin_of(maps[end]));
    p.joints = all_joints(rig);
    p.problem.root_travel_m = 0.5f;
    p.options.max_iterations = 8;
    p.options.tolerance_m = 1e-3f;
    double worst = 0;
    std::vector<SoaTransform> before = p.local;
    for (int frame = 0; frame < 1500; ++frame) {
      p.rest();
      p.goals[0].position[0] = 0.65f - 0.001f * static_cast<float>(frame > 750 ? 1500 - frame : frame);
      p.goals[0].position[2] = 0.05f + 0.001f * static_cast<float>(frame);
      p.solve();
      worst = std::max(worst, test::largest_turn(rig, before.data(), p.local.data()));
      before = p.local;
    }
    EXPECT_LE(worst, 0.03);
  }
}

TEST(IkGoals, ThePelvisTravelsAsFarAsItIsLet) {
  const test::TestSkeleton rig = person();
  for (const IkMethod method : kBoth) {
    double travelled[3];
    int i = 0;
    for (const float ease : {0.0f, 0.1f, 1.0f}) {
      PosedSkeleton p(rig, method);
      p.add_goal(kLeftHand, {0.3, 0.6, 0.5});
      p.add_goal(kLeftFoot, {0.1, 0.1, 0});
      p.joints = all_joints(rig);
      p.problem.root_travel_m = ease;
      p.solve();
      travelled[i++] = test::length(test::minus(test::origin_of(p.maps()[kPelvis]), {0, 1, 0}));
    }
    EXPECT_EQ(travelled[0], 0);
    EXPECT_GT(travelled[1], 1e-3);
    EXPECT_GT(travelled[2], 2 * travelled[1]);
  }
}

TEST(IkGoals, StiffJointsTurnLessAndRigidOnesNot) {
  for (const IkMethod method : kBoth) {
    double turned[3];
    int i = 0;
    for (const float stiffness : {0.0f, 0.9f, 1.0f}) {
      const test::TestSkeleton rig = test::bent_chain(6, 0.25, 0.2);
      PosedSkeleton p(rig, method);
      p.add_goal(6, {0.6, 0.8, 0.3});
      p.joints = test::first_joints(6);
      p.stiffness = {0, 0, stiffness, 0, 0, 0};
      const std::vector<SoaTransform> before = p.local;
      p.solve();
      EXPECT_LE(p.distance(0), 1.01e-4);
      turned[i++] = angle(test::joint_of(before.data(), 2).rotation, test::joint_of(p.local.data(), 2).rotation);
      if (stiffness == 1) {
        for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(p.local[0].rotation[c][2], before[0].rotation[c][2]);
      }
    }
    EXPECT_LT(turned[1], 0.5 * turned[0]);
    EXPECT_LE(turned[2], 1e-7);
  }
}

TEST(IkGoals, WeightBlendsAndNoughtLeavesEveryBit) {
  for (const IkMethod method : kBoth) {
    test::Random random(23);
    int cases = 0;
    for (; cases < 50; ++cases) {
      const RandomChain chain(random, 6);
      const Vec3 target = chain.reachable(random, 0.5);
      PosedSkeleton none(chain.skeleton, method), half(chain.skeleton, method), all(chain.skeleton, method);
      const std::vector<SoaTransform> local = none.local;
      const std::vector<Affine> scene = none.scene;
      for (PosedSkeleton* p : {&none, &half, &all}) {
        p->add_goal(chain.tip, target);
        p->joints = chain.joints;
        p->options.weight = p == &none ? 0.0f : p == &half ? 0.5f : 1.0f;
        p->solve();
      }
      EXPECT_EQ(std::memcmp(none.local.data(), local.data(), local.size() * sizeof local[0]), 0);
      EXPECT_EQ(std::memcmp(none.scene.data(), scene.data(), scene.size() * sizeof scene[0]), 0);
      for (std::uint16_t j = 0; j < chain.skeleton.joints.size(); ++j) {
        const Quat from = test::joint_of(local.data(), j).rotation,
                   middle = test::joint_of(half.local.data(), j).rotation;
        const Quat to = test::joint_of(all.local.data(), j).rotation;
        EXPECT_NEAR(angle(from, middle), angle(from, to) / 2, 1e-5);
        EXPECT_NEAR(angle(middle, to), angle(from, to) / 2, 1e-5);
        if (std::find(chain.joints.begin(), chain.joints.end(), j) != chain.joints.end()) continue;
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_EQ(all.local[j / 4].rotation[c][j % 4], local[j / 4].rotation[c][j % 4]);
      }
      // The matrices are those of the pose, bit for bit.
      std::vector<Affine> anew(all.scene.size());
      ASSERT_EQ(local_to_model(all.skeleton, all.local, anew), Status::ok);
      EXPECT_EQ(std::memcmp(all.scene.data(), anew.data(), anew.size() * sizeof anew[0]), 0);
    }
    EXPECT_EQ(cases, 50);
  }
}

TEST(IkGoals, BadCallsWriteNothing) {
  const test::TestSkeleton rig = person();
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  using Spoil = void (*)(PosedSkeleton&, float);
  const Spoil spoils[] = {
      [](PosedSkeleton& p, float bad) { p.goals[0].position[1] = bad; },
      [](PosedSkeleton& p, float bad) { p.goals[0].offset[2] = bad; },
      [](PosedSkeleton& p, float bad) { p.goals[0].rotation[3] = bad; },
      [](PosedSkeleton& p, float bad) { p.goals[0].position_weight = bad; },
      [](PosedSkeleton& p, float bad) { p.goals[0].rotation_weight = bad; },
      [](PosedSkeleton& p, float bad) { p.options.tolerance_m = bad; },
      [](PosedSkeleton& p, float bad) { p.options.damping = bad; },
      [](PosedSkeleton& p, float bad) { p.options.weight = bad; },
      [](PosedSkeleton& p, float bad) { p.problem.root_travel_m = bad; },
      [](PosedSkeleton& p, float bad) { p.stiffness.assign(20, bad); },
      [](PosedSkeleton& p, float bad) { p.local[0].rotation[1][0] = bad; },
      [](PosedSkeleton& p, float bad) { p.local[0].translation[1][2] = bad; },
      [](PosedSkeleton& p, float) { p.goals[0].position_weight = -1; },
      [](PosedSkeleton& p, float) { p.goals[0].position_weight = 101; },
      [](PosedSkeleton& p, float) { p.options.weight = 1.5f; },
      [](PosedSkeleton& p, float) { p.options.method = static_cast<IkMethod>(77); },
      [](PosedSkeleton& p, float) { p.stiffness = {0.5f}; },
      [](PosedSkeleton& p, float) { p.goals[0].joint = 20; },
      [](PosedSkeleton& p, float) { p.goals.clear(); },
      [](PosedSkeleton& p, float) {
        p.options.method = IkMethod::fabrik;  // which takes little memory a goal
        p.goals.assign(kMaxJoints + 1, IkGoal(p.goals[0]));
      },
      [](PosedSkeleton& p, float) { p.joints.clear(); },
      [](PosedSkeleton& p, float) {
        p.joints = {0, 2, 2, 5};
      },
      [](PosedSkeleton& p, float) {
        p.joints = {4, 2, 1};
      },
      [](PosedSkeleton& p, float) {
        p.joints = {0, 20};
      },
      [](PosedSkeleton& p, float) { p.joints = {kHead}; },  // moves no foot
      [](PosedSkeleton& p, float) { p.local.pop_back(); },
      [](PosedSkeleton& p, float) { p.scene.pop_back(); },
      [](PosedSkeleton& p, float) { p.limits.resize(1), p.limits[0].kind = static_cast<LimitKind>(9); },
  };
  int cases = 0;
  for (const Spoil spoil : spoils) {
    for (const float bad : {nan, infinite, -infinite}) {
      PosedSkeleton p(rig, IkMethod::damped_least_squares);
      p.add_goal(kLeftFoot, {0.1, 0.4, 0.2});
      p.joints = all_joints(rig);
      spoil(p, bad);
      const std::vector<SoaTransform> local = p.local;
      const std::vector<Affine> scene = p.scene;
      EXPECT_EQ(p.try_solve(), Status::bad_argument) << "case " << cases;
      EXPECT_EQ(std::memcmp(p.local.data(), local.data(), local.size() * sizeof local[0]), 0);
      EXPECT_EQ(std::memcmp(p.scene.data(), scene.data(), scene.size() * sizeof scene[0]), 0);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 84);
  // A byte of scratch too few; and just enough, of any alignment.
  PosedSkeleton p(rig, IkMethod::gauss_newton);
  p.add_goal(kLeftFoot, {0.1, 0.4, 0.2});
  p.joints = all_joints(rig);
  p.bind();
  const std::size_t bytes = ik_scratch_bytes(p.skeleton, p.problem, p.options);
  test::AlignedBlock block(bytes + 1);
  const Span<std::byte> few = {block.data(), bytes - 1}, odd = {block.data() + 1, bytes};
  EXPECT_EQ(solve_ik(p.pose(), p.problem, p.options, few), Status::bad_argument);
  EXPECT_EQ(solve_ik(p.pose(), p.problem, p.options, odd), Status::ok);
  EXPECT_LE(p.distance(0), 1.01e-4);
}

// The example of docs/ik/solvers.md.
Status plant_and_reach(const Pose& pose, std::uint16_t foot, std::uint16_t hand, const float (&door_handle)[3],
                       Span<const std::uint16_t> joints, Span<std::byte> scratch) {
  IkGoal goals[2];
  goals[0].joint = foot;  // stays where the animation put it
  for (int i = 0; i < 3; ++i) goals[0].position[i] = pose.model_from_joint[foot].rows[i][3];
  goals[1].joint = hand;
  goals[1].priority = 1;  // reaches as far as the foot allows
  for (int i = 0; i < 3; ++i) goals[1].position[i] = door_handle[i];
  IkProblem problem;
  problem.goals = {goals, 2};
  problem.joints = joints;
  problem.root_travel_m = 0.5f;  // the pelvis gives way
  IkOptions options;
  options.max_iterations = 8;
  options.tolerance_m = 1e-3f;
  return solve_ik(pose, problem, options, scratch);
}

TEST(IkGoals, TheExampleDoesWhatItSays) {
  const test::TestSkeleton rig = person();
  PosedSkeleton p(rig, IkMethod::damped_least_squares);
  const std::vector<std::uint16_t> joints = all_joints(rig);
  std::vector<std::byte> scratch(1 << 16);
  const float handle[3] = {0.3f, 1.0f, 0.5f};
  const Vec3 foot = test::origin_of(p.maps()[kLeftFoot]);
  ASSERT_EQ(plant_and_reach(p.pose(), kLeftFoot, kLeftHand, handle, joints, scratch), Status::ok);
  EXPECT_LE(test::length(test::minus(test::origin_of(p.maps()[kLeftFoot]), foot)), 1e-3);
  EXPECT_LE(test::length(test::minus(test::origin_of(p.maps()[kLeftHand]), {0.3, 1.0, 0.5})), 1e-3);
}

// The same bits on every processor: of poses by both methods, of chains with limits and of a body with rotations.
TEST(IkGoals, TheSameBitsEverywhere) {
  std::uint64_t hash = test::kHashStart;
  for (const IkMethod method : kBoth) {
    test::Random random(24);
    for (int i = 0; i < 100; ++i) {
      const RandomChain chain(random, 4 + i % 9);
      PosedSkeleton p(chain.skeleton, method);
      p.add_goal(chain.tip, chain.reachable(random));
      p.joints = chain.joints;
      p.solve();
      hash = test::hash(hash, p.local.data(), p.local.size() * sizeof p.local[0]);
      hash = test::hash(hash, p.scene.data(), p.scene.size() * sizeof p.scene[0]);
    }
    const test::TestSkeleton rig = person();
    for (int i = 0; i < 100; ++i) {
      PosedSkeleton p(rig, method);
      for (const std::uint16_t end : {kLeftHand, kRightHand, kLeftFoot, kRightFoot, kHead}) {
        Vec3 at = test::origin_of(test::to_map(p.scene[end]));
        for (double& c : at) c += random.between(-0.2, 0.2);
        IkGoal& goal = p.add_goal(end, at);
        goal.rotation_weight = end >= kLeftHand ? 0.0f : 0.25f;
        goal.priority = end >= kLeftHand ? 1 : 0;
      }
      p.joints = all_joints(rig);
      p.problem.root_travel_m = 0.5f;
      for (std::uint16_t j = 1; j < 9; ++j) {
        LimitDescription d;
        d.kind = j == 5 || j == 6 ? LimitKind::hinge : LimitKind::cone;
        d.least_rad[0] = -0.1f, d.most_rad[0] = 1;
        if (d.kind == LimitKind::cone) d.least_rad[1] = d.least_rad[2] = -0.5f, d.most_rad[1] = d.most_rad[2] = 0.5f;
        p.limits.emplace_back();
        ASSERT_EQ(make_limit(d, j, p.limits.back()), Status::ok);
      }
      p.solve();
      hash = test::hash(hash, p.local.data(), p.local.size() * sizeof p.local[0]);
    }
  }
  EXPECT_EQ(hash, 0xA138E3ED69B80065u) << std::hex << hash;
}

}  // namespace
}  // namespace marrow
