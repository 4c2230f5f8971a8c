// What is asked of PMAP sections beyond their description.
#include "asset/checker.h"
#include "math/finite.h"

namespace marrow {
namespace {

bool is_unit(const float* q, std::size_t stride = 1) {
  return within(dot_of_rotations(q, q, stride), 0.998f, 1.002f);
}

bool check_groups(Checker& c, Span<const MappedGroup> groups, std::uint32_t rig_joint_count) {
  for (const MappedGroup& g : groups)
    for (int lane = 0; lane < 4; ++lane) {
      if (!is_unit(&g.before[0][lane], 4) || !is_unit(&g.after[0][lane], 4)) return c.fail(&g, kNoUnit);
      if (g.rig_joints[lane] >= rig_joint_count && g.rig_joints[lane] != kNoJoint)
        return c.fail(&g.rig_joints[lane], "a joint outside the rig");
    }
  return true;
}

bool check_turns(Checker& c, Span<const MappedTurn> turns) {
  for (const MappedTurn* t = turns.begin(); t != turns.end(); ++t) {
    if (t != turns.begin() && t->joint < t[-1].joint) return c.fail(t, "turns ascend by joint");
    if (!is_unit(t->before) || !is_unit(t->after)) return c.fail(t, kNoUnit);
  }
  return true;
}

bool check_places(Checker& c, Span<const MappedPlace> places) {
  for (const MappedPlace* p = places.begin(); p != places.end(); ++p) {
    if (p != places.begin() && p->joint <= p[-1].joint) return c.fail(p, "places ascend by joint");
    if (!c.floats_below(kBeyondFarthest, p->parent_from_rig[0], 12, kNotBounded)) return false;
  }
  return true;
}

}  // namespace

void check(Checker& c, const format::PoseMapHeader& h) {
  format::PoseMapLayout l;
  if (!check_fields(c, h, l)) return;
  if (h.group_count != soa_count(c.joint_count()))
    return static_cast<void>(c.fail(&h, "as many groups as the skeleton has"));
  const Span<const MappedTurn> turns = c.in(l.turns);
  const Span<const MappedPlace> places = c.in(l.places);
  if (!check_groups(c, c.in(l.groups), h.rig_joint_count) || !check_turns(c, turns) || !check_places(c, places)) return;
  std::uint64_t count = 0;
  for (const MappedTurn& t : turns) count += t.step_count;
  const std::uint64_t first = count;
  for (const MappedPlace& p : places) count += p.step_count;
  if (count != h.step_count) return static_cast<void>(c.fail(&h, "as many steps as turns and places have"));
  for (const RigStep& s : Span<const RigStep>(c.in(l.steps).data + first, h.step_count - first))
    if (s.inverse != 0 || s.mirrored != 0) return static_cast<void>(c.fail(&s, "a place is the rig's own way down"));
}

}  // namespace marrow
