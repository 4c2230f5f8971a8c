// ROLE: what the joints of a skeleton are for, which of them mirror each other, and where feet stand.
#pragma once

#include "asset/sections/fields.h"
#include "asset/sections/kind.h"
#include "marrow/roles.h"

namespace marrow::format {

inline constexpr float kFarthestSole = 1e6f;

struct RoleHeader {
  std::uint32_t skeleton;
  std::uint16_t role_count;
  std::uint16_t pair_count;
  std::uint16_t sole_count;
  std::uint16_t reserved;
};
static_assert(sizeof(RoleHeader) == 12);

struct RoleLayout {
  Array<JointRole> roles;
  Array<JointPair> pairs;
  Array<JointSole> soles;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<RoleHeader> {
  using Type = RoleLayout;
};

inline constexpr const char* kNotOfSkeleton = "a joint outside the skeleton";

template <class V>
constexpr void fields(V& v, const JointRole& r) {
  v.joint({"joint", "below the skeleton's joint_count"}, r.joint, kNotOfSkeleton);
  v.range({"role", "1 … 57, see below"}, r.role, 1u, kRoleCount - 1, "no role");
  v.reserved(r.reserved);
}

template <class V>
constexpr void fields(V& v, const JointPair& p) {
  v.joint({"left", "below the skeleton's joint_count"}, p.left, kNotOfSkeleton);
  v.joint({"right", "as left"}, p.right, kNotOfSkeleton);
}

template <class V>
constexpr void fields(V& v, const JointSole& s) {
  v.joint({"joint", "whose role is a foot or a hand"}, s.joint, kNotOfSkeleton);
  v.reserved(s.reserved);
  v.near({"place", "in the joint's space, each within ±10⁶"}, s.place, kFarthestSole,
         "a sole that is not finite, or beyond 1e6");
}

template <class V>
constexpr void fields(V& v, const RoleHeader& h, RoleLayout& l) {
  v.only_of_skeleton({"skeleton", "which SKEL section"}, h.skeleton, "one section of roles a skeleton, in their order");
  v.range({"role_count", "≥ 1"}, h.role_count, 1u, UINT16_MAX, "a section of roles without one");
  v.any({"pair_count"}, h.pair_count);
  v.any({"sole_count"}, h.sole_count);
  v.reserved(h.reserved);
  v.records({"roles", "ascending strictly by joint; no role twice but that of tails", "role_count"}, l.roles,
            h.role_count, [&](const JointRole& r) { fields(v, r); });
  v.records({"pairs", "ascending strictly by left; no joint in two", "pair_count"}, l.pairs, h.pair_count,
            [&](const JointPair& p) { fields(v, p); });
  v.records({"soles", "ascending strictly by joint", "sole_count"}, l.soles, h.sole_count,
            [&](const JointSole& s) { fields(v, s); });
}

}  // namespace marrow::format
