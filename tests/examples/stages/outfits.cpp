// A body and an outfit from a file of its own, in one pose.
// $ outfits hero.mrw suit.mrw
#include "asset.h"

using marrow::Status;

// Skins all meshes of a character that is finished; gives the number of vertices, or 0.
std::size_t skin(const marrow::Character& character, std::vector<float>& positions) {
  std::size_t vertices = 0;
  for (const marrow::CharacterMesh& m : character.meshes) {
    positions.resize(3 * std::size_t(m.mesh.geometry.slot_count));
    if (skin_ssd(m.mesh, m.palette, {.positions = positions}) != Status::ok) return 0;
    vertices += m.mesh.geometry.vertex_count;
  }
  return vertices;
}

int main(int argc, char** argv) {
  Asset body, suit;
  if (argc < 3 || body.open(argv[1]) != Status::ok || suit.open(argv[2]) != Status::ok) return 1;

  // Once a load. An outfit that was cooked for another body is refused here.
  std::vector<std::byte> animations_memory(marrow::block_bytes(animations_bytes(body.file, body.file)));
  std::vector<std::byte> outfit_memory(marrow::block_bytes(outfit_bytes(suit.file)));
  marrow::Animations animations;
  marrow::Outfit outfit;
  if (make_animations(body.file, body.file, marrow::block_in(animations_memory), animations) != Status::ok ||
      make_outfit(body.file, suit.file, marrow::block_in(outfit_memory), outfit) != Status::ok)
    return 1;
  const marrow::Animation* const walk = find_animation(animations, "walk");
  if (walk == nullptr) return 1;

  // Once a character.
  std::vector<std::byte> wearer_memory(marrow::block_bytes(character_bytes(body.file, {})));
  std::vector<std::byte> worn_memory(marrow::block_bytes(character_bytes(suit.file, {})));
  marrow::Character wearer, worn;
  if (make_character(body.file, {}, marrow::block_in(wearer_memory), wearer) != Status::ok ||
      make_character(suit.file, {}, marrow::block_in(worn_memory), worn) != Status::ok)
    return 1;

  std::size_t vertices = 0;
  std::vector<float> positions;
  marrow::Playback playback;
  for (int frame = 0; frame < 60; ++frame) {
    if (advance(playback, walk->duration_s, 1.0f / 60) != Status::ok ||
        pose_character(wearer, {{walk, clip_time(playback)}}) != Status::ok)
      return 1;
    // Here the body reaches, looks, places feet.
    if (finish_character(wearer) != Status::ok) return 1;
    // Joints of the outfit's own at rest, or by a clip of its file; then all of them where the body is.
    if (sample_character(worn, {}) != Status::ok || follow_body(outfit, wearer, worn) != Status::ok) return 1;
    // Here springs let the outfit's own joints swing.
    if (finish_character(worn) != Status::ok) return 1;
    vertices += skin(wearer, positions) + skin(worn, positions);
  }
  std::printf("%zu meshes of the body, %zu of the outfit, %zu vertices in 60 frames\n", wearer.meshes.size,
              worn.meshes.size, vertices);
}
