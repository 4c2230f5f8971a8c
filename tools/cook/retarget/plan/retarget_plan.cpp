#include "cook/retarget/plan/retarget_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "cook/retarget/plan/alike_pose.h"
#include "cook/retarget/plan/pair_rigs.h"
#include "cook/scene/matrices.h"
#include "deform/rotations.h"
#include "marrow/roles.h"

namespace marrow::cook {
namespace {

constexpr double kFlat = 0.05;  // skeletons that reach less far sideways than that, of their size, face nowhere

using Joints = std::vector<RetargetJoint>;

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
  const std::vector<glm::dquat> arcs = arcs_of(skeleton, out.joints, take, out.facing);
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
