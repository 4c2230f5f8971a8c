// Look-at: how far eyes turn becomes limits of their joints, all that is said of it properties of the head.
#include <algorithm>

#include <glm/geometric.hpp>

#include "cook/gltf/vrm/vrm_parts.h"

namespace marrow::cook::gltf {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kMostDegrees = 89;  // the second angle of an euler limit has less than 90

constexpr const char* kMaps[] = {"rangeMapHorizontalInner", "rangeMapHorizontalOuter", "rangeMapVerticalDown",
                                 "rangeMapVerticalUp"};

// In version 1's words.
Json look_at_of(const VrmImport& vrm) {
  if (!vrm.is_0) return member_or_empty(vrm.vrm, "lookAt");
  const Json& from = member_or_empty(vrm.vrm, "firstPerson");
  if (!from.is_object()) return {};
  Json out = Json::object();
  const std::string type = text_or(from, "lookAtTypeName", "");
  if (!type.empty()) out["type"] = type == "BlendShape" ? "expression" : "bone";
  if (from.contains("firstPersonBoneOffset")) {
    const glm::dvec3 offset = vector_or(from, "firstPersonBoneOffset", {});
    out["offsetFromHeadBone"] = {offset.x, offset.y, -offset.z};  // version 0's z goes the other way
  }
  constexpr const char* kOld[] = {"lookAtHorizontalInner", "lookAtHorizontalOuter", "lookAtVerticalDown",
                                  "lookAtVerticalUp"};
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& map = member_or_empty(from, kOld[i]);
    if (map.is_object())
      out[kMaps[i]] = {{"inputMaxValue", number_or(map, "xRange", 90)}, {"outputScale", number_or(map, "yRange", 10)}};
  }
  return out;
}

// From the scene into a joint's own axes at rest.
glm::dvec3 in_joint(const VrmImport& vrm, int node, glm::dvec3 direction) {
  std::vector<int> way;
  for (int n = node; n != kNone; n = vrm.scene.nodes[static_cast<std::size_t>(n)].parent) way.push_back(n);
  for (std::size_t i = way.size(); i-- > 0;)
    direction = glm::conjugate(vrm.scene.nodes[static_cast<std::size_t>(way[i])].rotation) * direction;
  return direction;
}

// Yaw about the vertical, then pitch about what points to the avatar's left; no roll. degrees: as kMaps.
RawLimit eye_limit(const VrmImport& vrm, int eye, bool is_left, const double (&degrees)[4]) {
  const glm::dvec3 left = in_joint(vrm, eye, {vrm.is_0 ? -1 : 1, 0, 0}), up = in_joint(vrm, eye, {0, 1, 0});
  RawLimit out;
  LimitDescription& d = out.description;
  d.kind = LimitKind::euler;
  d.order = AxisOrder::yxz;
  for (int i = 0; i < 3; ++i) {
    d.axis[i] = static_cast<float>(left[i]);
    d.across[i] = static_cast<float>(up[i]);
  }
  const auto rad = [&](std::size_t map) { return static_cast<float>(degrees[map] * kDegree); };
  // Positive to the left, which is outwards for the left eye; and down.
  d.least_rad[0] = -rad(is_left ? 0 : 1);
  d.most_rad[0] = rad(is_left ? 1 : 0);
  d.least_rad[1] = -rad(3);
  d.most_rad[1] = rad(2);
  return out;
}

}  // namespace

void import_eyes(VrmImport& vrm) {
  const Json look_at = look_at_of(vrm);
  if (!look_at.is_object()) return;
  const int holder = vrm.head != kNone ? vrm.head : vrm.avatar;
  add_properties(look_at, "vrm/lookAt", under(vrm.where, vrm.is_0 ? "firstPerson" : "lookAt"), vrm.budget, vrm.report,
                 vrm.scene.nodes[static_cast<std::size_t>(holder)]);
  if (text_or(look_at, "type", "bone") != "bone") return;
  double degrees[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& map = member_or_empty(look_at, kMaps[i]);
    if (!map.is_object()) return;
    degrees[i] = std::clamp(number_or(map, "outputScale", 10), 0.0, kMostDegrees);
  }
  for (const int side : {0, 1}) {
    const int eye = vrm.eyes[side];
    if (eye == kNone || vrm.scene.nodes[static_cast<std::size_t>(eye)].limit) continue;
    vrm.scene.nodes[static_cast<std::size_t>(eye)].limit = eye_limit(vrm, eye, side == 0, degrees);
  }
}

}  // namespace marrow::cook::gltf
