// The newt's body as a smooth implicit surface: rounded primitives melted together.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace marrow::sample {

// Stretches of the body that follow one chain of joints. Sided parts come in pairs: left, then right.
enum Part : int {
  kTrunkPart,
  kHeadPart,
  kTailPart,
  kArmPart,
  kLegPart = kArmPart + 2,
  kThumbPart = kLegPart + 2,
  kGillTopPart = kThumbPart + 2,
  kGillMidPart = kGillTopPart + 2,
  kGillLowPart = kGillMidPart + 2,
  kPartCount = kGillLowPart + 2,
};

enum Tint : int { kSkinTint, kGillTint, kTipTint, kCrestTint, kTintCount };

// A cone with round ends from `a` to `b`, or, when `radii` is not zero, an ellipsoid about `a`.
struct Primitive {
  glm::vec3 a{0}, b{0};
  float ra = 0, rb = 0;
  glm::vec3 radii{0};
  glm::mat3 to_local{1};
  float melt = .02f;  // how far the union with what came before is rounded
  float edge = .02f;  // the triangle edge length wanted here
  int part = kTrunkPart;
  Tint tint = kSkinTint;
  glm::vec3 middle{0};
  float bound = 0;  // all of it lies this near to `middle`

  float distance(glm::vec3 p) const;
};

class Shape {
 public:
  void add(Primitive primitive);
  // Adds `primitive`, which must lie on the left, and its mirror image; its part must be a left one.
  void add_pair(Primitive primitive);

  float field(glm::vec3 p) const;  // negative inside; close to a distance near the surface
  glm::vec3 gradient(glm::vec3 p) const;
  glm::vec3 project(glm::vec3 p) const;  // to the surface, along the gradient
  float edge_length(glm::vec3 p) const;
  std::array<float, kPartCount> part_distances(glm::vec3 p) const;
  std::array<float, kTintCount> tints(glm::vec3 p) const;  // sums to 1

 private:
  std::vector<Primitive> primitives_;
};

// The newt itself.
Shape make_newt_shape();

}  // namespace marrow::sample
