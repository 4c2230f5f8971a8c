#include "cook/retarget/plan/retarget_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "cook/retarget/plan/pair_rigs.h"
#include "cook/scene/matrices.h"
#include "deform/rotations.h"
#include "marrow/roles.h"

namespace marrow::cook {
namespace {

constexpr double kCosineOf15Degrees = 0.9659258262890683;
constexpr double kCosineOf40Degrees = 0.766044443118978;
// Of fingers that tell of a roll: they spread by 4 degrees or more, and alike.
constexpr double kNarrow = 0.001, kOneShape = 0.7;

using Joints = std::vector<RetargetJoint>;

// About an axis, by the angle with this cosine and sine.
glm::dquat roll(const glm::dvec2& angle, const glm::dvec3& axis) {
  if (1 + angle.x < 1e-9) return {0, axis};
  return glm::normalize(glm::dquat(1 + angle.x, angle.y * axis));
}

// The turn about y that takes a foot's heading to the captured one's, so that a flat sole stays flat; false if the
// captured bone is no foot's, which is flat below one that comes down steeply. `bone`, `captured`: of an ankle.
bool heading_arc(const glm::dvec3& above, glm::dvec3 bone, glm::dvec3 captured, glm::dquat& out) {
  if (above.y >= 0 || lies_flat(above) || !lies_flat(captured)) return false;
  bone.y = captured.y = 0;
  if (!(glm::length(bone) > 0)) return false;
  out = arc(glm::normalize(bone), glm::normalize(captured));
  return true;
}

// Of each joint, from the paired one above to it, at rest, of length 1; 0 where there is none.
struct Bones {
  std::vector<glm::dvec3> own, captured;
};
Bones bones_of(const Joints& joints, const Take& take, const glm::dquat& facing) {
  Bones out{std::vector<glm::dvec3>(joints.size(), glm::dvec3(0)), {}};
  out.captured = out.own;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const RetargetJoint& joint = joints[j];
    if (!joint.at.is_there() || joint.upper == kNone) continue;
    const RetargetJoint& upper = joints[to_index(joint.upper)];
    const glm::dvec3 bone = joint.place - upper.place;
    const glm::dvec3 other = facing * (take.rest(joint.at) - take.rest(upper.at));
    const double length = glm::length(bone), other_length = glm::length(other);
    if (!(length > 0) || !(other_length > 0)) continue;
    out.own[j] = bone / length;
    out.captured[j] = other / other_length;
  }
  return out;
}

// Sums over the bones that start at a joint.
struct Below {
  glm::dvec3 own{0}, captured{0};
  double count = 0;
  bool lie_about_one_way() const { return 2 * std::min(glm::length(own), glm::length(captured)) >= count; }
};

// Of each joint with three bones or more that lie about one way, the captured one that is farthest from their mean: a
// hand's thumb, which rests in the palm's plane in one skeleton and in front of it in another, and says little of the
// palm. It is taken out of the sums.
std::vector<int> take_thumbs(const Joints& joints, const Bones& bones, std::vector<Below>& below) {
  std::vector<int> out(joints.size(), kNone);
  std::vector<double> least(joints.size(), 2);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (bones.own[j] == glm::dvec3(0)) continue;
    const std::size_t up = to_index(joints[j].upper);
    const double along = glm::dot(bones.captured[j], below[up].captured) / below[up].count;
    if (below[up].count < 3 || !below[up].lie_about_one_way() || along >= least[up]) continue;
    least[up] = along;
    out[up] = static_cast<int>(j);
  }
  for (std::size_t j = 0; j < out.size(); ++j) {
    if (out[j] == kNone) continue;
    below[j].own -= bones.own[to_index(out[j])];
    below[j].captured -= bones.captured[to_index(out[j])];
    --below[j].count;
  }
  return out;
}

// By how much a hand rolls about the mean of its fingers, once that lies as the captured one's: as its fingers lie
// about it, and the thumb if there is only one other. Cosine and sine; 0 of what has not several bones, or none that
// tell.
std::vector<glm::dvec2> rolls_of(const Joints& joints, const Bones& bones, const std::vector<Below>& below,
                                 const std::vector<int>& thumbs, const std::vector<glm::dquat>& arcs) {
  struct Spread {
    glm::dvec2 angle{0};  // cosine and sine, of some length
    double own = 0, captured = 0;
  };
  std::vector<Spread> spreads(joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (bones.own[j] == glm::dvec3(0)) continue;
    const std::size_t up = to_index(joints[j].upper);
    if (below[up].count < 2 || !below[up].lie_about_one_way() || thumbs[up] == static_cast<int>(j)) continue;
    const glm::dvec3 mean = glm::normalize(below[up].captured), own = arcs[up] * bones.own[j];
    const glm::dvec3 a = own - glm::dot(own, mean) * mean;
    const glm::dvec3 b = bones.captured[j] - glm::dot(bones.captured[j], mean) * mean;
    Spread& of = spreads[up];
    of.angle += glm::dvec2(glm::dot(a, b), glm::dot(mean, glm::cross(a, b)));
    of.own += glm::dot(a, a);
    of.captured += glm::dot(b, b);
  }
  std::vector<glm::dvec2> out(joints.size(), glm::dvec2(0));
  for (std::size_t j = 0; j < out.size(); ++j) {
    const Spread& of = spreads[j];
    const double length = glm::length(of.angle), least = std::min(of.own, of.captured);
    if (least > kNarrow * below[j].count && length >= kOneShape * std::sqrt(of.own * of.captured))
      out[j] = of.angle / length;
  }
  return out;
}

