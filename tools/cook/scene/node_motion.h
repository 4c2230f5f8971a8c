// Where nodes are in the course of a clip of the source.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cook/scene/raw.h"

namespace marrow::cook {

// A value as evaluate_curve() gives it; of a channel that moves a node x, y, z, w. Precondition: it has a key.
float value_at(const RawScalar& scalar, float time_s);
glm::dvec4 value_at(const RawChannel& channel, float time_s);

// Some nodes and all above them. Points into the scene and the clip.
class NodeMotion {
 public:
  NodeMotion(const RawScene& scene, const RawClip& clip, const std::vector<int>& nodes);

  // model_from_node, one a node asked for. Cost: step_count() products of matrices and three curves each.
  std::vector<glm::dmat4> at(float time_s) const;
  std::size_t step_count() const { return steps_.size(); }

  // First and last key of what moves them; 0 and 0 if nothing does.
  std::pair<float, float> range() const { return {first_s_, last_s_}; }

 private:
  struct Step {
    const RawNode* node;
    std::size_t above;           // which step; its own number: none
    const RawChannel* paths[3];  // by RawPath; null: as at rest
  };
  std::vector<Step> steps_;  // parents first
  std::vector<std::size_t> asked_;
  float first_s_ = 0, last_s_ = 0;
};

}  // namespace marrow::cook
