// Example shapes: a game sets two numbers, and gets the weights of morph targets.
// $ shapes face.mrw
#include "asset.h"

#include <cmath>

using marrow::Status;

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "face.mrw") != Status::ok) return 1;

  // Once a load.
  marrow::ExampleSpace space;
  if (asset.file.example_space(0, space) != Status::ok) return 1;
  std::printf("\"%s\" is made of %u examples by", space.name, space.example_count);
  for (const marrow::ExampleParameter& parameter : space.parameters)
    std::printf(" \"%s\"", asset.file.text(parameter.name));
  std::printf("\n");

  // Every frame: a point of the space.
  const marrow::Mesh mesh = asset.file.mesh(space.meshes[0]);
  std::vector<float> weights(mesh.targets.size);
  const float points[][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 2}, {0.5f, 0.5f}};
  for (const float(&point)[2] : points) {
    if (evaluate_examples(space, point, weights) != Status::ok) return 1;
    std::printf("at %.1f %.1f:", double(point[0]), double(point[1]));
    for (std::size_t t = 0; t < weights.size(); ++t)
      std::printf(" %s %ld %%", asset.file.text(mesh.targets[t].name), std::lround(100 * weights[t]));
    std::printf("\n");
  }
}

// Prints:
//   "moods" is made of 4 examples by "mood" "head.glow"
//   at 0.0 0.0: smile 0 % blink 0 %
//   at 1.0 0.0: smile 100 % blink 0 %
//   at 0.0 1.0: smile 0 % blink 100 %
//   at 2.0 2.0: smile 100 % blink 0 %
//   at 0.5 0.5: smile 43 % blink 36 %
