#include "cook/skin/joint_motion.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "deform/rotations.h"
#include "marrow/limits.h"

namespace marrow::cook {
namespace {

// Of the skin's joints: the axes in the bind pose, and the rotation from the joint above.
struct Bound {
  glm::dmat3 axes, from_axes;
  glm::dquat local;
};

Bound bound(const DeformSource& source, const BuiltSkeleton& skeleton, std::uint32_t joint) {
  Bound out;
  out.from_axes = glm::dmat3(source.inverse_bind[joint]);
  out.axes = glm::inverse(out.from_axes);
  const std::uint16_t own = source.joints[joint];
  const int above = source.parents[joint];
  if (above != kNone && source.joints[static_cast<std::size_t>(above)] == skeleton.parents[own]) {
    const glm::dmat3 from_above(source.inverse_bind[static_cast<std::size_t>(above)]);
    out.local = deform::quaternion_of(deform::rotation_of(from_above * out.axes));
  } else {
    const auto& rest = skeleton.rest[own / 4].rotation;
    const auto part = [&](std::size_t c) { return static_cast<double>(rest[c][own % 4]); };
    out.local = glm::dquat(part(3), part(0), part(1), part(2));
  }
  return out;
}

// Axes may be scaled or mirrored; turns go through them as matrices.
glm::dquat through(const glm::dmat3& from, const glm::dquat& turn, const glm::dmat3& to) {
  return deform::quaternion_of(deform::rotation_of(from * glm::mat3_cast(turn) * to));
}

glm::dquat limited(const JointLimit& limit, const Bound& joint, const glm::dquat& turn) {
  const glm::dquat wanted = joint.local * through(joint.from_axes, turn, joint.axes);
  float local[4] = {static_cast<float>(wanted.x), static_cast<float>(wanted.y), static_cast<float>(wanted.z),
                    static_cast<float>(wanted.w)};
  if (clamp_rotation(limit, local) != Status::ok) return turn;
  const glm::dquat allowed(static_cast<double>(local[3]), static_cast<double>(local[0]), static_cast<double>(local[1]),
                           static_cast<double>(local[2]));
  return through(joint.axes, glm::conjugate(joint.local) * glm::normalize(allowed), joint.from_axes);
}

}  // namespace

deform::RangeOfMotion range_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton) {
  deform::MotionOptions options;
  options.nearest_allowed = [&](std::uint32_t joint, const glm::dquat& turn) {
    const JointLimit* const limit = find_limit(skeleton.limits, source.joints[joint]);
    return limit == nullptr ? turn : limited(*limit, bound(source, skeleton, joint), turn);
  };
  return deform::range_of_motion(source.mesh, source.parents, source.centres, options);
}

std::vector<std::string> left_out_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton,
                                            const std::vector<deform::LeftOut>& left_out) {
  using Why = deform::LeftOut::Why;
  std::vector<std::string> out;
  for (const Why why :
       {Why::no_vertices, Why::not_finite, Why::no_axis, Why::limits, Why::limits_of_twist, Why::limits_of_bends}) {
    std::string names;
    for (const deform::LeftOut& joint : left_out) {
      if (joint.why != why) continue;
      names += (names.empty() ? "" : ", ") + skeleton.joint_names[source.joints[joint.joint]];
    }
    if (!names.empty()) out.push_back(deform::text_of(why) + (": " + names));
  }
  return out;
}

}  // namespace marrow::cook
