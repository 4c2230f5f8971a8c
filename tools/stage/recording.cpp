#include "stage/recording.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::tools {
namespace {

constexpr float kDegPerRad = 57.29577951f;

// The angle that is nearest to `before`, of all that are whole turns apart.
float continued(float before, float angle_deg) {
  return angle_deg + 360 * std::round((before - angle_deg) / 360);
}

void add(JointCurves& out, const JointTransform& t) {
  const glm::vec3 plain = angles_deg(t.rotation);
  glm::vec3 angles = plain;
  if (!out.rotation_deg[0].empty()) {
    // The same rotation has two sets of angles; the one that goes on as it came is shown.
    const glm::vec3 before(out.rotation_deg[0].back(), out.rotation_deg[1].back(), out.rotation_deg[2].back());
    const glm::vec3 other(plain.x + 180, 180 - plain.y, plain.z + 180);
    const auto on_from = [&](const glm::vec3& set) {
      return glm::vec3(continued(before.x, set.x), continued(before.y, set.y), continued(before.z, set.z));
    };
    const auto away = [&](const glm::vec3& set) { return glm::length(set - before); };
    const glm::vec3 a = on_from(plain), b = on_from(other);
    angles = away(b) < away(a) ? b : a;
  }
  for (int i = 0; i < 3; ++i) {
    out.translation[i].push_back(t.translation[i]);
    out.rotation_deg[i].push_back(angles[i]);
    out.scale[i].push_back(t.scale[i]);
  }
}

}  // namespace

glm::vec3 angles_deg(const float (&q)[4]) {
  const float x = q[0], y = q[1], z = q[2], w = q[3];
  // From the matrix rotate(z) · rotate(y) · rotate(x), whose last row begins with -sin(y).
  const float sine = std::clamp(2 * (w * y - x * z), -1.0f, 1.0f);
  return kDegPerRad * glm::vec3(std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), std::asin(sine),
                                std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)));
}

JointCurves record_joint(const File& file, const Play& play, std::uint32_t skeleton, std::uint32_t joint, int moments) {
  JointCurves out;
  Character probe(file);
  probe.set_change([&](std::uint32_t which, const Pose& pose) {
    if (which != skeleton) return;
    JointTransform transform;
    check(get_joint(pose.local, joint, transform));
    add(out, transform);
    const Affine& place = pose.model_from_joint[joint];
    out.places.emplace_back(place.rows[0][3], place.rows[1][3], place.rows[2][3]);
  });
  for (int i = 0; i < moments; ++i)
    probe.pose(play, play.duration_s * static_cast<float>(i) / static_cast<float>(moments - 1));
  return out;
}

}  // namespace marrow::tools
