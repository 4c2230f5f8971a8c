#include "story/adjust.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/check_status.h"
#include "common/failure.h"

namespace marrow::tools {
namespace {

// A foot whose lowest point is higher than that does not stand, metres.
constexpr float kLifted = 0.012f;
constexpr float kMostAside = 1.05f, kMostUp = 0.6f;  // of the look, radians
constexpr float kHeelBehindAnkle = 0.03f, kToesBeforeBall = 0.06f;

void put(float (&to)[3], const glm::vec3& v) {
  for (int c = 0; c < 3; ++c) to[c] = v[c];
}

glm::vec3 moved(const Affine& by, const glm::vec3& p) {
  return glm::vec3(to_glm(by) * glm::vec4(p, 1));
}

// Directions of the model, in a joint's space at rest.
void face_ahead(Aim& aim, const Affine& at_rest) {
  const glm::mat4 back = glm::inverse(to_glm(at_rest));
  put(aim.forward, glm::normalize(glm::vec3(back * glm::vec4(0, 0, 1, 0))));
  put(aim.up, glm::normalize(glm::vec3(back * glm::vec4(0, 1, 0, 0))));
  aim.pole[1] = 1;
}

}  // namespace

std::uint32_t joint_with(const Roles& roles, Role role) {
  const std::uint16_t joint = joint_of(roles, role);
  if (joint == kNoJoint)
    throw Failure(Exit::internal, "the sample", "", std::string("no ") + role_name(role), "please report this");
  return joint;
}

Adjuster::Adjuster(const File& file) {
  const Skeleton skeleton = file.skeleton(0);
  const Roles roles = file.roles(0);
  std::vector<Affine> rest(skeleton.joint_count);
  check(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, rest));
  const Role roles_of[kFeet][2] = {{Role::left_foot, Role::left_toes}, {Role::right_foot, Role::right_toes}};
  for (std::size_t i = 0; i < kFeet; ++i) {
    check(foot_of(roles, roles_of[i][0], feet_[i]));
    const std::uint32_t ankle = feet_[i].ankle, toes = joint_with(roles, roles_of[i][1]);
    const auto at = [&](std::uint32_t joint) { return moved(rest[joint], {0, 0, 0}); };
    const auto below = [&](std::uint32_t joint, glm::vec3 place) {
      place.y = 0;
      return Part{joint, moved(from_glm(glm::inverse(to_glm(rest[joint]))), place)};
    };
    soles_[i] = {below(ankle, at(ankle) - glm::vec3(0, 0, kHeelBehindAnkle)), below(toes, at(toes)),
                 below(toes, at(toes) + glm::vec3(0, 0, kToesBeforeBall))};
    // Clips roll the foot about the ball, so that joint is what stays.
    put(feet_[i].sole, moved(from_glm(glm::inverse(to_glm(rest[ankle]))), at(toes)));
  }
  both_.feet = feet_;
  both_.pelvis = joint_with(roles, Role::hips);
  both_.lower_m = 0.1f;
  head_ = joint_with(roles, Role::head);
  gaze_ = {joint_with(roles, Role::neck), head_};
  face_ahead(look_, rest[head_]);
  for (int side = 0; side < 2; ++side) {
    eyes_[static_cast<std::size_t>(side)] = joint_of(roles, side == 0 ? Role::left_eye : Role::right_eye);
    if (eyes_[static_cast<std::size_t>(side)] != kNoJoint)
      face_ahead(eye_[side], rest[eyes_[static_cast<std::size_t>(side)]]);
  }
  trunk_ = {joint_with(roles, Role::spine), joint_with(roles, Role::chest)};
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j)
    if (role_of(roles, j) == Role::tail) tail_.push_back(j);
  const glm::mat4 back = glm::inverse(to_glm(rest[tail_.back()]));
  put(trail_.forward, glm::normalize(glm::vec3(back * glm::vec4(0, 0, -1, 0))));
}

glm::vec3 Adjuster::ball(std::size_t foot, Span<const Affine> world_from_joint) const {
  glm::vec3 out = moved(world_from_joint[soles_[foot][1].joint], {0, 0, 0});
  out.y = 0;
  return out;
}

