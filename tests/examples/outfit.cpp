// A body and an outfit from a file of its own, in one pose. Of files that are not packed.
#include <marrow/marrow.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

struct Asset {
  std::vector<char> bytes;
  marrow::File file;

  bool open(const char* path) {
    std::ifstream stream(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
    return load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()}, file) == marrow::Status::ok;
  }
};

// Skins all meshes of a character that is finished; gives the number of vertices, or 0.
std::size_t skin(const marrow::Character& character, std::vector<float>& positions) {
  std::size_t vertices = 0;
  for (const marrow::CharacterMesh& m : character.meshes) {
    positions.resize(3 * std::size_t(m.mesh.geometry.slot_count));
    if (skin_ssd(m.mesh, m.palette, {.positions = positions}) != marrow::Status::ok) return 0;
    vertices += m.mesh.geometry.vertex_count;
  }
  return vertices;
}

int main(int argc, char** argv) {
  Asset body, hair;
  if (argc < 3 || !body.open(argv[1]) || !hair.open(argv[2])) return 1;

  // Once a load. An outfit that was cooked for another body is refused here.
  std::vector<std::byte> animations_memory(animations_bytes(body.file, body.file));
  std::vector<std::byte> outfit_memory(outfit_bytes(hair.file));
  marrow::Animations animations;
  marrow::Outfit outfit;
  if (make_animations(body.file, body.file, animations_memory, animations) != marrow::Status::ok ||
      make_outfit(body.file, hair.file, outfit_memory, outfit) != marrow::Status::ok)
    return 1;
  const marrow::Animation* const walk = find_animation(animations, "walk");
  if (walk == nullptr) return 1;

  // Once a character.
  std::vector<std::byte> wearer_memory(character_bytes(body.file, {})), worn_memory(character_bytes(hair.file, {}));
  marrow::Character wearer, worn;
  if (make_character(body.file, {}, wearer_memory, wearer) != marrow::Status::ok ||
      make_character(hair.file, {}, worn_memory, worn) != marrow::Status::ok)
    return 1;

  std::size_t vertices = 0;
  std::vector<float> positions;
  marrow::Playback playback;
  for (int frame = 0; frame < 60; ++frame) {
    if (advance(playback, walk->duration_s, 1.0f / 60) != marrow::Status::ok ||
        pose_character(wearer, {{walk, clip_time(playback)}}) != marrow::Status::ok)
      return 1;
    // Here the body reaches, looks, places feet.
    if (finish_character(wearer) != marrow::Status::ok) return 1;
    // Joints of the outfit's own at rest, or by a clip of its file; then all of them where the body is.
    if (sample_character(worn, {}) != marrow::Status::ok || follow_body(outfit, wearer, worn) != marrow::Status::ok)
      return 1;
    // Here springs let the outfit's own joints swing.
    if (finish_character(worn) != marrow::Status::ok) return 1;
    vertices += skin(wearer, positions) + skin(worn, positions);
  }
  std::printf("%zu meshes of the body, %zu of the outfit, %zu vertices in 60 frames\n", wearer.meshes.size,
              worn.meshes.size, vertices);
}
