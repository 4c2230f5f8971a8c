// Evaluates the implicit surface: distances to primitives, their smooth union, and what they say about a point.
#include "shape.h"

#include <algorithm>
#include <cmath>

namespace marrow::sample {
namespace {

// Distance to a ball that slides from `a` to `b` while its radius changes linearly.
float cone_distance(const Primitive& cone, glm::vec3 p) {
  const glm::vec3 ba = cone.b - cone.a;
  const float length2 = glm::dot(ba, ba);
  const float shrink = cone.ra - cone.rb;
  const float a2 = length2 - shrink * shrink;
  const float inverse = 1.0f / length2;
  const glm::vec3 pa = p - cone.a;
  const float y = glm::dot(pa, ba);
  const float z = y - length2;
  const glm::vec3 side = pa * length2 - ba * y;
  const float x2 = glm::dot(side, side);
  const float y2 = y * y * length2;
  const float z2 = z * z * length2;
  const float k = (shrink < 0 ? -1.0f : 1.0f) * shrink * shrink * x2;
  if ((z < 0 ? -1.0f : 1.0f) * a2 * z2 > k) return std::sqrt(x2 + z2) * inverse - cone.rb;
  if ((y < 0 ? -1.0f : 1.0f) * a2 * y2 < k) return std::sqrt(x2 + y2) * inverse - cone.ra;
  return (std::sqrt(x2 * a2 * inverse) + y * shrink) * inverse - cone.ra;
}

float ellipsoid_distance(const Primitive& ball, glm::vec3 p) {
  const glm::vec3 q = ball.to_local * (p - ball.a);
  const float k0 = glm::length(q / ball.radii);
  const float k1 = glm::length(q / (ball.radii * ball.radii));
  return k1 < 1e-6f ? -std::min({ball.radii.x, ball.radii.y, ball.radii.z}) : k0 * (k0 - 1.0f) / k1;
}

// Cubic smooth minimum: the same as min() once the two differ by more than `melt`.
float melt_together(float a, float b, float melt) {
  const float h = std::max(melt - std::abs(a - b), 0.0f) / melt;
  return std::min(a, b) - h * h * h * melt / 6.0f;
}

}  // namespace

float Primitive::distance(glm::vec3 p) const {
  return radii.x > 0 ? ellipsoid_distance(*this, p) : cone_distance(*this, p);
}

void Shape::add(Primitive primitive) {
  if (primitive.radii.x > 0) {
    primitive.middle = primitive.a;
    primitive.bound = std::max({primitive.radii.x, primitive.radii.y, primitive.radii.z});
  } else {
    primitive.middle = (primitive.a + primitive.b) * .5f;
    primitive.bound = glm::length(primitive.b - primitive.a) * .5f + std::max(primitive.ra, primitive.rb);
  }
  primitives_.push_back(primitive);
}

void Shape::add_pair(Primitive primitive) {
  add(primitive);
  const glm::vec3 mirror(-1, 1, 1);
  primitive.a *= mirror;
  primitive.b *= mirror;
  // Mirroring an ellipsoid: take the point back to the left before it enters the local frame.
  primitive.to_local = primitive.to_local * glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1);
  if (primitive.part >= kArmPart) ++primitive.part;
  add(primitive);
}

float Shape::field(glm::vec3 p) const {
  constexpr float kMargin = .04f;  // the ellipsoid's distance is an estimate, so skip it only from well away
  float d = 10.0f;
  for (const Primitive& primitive : primitives_) {
    const float reach = d + primitive.melt + kMargin + primitive.bound;
    const glm::vec3 away = p - primitive.middle;
    if (reach < 0 || glm::dot(away, away) > reach * reach) continue;
    d = melt_together(d, primitive.distance(p), primitive.melt);
  }
  return d;
}

glm::vec3 Shape::gradient(glm::vec3 p) const {
  constexpr float kStep = 1e-3f;
  const glm::vec3 x(kStep, 0, 0), y(0, kStep, 0), z(0, 0, kStep);
  return glm::vec3(field(p + x) - field(p - x), field(p + y) - field(p - y), field(p + z) - field(p - z)) / (2 * kStep);
}

glm::vec3 Shape::project(glm::vec3 p) const {
  for (int step = 0; step < 4; ++step) {
    const float d = field(p);
    if (std::abs(d) < 1e-6f) break;
    const glm::vec3 g = gradient(p);
    p -= g * (d / std::max(glm::dot(g, g), .05f));
  }
  return p;
}

float Shape::edge_length(glm::vec3 p) const {
  // Nearer primitives say more, and finer ones a little more than coarse ones, so that detail fades out slowly.
  float sum = 0, total = 0;
  for (const Primitive& primitive : primitives_) {
    const glm::vec3 away = p - primitive.middle;
    const float reach = primitive.bound + .15f;
    if (glm::dot(away, away) > reach * reach) continue;
    const float weight = std::exp(-std::max(primitive.distance(p), 0.0f) / .012f) / primitive.edge;
    sum += weight * primitive.edge;
    total += weight;
  }
  return total > 0 ? sum / total : .02f;
}

std::array<float, kPartCount> Shape::part_distances(glm::vec3 p) const {
  std::array<float, kPartCount> result;
  result.fill(10.0f);
  for (const Primitive& primitive : primitives_) {
    float& d = result[static_cast<std::size_t>(primitive.part)];
    d = melt_together(d, primitive.distance(p), primitive.melt);
  }
  return result;
}

std::array<float, kTintCount> Shape::tints(glm::vec3 p) const {
  std::array<float, kTintCount> result{};
  float total = 0;
  for (const Primitive& primitive : primitives_) {
    const float weight = std::exp(-std::max(primitive.distance(p) + .004f, 0.0f) / .006f);
    float& strongest = result[static_cast<std::size_t>(primitive.tint)];
    strongest = std::max(strongest, weight);
  }
  for (float value : result) total += value;
  for (float& value : result) value /= std::max(total, 1e-12f);
  if (total < 1e-12f) result[kSkinTint] = 1;
  return result;
}

}  // namespace marrow::sample
