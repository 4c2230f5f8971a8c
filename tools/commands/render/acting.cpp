#include "commands/render/acting.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/failure.h"

namespace marrow::tools {
namespace {

constexpr double kStepsPerSecond = 60;
constexpr float kAfterScript_s = 2;
constexpr float kAnkleToBall = 0.45f;  // of a foot's length
constexpr float kLeastFoot = 0.09f;    // of the character's size

glm::vec3 place_of(const Affine& m) {
  return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
}
glm::vec3 point_of(const Affine& m, const float* p) {
  glm::vec3 out;
  for (int r = 0; r < 3; ++r) out[r] = m.rows[r][0] * p[0] + m.rows[r][1] * p[1] + m.rows[r][2] * p[2] + m.rows[r][3];
  return out;
}
glm::vec3 level(glm::vec3 v) {
  return {v.x, 0, v.z};
}

}  // namespace

Acting::Acting(const std::string& path, const File& file, const ActingArguments& arguments)
    : behaviour_(path, file, arguments.behaviour) {
  const FoundGraph& found = behaviour_.found();
  if (!arguments.script.empty()) lines_ = read_script(arguments.script, found.file, found.graph);
  const float last_s = lines_.empty() ? 0 : static_cast<float>(lines_.back().time_s);
  duration_s_ = arguments.seconds.value_or(last_s + kAfterScript_s);
  find_feet(file);
}

void Acting::find_feet(const File& file) {
  Character rest(file);
  rest.pose({}, 0);
  Box joints;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s)
    for (const Affine& joint : rest.model_from_joint(s)) joints.add(place_of(joint));
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const Roles roles = file.roles(s);
    for (const JointSole& sole : roles.soles) {
      Foot foot{role_of(roles, sole.joint), s, sole.joint, {sole.place[0], sole.place[1], sole.place[2]}, 0};
      const Affine& ankle = rest.model_from_joint(s)[sole.joint];
      foot.length_m = std::max(glm::length(level(point_of(ankle, foot.ball) - place_of(ankle))) / kAnkleToBall,
                               kLeastFoot * 2 * joints.radius());
      feet_.push_back(foot);
    }
  }
}

std::vector<Acting::Met> Acting::play_to(double time_s, const OnStep& on_step) {
  std::vector<Met> met;
  if (now_s_ < 0 || time_s < now_s_) {
    behaviour_.restart();
    prints_.clear();
    next_line_ = 0;
    now_s_ = 0;
    set_what_is_due();
    step(0, on_step, met);
  }
  while (now_s_ < time_s) {
    set_what_is_due();
    double next_s = std::min((std::floor(now_s_ * kStepsPerSecond + 1e-6) + 1) / kStepsPerSecond, time_s);
    if (next_line_ < lines_.size()) next_s = std::min(next_s, lines_[next_line_].time_s);
    const auto dt_s = static_cast<float>(next_s - now_s_);
    now_s_ = next_s;
    step(dt_s, on_step, met);
  }
  return met;
}

void Acting::set_what_is_due() {
  for (; next_line_ < lines_.size() && lines_[next_line_].time_s <= now_s_; ++next_line_)
    behaviour_.set(lines_[next_line_].parameter, lines_[next_line_].value);
}

void Acting::step(float dt_s, const OnStep& on_step, std::vector<Met>& met) {
  for (const AnimatorEvent& e : behaviour_.update(dt_s).events)
    for (std::uint32_t i = 0; i < e.count; ++i) met.push_back({now_s_, e.name, e.animation->name, e.time_s, e.number});
  if (on_step) on_step(dt_s);
}

void Acting::leave_prints(const Character& character) {
  for (const AnimatorEvent& e : behaviour_.last_step().events) {
    const Role role = find_role(e.name);
    for (const Foot& foot : feet_) {
      if (role == Role::none || foot.role != role || foot.skeleton != e.animation->motion_skeleton) continue;
      const Affine& ankle = character.model_from_joint(foot.skeleton)[foot.joint];
      GroundPrint print{role, point_of(ankle, foot.ball), level(point_of(ankle, foot.ball) - place_of(ankle)),
                        foot.length_m};
      const float ahead = glm::length(print.ahead);
      if (!(ahead > 0) || !(foot.length_m > 0)) continue;
      print.ahead /= ahead;
      prints_.push_back({print, now_s_});
    }
  }
}

std::optional<float> Acting::ground_height() const {
  std::vector<float> heights;
  for (const Print& p : prints_) heights.push_back(p.print.at.y);
  if (heights.empty()) return std::nullopt;
  std::ranges::sort(heights);
  return heights[heights.size() / 2];
}

}  // namespace marrow::tools
