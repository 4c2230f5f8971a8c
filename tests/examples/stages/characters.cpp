// A whole character in two calls a frame: all skeletons, all meshes, blended animations.
// $ characters hero.mrw
#include "asset.h"

using marrow::Status;

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "hero.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;

  // Once a load: the animations, for any number of characters.
  std::vector<std::byte> shared(marrow::block_bytes(animations_bytes(file, file)));
  marrow::Animations animations;
  if (make_animations(file, file, marrow::block_in(shared), animations) != Status::ok) return 1;
  const marrow::Animation* const idle = find_animation(animations, "idle");
  const marrow::Animation* const walk = find_animation(animations, "walk");
  if (idle == nullptr || walk == nullptr) return 1;

  // Once a character: its poses, palettes and what it remembers of its clips.
  const marrow::CharacterOptions options{.layers = 2};
  std::vector<std::byte> own(marrow::block_bytes(character_bytes(file, options)));
  marrow::Character character;
  if (make_character(file, options, marrow::block_in(own), character) != Status::ok) return 1;
  std::printf("%zu animations, %zu skeletons, %zu meshes\n", animations.all.size, character.skeletons.size,
              character.meshes.size);

  marrow::Playback idling, walking;
  for (int frame = 0; frame < 24; ++frame) {
    const float dt_s = 1.0f / 60, share = float(frame + 1) / 48;  // half a walk at the end
    if (advance(idling, idle->duration_s, dt_s) != Status::ok || advance(walking, walk->duration_s, dt_s) != Status::ok)
      return 1;
    if (pose_character(character, {{idle, clip_time(idling), 1 - share}, {walk, clip_time(walking), share}}) !=
        Status::ok)
      return 1;
    // Here the game reaches, looks, places feet: `local` and `scene_from_joint` are both of this frame.
    if (finish_character(character) != Status::ok) return 1;
  }

  const marrow::CharacterSkeleton& posed = character.skeletons[0];
  const marrow::Affine& hand = posed.scene_from_joint[file.find_joint(posed.skeleton, "hand.L")];
  std::printf("hand.L is at %.3f %.3f %.3f m\n", double(hand.rows[0][3]), double(hand.rows[1][3]),
              double(hand.rows[2][3]));

  // Each mesh has its palette now. A gles3::Skinner would take scene_from_joint in its place.
  std::size_t vertices = 0;
  std::vector<float> positions;
  for (const marrow::CharacterMesh& m : character.meshes) {
    positions.resize(3 * std::size_t(m.mesh.geometry.slot_count));
    if (skin_ssd(m.mesh, m.palette, {.positions = positions}) != Status::ok) return 1;
    vertices += m.mesh.geometry.vertex_count;
  }
  std::printf("%zu vertices are skinned\n", vertices);
}

// Prints:
//   4 animations, 1 skeletons, 6 meshes
//   hand.L is at 0.357 0.531 0.191 m
//   8581 vertices are skinned
