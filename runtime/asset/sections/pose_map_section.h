// PMAP: how a skeleton takes poses of another rig, as pose_map.h has it.
#pragma once

#include "asset/sections/fields.h"
#include "marrow/pose_map.h"

namespace marrow::format {

inline constexpr float kLeastTurnWeight = 1e-6f;

struct PoseMapHeader {
  std::uint32_t name;
  std::uint32_t skeleton;
  std::uint64_t rig_hash;
  std::uint16_t rig_joint_count;
  std::uint16_t group_count;
  std::uint32_t turn_count;
  std::uint32_t place_count;
  std::uint32_t step_count;
};
static_assert(sizeof(PoseMapHeader) == 32);

struct PoseMapLayout {
  Array<MappedGroup> groups;
  Array<MappedTurn> turns;
  Array<MappedPlace> places;
  Array<RigStep> steps;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<PoseMapHeader> {
  using Type = PoseMapLayout;
};

// What is asked of these is in check_pose_maps.cpp, which takes fewer bytes that way.
template <class V>
constexpr void fields(V& v, const MappedGroup& g) {
  v.any({"before", "of four joints unit quaternions x[4] y[4] z[4] w[4]"}, g.before);
  v.any({"after", "likewise"}, g.after);
  v.any({"rig_joints", "below rig_joint_count; 65535: none"}, g.rig_joints);
}

template <class V>
constexpr void fields(V& v, const MappedTurn& t) {
  v.any({"joint", "below the skeleton's joint_count"}, t.joint);
  v.any({"step_count", "the next of steps"}, t.step_count);
  v.any({"weight", "10⁻⁶ … 1"}, t.weight);
  v.any({"before", "unit quaternion x, y, z, w"}, t.before);
  v.any({"after", "likewise"}, t.after);
}

template <class V>
constexpr void fields(V& v, const MappedPlace& p) {
  v.any({"joint", "below the skeleton's joint_count"}, p.joint);
  v.any({"step_count", "≥ 1; the next of steps"}, p.step_count);
  v.any({"parent_from_rig", "affine map, by rows; each number within ±10¹²"}, p.parent_from_rig);
}

template <class V>
constexpr void fields(V& v, const RigStep& s) {
  v.any({"joint", "below rig_joint_count"}, s.joint);
  v.any({"inverse", "not 0: the inverse of the rotation"}, s.inverse);
  v.any({"mirrored", "not 0: y and z of the rotation negated"}, s.mirrored);
}

template <class V>
constexpr void fields(V& v, const PoseMapHeader& h, PoseMapLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.skeleton({"skeleton", "which SKEL section"}, h.skeleton);
  v.any({"rig_hash", "of the rig's joints, as SREF's"}, h.rig_hash);
  v.range({"rig_joint_count", "1 … 32767"}, h.rig_joint_count, 1u, kMaxJoints, "1 to 32767 joints");
  v.any({"group_count", "⌈joint_count / 4⌉ of the skeleton"}, h.group_count);
  v.any({"turn_count"}, h.turn_count);
  v.any({"place_count"}, h.place_count);
  v.any({"step_count", "of all turns and places"}, h.step_count);
  v.array({"groups", "", "group_count"}, l.groups, h.group_count);
  v.array({"turns", "ascending by joint", "turn_count"}, l.turns, h.turn_count);
  v.array({"places", "ascending strictly by joint", "place_count"}, l.places, h.place_count);
  v.array({"steps", "those of the turns, then those of the places", "step_count"}, l.steps, h.step_count);
}

}  // namespace marrow::format
