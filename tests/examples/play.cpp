#include <marrow/owned.h>

#include <cstdio>
#include <fstream>
#include <iterator>

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "hero.mrw";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::perror(path), 1;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::OwnedFile file;
  marrow::OwnedCharacter newt;
  must(make_owned(bytes, file));
  must(make_owned(file, {}, newt));
  const marrow::Animation* const walk = find_animation(file.animations, "walk");
  if (walk == nullptr) return 1;
  std::vector<float> positions(3 * newt.meshes[0].mesh.geometry.slot_count);
  marrow::Playback playback;
  for (int frame = 0; frame < 60; ++frame) {  // nothing here allocates
    must(advance(playback, walk->duration_s, 1.0f / 60));
    must(pose_character(newt, {{walk, clip_time(playback)}}));
    must(finish_character(newt));  // before it a game reaches, looks, places feet
    must(skin_ssd(newt.meshes[0].mesh, newt.meshes[0].palette, {.positions = positions}));
  }
  std::printf("vertex 0 at %g %g %g m\n", double(positions[0]), double(positions[1]), double(positions[2]));
}
