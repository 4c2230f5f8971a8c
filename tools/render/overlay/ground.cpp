#include "render/overlay/ground.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace marrow::tools {
namespace {

constexpr glm::vec3 kLine{0.02f, 0.03f, 0.04f};
constexpr float kLineStrength = 0.55f;
constexpr float kSquare = 0.6f, kReach = 3.5f;  // radii
constexpr double kPales_s = 3;                  // that a print takes
constexpr float kFresh = 0.9f, kOld = 0.4f;     // how strong it is
constexpr int kMostSquares = 60;                // each way

float linear_of(std::uint8_t value) {
  return std::pow(static_cast<float>(value) / 255, 2.2f);
}

// Half of a sole's width at `along`, -1 at the heel and 1 at the toes, in lengths of the sole.
float half_width(float along) {
  const float waist = 1 - 0.28f * std::exp(-8 * (along + 0.15f) * (along + 0.15f));
  return (0.165f + 0.035f * along) * waist * std::sqrt(std::max(0.0f, 1 - along * along * along * along));
}

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

float ground_square(float radius) {
  const float most = kSquare * std::max(radius, 1e-20f), ten = std::pow(10.0f, std::floor(std::log10(most)));
  return most >= 5 * ten ? 5 * ten : most >= 2 * ten ? 2 * ten : ten;
}

void add_squares(const Shot& shot, const Box& way, Strokes& strokes) {
  const float y = shot.ground_height, reach = kReach * shot.radius + (way.empty() ? 0 : way.radius());
  const glm::vec3 centre = way.empty() ? shot.box.centre() : way.centre();
  float square = ground_square(shot.radius);
  while (reach > kMostSquares * square) square *= 10;
  if (std::abs(centre.x) > 1e6f * square || std::abs(centre.z) > 1e6f * square) return;
  const auto nearest = [&](float at_m) { return static_cast<int>(std::lround(at_m / square)); };
  const int count = static_cast<int>(std::ceil(reach / square)), x0 = nearest(centre.x), z0 = nearest(centre.z);
  const auto corner = [&](int x, int z) {
    // Who goes straight ahead from the origin goes along the middle of squares, and not on a line.
    const glm::vec3 at((static_cast<float>(x) + 0.5f) * square, y, (static_cast<float>(z) + 0.5f) * square);
    const float away = glm::length(glm::vec2(at.x - centre.x, at.z - centre.z)) / reach;
    return Strokes::Corner{at, glm::vec4(kLine, kLineStrength * std::max(0.0f, 1 - away * away))};
  };
  for (int i = -count; i <= count; ++i)
    for (int k = -count; k < count; ++k) {
      strokes.line(corner(x0 + i, z0 + k), corner(x0 + i, z0 + k + 1));
      strokes.line(corner(x0 + k, z0 + i), corner(x0 + k + 1, z0 + i));
    }
}

Rgb foot_colour(Role role) {
  constexpr Rgb kLeft = {255, 170, 60}, kRight = {90, 180, 255}, kOther = {220, 220, 220};
  if (role == Role::none) return kOther;
  return role == Role::left_foot || role == Role::left_hand ? kLeft : kRight;
}

void add_print(const GroundPrint& print, double age_s, const Shot& shot, Strokes& strokes) {
  constexpr int kPieces = 14;
  const float strength = kFresh + (kOld - kFresh) * static_cast<float>(std::min(age_s / kPales_s, 1.0));
  const Rgb rgb = foot_colour(print.role);
  const glm::vec4 colour(linear_of(rgb[0]), linear_of(rgb[1]), linear_of(rgb[2]), strength);
  const glm::vec3 side = glm::normalize(glm::cross(glm::vec3(0, 1, 0), print.ahead));
  // Its ball is a quarter of its length before its middle.
  const glm::vec3 ball(print.at.x, shot.ground_height, print.at.z);
  const glm::vec3 middle = ball - 0.25f * print.length_m * print.ahead;
  std::array<glm::vec3, 2> before{};
  for (int i = 0; i <= kPieces; ++i) {
    const float along = 2 * static_cast<float>(i) / kPieces - 1;
    const glm::vec3 on = middle + 0.5f * along * print.length_m * print.ahead;
    const glm::vec3 out = half_width(along) * print.length_m * side;
    const std::array<glm::vec3, 2> now = {on - out, on + out};
    if (i > 0) {
      strokes.face({before[0], colour}, {before[1], colour}, {now[1], colour});
      strokes.face({before[0], colour}, {now[1], colour}, {now[0], colour});
    }
    before = now;
  }
}

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
