// What is asked of ROLE sections beyond their description.
#include "asset/checker.h"

namespace marrow {
namespace {

bool check_joint_roles(Checker& c, Span<const JointRole> roles) {
  std::uint64_t seen = 0;
  static_assert(kRoleCount <= 64);
  for (const JointRole* r = roles.begin(); r != roles.end(); ++r) {
    if (r != roles.begin() && r->joint <= r[-1].joint) return c.fail(r, "roles ascend by joint");
    const std::uint64_t role = std::uint64_t{1} << static_cast<std::uint32_t>(r->role);
    if ((seen & role) != 0 && r->role != Role::tail) return c.fail(r, "a role of two joints");
    seen |= role;
  }
  return true;
}

bool check_pairs(Checker& c, Span<const JointPair> pairs) {
  std::uint32_t seen[(kMaxJoints + 1) / 32] = {};
  for (const JointPair* p = pairs.begin(); p != pairs.end(); ++p) {
    if (p != pairs.begin() && p->left <= p[-1].left) return c.fail(p, "pairs ascend by their left joints");
    for (const std::uint16_t joint : {p->left, p->right}) {
      const std::uint32_t bit = 1u << joint % 32;
      if ((seen[joint / 32] & bit) != 0) return c.fail(p, "a joint in two pairs");
      seen[joint / 32] |= bit;
    }
  }
  return true;
}

bool stands(Role role) {
  return role == Role::left_foot || role == Role::right_foot || role == Role::left_hand || role == Role::right_hand;
}

bool check_soles(Checker& c, Span<const JointSole> soles, const Roles& roles) {
  for (const JointSole* s = soles.begin(); s != soles.end(); ++s) {
    if (s != soles.begin() && s->joint <= s[-1].joint) return c.fail(s, "soles ascend by joint");
    if (!stands(role_of(roles, s->joint))) return c.fail(s, "a sole of what is no foot or hand");
  }
  return true;
}

}  // namespace

void check(Checker& c, const format::RoleHeader& h) {
  format::RoleLayout l;
  if (!check_fields(c, h, l)) return;
  const Roles roles{c.in(l.roles), c.in(l.pairs), c.in(l.soles)};
  if (check_joint_roles(c, roles.roles) && check_pairs(c, roles.pairs)) check_soles(c, roles.soles, roles);
}

}  // namespace marrow
