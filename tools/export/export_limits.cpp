// Joint limits become `extras.marrow.limits` of the joints' nodes, as docs/limits.schema.json has them.
#include <algorithm>
#include <cmath>

#include "export/export_parts.h"
#include "marrow/limits.h"
#include "math/joint.h"

namespace marrow::tools {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

// From the tangent of a quarter.
double degrees(float quarter_tangent) {
  return 4 * std::atan(static_cast<double>(quarter_tangent)) / kDegree;
}

Json range_of(const AngleRange& range, double most) {
  const double middle = degrees(range.middle), half = degrees(range.half_width);
  return Json::array({std::max(middle - half, -most), std::min(middle + half, most)});
}

Json list_of(const Vector3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json euler_of(const JointLimit& limit) {
  constexpr const char* kOrders[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
  const std::string order = kOrders[static_cast<std::size_t>(limit.order)];
  Json out = {{"order", order}};
  for (std::size_t i = 0; i < 3; ++i) out[order.substr(i, 1)] = range_of(limit.angles[i], i == 1 ? 90 : 360);
  return out;
}

Json limits_of(const JointLimit& limit, const Rotation& rest) {
  const Rotation joint_from_limit = rotation(limit.joint_from_limit);
  const Json axis = list_of(rotate(joint_from_limit, {1, 0, 0})), across = list_of(rotate(joint_from_limit, {0, 1, 0}));
  Json out = Json::object();
  if (limit.kind == LimitKind::hinge) out["hinge"] = {{"axis", axis}, {"angle", range_of(limit.angles[0], 360)}};
  if (limit.kind == LimitKind::cone)
    out["cone"] = {{"axis", axis},
                   {"across", across},
                   {"swing", Json::array({std::min(degrees(limit.angles[1].half_width), 170.0),
                                          std::min(degrees(limit.angles[2].half_width), 170.0)})},
                   {"twist", range_of(limit.angles[0], 360)}};
  if (limit.kind == LimitKind::euler) {
    out["euler"] = euler_of(limit);
    if (std::fabs(joint_from_limit.w) < 0.9999999f) {
      out["euler"]["axis"] = axis;
      out["euler"]["across"] = across;
    }
  }
  const Rotation zero = conjugate(rotation(limit.limit_from_parent)) * conjugate(joint_from_limit);
  const Rotation off = conjugate(normalised(rest)) * zero;
  if (limit.kind != LimitKind::none && dot(axis_part(off), axis_part(off)) > 1e-12f)
    out["zero"] = Json::array({zero.x, zero.y, zero.z, zero.w});
  const auto set_rate = [&](const char* name, float rate) {
    if (rate > 0) out[name] = std::min(static_cast<double>(rate) / kDegree, 1e9);
  };
  set_rate("speed", limit.rate.speed);
  set_rate("acceleration", limit.rate.acceleration);
  return out;
}

}  // namespace

void export_limits(ExportScene& scene) {
  for (std::uint32_t i = 0; i < scene.file.skeleton_count(); ++i) {
    const Skeleton skeleton = scene.file.skeleton(i);
    const Span<const SoaTransform> rest(skeleton.rest, skeleton.soa_size());
    for (const JointLimit& limit : skeleton.limits) {
      const Json limits = limits_of(limit, rotation_of(rest, limit.joint));
      if (!limits.empty())
        scene.glb.json["nodes"][scene.joint_nodes[i][limit.joint]]["extras"]["marrow"]["limits"] = limits;
    }
  }
}

}  // namespace marrow::tools