// Joints of the trunk and shoulders, by roles: where these are is a matter of the rig and not of the pose. Of one
// `stands`: it keeps its own pose where that is not far from the take's.
std::vector<char> standing(const BuiltSkeleton& skeleton) {
  std::vector<char> out(skeleton.parents.size(), 0);
  const TrunkJoints trunk = trunk_of(skeleton);
  for (const std::vector<int>* const joints : {&trunk.spine, &trunk.neck})
    for (const int joint : *joints) out[to_index(joint)] = 1;
  if (trunk.spine.empty()) return out;
  for (const Role role : {Role::hips, Role::head, Role::left_shoulder, Role::right_shoulder})
    if (const int joint = joint_with(skeleton, role); joint != kNone) out[to_index(joint)] = 1;
  return out;
}

// By how much each joint turns in the scene, from its rest pose to that in which the character looks as the take's rig
// does at rest: A, see retarget_clips().
std::vector<glm::dquat> arcs_with(const std::vector<char>& stands, const Joints& joints, const Bones& bones) {
  std::vector<Below> below(joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (bones.own[j] == glm::dvec3(0)) continue;
    Below& of = below[to_index(joints[j].upper)];
    of.own += bones.own[j];
    of.captured += bones.captured[j];
    ++of.count;
  }
  const std::vector<int> thumbs = take_thumbs(joints, bones, below);
  std::vector<glm::dquat> out(joints.size(), glm::dquat(1, 0, 0, 0));
  std::vector<char> is_foot(joints.size(), 0);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Below& of = below[j];
    if (of.count == 0) {
      const int upper = joints[j].upper;
      if (upper == kNone) continue;
      const glm::dquat& above = out[to_index(upper)];
      if (stands[j] != 0 && stands[to_index(upper)] != 0) continue;
      if (lies_flat(bones.captured[j]) || std::abs(above.w) < kCosineOf15Degrees) out[j] = above;
    } else if (of.lie_about_one_way()) {
      is_foot[j] = heading_arc(bones.captured[j], of.own, of.captured, out[j]) ? 1 : 0;
      if (is_foot[j] != 0) continue;
      const glm::dvec3 own = glm::normalize(of.own), other = glm::normalize(of.captured);
      if (stands[j] == 0 || glm::dot(own, other) < kCosineOf40Degrees) out[j] = arc(own, other);
    }
  }
  const std::vector<glm::dvec2> rolls = rolls_of(joints, bones, below, thumbs, out);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (rolls[j] == glm::dvec2(0) || is_foot[j] != 0) continue;
    out[j] = roll(rolls[j], glm::normalize(below[j].captured)) * out[j];
    // Nobody knows where in the arm it turns: half of it in the forearm.
    const int upper = joints[j].upper;
    if (upper == kNone || below[to_index(upper)].count != 1) continue;
    const glm::dquat whole = roll(rolls[j], bones.captured[j]);
    out[to_index(upper)] = glm::normalize(whole + glm::dquat(1, 0, 0, 0)) * out[to_index(upper)];
  }
  return out;
}

constexpr double kFlat = 0.05;  // skeletons that reach less far sideways than that, of their size, face nowhere

// Of what stands above a root. A mirror is one along x, then the rotation: as in_mirrored() has it.
glm::dquat rotation_of(const glm::dmat4& m) {
  glm::dmat3 linear(m);
  if (glm::determinant(linear) < 0) linear[0] = -linear[0];
  return deform::quaternion_of(deform::rotation_of(linear));
}

