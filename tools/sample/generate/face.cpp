// Builds eyes and lids as surfaces of revolution and sweeps the smile along the skin.
#include "face.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "newt_skeleton.h"
#include "paint.h"

namespace marrow::sample {
namespace {

constexpr float kEyeRadius = .085f;
constexpr float kEyeYaw = 15.0f;  // degrees outwards
constexpr float kPi = 3.14159265f;

glm::vec3 eye_place(int side) {
  return {side_sign(side) * .130f, 1.178f, .118f};
}

// One ring of a surface of revolution about +Z: how far from the axis' pole in degrees, how far from the centre.
struct Ring {
  float degrees;
  float radius;
  glm::vec3 colour;
};

// The rings must start at the pole or end there; normals point away from the centre unless `normal_degrees` says so.
void revolve(RigidPart& part, const std::vector<Ring>& rings, int segments, const glm::mat3& frame) {
  const auto first = static_cast<std::uint32_t>(part.mesh.positions.size());
  const auto around = static_cast<std::uint32_t>(segments);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const auto flat = [&](std::size_t at) {
      const float angle = glm::radians(rings[at].degrees);
      return glm::vec2(std::sin(angle), std::cos(angle)) * rings[at].radius;
    };
    const glm::vec2 here = flat(r), before = flat(r > 0 ? r - 1 : 0), after = flat(std::min(r + 1, rings.size() - 1));
    const glm::vec2 along = after - before;
    const glm::vec2 out =
        here.x < 1e-6f ? glm::vec2(0, here.y > 0 ? 1 : -1) : glm::normalize(glm::vec2(-along.y, along.x));
    for (std::uint32_t s = 0; s < around; ++s) {
      const float turn = 2 * kPi * static_cast<float>(s) / static_cast<float>(around);
      const glm::vec2 spoke(std::cos(turn), std::sin(turn));
      part.mesh.positions.push_back(frame * glm::vec3(spoke * here.x, here.y));
      part.normals.push_back(glm::normalize(frame * glm::vec3(spoke * out.x, out.y)));
      part.colours.push_back(rings[r].colour);
    }
  }
  for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::uint32_t s = 0; s < around; ++s) {
      const std::uint32_t a = first + r * around + s, b = first + r * around + (s + 1) % around;
      const bool at_pole = std::sin(glm::radians(rings[r].degrees)) < 1e-4f;
      const bool to_pole = std::sin(glm::radians(rings[r + 1].degrees)) < 1e-4f;
      if (!to_pole) part.mesh.triangles.push_back({a, a + around, b + around});
      if (!at_pole) part.mesh.triangles.push_back({a, b + around, b});
    }
  }
}

RigidPart make_eye(int side) {
  static const glm::vec3 kPupil = linear_rgb(14, 12, 22), kInner = linear_rgb(255, 206, 84);
  static const glm::vec3 kOuter = linear_rgb(226, 122, 30), kRim = linear_rgb(70, 34, 20);
  static const glm::vec3 kWhite = linear_rgb(255, 250, 240);
  RigidPart eye{side == 0 ? "eye.L" : "eye.R", eye_place(side), eye_turn(side), {}, {}, {}};
  const float r = kEyeRadius;
  // Pairs of rings close together keep the colours from running into each other.
  revolve(eye,
          {{0, r, kPupil},
           {14, r, kPupil},
           {28, r, kPupil},
           {39, r, kPupil},
           {40.5f, r, kInner},
           {48, r, kInner},
           {59, r, kOuter},
           {63, r, kOuter},
           {64, r, kRim},
           {68, r, kRim},
           {69.5f, r, kWhite},
           {78, r, kWhite},
           {90, r, kWhite},
           {108, r, kWhite},
           {128, r, kWhite},
           {150, r, kWhite},
           {180, r, kWhite}},
          28, glm::mat3(1));
  // Two painted glints, so that the eye is alive in renderers without highlights too.
  const auto glint = [&](float yaw, float pitch, float size) {
    const glm::quat turn = glm::angleAxis(glm::radians(yaw), glm::vec3(0, 1, 0)) *
                           glm::angleAxis(glm::radians(-pitch), glm::vec3(1, 0, 0));
    const glm::vec3 shine(1.0f);
    revolve(eye,
            {{0, r * 1.022f, shine},
             {size * .6f, r * 1.018f, shine},
             {size * .9f, r * 1.008f, shine},
             {size, r * .995f, shine}},
            12, glm::mat3_cast(turn));
  };
  glint(15, 19, 11.5f);
  glint(-14, -15, 5.0f);
  return eye;
}

RigidPart make_lid(int side) {
  static const glm::vec3 kSkin = linear_rgb(40, 148, 140), kEdge = linear_rgb(16, 84, 94);
  RigidPart lid{
      side == 0 ? "lid.L" : "lid.R", eye_place(side), eye_turn(side) * lid_turn(side, kLidAtRest), {}, {}, {}};
  const float r = kEyeRadius * 1.075f;
  // The dome's pole is the part's +Y; the last rings roll its rim in to the eyeball.
  const glm::mat3 frame(glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0, 1, 0));
  revolve(lid,
          {{0, r, kSkin},
           {20, r, kSkin},
           {40, r, kSkin},
           {60, r, kSkin},
           {77, r, kSkin},
           {82, r, kEdge},
           {89, r * 1.012f, kEdge},
           {92.5f, r * .995f, kEdge},
           {93.5f, r * .96f, kEdge},
           {92, r * .915f, kEdge}},
          24, frame);
  return lid;
}

