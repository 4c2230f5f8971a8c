// What is asked of PMAP sections beyond their description.
#include "asset/checker.h"
#include "math/finite.h"

namespace marrow {
namespace {

constexpr const char *kNotAscending = "turns and places ascend by joint", *kNotOfRig = "a joint outside the rig";

[[gnu::noinline]] bool is_unit_turn(const float* q, std::size_t stride) {
  return within(dot_of_rotations(q, q, stride), 0.998f, 1.002f);
}

bool check_groups(Checker& c, Span<const MappedGroup> groups, std::uint32_t rig_joint_count) {
  for (const MappedGroup& g : groups)
    for (int lane = 0; lane < 4; ++lane) {
      if (!is_unit_turn(&g.before[0][lane], 4) || !is_unit_turn(&g.after[0][lane], 4)) return c.fail(&g, kNoUnit);
      if (g.rig_joints[lane] >= rig_joint_count && g.rig_joints[lane] != kNoJoint) return c.fail(&g, kNotOfRig);
    }
  return true;
}

bool check_turns(Checker& c, Span<const MappedTurn> turns, std::uint64_t& steps) {
  for (const MappedTurn* t = turns.begin(); t != turns.end(); ++t) {
    if (t->joint >= c.joint_count()) return c.fail(t, format::kNotOfSkeleton);
    if (t != turns.begin() && t->joint < t[-1].joint) return c.fail(t, kNotAscending);
    if (!within(t->weight, format::kLeastTurnWeight, 1)) return c.fail(t, "a weight that is not 1e-6 to 1");
    if (!is_unit_turn(t->before, 1) || !is_unit_turn(t->after, 1)) return c.fail(t, kNoUnit);
    steps += t->step_count;
  }
  return true;
}

bool check_places(Checker& c, Span<const MappedPlace> places, std::uint64_t& steps) {
  for (const MappedPlace* p = places.begin(); p != places.end(); ++p) {
    if (p->joint >= c.joint_count()) return c.fail(p, format::kNotOfSkeleton);
    if (p != places.begin() && p->joint <= p[-1].joint) return c.fail(p, kNotAscending);
    if (p->step_count == 0) return c.fail(p, "a place without a step");
    if (!c.floats_below(kBeyondFarthest, p->parent_from_rig[0], 12, kNotBounded)) return false;
    steps += p->step_count;
  }
  return true;
}

}  // namespace

void check(Checker& c, const format::PoseMapHeader& h) {
  format::PoseMapLayout l;
  if (!check_fields(c, h, l)) return;
  std::uint64_t steps = 0;
  if (!check_groups(c, c.in(l.groups), h.rig_joint_count) || !check_turns(c, c.in(l.turns), steps) ||
      !check_places(c, c.in(l.places), steps))
    return;
  if (h.group_count != soa_count(c.joint_count()) || steps != h.step_count)
    return static_cast<void>(c.fail(&h, "as many groups as the skeleton has, and steps as turns and places have"));
  for (const RigStep& s : c.in(l.steps))
    if (s.joint >= h.rig_joint_count) return static_cast<void>(c.fail(&s, kNotOfRig));
}

}  // namespace marrow
