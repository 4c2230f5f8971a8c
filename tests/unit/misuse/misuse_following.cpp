// Joint limits, what follows with limited speed, springs.
#include <cmath>

#include <gtest/gtest.h>

#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

JointLimit good_limit(LimitKind kind, std::uint16_t joint) {
  JointLimit out;
  LimitDescription d{.kind = kind, .rate = {3, 20}};
  for (int i = 0; i < 3; ++i) {
    d.least_rad[i] = -0.5f;
    d.most_rad[i] = 0.5f;
  }
  EXPECT_EQ(make_limit(d, joint, out), Status::ok);
  return out;
}

std::vector<JointLimit> good_limits() {
  return {good_limit(LimitKind::hinge, 2), good_limit(LimitKind::cone, 5), good_limit(LimitKind::euler, 10)};
}

// As many joints as those limits need.
std::vector<SoaTransform> limited_pose() {
  return {stage().pose.begin(), stage().pose.begin() + 3};
}

LimitDescription description_of(Misuse& m) {
  LimitDescription d{.kind = m.kind(LimitKind::cone), .order = m.kind(AxisOrder::zyx)};
  for (float* const v : {d.zero, d.axis, d.across}) *v = m.number(*v);
  for (int i = 0; i < 3; ++i) {
    d.least_rad[i] = m.number(-0.5f);
    d.most_rad[i] = m.number(0.5f);
  }
  d.rate = {m.number(3), m.number(20)};
  return d;
}

template <std::size_t count>
void numbers(Misuse& m, float (&values)[count], float good) {
  for (float& v : values) v = m.number(good);
}

RotationFollower turning(Misuse& m) {
  RotationFollower f;
  if (m.truth(true)) return f;
  numbers(m, f.rotation, 0.5f);
  numbers(m, f.target, 0.5f);
  numbers(m, f.velocity, 0.1f);
  f.frame_s = m.number(0.02f);
  f.mode = m.index(1);
  return f;
}

std::vector<SpringChain> chains_of(Misuse& m, std::vector<SpringJoint>& joints) {
  for (const std::uint32_t joint : {2u, 5u, 10u})
    joints.push_back({static_cast<std::uint16_t>(m.index(joint)), 0, m.number(2), m.number(0.5f), m.number(1),
                      m.number(0.5f), m.number(0.05f), m.number(1)});
  return {{m.in(joints, Length::any), {m.number(0.2f), m.number(0), m.number(0)}}};
}

// Springs in good order, in memory that stays as long as they do.
struct Swinging {
  Swinging() {
    const std::vector<SpringJoint> joints = {{2}, {5}, {10}};
    const std::vector<SpringChain> chains = {{joints, {0.2f, 0, 0}}};
    memory.resize(springs_bytes(stage().skeleton, chains) / sizeof(Affine) + 1);
    EXPECT_EQ(make_springs(stage().skeleton, chains,
                           {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(Affine)}, springs),
              Status::ok);
  }
  std::vector<Affine> memory;
  Springs springs;
};

SpringFrame frame_of(Misuse& m, std::vector<SpringCollider>& colliders) {
  colliders = {
      {static_cast<std::uint16_t>(m.index(3)), 0, {m.number(0), 0, 0}, {0, m.number(0.1f), 0}, m.number(0.1f)}};
  SpringFrame frame{.dt_s = m.number(0.02f), .colliders = m.in(colliders, Length::any), .teleport_m = m.number(1)};
  frame.world_from_model.rows[1][1] = m.number(1);
  frame.world_from_model.rows[2][3] = m.number(3);
  frame.gravity[1] = m.number(-9.81f);
  frame.wind[0] = m.number(2);
  frame.teleported = m.truth(false);
  frame.weight = m.number(1);
  return frame;
}