// The turn about y, of those by quarters, after which paired joints lie most alike.
int facing_of(const Joints& joints, const Take& take) {
  glm::dvec3 middle(0), taken_middle(0);
  double count = 0, along = 0, across = 0, size = 0, taken_size = 0;
  for (const RetargetJoint& joint : joints) {
    if (!joint.at.is_there()) continue;
    middle += joint.place;
    taken_middle += take.rest(joint.at);
    ++count;
  }
  for (const RetargetJoint& joint : joints) {
    if (!joint.at.is_there()) continue;
    const glm::dvec3 a = joint.place - middle / count, b = take.rest(joint.at) - taken_middle / count;
    along += a.x * b.x + a.z * b.z;
    across += a.x * b.z - a.z * b.x;
    size += glm::dot(a, a);
    taken_size += glm::dot(b, b);
  }
  const double clear = kFlat * std::sqrt(size) * std::sqrt(taken_size);
  if (along >= std::abs(across) || !(std::max(-along, std::abs(across)) > clear)) return 0;
  if (-along >= std::abs(across)) return 180;
  return across > 0 ? 90 : -90;
}

glm::dquat turn_about_y(int degrees) {
  const double half = std::sqrt(0.5);
  if (degrees == 0) return {1, 0, 0, 0};
  return degrees == 180 ? glm::dquat(0, 0, 1, 0) : glm::dquat(half, 0, degrees > 0 ? half : -half, 0);
}

// Lengths of the character in those of the take.
double scale_below(const Joints& joints, std::size_t carried, const Take& take) {
  const auto lengths = [&](const RetargetJoint& joint) {
    if (!joint.at.is_there() || joint.upper == kNone) return glm::dvec2(0);
    const RetargetJoint& upper = joints[to_index(joint.upper)];
    return glm::dvec2(glm::length(joint.place - upper.place), glm::length(take.rest(joint.at) - take.rest(upper.at)));
  };
  std::vector<char> below(joints.size(), 0);
  std::size_t lowest = carried;
  glm::dvec2 all(0), way(0);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    all += lengths(joints[j]);
    below[j] = j == carried || (joints[j].parent != kNone && below[to_index(joints[j].parent)] != 0);
    if (below[j] != 0 && joints[j].at.is_there() && joints[j].place.y < joints[lowest].place.y) lowest = j;
  }
  for (std::size_t j = lowest; j != carried; j = to_index(joints[j].upper)) way += lengths(joints[j]);
  if (way.x > 0 && way.y > 0) return way.x / way.y;
  return all.x > 0 && all.y > 0 ? all.x / all.y : 1;
}

// Which joints move from their places: the topmost that the take carries. Of others than motion capture hips do in any
// case, also below a root, as feet stand on the ground.
std::vector<std::size_t> choose_carried(const Joints& joints, int hips, const Take& take) {
  const std::vector<char> moved = take.moved_nodes();
  std::vector<char> within(joints.size(), 0);
  std::vector<std::size_t> out;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const RetargetJoint& joint = joints[j];
    if (joint.parent != kNone) within[j] = within[to_index(joint.parent)];
    if (!joint.at.is_there()) continue;
    const bool is_hips = static_cast<int>(j) == hips && !take.scene().is_capture;
    if (!is_hips && (within[j] != 0 || moved[to_index(joint.at.node)] == 0)) continue;
    within[j] = 1;
    out.push_back(j);
  }
  return out;
}

// Motion capture is where it says; others are where they go from their rest pose.
void set_zero(const Joints& joints, const Take& take, CarriedJoint& carried) {
  if (take.scene().is_capture) {
    carried.zero = origin_of(joints, carried.joint);
    return;
  }
  const std::vector<std::size_t> self = {carried.joint};
  const std::vector<std::size_t> tops = carried.legs.carriers();
  const std::vector<std::size_t>& middle = tops.empty() ? self : tops;
  for (const std::size_t joint : middle) {
    carried.zero += joints[joint].place / static_cast<double>(middle.size());
    carried.taken_zero += take.rest(joints[joint].at) / static_cast<double>(middle.size());
  }
}

}  // namespace

Puppet::Puppet(std::size_t joints)
    : is_turned(joints, 0),
      wanted(joints, glm::dquat(1, 0, 0, 0)),
      turns(wanted),
      local(wanted),
      model_from_joint(joints, glm::dmat4(1.0)),
      is_put(joints, 0),
      local_place(joints, glm::dvec3(0)) {}

void Puppet::pose(const RetargetPlan& plan) {
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    const RetargetJoint& joint = plan.joints[j];
    const bool is_root = joint.parent == kNone;
    const glm::dquat turn_above = is_root ? joint.turn_above : turns[to_index(joint.parent)];
    Transform below = joint.rest;
    if (is_put[j] != 0) below.translation = local_place[j];
    if (is_turned[j] != 0) {
      const glm::dquat turned = glm::normalize(glm::conjugate(turn_above) * wanted[j]);
      below.rotation = joint.is_in_mirror ? in_mirrored(turned) : turned;
    }
    local[j] = below.rotation;
    turns[j] = turn_above * (joint.is_in_mirror ? in_mirrored(below.rotation) : below.rotation);
    model_from_joint[j] = (is_root ? joint.scene_above : model_from_joint[to_index(joint.parent)]) * matrix_of(below);
  }
}

