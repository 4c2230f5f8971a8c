// Generates Marrow's own sample character, a newt that walks, twists and reaches, and what it does
// in a game: make_sample OUT.glb [MOVES.glb]
#include <fmt/core.h>

#include <cstdio>
#include <fstream>

#include "paint.h"
#include "shape.h"
#include "write_newt.h"

namespace {

using namespace marrow::sample;

Model make_newt() {
  const Shape shape = make_newt_shape();
  Surface half = polygonise_left_half(shape, {0, -.024f, -1.332f}, {.696f, 1.452f, .348f}, .012f);
  remesh_half(shape, half, 14);
  Model model;
  model.body = mirror_half(half);
  for (const glm::vec3& p : model.body.positions) {
    model.normals.push_back(glm::normalize(shape.gradient(p)));
    model.colours.push_back(skin_colour(shape, p, model.normals.back()));
  }
  model.weights = make_weights(shape, model.body);
  model.face = make_face(shape);
  model.clips = make_clips();
  return model;
}

bool write(const char* path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) fmt::print(stderr, "{}: cannot be written\n", path);
  return bool(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    fmt::print(stderr, "usage: make_sample OUT.glb [MOVES.glb]\n");
    return 1;
  }
  const Model model = make_newt();
  if (!is_watertight(model.body) || model.body.positions.size() > 65535) {
    fmt::print(stderr, "make_sample: the skin has holes or too many vertices; the shape needs a look\n");
    return 5;
  }
  const std::string bytes = make_glb(model);
  if (!write(argv[1], bytes)) return 2;
  fmt::print("{}: {} vertices, {} triangles, {} joints, {} clips, {} bytes\n", argv[1], model.body.positions.size(),
             model.body.triangles.size(), static_cast<int>(kJointCount), model.clips.size(), bytes.size());
  if (argc == 2) return 0;
  const std::vector<Clip> moves = make_moves();
  const std::string of_moves = make_moves_glb(model.face, moves);
  if (!write(argv[2], of_moves)) return 2;
  fmt::print("{}: {} clips, {} bytes\n", argv[2], moves.size(), of_moves.size());
  return 0;
}
