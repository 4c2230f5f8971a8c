// The newt's body: every primitive that is melted into the skin, and how fine the mesh has to be there.
#include <glm/gtc/quaternion.hpp>

#include "newt_skeleton.h"
#include "shape.h"

namespace marrow::sample {
namespace {

struct Look {
  float melt;
  float edge;
  int part;
  Tint tint = kSkinTint;
};

Primitive cone(glm::vec3 a, float ra, glm::vec3 b, float rb, Look look) {
  Primitive primitive;
  primitive.a = a;
  primitive.b = b;
  primitive.ra = ra;
  primitive.rb = rb;
  primitive.melt = look.melt;
  primitive.edge = look.edge;
  primitive.part = look.part;
  primitive.tint = look.tint;
  return primitive;
}

Primitive ball(glm::vec3 at, glm::vec3 radii, Look look, glm::quat turn = {1, 0, 0, 0}) {
  Primitive primitive = cone(at, 0, at, 0, look);
  primitive.radii = radii;
  primitive.to_local = glm::transpose(glm::mat3_cast(turn));
  return primitive;
}

glm::quat pitch(float degrees) {
  return glm::angleAxis(glm::radians(degrees), glm::vec3(1, 0, 0));
}
glm::vec3 head_of(int joint) {
  return skeleton()[static_cast<std::size_t>(joint)].head;
}
glm::vec3 tip_of(int joint) {
  return skeleton()[static_cast<std::size_t>(joint)].tip;
}

void add_trunk(Shape& shape) {
  const float edge = .033f;
  shape.add(ball({0, .590f, .015f}, {.205f, .215f, .200f}, {.05f, edge, kTrunkPart}));  // the belly
  shape.add(ball({0, .790f, .000f}, {.138f, .150f, .118f}, {.14f, edge, kTrunkPart}));  // the chest
  shape.add(cone({0, .890f, .000f}, .088f, {0, 1.00f, .015f}, .090f, {.06f, .026f, kTrunkPart}));
}

void add_head(Shape& shape) {
  shape.add(ball({0, 1.110f, .025f}, {.214f, .152f, .174f}, {.06f, .026f, kHeadPart}));
  shape.add(ball({0, 1.065f, .120f}, {.184f, .097f, .122f}, {.08f, .0235f, kHeadPart}));           // the snout
  shape.add_pair(ball({.095f, 1.040f, .060f}, {.108f, .078f, .112f}, {.07f, .0235f, kHeadPart}));  // a cheek
  shape.add_pair(ball({.126f, 1.178f, .096f}, {.090f, .089f, .083f}, {.05f, .019f, kHeadPart}));   // an eye socket
}

void add_tail(Shape& shape) {
  constexpr std::array<float, kTailCount + 1> kRadius{.125f, .103f, .086f, .074f, .064f, .055f, .046f, .037f, .026f};
  for (int i = 0; i < kTailCount; ++i) {
    const auto at = static_cast<std::size_t>(i);
    shape.add(cone(head_of(kTail1 + i), kRadius[at], tip_of(kTail1 + i), kRadius[at + 1],
                   {i == 0 ? .12f : .012f, .0305f - .0013f * static_cast<float>(i), kTailPart}));
  }
  // The paddle at the end: a leaf that stands upright.
  shape.add(ball({0, .600f, -1.165f}, {.021f, .140f, .085f}, {.05f, .017f, kTailPart, kCrestTint}, pitch(-24)));
}

// Rounded plates from the crown down to the tail, tallest between the shoulders.
void add_crest(Shape& shape) {
  struct Plate {
    float y, z, size, lean;
    int part;
  };
  constexpr Plate kPlates[] = {
      {1.262f, -.005f, .038f, -10, kHeadPart}, {1.225f, -.098f, .050f, -45, kHeadPart},
      {1.125f, -.150f, .050f, -80, kHeadPart}, {.965f, -.085f, .044f, -85, kTrunkPart},
      {.865f, -.118f, .056f, -88, kTrunkPart}, {.750f, -.150f, .062f, -85, kTrunkPart},
      {.628f, -.190f, .060f, -75, kTrunkPart}, {.540f, -.268f, .054f, -45, kTailPart},
      {.465f, -.385f, .049f, -32, kTailPart},  {.390f, -.505f, .044f, -20, kTailPart},
      {.346f, -.625f, .040f, -8, kTailPart},   {.330f, -.740f, .036f, 5, kTailPart},
      {.345f, -.850f, .032f, 20, kTailPart},   {.395f, -.952f, .028f, 40, kTailPart},
  };
  for (const Plate& plate : kPlates) {
    shape.add(ball({0, plate.y, plate.z}, {.019f, plate.size, plate.size * .78f},
                   {.022f, .0165f, plate.part, kCrestTint}, pitch(plate.lean)));
  }
}

void add_arm(Shape& shape) {
  const glm::vec3 shoulder = head_of(kUpperArm), elbow = head_of(kForearm), wrist = head_of(kHand);
  const glm::vec3 knuckles = tip_of(kHand);
  shape.add_pair(cone({.085f, .858f, -.002f}, .062f, shoulder, .060f, {.05f, .025f, kArmPart}));
  shape.add_pair(cone(shoulder, .058f, elbow, .046f, {.008f, .021f, kArmPart}));
  shape.add_pair(cone(elbow, .046f, glm::mix(elbow, wrist, .35f), .049f, {.008f, .0195f, kArmPart}));
  shape.add_pair(cone(glm::mix(elbow, wrist, .35f), .049f, wrist, .036f, {.008f, .0195f, kArmPart}));
  const glm::vec3 palm = glm::mix(wrist, knuckles, .62f);
  const glm::vec3 x = glm::normalize(knuckles - wrist);              // along the hand
  const glm::vec3 z = glm::normalize(glm::vec3(0, 0, 1) - x * x.z);  // across the palm
  const glm::vec3 y = glm::cross(z, x);
  const glm::quat turn = glm::normalize(glm::quat_cast(glm::mat3(x, y, z)));
  shape.add_pair(ball(palm, {.062f, .034f, .054f}, {.04f, .0165f, kArmPart}, turn));
  for (int i = -1; i <= 1; ++i) {
    const auto spread = static_cast<float>(i);
    const glm::vec3 root = knuckles + z * (.034f * spread) - x * .006f;
    const glm::vec3 end = root + glm::normalize(x + z * (.42f * spread)) * (i == 0 ? .076f : .066f);
    shape.add_pair(cone(root, .0185f, end, .0160f, {.014f, .0145f, kArmPart}));
    shape.add_pair(ball(end, glm::vec3(.0235f), {.018f, .0140f, kArmPart, kTipTint}));
  }
  const glm::vec3 thumb = palm + z * .034f - x * .02f;
  const glm::vec3 thumb_end = thumb + glm::normalize(z * .9f + x * .42f) * .062f;
  shape.add_pair(cone(thumb, .020f, thumb_end, .0165f, {.016f, .0145f, kThumbPart}));
  shape.add_pair(ball(thumb_end, glm::vec3(.023f), {.018f, .0140f, kThumbPart, kTipTint}));
}

void add_leg(Shape& shape) {
  const glm::vec3 hip = head_of(kThigh), knee = head_of(kShin), ankle = head_of(kFoot);
  shape.add_pair(cone(hip, .102f, glm::mix(hip, knee, .5f), .086f, {.07f, .029f, kLegPart}));
  shape.add_pair(cone(glm::mix(hip, knee, .5f), .086f, knee, .064f, {.010f, .026f, kLegPart}));
  shape.add_pair(cone(knee, .064f, ankle, .046f, {.010f, .0225f, kLegPart}));
  // The foot: a flat wedge from heel to ball, three toes with pads.
  const glm::vec3 heel(.152f, .044f, -.035f), sole(.170f, .040f, .090f);
  shape.add_pair(cone(heel, .044f, sole, .038f, {.04f, .020f, kLegPart}));
  shape.add_pair(ball({.168f, .034f, .085f}, {.074f, .032f, .062f}, {.03f, .019f, kLegPart}));
  for (int i = -1; i <= 1; ++i) {
    const auto spread = static_cast<float>(i);
    const glm::vec3 root(.169f + .040f * spread, .028f, .115f);
    const glm::vec3 end(.175f + .068f * spread, .0265f, i == 0 ? .190f : .170f);
    shape.add_pair(cone(root, .025f, end, .0215f, {.016f, .0170f, kLegPart}));
    shape.add_pair(ball(end, {.029f, .0265f, .029f}, {.016f, .0160f, kLegPart, kTipTint}));
  }
}

// Three feathery gills a side, curving up and back.
void add_gills(Shape& shape) {
  struct Gill {
    Joint joint;
    int part;
    glm::vec3 bend;
    float thick;
  };
  const Gill gills[] = {{kGillTop, kGillTopPart, {.010f, -.022f, -.012f}, .030f},
                        {kGillMid, kGillMidPart, {.000f, -.020f, -.016f}, .032f},
                        {kGillLow, kGillLowPart, {.000f, -.020f, -.016f}, .029f}};
  for (const Gill& gill : gills) {
    const glm::vec3 root = head_of(gill.joint), tip = tip_of(gill.joint);
    const glm::vec3 middle = glm::mix(root, tip, .5f) + gill.bend;
    const Look look{.010f, .0185f, gill.part, kGillTint};
    shape.add_pair(cone(root, gill.thick, middle, gill.thick * .84f, look));
    shape.add_pair(cone(middle, gill.thick * .84f, tip, gill.thick * .55f, look));
    // Fronds hang in the plane that the bow of the gill spans.
    const glm::vec3 along = glm::normalize(tip - root);
    const glm::vec3 across = glm::normalize(glm::cross(along, glm::normalize(glm::vec3(.35f, .1f, 1))));
    for (int i = 0; i < 3; ++i) {
      const float t = .43f + .22f * static_cast<float>(i);
      const glm::vec3 at = t < .5f ? glm::mix(root, middle, t * 2) : glm::mix(middle, tip, t * 2 - 1);
      const float reach = .056f - .008f * static_cast<float>(i);
      for (const float way : {-1.0f, 1.0f}) {
        shape.add_pair(cone(at, .017f, at + (across * way * .9f + along * .55f) * reach, .0145f,
                            {.016f, .0155f, gill.part, kGillTint}));
      }
    }
  }
}

}  // namespace

Shape make_newt_shape() {
  Shape shape;
  add_trunk(shape);
  add_head(shape);
  add_tail(shape);
  add_leg(shape);
  add_arm(shape);
  add_gills(shape);
  add_crest(shape);
  return shape;
}

}  // namespace marrow::sample
