// Where the feet of a clip stand, and the way of its root.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "marrow/roles.h"
#include "pose/evaluate.h"

namespace marrow::tools {

class Drawer;

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
  // Prints of the round before, this one and the next, as the ground has carried them at time_s, and the root's path.
  void draw(float time_s, Drawer& drawer) const;
  // A row a foot, with its contacts, other events, and time_s: as wide as the panel.
  void draw_rows(float time_s, float scale) const;

 private:
  glm::mat4 ground_since(double from_s, double to_s) const;

  ClipMotion motion_;
  std::vector<Footprint> prints_;
  std::vector<std::string> names_;  // an event
  glm::vec3 ground_m_s_{0};         // of a clip that walks on the spot, whose poses have its root
};

}  // namespace marrow::tools
