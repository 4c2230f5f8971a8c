// Plays an animation on the CPU, of a file that was cooked with --mesh-codec none.
#include <marrow/marrow.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

void must(marrow::Status status) {
  if (status != marrow::Status::ok) throw std::runtime_error(to_string(status));
}

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "hero.mrw";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::perror(path), 1;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::File file;
  must(load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()}, file));
  std::vector<std::byte> shared(animations_bytes(file, file)), own(character_bytes(file, {}));
  marrow::Animations animations;
  marrow::Character newt;
  must(make_animations(file, file, shared, animations));
  must(make_character(file, {}, own, newt));
  const marrow::Animation* const walk = find_animation(animations, "walk");
  if (walk == nullptr || newt.meshes.empty()) return 1;
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
