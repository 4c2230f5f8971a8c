// Source curves in double precision: what a clip's tracks mean, by the glTF 2.0 specification (appendix C).
#pragma once

#include <array>
#include <vector>

#include <glm/vec4.hpp>

#include "cook/scene/built.h"
#include "cook/scene/views.h"

namespace marrow::cook {

// How far apart two times may be that are one but for rounding in single precision: half a last place each, and as much
// for whoever computed them in such numbers.
double rounding_at(float time_s);

// Before a key, and so far that no rounding of floats makes it the key.
inline float just_before(float key_s) {
  return key_s - key_s * 0x1p-21f;
}

// A STEP track that changes cannot be blended between frames, nor can one with different keys at one time, but for the
// rounding of floats. Exporters write STEP for what is constant but for that.
bool jumps(const BuiltClip& clip, const Track& track);

// A clip's joints as functions of time.
class SourceCurves {
 public:
  SourceCurves(const BuiltClip& clip, const BuiltSkeleton& skeleton);

  // parent_from_joint at a time, clamped to each track's keys.
  Transform at(std::size_t joint, double time_s) const;
  const Track* track(std::size_t joint, TrackPath path) const { return tracks_[joint][static_cast<std::size_t>(path)]; }

 private:
  glm::dvec4 evaluate(const Track& track, double time_s) const;

  const BuiltClip* clip_;
  std::vector<Transform> rest_;
  std::vector<std::array<const Track*, 3>> tracks_;  // a joint: translation, rotation, scale; null: rest
};

}  // namespace marrow::cook
