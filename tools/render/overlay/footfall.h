// A character's feet: the prints that they leave where they come down.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/animator.h"
#include "pose/evaluate.h"
#include "render/overlay/ground.h"

namespace marrow::tools {

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
