#include "cook/prepare/retarget_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "cook/scene/matrices.h"
#include "deform/rotation_of_matrix.h"

namespace marrow::cook {
namespace {

constexpr double kCosineOf15Degrees = 0.9659258262890683;
constexpr double kFlat = 0.05;  // skeletons that reach less far sideways than that, of their size, face nowhere

using Joints = std::vector<RetargetJoint>;

// Of what stands above a root. A mirror is a rotation and a point reflection, in which all rotations are the same.
glm::dquat rotation_of(const glm::dmat4& m) {
  const glm::dmat3 linear(m);
  return deform::quaternion_of(deform::rotation_of(glm::determinant(linear) < 0 ? -linear : linear));
}

Joints lay_out(const BuiltSkeleton& skeleton, const std::vector<int>& node_of_joint) {
  const std::vector<Transform> rest = rest_transforms(skeleton);
  std::vector<glm::dmat4> scene_from_joint;
  Joints out(rest.size());
  for (std::size_t j = 0; j < out.size(); ++j) {
    RetargetJoint& joint = out[j];
    joint.node = node_of_joint[j];
    joint.rest = rest[j];
    glm::dquat turn_above;
    if (skeleton.parents[j] == kNoParent) {
      joint.scene_above = to_matrix(skeleton.scene_from_root[j]);
      joint.turn_above = turn_above = rotation_of(joint.scene_above);
      scene_from_joint.push_back(joint.scene_above * matrix_of(rest[j]));
    } else {
      joint.parent = skeleton.parents[j];
      const RetargetJoint& parent = out[to_index(joint.parent)];
      joint.upper = parent.node == kNone ? parent.upper : joint.parent;
      turn_above = parent.turn;
      scene_from_joint.push_back(scene_from_joint[to_index(joint.parent)] * matrix_of(rest[j]));
    }
    joint.turn = turn_above * rest[j].rotation;
    joint.place = glm::dvec3(scene_from_joint[j][3]);
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

// The shortest turn that takes one direction to another; both of length 1.
glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to) {
  const double w = 1 + glm::dot(from, to);
  if (w > 1e-9) return glm::normalize(glm::dquat(w, glm::cross(from, to)));
  const glm::dvec3 other = std::abs(from.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return {0, glm::normalize(glm::cross(from, other))};
}

// A of every joint.
std::vector<glm::dquat> arcs_of(const Joints& joints, const std::vector<glm::dvec3>& captured,
                                const glm::dquat& facing) {
  struct Below {  // sums of directions
    glm::dvec3 bones{0}, captured{0};
    double count = 0;
  };
  std::vector<Below> below(joints.size());
  for (const RetargetJoint& joint : joints) {
    if (joint.node == kNone || joint.upper == kNone) continue;
    const RetargetJoint& upper = joints[to_index(joint.upper)];
    const glm::dvec3 bone = joint.place - upper.place;
    const glm::dvec3 other = facing * (captured[to_index(joint.node)] - captured[to_index(upper.node)]);
    const double length = glm::length(bone), other_length = glm::length(other);
    if (!(length > 0) || !(other_length > 0)) continue;
    Below& of = below[to_index(joint.upper)];
    of.bones += bone / length;
    of.captured += other / other_length;
    ++of.count;
  }
  std::vector<glm::dquat> out(joints.size(), glm::dquat(1, 0, 0, 0));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Below& of = below[j];
    const double length = glm::length(of.bones), other_length = glm::length(of.captured);
    if (of.count == 0) {
      const int upper = joints[j].upper;
      if (upper != kNone && std::abs(out[to_index(upper)].w) < kCosineOf15Degrees) out[j] = out[to_index(upper)];
    } else if (2 * std::min(length, other_length) >= of.count) {
      out[j] = arc(of.bones / length, of.captured / other_length);
    }
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
  for (std::size_t j = 0; j < out.joints.size(); ++j) {
    RetargetJoint& joint = out.joints[j];
    joint.aligned = arcs[j] * joint.turn;
    if (joint.parent != kNone) within[j] = within[to_index(joint.parent)];
    if (within[j] != 0 || joint.node == kNone || moved[to_index(joint.node)] == 0) continue;
    within[j] = 1;
    joint.carried = scale_below(out.joints, j, captured);
  }
  return out;
}

}  // namespace marrow::cook
