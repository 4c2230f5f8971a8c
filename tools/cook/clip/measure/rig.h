// Joints in double precision: their source curves, and how far apart two poses of them are.
#pragma once

#include <array>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include "cook/scene/built.h"
#include "cook/scene/views.h"

namespace marrow::cook {

// How far apart two times may be that differ by rounding alone: half a last place each in single precision, and as much
// for whoever computed them so.
double rounding_at(float time_s);

// A time before a key, so far that no rounding of floats makes it the key.
inline float just_before(float key_s) {
  return key_s - key_s * 0x1p-21f;
}

// Whether a track cannot be blended between frames: a STEP track that changes, or one with different keys at one time.
// Differences by rounding alone do not count, as exporters write STEP for what is constant.
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

// An affine map: x → linear · x + origin.
struct World {
  glm::dmat3 linear{1.0};
  glm::dvec3 origin{0};
};

World operator*(const World& a, const World& b);
World to_world(const Transform& t);

struct Rig {
  explicit Rig(const BuiltSkeleton& skeleton);

  std::size_t size() const { return parents.size(); }
  // model_from_joint of a joint above whose parent stands at `parent` (null for roots).
  World place(std::size_t joint, const World* parent, const Transform& local) const {
    return (parent != nullptr ? *parent : above[joint]) * to_world(local);
  }

  // A joint and everything below it, ascending. In a chain all joints together have as many as its length squared.
  std::vector<std::size_t> subtree(std::size_t joint) const;
  // Of each joint the least value that it or something below it has.
  std::vector<double> least_below(const std::vector<double>& values) const;

  std::vector<int> parents;                        // kNone for roots
  std::vector<World> above;                        // what stands above a root; the identity for others
  std::vector<Transform> rest;                     // parent_from_joint
  std::vector<std::vector<std::size_t>> children;  // of a joint
  std::vector<std::size_t> subtree_sizes;          // of a joint and everything below it
  std::vector<World> world;                        // model_from_joint at rest
  std::vector<double> scale_above;                 // scene units a unit of a joint's translation, at rest
};

// What is promised about a clip: how far points on a shell round each joint, and what hangs on it, may stray, in scene
// units.
struct Promise {
  std::vector<double> error;  // a joint
  double shell = 0.03;
  bool of_vertices = true;  // vertices keep it too, measured in the end
  // A joint: what hangs on it farther out than the shell. A place in its space times a weight, and the weight.
  std::vector<std::vector<glm::dvec4>> points;
  std::vector<double> reach;  // a joint: how far out the shell and the points are, at rest

  void watch(std::size_t joint, const glm::dvec4& point, const Rig& rig);
};

// The largest distance between the six points of the shell of a joint in two poses. The shell is round in the source's
// pose at scene scale, however its joint is scaled.
double shell_error(const World& source, const World& other, double shell);

// How far what a joint carries is from it, at rest: the joints below it, their shells and points.
double reach_below(std::size_t joint, const Rig& rig, const Promise& promise);

}  // namespace marrow::cook
