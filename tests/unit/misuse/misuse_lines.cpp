// Lines for a debug view.
#include "marrow/debug_lines.h"
#include "marrow/limits.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

DebugLines& lines_of(Misuse& m) {
  DebugLines lines;
  lines.room = m.out<DebugLine>(64, Length::any);
  lines.count = m.index(3);
  return m.one(lines);
}

Span<const Affine> scene_of(Misuse& m) {
  return m.in(stage().joints);
}

std::uint16_t joint_of(Misuse& m, std::uint32_t good) {
  return static_cast<std::uint16_t>(m.index(good));
}

}  // namespace

std::vector<MisuseRow> rows_of_lines() {
  return {
      {"joint_lines",
       [](Misuse& m) {
         DebugLines& lines = lines_of(m);
         m.returned(joint_lines(stage().skeleton, scene_of(m), m.number(0.1f), lines));
       }},
      {"limit_lines",
       [](Misuse& m) {
         DebugLines& lines = lines_of(m);
         JointLimit limit;
         limit.joint = joint_of(m, 2);
         limit.kind = m.kind(LimitKind::cone);
         limit.order = m.kind(AxisOrder::xyz);
         limit.angles[0] = {m.number(0), m.number(0.5f)};
         limit.angles[1].half_width = limit.angles[2].half_width = m.number(0.2f);
         limit.limit_from_parent[3] = m.number(1);
         const std::vector<JointLimit> limits = {limit};
         m.returned(limit_lines(stage().skeleton, m.in(limits, Length::any), m.in(stage().pose), scene_of(m),
                                m.number(0.1f), lines));
       }},
      {"goal_lines",
       [](Misuse& m) {
         DebugLines& lines = lines_of(m);
         IkGoal goal;
         goal.joint = joint_of(m, 5);
         for (float* const v : {goal.offset, goal.position, goal.rotation}) *v = m.number(0.5f);
         goal.rotation_weight = m.number(0);
         const std::vector<IkGoal> goals = {goal};
         m.returned(goal_lines(stage().skeleton, m.in(goals, Length::any), scene_of(m), m.number(0.1f), m.number(0.01f),
                               lines));
       }},
      {"spring_lines",
       [](Misuse& m) {
         DebugLines& lines = lines_of(m);
         std::vector<SpringJoint> joints(2);
         joints[0].joint = joint_of(m, 2);
         joints[1].joint = joint_of(m, 5);
         const std::vector<SpringChain> chains = {{m.in(joints, Length::any), {m.number(0.1f), 0, 0}}};
         m.returned(spring_lines(stage().skeleton, m.in(chains, Length::any), scene_of(m), lines));
       }},
      {"collider_lines",
       [](Misuse& m) {
         DebugLines& lines = lines_of(m);
         const std::vector<SpringCollider> colliders = {
             {joint_of(m, 3), 0, {m.number(0), 0, 0}, {0, m.number(0.1f), 0}, m.number(0.1f)}};
         m.returned(collider_lines(stage().skeleton, m.in(colliders, Length::any), scene_of(m), lines));
       }},
      {"bounds_lines",
       [](Misuse& m) {
         DebugLines& lines = lines_of(m);
         m.returned(bounds_lines({{m.number(-1), -1, -1}, {1, m.number(1), 1}, m.number(2)}, lines));
       }},
  };
}

}  // namespace marrow::test