float Adjuster::height(std::size_t foot, Span<const Affine> world_from_joint) const {
  float out = 1e9f;
  for (const Part& part : soles_[foot]) out = std::min(out, moved(world_from_joint[part.joint], part.place).y);
  return out;
}

float Adjuster::heading(std::size_t foot, Span<const Affine> world_from_joint) const {
  const glm::vec3 way =
      moved(world_from_joint[soles_[foot][1].joint], {0, 0, 0}) - moved(world_from_joint[feet_[foot].ankle], {0, 0, 0});
  return std::atan2(way.x, way.z);
}

glm::vec3 Adjuster::head(Span<const Affine> world_from_joint) const {
  return moved(world_from_joint[head_], {0, 0, 0});
}

float Adjuster::sunk(const Pose& pose) const {
  float lowest = 0;
  for (std::size_t i = 0; i < kFeet; ++i) lowest = std::min(lowest, height(i, pose.model_from_joint));
  return -lowest;
}

void Adjuster::place(const Pose& pose, const Affine& world_from_model, float dt_s) {
  std::array<FootGround, kFeet> ground;
  for (std::size_t i = 0; i < kFeet; ++i) {
    const float animated = height(i, pose.model_from_joint) + world_from_model.rows[1][3];
    planted_[i] = (planted_[i] || wait_s_[i] > 0) && animated < kLifted;
    wait_s_[i] = planted_[i] ? 0 : wait_s_[i] - dt_s;
    ground[i].planted = planted_[i];
  }
  FeetFrame frame;
  frame.dt_s = dt_s;
  frame.world_from_model = world_from_model;
  check(place_feet(pose, both_, frame, ground, motions_));
}

void Adjuster::look(const Pose& pose, const Affine& world_from_model, const glm::vec3& target, float head_weight,
                    float eyes_weight) const {
  const glm::vec3 in_model = glm::vec3(glm::inverse(to_glm(world_from_model)) * glm::vec4(target, 1));
  const glm::vec3 head = moved(pose.model_from_joint[head_], {0, 0, 0});
  const glm::vec3 way = in_model - head;
  const float aside = std::atan2(way.x, way.z), up = std::atan2(way.y, std::hypot(way.x, way.z));
  // It turns as far as a neck does; what is behind it, it does not look at.
  const float ahead = 1 - glm::smoothstep(1.5f, 2.3f, std::abs(aside));
  const float yaw = std::clamp(aside, -kMostAside, kMostAside), pitch = std::clamp(up, -kMostUp, kMostUp);
  const glm::vec3 seen =
      head + std::max(glm::length(way), 0.5f) *
                 glm::vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
  Aim aim = look_;
  put(aim.target, seen);
  aim.weight = head_weight * ahead;
  check(solve_look_at(pose, gaze_, aim, 0.7f));
  for (std::size_t e = 0; e < eyes_.size(); ++e) {
    if (eyes_[e] == kNoJoint) continue;
    Aim eye = eye_[e];
    put(eye.target, seen);
    eye.weight = eyes_weight * ahead;
    check(solve_aim(pose, eyes_[e], eye));
  }
}

void Adjuster::lean(const Pose& pose, float left_rad) const {
  const glm::mat4 chest = to_glm(pose.model_from_joint[trunk_.back()]);
  const glm::vec3 up = glm::normalize(glm::vec3(chest[1])), at(chest[3]);
  Aim aim;
  put(aim.forward, {0, 1, 0});  // along its bone
  put(aim.target, at + 10.0f * (std::cos(left_rad) * up + std::sin(left_rad) * glm::vec3(1, 0, 0)));
  check(solve_look_at(pose, trunk_, aim, 1));
}

void Adjuster::trail(const Pose& pose, const Affine& world_from_model, const glm::vec3& target, float weight) const {
  glm::vec3 in_model = glm::vec3(glm::inverse(to_glm(world_from_model)) * glm::vec4(target, 1));
  in_model.y = moved(pose.model_from_joint[tail_.back()], {0, 0, 0}).y;
  Aim aim = trail_;
  put(aim.target, in_model);
  aim.weight = weight;
  check(solve_look_at(pose, tail_, aim, 1));
}

}  // namespace marrow::tools
