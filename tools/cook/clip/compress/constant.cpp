#include "cook/clip/compress/constant.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr int kFactors = 4096;  // that are tried

// Halves away from 0. In lround's place, which no compiler inlines: it is asked for millions.
std::int16_t rounded(double x) {
  return static_cast<std::int16_t>(x + std::copysign(0.5, x));
}

}  // namespace

format::Constant code_rotation(const glm::dquat& q, int most) {
  const double largest = std::max({std::fabs(q.x), std::fabs(q.y), std::fabs(q.z), std::fabs(q.w)});
  format::Constant best{};
  double least = INFINITY;
  const int factors = std::min(kFactors, most);  // fewer numbers, fewer that differ
  for (int i = 0; i < factors; ++i) {
    const double factor = most / largest * (1 - 0.5 * i / factors);
    const format::Constant c = {
        {rounded(q.x * factor), rounded(q.y * factor), rounded(q.z * factor), rounded(q.w * factor)}};
    // Of the distance from the line through q, so that small angles count; as a share of the length.
    const glm::dquat d(c.v[3], c.v[0], c.v[1], c.v[2]), off = d - q * glm::dot(q, d);
    const double distance = glm::dot(off, off) / glm::dot(d, d);
    if (distance >= least) continue;
    least = distance;
    best = c;
  }
  return best;
}

glm::dquat decode_rotation(const format::Constant& c) {
  return glm::normalize(glm::dquat(c.v[3], c.v[0], c.v[1], c.v[2]));
}

format::Constant code_offset(const glm::dvec3& offset, int most) {
  const double largest = std::max({std::fabs(offset.x), std::fabs(offset.y), std::fabs(offset.z)});
  int code = 0;
  while (code < 255 && largest > most * static_cast<double>(format::step_size(static_cast<std::uint32_t>(code))))
    ++code;
  const double inverse = 1 / static_cast<double>(format::step_size(static_cast<std::uint32_t>(code)));
  const auto fitted = [&](double x) { return rounded(std::clamp(x * inverse, -1.0 * most, 1.0 * most)); };
  return {{fitted(offset.x), fitted(offset.y), fitted(offset.z), static_cast<std::int16_t>(code)}};
}

glm::dvec3 decode_offset(const format::Constant& c) {
  return static_cast<double>(format::step_size(static_cast<std::uint32_t>(c.v[3]))) *
         glm::dvec3(c.v[0], c.v[1], c.v[2]);
}

}  // namespace marrow::cook
