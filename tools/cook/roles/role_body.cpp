#include "cook/roles/role_body.h"

#include <algorithm>

#include <glm/mat4x4.hpp>

#include "cook/scene/matrices.h"
#include "cook/scene/views.h"

namespace marrow::cook {

namespace {

void number_joints(Body& body) {
  const std::size_t count = body.size();
  std::vector<std::uint32_t> below(count, 1);  // itself, and what hangs on it
  for (std::size_t j = count; j-- > 0;)
    if (body.parents[j] != kNone) below[to_index(body.parents[j])] += below[j];
  body.order.assign(count, 0);
  std::uint32_t next = 0;
  for (std::size_t j = 0; j < count; ++j) {
    if (body.parents[j] == kNone) {
      body.order[j] = next;
      next += below[j];
    }
    std::uint32_t at = body.order[j] + 1;
    for (const int child : body.children[j]) {
      body.order[to_index(child)] = at;
      at += below[to_index(child)];
    }
    body.end_below.push_back(at);
  }
}

}  // namespace

int Body::common(int a, int b) const {
  if (a == kNone || b == kNone) return kNone;
  while (a != b) {
    int& lower = a > b ? a : b;  // a parent has the lower number
    lower = parent(lower);
    if (lower == kNone) return kNone;
  }
  return a;
}

std::vector<int> Body::way(int above, int joint) const {
  std::vector<int> out;
  for (; joint != above && joint != kNone; joint = parent(joint)) out.push_back(joint);
  std::ranges::reverse(out);
  return out;
}

bool Body::is_end(int joint) const {
  if (!part(joint).is_end) return false;
  return std::ranges::all_of(children[to_index(joint)],
                             [&](int child) { return part(child).is_end && children[to_index(child)].empty(); }) &&
         (children[to_index(joint)].empty() || part(joint).part != Part::tail);
}

void Body::give(Role role, int joint) {
  if (joint == kNone || this->role(joint) != Role::none) return;
  int& first = first_[static_cast<std::size_t>(role)];
  if (role != Role::tail && first != kNone) return;
  roles_[to_index(joint)] = role;
  first = first == kNone ? joint : std::min(first, joint);
}

void Body::take(Role role) {
  int& first = first_[static_cast<std::size_t>(role)];
  if (first == kNone) return;
  std::ranges::replace(roles_, role, Role::none);
  first = kNone;
}

void Body::set(Role role, int joint) {
  if (role != Role::tail) take(role);
  if (const Role old = this->role(joint); old != Role::none) {
    roles_[to_index(joint)] = Role::none;
    const auto next = std::ranges::find(roles_, old);
    first_[static_cast<std::size_t>(old)] = next == roles_.end() ? kNone : static_cast<int>(next - roles_.begin());
  }
  give(role, joint);
}

Body body_of(const BuiltSkeleton& skeleton) {
  Body out;
  const std::size_t count = skeleton.parents.size();
  out.names = skeleton.joint_names;
  out.parts = parts_of(out.names, skeleton.parents);
  out.children.resize(count);
  out.roles_.assign(count, Role::none);
  out.first_.fill(kNone);
  const std::vector<Transform> rest = rest_transforms(skeleton);
  for (std::size_t j = 0; j < count; ++j) {
    const bool is_root = skeleton.parents[j] == kNoJoint;
    out.parents.push_back(is_root ? kNone : skeleton.parents[j]);
    const glm::dmat4 above =
        is_root ? to_matrix(skeleton.model_from_root[j]) : out.model_from_joint[skeleton.parents[j]];
    out.model_from_joint.push_back(above * matrix_of(rest[j]));
    out.places.emplace_back(out.model_from_joint[j][3]);
    if (!is_root) out.children[skeleton.parents[j]].push_back(static_cast<int>(j));
  }
  number_joints(out);
  return out;
}

Role other_side(Role role) {
  const auto move = [&](Role left, Role right, unsigned count) {
    const auto n = static_cast<unsigned>(role), l = static_cast<unsigned>(left), r = static_cast<unsigned>(right);
    if (n >= l && n < l + count)
      role = static_cast<Role>(n - l + r);
    else if (n >= r && n < r + count)
      role = static_cast<Role>(n - r + l);
  };
  move(Role::left_eye, Role::right_eye, 1);
  move(Role::left_shoulder, Role::right_shoulder, 4);
  move(Role::left_upper_leg, Role::right_upper_leg, 4);
  move(Role::left_thumb_metacarpal, Role::right_thumb_metacarpal, 15);
  return role;
}

}  // namespace marrow::cook
