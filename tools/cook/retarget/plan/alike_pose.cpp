#include "cook/retarget/plan/alike_pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "cook/retarget/plan/pair_rigs.h"
#include "cook/retarget/plan/retarget_feet.h"
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

}  // namespace

glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to) {
  const double w = 1 + glm::dot(from, to);
  if (w > 1e-9) return glm::normalize(glm::dquat(w, glm::cross(from, to)));
  const glm::dvec3 other = std::abs(from.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return {0, glm::normalize(glm::cross(from, other))};
}

std::vector<glm::dquat> arcs_of(const BuiltSkeleton& skeleton, const std::vector<RetargetJoint>& joints,
                                const Take& take, const glm::dquat& facing) {
  return arcs_with(standing(skeleton), joints, bones_of(joints, take, facing));
}

}  // namespace marrow::cook
