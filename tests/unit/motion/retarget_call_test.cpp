// A pose of another rig on a skeleton: against the words of pose_map.h in double precision, on maps of noise, and what
// is refused.
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/pose_map.h"
#include "support/bad_numbers.h"
#include "support/call_errors.h"
#include "support/rig.h"
#include "unit/motion/any_bits.h"

namespace marrow {
namespace {

using test::Random;

struct RealQuat {
  double x, y, z, w;
};
RealQuat product(const RealQuat& a, const RealQuat& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
          a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
double scalar_product(const RealQuat& a, const RealQuat& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
RealQuat real_quat(const float (&q)[4]) {
  return {double{q[0]}, double{q[1]}, double{q[2]}, double{q[3]}};
}

// A rig, a skeleton of 4 … 40 joints, and a map: turns of one joint or of several, by up to four steps each way.
struct NoiseMap {
  explicit NoiseMap(std::uint64_t seed) : random(seed) {
    const std::uint32_t rig_joints = 3 + random.below(40), joints = 4 + random.below(37);
    rig = pose_of(rig_joints, true);
    const std::vector<SoaTransform> rest = pose_of(joints, false);
    std::vector<test::TestJoint> bones(joints);
    for (std::uint32_t j = 0; j < joints; ++j) {
      bones[j] = test::joint_of(rest.data(), j);
      bones[j].parent = j == 0 ? -1 : static_cast<int>((j - 1) / 2);
    }
    skeleton = std::make_unique<test::TestSkeleton>(bones);
    add_groups(joints, rig_joints);
    for (std::uint32_t j = 0; j < joints; ++j)
      if (random.below(4) == 0) add_turns(j, rig_joints);
    for (std::uint32_t j = 0; j < joints; j += 1 + random.below(8)) add_place(j, rig_joints);
    map.rig_joint_count = rig_joints;
    map.groups = groups;
    map.turns = turns;
    map.places = places;
    map.steps = steps;
    out.resize(soa_count(joints));
  }
  std::vector<SoaTransform> pose_of(std::uint32_t joints, bool scaled) {
    std::vector<SoaTransform> pose(soa_count(joints));
    for (std::size_t j = 0; j < 4 * pose.size(); ++j) {
      SoaTransform& four = pose[j / 4];
      const auto q = random.rotation();
      for (std::size_t c = 0; c < 4; ++c) four.rotation[c][j % 4] = static_cast<float>(q[c]);
      for (int c = 0; c < 3; ++c) {
        four.translation[c][j % 4] = static_cast<float>(random.between(-1, 1));
        four.scale[c][j % 4] = scaled ? static_cast<float>(random.between(-1.5, 1.5)) : 1.0f;
      }
    }
    return pose;
  }
  void unit(float (&to)[4]) {
    const auto q = random.rotation();
    for (std::size_t c = 0; c < 4; ++c) to[c] = static_cast<float>(q[c]);
  }
  RigStep step(std::uint32_t rig_joints) {
    return {static_cast<std::uint16_t>(random.below(rig_joints)), static_cast<std::uint8_t>(random.below(2)),
            static_cast<std::uint8_t>(random.below(2))};
  }
  void add_groups(std::uint32_t joints, std::uint32_t rig_joints) {
    groups.resize(soa_count(joints));
    for (std::size_t j = 0; j < 4 * groups.size(); ++j) {
      MappedGroup& group = groups[j / 4];
      float before[4], after[4];
      unit(before);
      unit(after);
      for (int c = 0; c < 4; ++c) {
        group.before[c][j % 4] = before[c];
        group.after[c][j % 4] = after[c];
      }
      group.rig_joints[j % 4] = random.below(8) == 0 ? kNoJoint : static_cast<std::uint16_t>(random.below(rig_joints));
    }
  }
  void add_turns(std::uint32_t joint, std::uint32_t rig_joints) {
    const std::uint32_t count = random.below(3) == 0 ? 1 + random.below(3) : 1;
    for (std::uint32_t i = 0; i < count; ++i) {
      MappedTurn turn;
      turn.joint = static_cast<std::uint16_t>(joint);
      turn.weight = count == 1 ? 1 : static_cast<float>(random.between(0.1, 0.9));
      turn.step_count = static_cast<std::uint16_t>(random.below(5));
      unit(turn.before);
      unit(turn.after);
      for (int s = 0; s < turn.step_count; ++s) steps.push_back(step(rig_joints));
      turns.push_back(turn);
    }
  }
  // Its steps are the last of all.
  void add_place(std::uint32_t joint, std::uint32_t rig_joints) {
    MappedPlace place;
    place.joint = static_cast<std::uint16_t>(joint);
    place.step_count = static_cast<std::uint16_t>(1 + random.below(4));
    for (auto& row : place.parent_from_rig)
      for (float& x : row) x = static_cast<float>(random.between(-1, 1));
    for (int s = 0; s < place.step_count; ++s) steps.push_back({step(rig_joints).joint, 0, 0});
    places.push_back(place);
  }
  Status put() { return retarget_pose(map, rig, skeleton->view(), out); }

  Random random;
  std::vector<SoaTransform> rig, out;
  std::unique_ptr<test::TestSkeleton> skeleton;
  std::vector<MappedGroup> groups;
  std::vector<MappedTurn> turns;
  std::vector<MappedPlace> places;
  std::vector<RigStep> steps;
  PoseMap map;
};

RealQuat rig_rotation(const std::vector<SoaTransform>& rig, const RigStep& step) {
  const auto& r = rig[step.joint / 4u].rotation;
  const std::size_t lane = step.joint % 4u;
  RealQuat q{double{r[0][lane]}, double{r[1][lane]}, double{r[2][lane]}, double{r[3][lane]}};
  if (step.inverse != 0) q = {-q.x, -q.y, -q.z, q.w};
  if (step.mirrored != 0) q = {q.x, -q.y, -q.z, q.w};
  return q;
}

// Of length 1, at its best sign.
double rotation_apart(const RealQuat& expected, const NoiseMap& of, std::uint32_t joint) {
  const RealQuat got = rig_rotation(of.out, {static_cast<std::uint16_t>(joint), 0, 0});
  const double length = std::sqrt(scalar_product(expected, expected));
  const double s = (scalar_product(expected, got) < 0 ? -1 : 1) / length;
  const RealQuat off{s * expected.x - got.x, s * expected.y - got.y, s * expected.z - got.z, s * expected.w - got.w};
  return std::sqrt(scalar_product(off, off));
}

// How far the rotations of an output are from the words of the header.
double turns_apart(const NoiseMap& of) {
  std::vector<RealQuat> expected;
  for (std::size_t j = 0; j < of.skeleton->joints.size(); ++j) {
    const MappedGroup& g = of.groups[j / 4];
    const auto in = [&](const float(&q)[4][4]) {
      return RealQuat{double{q[0][j % 4]}, double{q[1][j % 4]}, double{q[2][j % 4]}, double{q[3][j % 4]}};
    };
    const std::uint16_t from = g.rig_joints[j % 4];
    const RealQuat r = from == kNoJoint ? RealQuat{0, 0, 0, 1} : rig_rotation(of.rig, {from, 0, 0});
    expected.push_back(product(product(in(g.before), r), in(g.after)));
  }
  std::size_t step = 0;
  for (std::size_t t = 0; t < of.turns.size();) {
    RealQuat sum{0, 0, 0, 0};
    const std::uint32_t joint = of.turns[t].joint;
    for (; t < of.turns.size() && of.turns[t].joint == joint; ++t) {
      RealQuat q = real_quat(of.turns[t].before);
      for (int s = 0; s < of.turns[t].step_count; ++s) q = product(q, rig_rotation(of.rig, of.steps[step++]));
      q = product(q, real_quat(of.turns[t].after));
      const double weight = double{of.turns[t].weight} * (scalar_product(q, sum) < 0 ? -1 : 1);
      sum = {sum.x + weight * q.x, sum.y + weight * q.y, sum.z + weight * q.z, sum.w + weight * q.w};
    }
    expected[joint] = sum;
  }
  double worst = 0;
  for (std::uint32_t j = 0; j < expected.size(); ++j) worst = std::fmax(worst, rotation_apart(expected[j], of, j));
  return worst;
}

// By matrices: out = parent_from_rig · Π parent_from_joint · origin.
double places_apart(const NoiseMap& of) {
  double worst = 0;
  std::size_t step = of.steps.size();
  for (const MappedPlace& place : of.places) step -= place.step_count;
  for (const MappedPlace& place : of.places) {
    test::Map all;
    for (int s = 0; s < place.step_count; ++s) {
      const test::TestJoint joint = test::joint_of(of.rig.data(), of.steps[step++].joint);
      all = all * test::from_trs(joint.translation, joint.rotation, joint.scale);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const float(&row)[4] = place.parent_from_rig[axis];
      double expected = double{row[3]};
      for (int c = 0; c < 3; ++c) expected += double{row[c]} * all.rows[c][3];
      const float got = of.out[place.joint / 4u].translation[axis][place.joint % 4u];
      worst = std::fmax(worst, std::fabs(expected - double{got}));
    }
  }
  return worst;
}

TEST(RetargetPose, IsWhatTheHeaderSays) {
  double turns = 0, places = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    NoiseMap of(seed);
    ASSERT_EQ(of.put(), Status::ok);
    turns = std::fmax(turns, turns_apart(of));
    places = std::fmax(places, places_apart(of));
    std::vector<SoaTransform> rest = of.skeleton->rest;
    for (std::size_t g = 0; g < rest.size(); ++g)
      std::memcpy(rest[g].rotation, of.out[g].rotation, sizeof rest[g].rotation);
    for (const MappedPlace& p : of.places)
      for (int c = 0; c < 3; ++c)
        rest[p.joint / 4u].translation[c][p.joint % 4u] = of.out[p.joint / 4u].translation[c][p.joint % 4u];
    EXPECT_EQ(std::memcmp(rest.data(), of.out.data(), rest.size() * sizeof(SoaTransform)), 0) << "all else rests";
  }
  EXPECT_LE(turns, 3e-6);
  EXPECT_LE(places, 2e-5);
}

TEST(RetargetPose, WhatIsWrongIsRefusedAndNothingWritten) {
  const test::CallErrors errors;
  const NoiseMap good(7);
  const auto expect_refused = [&](const auto& spoil) {
    NoiseMap of(7);
    spoil(of);
    const std::vector<SoaTransform> before = of.out;
    EXPECT_EQ(of.put(), Status::bad_argument);
    EXPECT_EQ(std::memcmp(before.data(), of.out.data(), before.size() * sizeof(SoaTransform)), 0);
  };
  expect_refused([](NoiseMap& of) { of.map.rig_joint_count += 8; });
  expect_refused([](NoiseMap& of) { of.map.rig_joint_count = 1; });
  expect_refused([](NoiseMap& of) { of.map.groups = {of.groups.data(), of.groups.size() - 1}; });
  expect_refused([](NoiseMap& of) { of.map.groups = {nullptr, of.groups.size()}; });
  expect_refused([](NoiseMap& of) { of.map.turns = {nullptr, 1}; });
  expect_refused([](NoiseMap& of) { of.map.places = {nullptr, 1}; });
  expect_refused([](NoiseMap& of) { of.map.steps = {nullptr, of.steps.size()}; });
  expect_refused([](NoiseMap& of) { of.map.steps = {of.steps.data(), of.steps.size() - 1}; });
  expect_refused([](NoiseMap& of) { of.turns.back().joint = 1000; });
  expect_refused([](NoiseMap& of) { ++of.turns[0].step_count; });
  expect_refused([](NoiseMap& of) { of.places.back().joint = 1000; });
  expect_refused([](NoiseMap& of) { of.places[0].step_count = 0; });
  expect_refused([](NoiseMap& of) { of.steps[0].joint = 0xFFFF; });
  expect_refused([](NoiseMap& of) { of.rig[0].rotation[2][1] = test::kNan; });
  expect_refused([](NoiseMap& of) { of.rig[0].rotation[2][1] = test::kInfinity; });
  expect_refused([](NoiseMap& of) {
    for (auto& row : of.rig[0].rotation) row[0] = 0;
  });
  expect_refused([](NoiseMap& of) {
    for (auto& row : of.rig[0].rotation) row[0] = 1.1f;
  });
  ASSERT_GT(good.places.size(), 1u);
}

// A joint whose place would be none rests, and others go on.
TEST(RetargetPose, WhatHasNoPlaceRests) {
  for (const float bad : {test::kNan, test::kInfinity, 2e12f}) {
    NoiseMap of(7), good(7);
    of.places[0].parent_from_rig[1][3] = bad;
    ASSERT_EQ(of.put(), Status::ok);
    ASSERT_EQ(good.put(), Status::ok);
    const auto place = [](const std::vector<SoaTransform>& pose, std::uint16_t joint, int axis) {
      return pose[joint / 4u].translation[axis][joint % 4u];
    };
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(place(of.out, of.places[0].joint, axis), place(of.skeleton->rest, of.places[0].joint, axis));
      EXPECT_EQ(place(of.out, of.places[1].joint, axis), place(good.out, of.places[1].joint, axis));
    }
  }
}

// Whatever the numbers of a map and a pose are, what comes out is finite.
TEST(RetargetPose, OfAnyNumbersIsFinite) {
  const test::CallErrors errors;
  Random random(3);
  int ok = 0;
  for (std::uint64_t round = 0; round < 3000; ++round) {
    NoiseMap of(round);
    const auto spoil = [&](float& x) {
      if (random.below(40) == 0) x = test::any_float(random, 1, 1);
    };
    for (MappedGroup& g : of.groups)
      for (int i = 0; i < 16; ++i) {
        spoil(g.before[i / 4][i % 4]);
        spoil(g.after[i / 4][i % 4]);
        if (random.below(40) == 0) g.rig_joints[i % 4] = static_cast<std::uint16_t>(random.bits());
      }
    for (MappedTurn& t : of.turns) {
      spoil(t.weight);
      for (float& x : t.before) spoil(x);
      for (float& x : t.after) spoil(x);
    }
    if (random.below(2) == 0)
      for (SoaTransform& four : of.rig)
        for (auto& row : four.scale)
          for (float& x : row) spoil(x);
    if (of.put() != Status::ok) continue;
    ++ok;
    for (const SoaTransform& four : of.out)
      for (int lane = 0; lane < 4; ++lane) {
        double squared = 0;
        for (const auto& row : four.rotation) squared += double{row[lane]} * double{row[lane]};
        ASSERT_NEAR(squared, 1, 1e-5) << round;
        for (const auto& row : four.translation) ASSERT_TRUE(std::fabs(row[lane]) <= 1e12f) << round;
      }
  }
  EXPECT_GT(ok, 1000);
}

}  // namespace
}  // namespace marrow