// Where a ray from inside the head leaves the skin.
glm::vec3 on_face(const Shape& shape, float yaw, float pitch) {
  const glm::vec3 from(0, 1.07f, .06f);
  const float y = glm::radians(yaw), x = glm::radians(pitch);
  const glm::vec3 ray(std::sin(y) * std::cos(x), std::sin(x), std::cos(y) * std::cos(x));
  float low = 0, high = .4f;
  for (int i = 0; i < 30; ++i) {
    const float middle = (low + high) * .5f;
    (shape.field(from + ray * middle) < 0 ? low : high) = middle;
  }
  return from + ray * low;
}

// A thin tube along the skin, pointed at both ends.
void add_smile(const Shape& shape, RigidPart& part) {
  constexpr int kSteps = 36, kSides = 8;
  static const glm::vec3 kLine = linear_rgb(72, 28, 44);
  const auto at = [&](float u) { return on_face(shape, 58 * u, -13 + 17 * u * u * u * u * .6f + 7 * u * u); };
  const auto first = static_cast<std::uint32_t>(part.mesh.positions.size());
  for (int i = 0; i <= kSteps; ++i) {
    const float u = 2.0f * static_cast<float>(i) / kSteps - 1;
    const glm::vec3 p = at(u), tangent = glm::normalize(at(u + .01f) - at(u - .01f));
    const glm::vec3 out = glm::normalize(shape.gradient(p));
    const glm::vec3 across = glm::normalize(glm::cross(tangent, out));
    const float radius = std::max(.0062f * (1 - u * u * u * u * u * u), .0004f);
    for (int s = 0; s < kSides; ++s) {
      const float turn = 2 * kPi * static_cast<float>(s) / kSides;
      const glm::vec3 spoke = across * std::cos(turn) - glm::cross(across, tangent) * std::sin(turn);
      part.mesh.positions.push_back(p + spoke * radius);
      part.normals.push_back(glm::normalize(spoke));
      part.colours.push_back(kLine);
    }
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    for (std::uint32_t s = 0; s < kSides; ++s) {
      const std::uint32_t a = first + i * kSides + s, b = first + i * kSides + (s + 1) % kSides;
      part.mesh.triangles.push_back({a, b, b + kSides});
      part.mesh.triangles.push_back({a, b + kSides, a + kSides});
    }
  }
}

void add_nostril(const Shape& shape, RigidPart& part, float yaw) {
  static const glm::vec3 kLine = linear_rgb(34, 70, 76);
  const std::size_t first = part.mesh.positions.size();
  const float r = .0085f;
  revolve(part, {{0, r, kLine}, {45, r, kLine}, {90, r, kLine}, {135, r, kLine}, {180, r, kLine}}, 10, glm::mat3(1));
  const glm::vec3 p = on_face(shape, yaw, 7);
  for (std::size_t i = first; i < part.mesh.positions.size(); ++i) part.mesh.positions[i] += p;
}

}  // namespace

glm::quat eye_turn(int side) {
  return glm::angleAxis(side_sign(side) * glm::radians(kEyeYaw), glm::vec3(0, 1, 0)) *
         glm::angleAxis(glm::radians(-4.0f), glm::vec3(1, 0, 0));
}

glm::quat lid_turn(int side, float shut) {
  // The outer corner hangs a little, which makes for a friendly look.
  const float sign = side_sign(side), droop = sign * glm::mix(-12.0f, -3.0f, shut);
  // The hinge runs straight across the head, so that its inner end stays buried in the brow.
  return glm::angleAxis(glm::radians(-sign * kEyeYaw * glm::mix(1.4f, .1f, shut)), glm::vec3(0, 1, 0)) *
         glm::angleAxis(glm::radians(droop), glm::vec3(0, 0, 1)) *
         glm::angleAxis(glm::radians(glm::mix(-70.0f, 33.0f, shut)), glm::vec3(1, 0, 0));
}

std::vector<RigidPart> make_face(const Shape& shape) {
  std::vector<RigidPart> parts;
  parts.push_back(make_eye(0));
  parts.push_back(make_eye(1));
  parts.push_back(make_lid(0));
  parts.push_back(make_lid(1));
  RigidPart mouth{"mouth", {0, 1.07f, .06f}, {1, 0, 0, 0}, {}, {}, {}};
  add_smile(shape, mouth);
  add_nostril(shape, mouth, 13);
  add_nostril(shape, mouth, -13);
  for (glm::vec3& p : mouth.mesh.positions) p -= mouth.at;
  parts.push_back(std::move(mouth));
  return parts;
}

}  // namespace marrow::sample
