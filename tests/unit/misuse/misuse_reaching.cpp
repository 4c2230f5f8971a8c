// Inverse kinematics: limbs, heads, chains, feet.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "ik/foot_state.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

const Skeleton& skeleton_of(Misuse& m) {
  return m.either(stage().skeleton, stage().smaller);
}

TwoBone reach_of(Misuse& m) {
  TwoBone goal{.weight = m.number(1), .twist_rad = m.number(0.1f), .soft = m.number(0.97f)};
  for (int i = 0; i < 3; ++i) {
    goal.target[i] = m.number(0.3f);
    goal.pole[i] = m.number(0);
    goal.bend_axis[i] = m.number(0);
  }
  goal.max_stretch = m.number(1.5f);
  return goal;
}

Aim aim_of(Misuse& m) {
  Aim goal{.weight = m.number(1), .twist_rad = m.number(0.1f)};
  for (int i = 0; i < 3; ++i) {
    goal.target[i] = m.number(3);
    goal.pole[i] = m.number(0.2f);
    goal.forward[i] = m.number(i == 2 ? 1 : 0);
    goal.up[i] = m.number(i == 1 ? 1 : 0);
    goal.offset[i] = m.number(0.1f);
  }
  return goal;
}

// A matrix of its own, with bad numbers now and then.
const Affine* matrix(Misuse& m, std::size_t joint) {
  Affine a = stage().joints[joint];
  a.rows[1][3] = m.number(a.rows[1][3]);
  a.rows[2][2] = m.number(a.rows[2][2]);
  return &m.given(a);
}

TwoBoneJoints limb_of(Misuse& m) {
  return {m.pointer(matrix(m, 2)), m.pointer(matrix(m, 5)), m.pointer(matrix(m, 10))};
}

void expect_turn(Status status, const float (&turn)[4]) {
  for (int i = 0; i < 4 && status == Status::ok; ++i) EXPECT_TRUE(std::isfinite(turn[i]));
}

// What the problem views.
struct Asked {
  std::vector<IkGoal> goals;
  std::vector<JointLimit> limits;
};

IkProblem problem_of(Misuse& m, Asked& asked) {
  IkGoal goal{.joint = static_cast<std::uint16_t>(m.index(10))};
  goal.priority = static_cast<std::uint8_t>(m.index(0));
  for (float* const v : {goal.offset, goal.position, goal.rotation}) v[1] = m.number(0.1f);
  goal.position_weight = m.number(1);
  goal.rotation_weight = m.number(0);
  asked.goals = {goal};
  JointLimit limit;
  EXPECT_EQ(make_limit({.kind = LimitKind::hinge, .least_rad = {-1, 0, 0}, .most_rad = {1, 0, 0}}, 5, limit),
            Status::ok);
  asked.limits = {limit};
  const std::vector<std::uint16_t> turning = {0, 2, 5, 10};
  const std::vector<float> stiffness = {m.number(0.5f), 0, m.number(0.1f), 0};
  IkProblem problem{.goals = m.in(asked.goals, Length::any), .joints = m.in(turning, Length::any)};
  if (m.truth(false)) problem.stiffness = m.in(stiffness, Length::any);
  if (m.truth(false)) problem.limits = m.in(asked.limits, Length::any);
  problem.pole[0] = m.number(1);
  problem.pole_weight = m.number(0);
  problem.root_travel_m = m.number(0);
  return problem;
}

IkOptions options_of(Misuse& m, IkMethod method = IkMethod::gauss_newton) {
  return {.method = m.kind(method),
          .starts = static_cast<std::uint8_t>(m.index(2)),
          .max_iterations = static_cast<std::uint16_t>(m.truth(true) ? 4 : 0),
          .tolerance_m = m.number(1e-4f),
          .damping = m.number(1),
          .seed = m.index(1),
          .weight = m.number(1),
          .stretch = m.number(1)};
}

// What is asked for; bytes that a bad problem makes of it have a bound.
std::size_t scratch_bytes(std::size_t asked) {
  return std::min(asked, std::size_t{1} << 20);
}

