// What is drawn on the ground below a character that goes somewhere: squares, and the prints of its feet.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "image/image.h"
#include "marrow/animator.h"
#include "marrow/roles.h"
#include "pose/evaluate.h"
#include "render/overlay/strokes.h"
#include "render/studio.h"

namespace marrow::tools {

// A square of the ground, metres: 1, 2 or 5 times a power of ten, at most so many times the radius.
float ground_square(float radius);
// Lines that fade out round a shot's figure, or round all of its way; empty: none is known.
void add_squares(const Shot& shot, const Box& way, Strokes& strokes);

// Of left feet and front feet, of right ones, and of what is neither.
Rgb foot_colour(Role role);

// A foot that came down.
struct GroundPrint {
  Role role = Role::none;
  glm::vec3 at{0};     // its ball, on the ground
  glm::vec3 ahead{0};  // unit, along the ground
  float length_m = 0;
};
// On the shot's ground. It pales with its age, and stays.
void add_print(const GroundPrint& print, double age_s, const Shot& shot, Strokes& strokes);

// A character's feet: the prints that they leave where they come down.
class Feet {
 public:
  // By the soles and roles of the file's joints.
  explicit Feet(const File& file);

  // Of the feet that came down in a step, as its events say. character: in its pose of the step's end, in the world.
  std::vector<GroundPrint> prints(const AnimatorStep& step, const Character& character) const;

 private:
  // How long a foot is, by its ankle and its ball at rest.
  struct Foot {
    Role role = Role::none;
    std::uint32_t skeleton = 0, joint = 0;
    float ball[3] = {};  // joint space
    float length_m = 0;
  };
  std::vector<Foot> feet_;
};

}  // namespace marrow::tools
