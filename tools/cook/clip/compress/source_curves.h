// Source curves in double precision: what a clip's tracks mean, by the glTF 2.0 specification (appendix C).
#pragma once

#include <array>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "cook/scene/built.h"

namespace marrow::cook {

struct Transform {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
};

// A clip's joints as functions of time.
class SourceCurves {
 public:
  SourceCurves(const BuiltClip& clip, const BuiltSkeleton& skeleton);

  // parent_from_joint at a time, clamped to each track's keys.
  Transform at(std::size_t joint, double time_s) const;
  const Track* track(std::size_t joint, Path path) const { return tracks_[joint][static_cast<std::size_t>(path)]; }

 private:
  glm::dvec4 evaluate(const Track& track, double time_s) const;

  const BuiltClip* clip_;
  std::vector<Transform> rest_;
  std::vector<std::array<const Track*, 3>> tracks_;  // a joint: translation, rotation, scale; null: rest
};

// The rest pose of a skeleton, joint by joint.
std::vector<Transform> rest_transforms(const BuiltSkeleton& skeleton);

}  // namespace marrow::cook