std::vector<MisuseRow> rows_of_limits() {
  return {
      {"angle_range",
       [](Misuse& m) {
         const AngleRange range = angle_range(m.number(-1), m.number(1));
         (void)range;
         m.returned_ok();
       }},
      {"make_limit",
       [](Misuse& m) {
         JointLimit& out = m.one(JointLimit{});
         m.returned(make_limit(description_of(m), static_cast<std::uint16_t>(m.index(2)), out));
       }},
      {"clamp_rotation",
       [](Misuse& m) {
         float local[4] = {0.5f, m.number(0.5f), -0.5f, m.number(0.5f)};
         const float before = local[0];
         const Status status = clamp_rotation(good_limits()[m.index(1) % 3], local);
         m.returned(status);
         if (status == Status::ok)
           for (const float c : local) EXPECT_TRUE(std::isfinite(c));
         else
           EXPECT_EQ(local[0], before);
       }},
      {"limit_excess",
       [](Misuse& m) {
         const float local[4] = {0.5f, m.number(0.5f), -0.5f, m.number(0.5f)};
         m.returned(limit_excess(good_limits()[m.index(1) % 3], local));
       }},
      {"limit_pose",
       [](Misuse& m) {
         const Span<const JointLimit> limits = m.in(good_limits(), Length::any);
         m.returned(limit_pose(limits, m.out(limited_pose())));
       }},
      {"is_valid",
       [](Misuse& m) {
         JointLimit limit = good_limits()[m.index(1) % 3];
         limit.kind = m.kind(limit.kind);
         limit.limit_from_parent[0] = m.number(limit.limit_from_parent[0]);
         limit.rate.speed = m.number(1);
         (void)is_valid(limit);
         m.returned_ok();
       }},
      {"find_limit",
       [](Misuse& m) {
         const std::vector<JointLimit> limits = good_limits();
         const std::uint32_t joint = m.index(5);
         const JointLimit* const found = find_limit(limits, joint);
         EXPECT_EQ(found != nullptr, joint == 2 || joint == 5 || joint == 10);
         m.returned_ok();
       }},
      {"follow_rotation",
       [](Misuse& m) {
         RotationFollower& state = m.one(turning(m));
         const float target[4] = {m.number(0.5f), m.number(-0.5f), m.number(0.5f), m.number(0.5f)};
         const Status status = follow_rotation(state, target, m.number(0.02f), {m.number(3), m.number(20)});
         m.returned(status);
         for (int i = 0; i < 4 && status == Status::ok; ++i) EXPECT_TRUE(std::isfinite(state.rotation[i]));
       }},
      {"follow_point",
       [](Misuse& m) {
         PointFollower good;
         if (!m.truth(true)) {
           numbers(m, good.point, 0.5f);
           numbers(m, good.target, 0.25f);
           numbers(m, good.velocity, 0.1f);
           good.frame_s = m.number(0.02f);
           good.mode = m.index(1);
         }
         PointFollower& state = m.one(good);
         const float target[3] = {m.number(1), m.number(2), m.number(3)};
         const Status status = follow_point(state, target, m.number(0.02f), {m.number(3), m.number(20)});
         m.returned(status);
         for (int i = 0; i < 3 && status == Status::ok; ++i) EXPECT_TRUE(std::isfinite(state.point[i]));
       }},
      {"follow_pose",
       [](Misuse& m) {
         std::vector<RotationFollower> good;
         for (int i = 0; i < 3; ++i) good.push_back(turning(m));
         const Span<const JointLimit> limits = m.in(good_limits(), Length::any);
         const Span<RotationFollower> states = m.out(good);
         m.returned(follow_pose(limits, states, m.number(0.02f), m.out(limited_pose())));
       }},
  };
}

}  // namespace

std::vector<MisuseRow> rows_of_following() {
  std::vector<MisuseRow> rows = rows_of_limits();
  const std::vector<MisuseRow> springs = {
      {"springs_bytes",
       [](Misuse& m) {
         std::vector<SpringJoint> joints;
         (void)springs_bytes(m.either(stage().skeleton, stage().smaller), chains_of(m, joints));
         m.returned_ok();
       }},
      {"make_springs",
       [](Misuse& m) {
         std::vector<SpringJoint> joints;
         const std::vector<SpringChain> chains = chains_of(m, joints);
         const Skeleton& skeleton = m.either(stage().skeleton, stage().smaller);
         const Span<std::byte> memory = m.memory(springs_bytes(skeleton, chains));
         Springs& out = m.one(Springs{});
         m.returned(make_springs(skeleton, m.in(chains, Length::any), memory, out));
       }},
      {"set_springs",
       [](Misuse& m) {
         std::vector<SpringJoint> joints;
         const std::vector<SpringChain> chains = chains_of(m, joints);
         Swinging swinging;
         m.returned(
             set_springs(m.either(stage().skeleton, stage().smaller), m.in(chains, Length::any), swinging.springs));
       }},
      {"reset_springs",
       [](Misuse& m) {
         Swinging swinging;
         Springs none;
         reset_springs(m.truth(true) ? swinging.springs : none);
         m.returned_ok();
       }},
      {"simulate_springs",
       [](Misuse& m) {
         Swinging swinging;
         std::vector<SpringCollider> colliders;
         const SpringFrame frame = frame_of(m, colliders);
         const Span<SoaTransform> local = m.out(stage().pose);
         const Span<Affine> joints = m.out(stage().joints);
         m.returned(
             simulate_springs({m.either(stage().skeleton, stage().smaller), local, joints}, frame, swinging.springs));
       }},
  };
  rows.insert(rows.end(), springs.begin(), springs.end());
  return rows;
}

}  // namespace marrow::test