void solve(Misuse& m, decltype(solve_ik)& by, IkMethod method) {
  Asked asked;
  const IkProblem problem = problem_of(m, asked);
  const IkOptions options = options_of(m, method);
  const Skeleton& skeleton = skeleton_of(m);
  const Span<std::byte> scratch = m.memory(scratch_bytes(ik_scratch_bytes(skeleton, problem, options)), 1);
  const Span<SoaTransform> local = m.out(stage().pose);
  const Span<Affine> joints = m.out(stage().joints);
  IkReport report;
  m.returned(by({skeleton, local, joints}, problem, options, scratch, m.pointer(&report)));
  EXPECT_FALSE(std::isnan(report.error_m));
}

FeetFrame feet_frame(Misuse& m) {
  FeetFrame frame{.dt_s = m.number(0.02f)};
  frame.world_from_model.rows[0][0] = m.number(1);
  frame.world_from_model.rows[2][3] = m.number(4);
  frame.up[1] = m.number(1);
  frame.teleported = m.truth(false);
  frame.weight = m.number(1);
  return frame;
}

Foot foot_of(Misuse& m, std::uint32_t hip, std::uint32_t knee, std::uint32_t ankle) {
  Foot foot{.hip = m.index(hip), .knee = m.index(knee), .ankle = m.index(ankle), .weight = m.number(1)};
  foot.sole[1] = m.number(-0.1f);
  foot.bend_axis[0] = m.number(0);
  return foot;
}

void place(Misuse& m) {
  const std::vector<Foot> two = {foot_of(m, 2, 5, 10), foot_of(m, 3, 7, 13)};
  const Feet feet{m.in(two, Length::any), m.index(0), m.number(0.5f), m.number(0.99f), m.number(0.6f), m.number(0.25f)};
  std::vector<FootGround> ground(2);
  for (FootGround& g : ground) {
    g.hit = m.truth(true);
    g.planted = m.truth(false);
    g.point[1] = m.number(0.1f);
    g.normal[1] = m.number(1);
  }
  std::vector<FootMotion> motion(2);
  for (FootMotion& one : motion) {
    if (m.truth(true)) continue;
    FootState& f = state_of(one);
    f.begun = f.hit = 1;
    f.planted = m.truth(false) ? 1 : 0;
    f.axis = static_cast<std::uint8_t>(m.index(1));
    for (auto* const v :
         {&one.place, &f.offset, &f.offset_speed, &f.lean, &f.lean_speed, &f.point, &f.normal, &f.heading})
      (*v)[1] = m.number(0.5f);
    f.turn[3] = m.number(1);
    f.turn_share = m.number(0.5f);
    f.turn_share_speed = m.number(0);
  }
  const FeetFrame frame = feet_frame(m);
  const Span<FootMotion> moving = m.out(motion);
  const Span<SoaTransform> local = m.out(stage().pose);
  const Span<Affine> joints = m.out(stage().joints);
  m.returned(place_feet({skeleton_of(m), local, joints}, feet, frame, m.in(ground), moving));
}

void call_two_bone(Misuse& m) {
  TwoBoneTurns& out = m.one(TwoBoneTurns{});
  const Status status = two_bone(limb_of(m), reach_of(m), out);
  m.returned(status);
  expect_turn(status, out.start);
  expect_turn(status, out.mid);
}

void call_two_bone_x4(Misuse& m) {
  const TwoBoneJoints limbs[4] = {limb_of(m), limb_of(m), limb_of(m), limb_of(m)};
  const TwoBone goals[4] = {reach_of(m), reach_of(m), reach_of(m), reach_of(m)};
  TwoBoneTurns out[4];
  const Status status = two_bone_x4(limbs, goals, out);
  m.returned(status);
  for (const TwoBoneTurns& turns : out) expect_turn(status, turns.mid);
}

void call_solve_two_bone(Misuse& m) {
  const TwoBoneLimb limb{m.index(2), m.index(5), m.index(10)};
  const Span<SoaTransform> local = m.out(stage().pose);
  const Span<Affine> joints = m.out(stage().joints);
  bool reached = false;
  m.returned(solve_two_bone({skeleton_of(m), local, joints}, limb, reach_of(m), m.pointer(&reached)));
}

