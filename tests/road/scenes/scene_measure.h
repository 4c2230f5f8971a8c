// How far what was cooked of a random scene is from the reference, beside how far the cooker says that it is.
#pragma once

#include <cstddef>
#include <string>

#include "road/scenes/random_scene.h"

namespace marrow::test {

// The most that a real error may be of what is said and what floats may do together: between the moments that the
// cooker looks at it may be a little larger.
inline constexpr double kMostRatio = 1.1;

// Real errors, the largest of each kind, as shares of what is said of them.
struct SceneErrors {
  double lossless = 0;                  // nothing packed, nothing compressed: by 2e-5 of the scene's diagonal
  double vertices = 0;                  // of clips, by max_vertex_error_m
  double joints = 0;                    // of clips, by max_error_m
  double promise = 0;                   // of clips, by --clip-error; what is said, too
  double rest = 0;                      // of packed meshes at rest, by max_position_error_m and max_target_error_m
  std::size_t compared = 0, coded = 0;  // vertices; clips in segments
  std::string worst;                    // where the largest of all is
  std::string refused;                  // why; what can be cooked of it all the same is compared

  double largest() const;
};

SceneErrors measure(const RandomScene& scene);

}  // namespace marrow::test
