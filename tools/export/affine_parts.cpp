#include "export/affine_parts.h"

#include <cmath>
#include <cstring>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace marrow::tools {
namespace {

// Columns that are this near to orthogonal (cosine) are so but for the rounding of products of float matrices.
constexpr double kRounding = 1e-6;

double cosine(const glm::dvec3& a, const glm::dvec3& b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 ? glm::dot(a, b) / lengths : 0;
}

// Turns columns p and q of `m` in their plane so that they are orthogonal, and `v` with them: m v⁻¹ does not change.
void orthogonalise(glm::dmat3& m, glm::dmat3& v, int p, int q) {
  const double slope =
      (glm::dot(m[q], m[q]) - glm::dot(m[p], m[p])) / (2 * glm::dot(m[p], m[q]));  // cot of twice the angle
  const double t = (slope < 0 ? -1 : 1) / (std::fabs(slope) + std::sqrt(1 + slope * slope));
  const double c = 1 / std::sqrt(1 + t * t), s = c * t;
  for (glm::dmat3* const matrix : {&m, &v}) {
    const glm::dvec3 a = (*matrix)[p], b = (*matrix)[q];
    (*matrix)[p] = c * a - s * b;
    (*matrix)[q] = s * a + c * b;
  }
}

// Makes the columns of `m` orthogonal; the result is true if that took a turn.
bool remove_shear(glm::dmat3& m, glm::dmat3& v) {
  const auto worst = [&] {
    return std::max({std::fabs(cosine(m[0], m[1])), std::fabs(cosine(m[0], m[2])), std::fabs(cosine(m[1], m[2]))});
  };
  if (worst() < kRounding) return false;
  for (int sweep = 0; sweep < 60 && worst() > 1e-15; ++sweep)
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
      if (std::fabs(cosine(m[p], m[q])) > 1e-16) orthogonalise(m, v, p, q);
  return true;
}

// Unit columns for those of `m`, orthogonal and right-handed; a column without length gets what the others leave.
glm::dmat3 directions(const glm::dmat3& m, double (&scale)[3]) {
  glm::dmat3 u(1.0);
  int known[3], known_count = 0, unknown[3], unknown_count = 0;
  for (int i = 0; i < 3; ++i) {
    scale[i] = glm::length(m[i]);
    (scale[i] > 0 ? known[known_count++] : unknown[unknown_count++]) = i;
    if (scale[i] > 0) u[i] = m[i] / scale[i];
  }
  if (known_count == 1) {
    const glm::dvec3 k = u[known[0]];
    const glm::dvec3 other = std::fabs(k.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    u[unknown[0]] = glm::normalize(glm::cross(k, other));
    u[unknown[1]] = glm::cross(k, u[unknown[0]]);
  } else if (known_count == 2) {
    u[unknown[0]] = glm::cross(u[known[0]], u[known[1]]);
  }
  if (glm::determinant(u) < 0) {
    u[0] = -u[0];
    scale[0] = -scale[0];
  }
  return u;
}

void set_rotation(const glm::dmat3& turn, Parts& parts) {
  const glm::dquat q = glm::normalize(glm::quat_cast(turn));
  const double sign = q.w < 0 ? -1 : 1;
  const double xyzw[4] = {q.x * sign, q.y * sign, q.z * sign, q.w * sign};
  std::memcpy(parts.rotation, xyzw, sizeof xyzw);
}

Json short_numbers(const double* values, int count) {
  Json out = Json::array();
  for (int i = 0; i < count; ++i) out.push_back(number(static_cast<float>(values[i])));
  return out;
}

}  // namespace

std::vector<Parts> parts_of(const Affine& map) {
  glm::dmat3 m;
  Parts outer;
  bool identity = true;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m[c][r] = static_cast<double>(map.rows[r][c]);
    outer.translation[r] = static_cast<double>(map.rows[r][3]);
    for (int c = 0; c < 4; ++c) identity = identity && map.rows[r][c] == (r == c ? 1.0f : 0.0f);
  }
  if (identity) return {};
  glm::dmat3 v(1.0);
  const bool sheared = remove_shear(m, v);
  set_rotation(directions(m, outer.scale), outer);
  if (!sheared) return {outer};
  Parts inner;
  set_rotation(glm::transpose(v), inner);
  return {outer, inner};
}

void set_parts(Json& node, const Parts& parts) {
  const Parts defaults;
  const auto set = [&](const char* name, const double* values, const double* unset, int count) {
    Json given = short_numbers(values, count);
    if (given != short_numbers(unset, count)) node[name] = std::move(given);
  };
  set("translation", parts.translation, defaults.translation, 3);
  set("rotation", parts.rotation, defaults.rotation, 4);
  set("scale", parts.scale, defaults.scale, 3);
}

}  // namespace marrow::tools
