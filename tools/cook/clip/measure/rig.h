// Joints in double precision, and how far apart two poses of them are.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include "cook/clip/measure/source_curves.h"

namespace marrow::cook {

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
