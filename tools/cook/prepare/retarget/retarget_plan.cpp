#include "cook/prepare/retarget/retarget_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "cook/scene/matrices.h"
#include "deform/rotation_of_matrix.h"

namespace marrow::cook {
namespace {

constexpr double kCosineOf15Degrees = 0.9659258262890683;
// Of fingers that tell of a roll: they spread by 4 degrees or more, and alike.
constexpr double kNarrow = 0.001, kOneShape = 0.7;
constexpr double kFlat = 0.05;  // skeletons that reach less far sideways than that, of their size, face nowhere

using Joints = std::vector<RetargetJoint>;

// Of what stands above a root. A mirror is a rotation and a point reflection, in which all rotations are the same.
glm::dquat rotation_of(const glm::dmat4& m) {
  const glm::dmat3 linear(m);
  return deform::quaternion_of(deform::rotation_of(glm::determinant(linear) < 0 ? -linear : linear));
}

Joints lay_out(const BuiltSkeleton& skeleton, const std::vector<int>& node_of_joint) {
  const std::vector<Transform> rest = rest_transforms(skeleton);
  std::vector<glm::dmat4> model_from_joint;
  Joints out(rest.size());
  for (std::size_t j = 0; j < out.size(); ++j) {
    RetargetJoint& joint = out[j];
    joint.node = node_of_joint[j];
    joint.rest = rest[j];
    glm::dquat turn_above;
    if (skeleton.parents[j] == kNoJoint) {
      joint.scene_above = to_matrix(skeleton.model_from_root[j]);
      joint.turn_above = turn_above = rotation_of(joint.scene_above);
      model_from_joint.push_back(joint.scene_above * matrix_of(rest[j]));
    } else {
      joint.parent = skeleton.parents[j];
      const RetargetJoint& parent = out[to_index(joint.parent)];
      joint.upper = parent.node == kNone ? parent.upper : joint.parent;
      turn_above = parent.turn;
      model_from_joint.push_back(model_from_joint[to_index(joint.parent)] * matrix_of(rest[j]));
    }
    joint.turn = turn_above * rest[j].rotation;
    joint.place = glm::dvec3(model_from_joint[j][3]);
  }
  return out;
}

std::vector<glm::dvec3> places_at_rest(const RawScene& capture) {
  std::vector<glm::dvec3> out;
  for (const RawNode& node : capture.nodes)
    out.push_back(node.translation + (node.parent == kNone ? glm::dvec3(0) : out[to_index(node.parent)]));
  return out;
}

// The turn about y, of those by quarters, after which paired joints lie most alike.
int facing_of(const Joints& joints, const std::vector<glm::dvec3>& captured) {
  glm::dvec3 middle(0), captured_middle(0);
  double count = 0, along = 0, across = 0, size = 0, captured_size = 0;
  for (const RetargetJoint& joint : joints) {
    if (joint.node == kNone) continue;
    middle += joint.place;
    captured_middle += captured[to_index(joint.node)];
    ++count;
  }
  for (const RetargetJoint& joint : joints) {
    if (joint.node == kNone) continue;
    const glm::dvec3 a = joint.place - middle / count, b = captured[to_index(joint.node)] - captured_middle / count;
    along += a.x * b.x + a.z * b.z;
    across += a.x * b.z - a.z * b.x;
    size += glm::dot(a, a);
    captured_size += glm::dot(b, b);
  }
  const double clear = kFlat * std::sqrt(size) * std::sqrt(captured_size);
  if (along >= std::abs(across) || !(std::max(-along, std::abs(across)) > clear)) return 0;
  if (-along >= std::abs(across)) return 180;
  return across > 0 ? 90 : -90;
}

glm::dquat turn_about_y(int degrees) {
  const double half = std::sqrt(0.5);
  if (degrees == 0) return {1, 0, 0, 0};
  return degrees == 180 ? glm::dquat(0, 0, 1, 0) : glm::dquat(half, 0, degrees > 0 ? half : -half, 0);
}

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
Bones bones_of(const Joints& joints, const std::vector<glm::dvec3>& captured, const glm::dquat& facing) {
  Bones out{std::vector<glm::dvec3>(joints.size(), glm::dvec3(0)), {}};
  out.captured = out.own;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const RetargetJoint& joint = joints[j];
    if (joint.node == kNone || joint.upper == kNone) continue;
    const RetargetJoint& upper = joints[to_index(joint.upper)];
    const glm::dvec3 bone = joint.place - upper.place;
    const glm::dvec3 other = facing * (captured[to_index(joint.node)] - captured[to_index(upper.node)]);
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

// A of every joint.
std::vector<glm::dquat> arcs_of(const Joints& joints, const std::vector<glm::dvec3>& captured,
                                const glm::dquat& facing) {
  const Bones bones = bones_of(joints, captured, facing);
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
      if (lies_flat(bones.captured[j]) || std::abs(above.w) < kCosineOf15Degrees) out[j] = above;
    } else if (of.lie_about_one_way()) {
      is_foot[j] = heading_arc(bones.captured[j], of.own, of.captured, out[j]) ? 1 : 0;
      if (is_foot[j] == 0) out[j] = arc(glm::normalize(of.own), glm::normalize(of.captured));
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

// Lengths of the character in those of the capture.
double scale_below(const Joints& joints, std::size_t carried, const std::vector<glm::dvec3>& captured) {
  const auto lengths = [&](const RetargetJoint& joint) {
    if (joint.node == kNone || joint.upper == kNone) return glm::dvec2(0);
    const RetargetJoint& upper = joints[to_index(joint.upper)];
    return glm::dvec2(glm::length(joint.place - upper.place),
                      glm::length(captured[to_index(joint.node)] - captured[to_index(upper.node)]));
  };
  std::vector<char> below(joints.size(), 0);
  std::size_t lowest = carried;
  glm::dvec2 all(0), way(0);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    all += lengths(joints[j]);
    below[j] = j == carried || (joints[j].parent != kNone && below[to_index(joints[j].parent)] != 0);
    if (below[j] != 0 && joints[j].node != kNone && joints[j].place.y < joints[lowest].place.y) lowest = j;
  }
  for (std::size_t j = lowest; j != carried; j = to_index(joints[j].upper)) way += lengths(joints[j]);
  if (way.x > 0 && way.y > 0) return way.x / way.y;
  return all.x > 0 && all.y > 0 ? all.x / all.y : 1;
}

// Whether the capture moves a node from its place, or one above it.
std::vector<char> moved_nodes(const RawScene& capture) {
  std::vector<char> out(capture.nodes.size(), 0);
  for (const RawChannel& channel : capture.clips.at(0).channels) {
    const auto elsewhere = [&](const glm::vec4& place) { return place != channel.values[0]; };
    if (channel.path == RawPath::translation && std::ranges::any_of(channel.values, elsewhere))
      out[to_index(channel.node)] = 1;
  }
  for (std::size_t n = 0; n < out.size(); ++n)
    if (capture.nodes[n].parent != kNone && out[to_index(capture.nodes[n].parent)] != 0) out[n] = 1;
  return out;
}

}  // namespace

glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to) {
  const double w = 1 + glm::dot(from, to);
  if (w > 1e-9) return glm::normalize(glm::dquat(w, glm::cross(from, to)));
  const glm::dvec3 other = std::abs(from.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return {0, glm::normalize(glm::cross(from, other))};
}

RetargetPlan plan_retarget(const BuiltSkeleton& skeleton, const std::vector<int>& node_of_joint,
                           const RawScene& capture) {
  RetargetPlan out;
  out.joints = lay_out(skeleton, node_of_joint);
  const std::vector<glm::dvec3> captured = places_at_rest(capture);
  out.facing_deg = facing_of(out.joints, captured);
  out.facing = turn_about_y(out.facing_deg);
  const std::vector<glm::dquat> arcs = arcs_of(out.joints, captured, out.facing);
  const std::vector<char> moved = moved_nodes(capture);
  std::vector<char> within(out.joints.size(), 0);
  std::vector<std::size_t> carried;
  for (std::size_t j = 0; j < out.joints.size(); ++j) {
    RetargetJoint& joint = out.joints[j];
    joint.aligned = arcs[j] * joint.turn;
    if (joint.parent != kNone) within[j] = within[to_index(joint.parent)];
    if (within[j] != 0 || joint.node == kNone || moved[to_index(joint.node)] == 0) continue;
    within[j] = 1;
    carried.push_back(j);
  }
  for (Legs& legs : find_legs(out.joints, carried, capture.nodes, captured)) {
    const std::size_t joint = carried[out.carried.size()];
    const double scale =
        legs.tops.empty() ? scale_below(out.joints, joint, captured) : legs.length / legs.captured_length;
    out.carried.push_back({joint, scale, std::move(legs)});
  }
  return out;
}

}  // namespace marrow::cook
