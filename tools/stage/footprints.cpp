#include "stage/footprints.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "common/check_status.h"
#include "marrow/roles.h"

namespace marrow::tools {
namespace {

// M(t), rounds of a loop included.
glm::mat4 root_at(const ClipMotion& motion, double time_s) {
  const auto duration = static_cast<double>(motion.duration_s);
  const double rounds = duration > 0 ? std::floor(time_s / duration) : 0;
  Playback from{.mode = PlayMode::loop}, to{.time_s = time_s - rounds * duration, .mode = PlayMode::loop};
  to.time_s = std::clamp(to.time_s, 0.0, duration);
  to.turns = static_cast<std::int32_t>(rounds);
  RigidStep step;
  check(root_step(motion, from, to, step));
  glm::mat4 out = glm::mat4_cast(glm::quat(step.rotation[3], step.rotation[0], step.rotation[1], step.rotation[2]));
  out[3] = glm::vec4(step.translation[0], step.translation[1], step.translation[2], 1);
  return out;
}

// Where a joint stands at a moment, and a point of it.
glm::vec3 placed(const File& file, const Play& play, std::uint32_t joint, const float* point, float time_s) {
  Character probe(file);
  probe.pose(play, time_s);
  const Affine& m = probe.model_from_joint(play.motion_skeleton)[joint];
  glm::vec3 out;
  for (int r = 0; r < 3; ++r)
    out[r] = m.rows[r][0] * point[0] + m.rows[r][1] * point[1] + m.rows[r][2] * point[2] + m.rows[r][3];
  return out;
}

glm::vec3 heading_of(const ClipMotion& m) {
  return {m.heading[0], m.heading[1], m.heading[2]};
}

}  // namespace

Footprints::Footprints(const File& file, const Play& play) : motion_(play.motion) {
  const Roles roles = file.roles(play.motion_skeleton);
  const float origin[3] = {0, 0, 0};
  for (const ClipEvent& e : motion_.events) {
    names_.emplace_back(play.clips.text(e.name));
    const Role role = find_role(names_.back().c_str());
    const std::uint16_t joint = joint_of(roles, role);
    const JointSole* const sole = joint != kNoJoint ? sole_of(roles, joint) : nullptr;
    if (sole == nullptr) continue;
    const float middle = 0.5f * (e.time_s + e.until_s), time_s = std::fmod(middle, std::max(motion_.duration_s, 1e-6f));
    const glm::vec3 at = placed(file, play, joint, sole->place, time_s);
    prints_.push_back({role, e.time_s, e.until_s, at});
    prints_.back().at = glm::vec3(ground_since(middle, e.time_s) * glm::vec4(at, 1));
  }
  if (!motion_.root.empty() || motion_.duration_s <= 0) return;
  const std::uint16_t hips = joint_of(roles, Role::hips);
  const std::uint32_t joint = hips != kNoJoint ? hips : 0;
  const glm::vec3 way = placed(file, play, joint, origin, motion_.duration_s) - placed(file, play, joint, origin, 0);
  ground_m_s_ = glm::vec3(way.x, 0, way.z) / motion_.duration_s - motion_.speed_m_s * heading_of(motion_);
  if (glm::length(ground_m_s_) < 0.1f * motion_.speed_m_s) ground_m_s_ = glm::vec3(0);
}

std::vector<float> Footprints::heights() const {
  std::vector<float> out;
  for (const Footprint& print : prints_) out.push_back(print.at.y);
  return out;
}

// How what lies on the ground has moved in the character's eyes.
glm::mat4 Footprints::ground_since(double from_s, double to_s) const {
  if (!motion_.root.empty()) return glm::inverse(root_at(motion_, to_s)) * root_at(motion_, from_s);
  glm::mat4 out(1);
  out[3] = glm::vec4(static_cast<float>(to_s - from_s) * ground_m_s_, 1);
  return out;
}

std::vector<Footprints::Carried> Footprints::at(float time_s) const {
  const auto now = static_cast<double>(time_s), duration = static_cast<double>(motion_.duration_s);
  std::vector<Carried> out;
  for (const Footprint& print : prints_)
    for (int round = -1; round <= 1; ++round) {
      const double from = static_cast<double>(print.time_s) + round * duration,
                   until = static_cast<double>(print.until_s) + round * duration;
      out.push_back(
          {glm::vec3(ground_since(from, now) * glm::vec4(print.at, 1)), print.role, from <= now && now <= until});
    }
  return out;
}

std::vector<glm::vec3> Footprints::path(float time_s) const {
  constexpr int kPieces = 48;
  std::vector<glm::vec3> out;
  const auto now = static_cast<double>(time_s), duration = static_cast<double>(motion_.duration_s);
  for (int i = 0; i <= kPieces && motion_.speed_m_s > 0; ++i)
    out.emplace_back(ground_since(duration * i / kPieces, now)[3]);
  return out;
}

}  // namespace marrow::tools
