#include "render/overlay/footfall.h"

#include <glm/geometric.hpp>

namespace marrow::tools {
namespace {

constexpr float kAnkleToBall = 0.45f;  // of a foot's length

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

Feet::Feet(const File& file) {
  Character rest(file);
  rest.pose({}, 0);
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const Roles roles = file.roles(s);
    for (const JointSole& sole : roles.soles) {
      Foot foot{role_of(roles, sole.joint), s, sole.joint, {sole.place[0], sole.place[1], sole.place[2]}, 0};
      const Affine& ankle = rest.model_from_joint(s)[sole.joint];
      foot.length_m = glm::length(level(point_of(ankle, foot.ball) - place_of(ankle))) / kAnkleToBall;
      feet_.push_back(foot);
    }
  }
}

std::vector<GroundPrint> Feet::prints(const AnimatorStep& step, const Character& character) const {
  std::vector<GroundPrint> out;
  for (const AnimatorEvent& e : step.events) {
    const Role role = find_role(e.name);
    for (const Foot& foot : feet_) {
      if (role == Role::none || foot.role != role || foot.skeleton != e.animation->motion_skeleton) continue;
      const Affine& ankle = character.model_from_joint(foot.skeleton)[foot.joint];
      GroundPrint print{role, point_of(ankle, foot.ball), level(point_of(ankle, foot.ball) - place_of(ankle)),
                        foot.length_m};
      const float ahead = glm::length(print.ahead);
      if (!(ahead > 0) || !(foot.length_m > 0)) continue;
      print.ahead /= ahead;
      out.push_back(print);
    }
  }
  return out;
}

}  // namespace marrow::tools
