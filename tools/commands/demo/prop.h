// A thing in a picture beside the characters: of one colour, in a file of its own.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "common/aligned_bytes.h"
#include "cook/scene/raw.h"
#include "render/figure.h"
#include "render/performance.h"

namespace marrow::tools {

// colour, glow: linear.
cook::RawScene prop_scene(cook::RawPrimitive primitive, const glm::vec3& colour, const glm::vec3& glow = glm::vec3(0));

class Prop {
 public:
  Prop(const Gl& gl, gles3::ProgramSet& programs, const cook::RawScene& scene);

  // Where it is made.
  std::vector<Drawable> drawables() { return figure_->from_cpu(posed_); }
  // Moved there.
  std::vector<Drawable> drawables_at(const glm::vec3& place);
  Box box() const { return box_of(posed_); }

 private:
  AlignedBytes bytes_;
  File file_;
  std::unique_ptr<Figure> figure_;
  std::vector<PosedMesh> posed_, moved_;
};

}  // namespace marrow::tools
