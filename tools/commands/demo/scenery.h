// What stands about the newt in the demo's movie: a stone, a firefly with its light, prints of its feet.
#pragma once

#include <vector>

#include "commands/demo/prop.h"
#include "render/overlay/strokes.h"
#include "story/story.h"

namespace marrow::tools {

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
