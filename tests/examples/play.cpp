// Plays an animation on the CPU.
#include <marrow/draco.h>
#include <marrow/marrow.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv) {
  std::ifstream stream(argc > 1 ? argv[1] : "character.mrw", std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::Span<const std::byte> block(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size());
  std::vector<std::byte> memory;
  if (marrow::is_packed(block)) {  // meshes are compressed, unless cooked with --mesh-codec none
    const marrow::MeshDecoder decoders[] = {marrow::draco_decoder()};
    marrow::UnpackSizes sizes;
    if (unpack_sizes(block, sizes) != marrow::Status::ok) return 1;
    memory.resize(sizes.memory_bytes);
    if (unpack(block, {decoders, 1}, memory, block) != marrow::Status::ok) return 1;
  }
  marrow::File file;
  if (load(block, file) != marrow::Status::ok) return 1;

  std::vector<std::byte> shared(animations_bytes(file, file)), own(character_bytes(file, {}));
  marrow::Animations animations;
  marrow::Character character;
  if (make_animations(file, file, shared, animations) != marrow::Status::ok ||
      make_character(file, {}, own, character) != marrow::Status::ok)
    return 1;
  const marrow::Animation* const walk = find_animation(animations, "walk");
  if (walk == nullptr) return 1;
  const marrow::CharacterMesh& body = character.meshes[0];
  std::vector<float> positions(3 * body.mesh.geometry.slot_count);
  marrow::Playback playback;

  for (int frame = 0; frame < 60; ++frame) {  // nothing here allocates
    if (advance(playback, walk->duration_s, 1.0f / 60) != marrow::Status::ok) return 1;
    if (pose_character(character, {{walk, clip_time(playback)}}) != marrow::Status::ok) return 1;
    // Here the game reaches, looks, places feet.
    if (finish_character(character) != marrow::Status::ok ||
        skin_ssd(body.mesh, body.palette, {.positions = positions}) != marrow::Status::ok)
      return 1;
  }
  std::printf("%s: vertex 0 at %g %g %g m\n", body.mesh.name, double(positions[0]), double(positions[1]),
              double(positions[2]));
}