void call_aim(Misuse& m) {
  AimTurn& out = m.one(AimTurn{});
  const Status status = aim(*matrix(m, 5), aim_of(m), out);
  m.returned(status);
  expect_turn(status, out.turn);
}

void call_solve_aim(Misuse& m) {
  const Span<SoaTransform> local = m.out(stage().pose);
  const Span<Affine> joints = m.out(stage().joints);
  bool reached = false;
  m.returned(solve_aim({skeleton_of(m), local, joints}, m.index(5), aim_of(m), m.pointer(&reached)));
}

void call_solve_look_at(Misuse& m) {
  const std::vector<std::uint32_t> chain = {0, 2, 5};
  const Span<SoaTransform> local = m.out(stage().pose);
  const Span<Affine> joints = m.out(stage().joints);
  m.returned(solve_look_at({skeleton_of(m), local, joints}, m.in(chain, Length::any), aim_of(m), m.number(0.5f)));
}

void call_ik_scratch_bytes(Misuse& m) {
  Asked asked;
  (void)ik_scratch_bytes(skeleton_of(m), problem_of(m, asked), options_of(m));
  m.returned_ok();
}

void call_ik_genetic_scratch_bytes(Misuse& m) {
  Asked asked;
  (void)ik_genetic_scratch_bytes(skeleton_of(m), problem_of(m, asked));
  m.returned_ok();
}

void call_solve_ik_genetic(Misuse& m) {
  Asked asked;
  const IkProblem problem = problem_of(m, asked);
  const IkOptions options = options_of(m);
  const Skeleton& skeleton = skeleton_of(m);
  const Span<std::byte> scratch = m.memory(scratch_bytes(ik_genetic_scratch_bytes(skeleton, problem)), 1);
  const Span<SoaTransform> local = m.out(stage().pose);
  const Span<Affine> joints = m.out(stage().joints);
  m.returned(solve_ik_genetic({skeleton, local, joints}, problem, options, scratch));
}

void call_foot_of(Misuse& m) {
  static const JointRole roles[] = {
      {2, Role::left_upper_leg, 0}, {5, Role::left_lower_leg, 0}, {10, Role::left_foot, 0}};
  static const JointSole soles[] = {{10, 0, {0, -0.1f, 0.1f}}};
  const bool all = m.truth(true);
  Foot& out = m.one(Foot{});
  const Role role = m.spoils("a role that does not stand") ? Role::head : Role::left_foot;
  if (!all) m.may_fail();
  m.returned(marrow::foot_of({roles, {}, all ? Span<const JointSole>(soles) : Span<const JointSole>()}, role, out));
}

void call_foot_sole(Misuse& m) {
  float sole[3] = {};
  const Span<const Affine> joints = m.in(Span<const Affine>(stage().joints.data(), 11));
  const Status status = foot_sole(foot_of(m, 2, 5, 10), *matrix(m, 0), joints, sole);
  m.returned(status);
  for (const float x : sole) EXPECT_TRUE(status != Status::ok || std::isfinite(x));
}

}  // namespace

std::vector<MisuseRow> rows_of_reaching() {
  return {
      {"two_bone", call_two_bone},
      {"two_bone_x4", call_two_bone_x4},
      {"solve_two_bone", call_solve_two_bone},
      {"aim", call_aim},
      {"solve_aim", call_solve_aim},
      {"solve_look_at", call_solve_look_at},
      {"ik_scratch_bytes", call_ik_scratch_bytes},
      {"ik_genetic_scratch_bytes", call_ik_genetic_scratch_bytes},
      {"solve_ik", [](Misuse& m) { solve(m, solve_ik, IkMethod::gauss_newton); }},
      {"solve_ik_chain", [](Misuse& m) { solve(m, solve_ik_chain, IkMethod::fabrik); }},
      {"solve_ik_body", [](Misuse& m) { solve(m, solve_ik_body, IkMethod::gauss_newton); }},
      {"solve_ik_genetic", call_solve_ik_genetic},
      {"foot_of", call_foot_of},
      {"foot_sole", call_foot_sole},
      {"place_feet", place},
  };
}

}  // namespace marrow::test
