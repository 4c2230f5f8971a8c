// Where a node is in the course of a clip of the source.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cook/scene/raw.h"

namespace marrow::cook {

// A number's value, as evaluate_curve() gives it. Precondition: it has a key.
float value_at(const RawScalar& scalar, float time_s);

// A node and all above it. Points into the scene and the clip.
class NodeMotion {
 public:
  NodeMotion(const RawScene& scene, const RawClip& clip, int node);

  // scene_from_node.
  glm::dmat4 at(float time_s) const;

  // First and last key of what moves it; 0 and 0 if nothing does.
  std::pair<float, float> range() const { return {first_s_, last_s_}; }

 private:
  struct Step {
    const RawNode* node;
    const RawChannel* paths[3];  // by RawPath; null: as at rest
  };
  std::vector<Step> steps_;  // the node first, its root last
  float first_s_ = 0, last_s_ = 0;
};

}  // namespace marrow::cook
