// Motion of a rig that is to be put onto another: where its nodes are in the scene, frame by frame.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cook/scene/raw.h"

namespace marrow::cook {

// What a joint turns and goes as: a node, or one between two nodes.
struct Counterpart {
  int node = kNone;   // kNone: the joint keeps its rest pose
  int other = kNone;  // kNone: `node` alone
  double share = 0;   // of `other`

  bool is_there() const { return node != kNone; }
};

// Nodes are those of the scene, and have their numbers. Rotations are relative to the rest pose, in the scene: a bone
// that points along v at rest points along turn · v. Scales move places, and turn nothing. In the space of a mirrored
// node rotations go the other way round.
class Take {
 public:
  // Points into `scene`.
  explicit Take(const RawScene& scene);

  const RawScene& scene() const { return *scene_; }
  const std::vector<std::size_t>& order() const { return order_; }  // parents first

  // Opens a clip of the scene, with frames at its keys. Unless it is motion capture, frames are added between keys that
  // are farther apart than 1/24 s; fewer where the poses of `joints` joints would be too many.
  void open(const RawClip& clip, std::size_t joints);
  const std::vector<float>& times_s() const { return times_s_; }  // of frames
  // For each node whether the clip moves it, or one above it, from its place.
  std::vector<char> moved_nodes() const;

  // Goes to a frame of the clip.
  void pose(std::size_t frame);
  glm::dvec3 place(const Counterpart& at) const { return mixed(places_, at); }
  glm::dvec3 place(std::size_t node) const { return places_[node]; }
  // Of a point in a node's space.
  glm::dvec3 place(std::size_t node, const glm::dvec3& point) const {
    return glm::dvec3(matrices_[node] * glm::dvec4(point, 1));
  }
  glm::dquat turn(const Counterpart& at) const;

  glm::dvec3 rest(const Counterpart& at) const { return mixed(rest_, at); }
  glm::dvec3 rest(std::size_t node) const { return rest_[node]; }

 private:
  struct Channels {
    const RawChannel* paths[3] = {nullptr, nullptr, nullptr};  // by RawPath; null: as at rest
  };
  glm::dvec3 mixed(const std::vector<glm::dvec3>& places, const Counterpart& at) const;
  void pose_at(const float* time_s);

  const RawScene* scene_;
  const RawClip* clip_ = nullptr;
  std::vector<std::size_t> order_;
  std::vector<char> mirrored_;      // the space of a node
  std::vector<Channels> channels_;  // a node
  std::vector<float> times_s_;
  std::vector<glm::dmat4> matrices_;  // model_from_node
  std::vector<glm::dquat> turns_, rest_turns_;
  std::vector<glm::dvec3> places_, rest_;
};

// A rotation as the space above it has it, if that is mirrored along x.
inline glm::dquat in_mirrored(const glm::dquat& q) {
  return {q.w, q.x, -q.y, -q.z};
}

}  // namespace marrow::cook
