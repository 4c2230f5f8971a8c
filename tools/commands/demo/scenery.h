// What stands about the newt in the demo's movie: a stone, a firefly with its light, prints of its feet.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "common/aligned_bytes.h"
#include "cook/scene/raw.h"
#include "render/figure.h"
#include "render/overlay/strokes.h"
#include "render/performance.h"
#include "story/story.h"

namespace marrow::tools {

// colour, glow: linear.
cook::RawScene prop_scene(cook::RawPrimitive primitive, const glm::vec3& colour, const glm::vec3& glow = glm::vec3(0));

// A thing of one primitive.
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

class Scenery {
 public:
  // The story outlives it.
  Scenery(const Gl& gl, gles3::ProgramSet& programs, const Story& story);

  // At a moment of the story.
  std::vector<Drawable> drawables(std::size_t moment);
  // Prints that are there by then, and the firefly's light as the camera sees it.
  void draw(std::size_t moment, const Camera& camera, Strokes& strokes) const;

 private:
  const Story& story_;
  Prop stone_, firefly_;
};

}  // namespace marrow::tools
