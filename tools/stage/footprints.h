// Where the feet of a clip stand, and the way of its root.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "marrow/roles.h"
#include "pose/evaluate.h"

namespace marrow::tools {

// A foot on the ground from time_s until until_s.
struct Footprint {
  Role role = Role::none;
  float time_s = 0, until_s = 0;
  glm::vec3 at{0};  // model space, at time_s
};

// Of a clip: its contacts in its poses.
class Footprints {
 public:
  Footprints(const File& file, const Play& play);

  // Of the ground below each foot that stands.
  std::vector<float> heights() const;
  // A print as the ground has carried it at a moment.
  struct Carried {
    glm::vec3 at{0};  // model space
    Role role = Role::none;
    bool stands = false;  // a foot, on it
  };
  // Those of the round before, this one and the next.
  std::vector<Carried> at(float time_s) const;
  // The root's path over a round, as the ground has carried it; empty of one that goes nowhere.
  std::vector<glm::vec3> path(float time_s) const;

  // Events and contacts of the clip.
  const ClipMotion& motion() const { return motion_; }
  // An event's.
  const std::string& name(std::size_t event) const { return names_[event]; }

 private:
  glm::mat4 ground_since(double from_s, double to_s) const;

  ClipMotion motion_;
  std::vector<Footprint> prints_;
  std::vector<std::string> names_;  // an event
  glm::vec3 ground_m_s_{0};         // of a clip that walks on the spot, whose poses have its root
};

}  // namespace marrow::tools
