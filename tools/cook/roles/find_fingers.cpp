#include "cook/roles/find_fingers.h"

#include <algorithm>

namespace marrow::cook {
namespace {

// The joints of one finger below a joint, each below the one before; empty if they lie otherwise.
std::vector<int> joints_of_finger(const Body& body, int above, Part finger, Side side) {
  std::vector<int> out;
  for (std::size_t j = 0; j < body.size(); ++j) {
    const int joint = static_cast<int>(j);
    const JointPart& p = body.parts[j];
    if (p.part != finger || p.side != side || body.is_end(joint) || !body.is_at_or_above(above, joint)) continue;
    if (!out.empty() && !body.is_at_or_above(out.back(), joint)) return {};
    out.push_back(joint);
  }
  return out;
}

// A finger may begin in the palm; the joint numbered 1 is the first outside. A thumb has no joint there.
std::size_t first_of(const Body& body, const std::vector<int>& joints, Part finger) {
  if (finger == Part::thumb) return 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (body.part(joints[i]).number == 1 && joints.size() - i >= 3) return i;
  return 0;
}

}  // namespace

void find_fingers(Body& body) {
  constexpr std::pair<Part, Role> kFingers[] = {{Part::thumb, Role::left_thumb_metacarpal},
                                                {Part::index, Role::left_index_proximal},
                                                {Part::middle, Role::left_middle_proximal},
                                                {Part::ring, Role::left_ring_proximal},
                                                {Part::little, Role::left_little_proximal}};
  for (const Side side : {Side::left, Side::right}) {
    int above = body.joint_of(on_side(Role::left_hand, side));
    if (above == kNone) above = body.joint_of(on_side(Role::left_lower_arm, side));
    if (above == kNone) continue;
    for (const auto& [part, role] : kFingers) {
      const std::vector<int> joints = joints_of_finger(body, above, part, side);
      const std::size_t first = first_of(body, joints, part);
      for (std::size_t i = first; i < joints.size() && i < first + 3; ++i)
        body.give(on_side(static_cast<Role>(static_cast<std::size_t>(role) + i - first), side), joints[i]);
    }
  }
}

}  // namespace marrow::cook