void Puppet::put(const RetargetPlan& plan, std::size_t joint, const glm::dvec3& place) {
  const RetargetJoint& of = plan.joints[joint];
  const glm::dmat4& above = of.parent == kNone ? of.scene_above : model_from_joint[to_index(of.parent)];
  local_place[joint] = glm::dvec3(glm::inverse(above) * glm::dvec4(place, 1));
  is_put[joint] = 1;
}

glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to) {
  const double w = 1 + glm::dot(from, to);
  if (w > 1e-9) return glm::normalize(glm::dquat(w, glm::cross(from, to)));
  const glm::dvec3 other = std::abs(from.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return {0, glm::normalize(glm::cross(from, other))};
}

std::vector<RetargetJoint> lay_out(const BuiltSkeleton& skeleton, const std::vector<Counterpart>& pairs) {
  const std::vector<Transform> rest = rest_transforms(skeleton);
  Joints out(rest.size());
  std::vector<char> mirrored(rest.size(), 0);  // the space of a joint
  for (std::size_t j = 0; j < out.size(); ++j) {
    RetargetJoint& joint = out[j];
    joint.at = pairs[j];
    joint.rest = rest[j];
    glm::dquat turn_above;
    if (skeleton.parents[j] == kNoJoint) {
      joint.scene_above = to_matrix(skeleton.model_from_root[j]);
      joint.turn_above = turn_above = rotation_of(joint.scene_above);
      joint.is_in_mirror = glm::determinant(glm::dmat3(joint.scene_above)) < 0;
      joint.model_from_joint = joint.scene_above * matrix_of(rest[j]);
    } else {
      joint.parent = skeleton.parents[j];
      const RetargetJoint& parent = out[to_index(joint.parent)];
      joint.upper = parent.at.is_there() ? joint.parent : parent.upper;
      joint.is_in_mirror = mirrored[to_index(joint.parent)] != 0;
      turn_above = parent.turn;
      joint.model_from_joint = parent.model_from_joint * matrix_of(rest[j]);
    }
    const glm::dvec3& scale = rest[j].scale;
    const bool is_mirror = (scale.x < 0) != ((scale.y < 0) != (scale.z < 0));
    mirrored[j] = joint.is_in_mirror != is_mirror ? 1 : 0;
    joint.turn = turn_above * (joint.is_in_mirror ? in_mirrored(rest[j].rotation) : rest[j].rotation);
    joint.place = glm::dvec3(joint.model_from_joint[3]);
  }
  return out;
}

glm::dvec3 origin_of(const Joints& joints, std::size_t joint) {
  while (joints[joint].parent != kNone) joint = to_index(joints[joint].parent);
  return glm::dvec3(joints[joint].scene_above[3]);
}

RetargetPlan plan_retarget(const BuiltSkeleton& skeleton, const BuiltSkeleton& rig,
                           const std::vector<Counterpart>& pairs, const Take& take) {
  const int hips = joint_with(skeleton, Role::hips);
  return plan_carrying(choose_carried(lay_out(skeleton, pairs), hips, take), skeleton, rig, pairs, take);
}

RetargetPlan plan_carrying(const std::vector<std::size_t>& carried, const BuiltSkeleton& skeleton,
                           const BuiltSkeleton& rig, const std::vector<Counterpart>& pairs, const Take& take) {
  RetargetPlan out;
  out.joints = lay_out(skeleton, pairs);
  out.facing_deg = facing_of(out.joints, take);
  out.facing = turn_about_y(out.facing_deg);
  const std::vector<glm::dquat> arcs =
      arcs_with(standing(skeleton), out.joints, bones_of(out.joints, take, out.facing));
  for (std::size_t j = 0; j < arcs.size(); ++j) out.joints[j].aligned = arcs[j] * out.joints[j].turn;
  std::vector<Legs> legs = find_legs(skeleton, rig, out.joints, carried, take);
  double scale = 0;  // of the legs
  for (const Legs& of : legs)
    if (!of.tops.empty() && scale == 0) scale = of.length / of.taken_length;
  for (std::size_t c = 0; c < carried.size(); ++c) {
    const bool has_legs = !legs[c].tops.empty();
    const double own = has_legs                                ? legs[c].length / legs[c].taken_length
                       : scale > 0 && !take.scene().is_capture ? scale
                                                               : scale_below(out.joints, carried[c], take);
    out.carried.push_back({carried[c], own, {}, {}, std::move(legs[c])});
    set_zero(out.joints, take, out.carried.back());
  }
  return out;
}
}  // namespace marrow::cook
