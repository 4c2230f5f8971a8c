// The newt's livery: teal back, mint flanks, cream belly, dark bands, coral gills, crest and toes.
#include "paint.h"

#include <algorithm>
#include <cmath>

#include "newt_skeleton.h"

namespace marrow::sample {
namespace {

float ramp(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

// 0..1, along the tail from its root to its end.
float along_tail(glm::vec3 p) {
  float best = 1e9f, result = 0;
  for (int i = 0; i < kTailCount; ++i) {
    const RestJoint& rest = skeleton()[static_cast<std::size_t>(kTail1 + i)];
    const glm::vec3 bone = rest.tip - rest.head;
    const float t = std::clamp(glm::dot(p - rest.head, bone) / glm::dot(bone, bone), 0.0f, 1.0f);
    const float d = glm::distance(p, rest.head + bone * t);
    if (d >= best) continue;
    best = d;
    result = (static_cast<float>(i) + t) / kTailCount;
  }
  return result;
}

float spots(glm::vec3 p) {
  struct Spot {
    glm::vec3 at;
    float radius;
  };
  // Asymmetric on purpose, like a real newt's.
  static constexpr Spot kSpots[] = {
      {{.100f, 1.235f, -.06f}, .034f}, {{-.085f, 1.250f, -.04f}, .026f}, {{-.130f, 1.180f, -.10f}, .034f},
      {{.085f, 1.150f, -.14f}, .030f}, {{.115f, .800f, -.08f}, .034f},   {{-.110f, .760f, -.10f}, .038f},
      {{.165f, .680f, -.11f}, .038f},  {{-.185f, .630f, -.09f}, .042f},  {{.195f, .560f, -.06f}, .032f},
      {{-.160f, .540f, -.14f}, .034f}, {{.110f, .620f, -.19f}, .036f},   {{-.090f, .680f, -.17f}, .028f},
      {{.205f, .420f, -.01f}, .034f},  {{.200f, .330f, .04f}, .024f},    {{-.205f, .390f, .02f}, .036f},
      {{-.190f, .300f, -.02f}, .024f}, {{.210f, .830f, -.02f}, .028f},   {{-.190f, .860f, -.01f}, .026f},
      {{-.270f, .790f, -.03f}, .026f}, {{.290f, .770f, -.02f}, .022f},   {{.020f, 1.275f, .05f}, .022f}};
  float result = 0;
  for (const Spot& spot : kSpots) {
    result = std::max(result, 1 - ramp(spot.radius * .65f, spot.radius * 1.15f, glm::distance(p, spot.at)));
  }
  return result;
}

// How much of the pale underside shows: 1 on belly and throat, 0 on the back.
float underside(const std::array<float, kPartCount>& d, glm::vec3 p, glm::vec3 n) {
  const float nearest = *std::min_element(d.begin(), d.end());
  const auto near = [&](std::size_t part) { return std::exp(-(d[part] - nearest) / .03f); };
  const float trunk = near(kTrunkPart), head = near(kHeadPart), tail = near(kTailPart);
  const float arm = near(kArmPart) + near(kArmPart + 1), leg = near(kLegPart) + near(kLegPart + 1);
  const float front = glm::dot(n, glm::normalize(glm::vec3(0, -.22f, 1)));
  const float on_trunk = ramp(.15f, .55f, front);
  const float on_head = ramp(1.085f, 1.020f, p.y + .10f * std::max(-p.z, 0.0f)) * ramp(-.5f, .1f, n.z + .3f);
  const float on_tail = ramp(.35f, .75f, -n.y);
  const float on_arm = .55f * ramp(.60f, 1.0f, glm::dot(n, glm::normalize(glm::vec3(p.x > 0 ? -.6f : .6f, -.7f, .2f))));
  const float on_leg = .7f * ramp(.55f, .95f, glm::dot(n, glm::normalize(glm::vec3(p.x > 0 ? -1.f : 1.f, -.2f, .3f))));
  return (trunk * on_trunk + head * on_head + tail * on_tail + arm * on_arm + leg * on_leg) /
         (trunk + head + tail + arm + leg);
}

}  // namespace

glm::vec3 linear_rgb(int red, int green, int blue) {
  glm::vec3 result = glm::vec3(red, green, blue) / 255.0f;
  for (int i = 0; i < 3; ++i) {
    result[i] = result[i] <= .04045f ? result[i] / 12.92f : std::pow((result[i] + .055f) / 1.055f, 2.4f);
  }
  return result;
}

glm::vec3 skin_colour(const Shape& shape, glm::vec3 p, glm::vec3 n) {
  static const glm::vec3 kBack = linear_rgb(24, 128, 130), kFlank = linear_rgb(74, 190, 160);
  static const glm::vec3 kPale = linear_rgb(255, 230, 180), kDark = linear_rgb(12, 62, 80);
  static const glm::vec3 kCoral = linear_rgb(255, 104, 92), kOrange = linear_rgb(255, 158, 74);
  static const glm::vec3 kBlush = linear_rgb(255, 140, 128), kDeep = linear_rgb(205, 52, 78);
  const auto distances = shape.part_distances(p);
  const float nearest = *std::min_element(distances.begin(), distances.end());

  const float dorsal = glm::dot(n, glm::normalize(glm::vec3(0, .62f, -.78f)));
  glm::vec3 colour = glm::mix(kFlank, kBack, ramp(-.35f, .75f, dorsal));
  colour = glm::mix(colour, kDark, .85f * spots(p));
  if (distances[kTailPart] - nearest < .02f) {
    const float s = along_tail(p);
    const float band = ramp(.35f, .75f, std::sin(s * 6.2832f * 6.0f - .9f)) * ramp(.06f, .12f, s);
    colour = glm::mix(colour, kDark, .8f * band * (1 - ramp(.0f, .02f, distances[kTailPart] - nearest)));
  }
  colour = glm::mix(colour, kPale, underside(distances, p, n));
  const glm::vec3 cheek(p.x > 0 ? .172f : -.172f, 1.055f, .148f);
  colour = glm::mix(colour, kBlush, .8f * (1 - ramp(.015f, .060f, glm::distance(p, cheek))));

  const auto tint = shape.tints(p);
  const float root = std::min(std::abs(p.x) / .30f, 1.0f);  // gills darken towards the head
  const glm::vec3 gill = glm::mix(kDeep, kCoral, ramp(.60f, 1.0f, root));
  return colour * tint[kSkinTint] + gill * tint[kGillTint] + kOrange * tint[kTipTint] +
         glm::mix(kCoral, kOrange, .55f) * tint[kCrestTint];
}

}  // namespace marrow::sample
