// A whole character in two calls a frame: all skeletons, all meshes, blended animations.
// $ characters hero.mrw
#include <marrow/draco.h>
#include <marrow/owned.h>

#include <cstdio>
#include <fstream>
#include <iterator>

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "hero.mrw";
  std::ifstream stream(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::OwnedFile file;  // with the animations, for any number of characters
  must(make_owned(bytes, {marrow::draco_decoder()}, file));
  const marrow::Animation* const idle = find_animation(file.animations, "idle");
  const marrow::Animation* const walk = find_animation(file.animations, "walk");
  if (idle == nullptr || walk == nullptr) return 1;

  marrow::OwnedCharacter character;  // its poses, palettes and what it remembers of its clips
  must(make_owned(file, {.layers = 2}, character));
  std::printf("%zu animations, %zu skeletons, %zu meshes\n", file.animations.all.size, character.skeletons.size,
              character.meshes.size);

  marrow::Playback idling, walking;
  for (int frame = 0; frame < 24; ++frame) {
    const float dt_s = 1.0f / 60, share = float(frame + 1) / 48;  // half a walk at the end
    must(advance(idling, idle->duration_s, dt_s));
    must(advance(walking, walk->duration_s, dt_s));
    must(pose_character(character, {{idle, clip_time(idling), 1 - share}, {walk, clip_time(walking), share}}));
    // Here the game reaches, looks, places feet: both forms of the pose are of this frame.
    must(finish_character(character));
  }

  const marrow::Pose& pose = character.skeletons[0].pose;
  const marrow::Affine& hand = pose.model_from_joint[file.find_joint(pose.skeleton, "hand.L")];
  std::printf("hand.L is at %.3f %.3f %.3f m\n", double(hand.rows[0][3]), double(hand.rows[1][3]),
              double(hand.rows[2][3]));

  // Each mesh has its palette now. A gles3::Skinner would take model_from_joint in its place.
  std::size_t vertices = 0;
  std::vector<float> positions;
  for (const marrow::CharacterMesh& m : character.meshes) {
    positions.resize(3 * std::size_t(m.mesh.geometry.slot_count));
    must(skin_ssd(m.mesh, m.palette, {.positions = positions}));
    vertices += m.mesh.geometry.vertex_count;
  }
  std::printf("%zu vertices are skinned\n", vertices);

  // The left arm reaches while the rest walks.
  const marrow::Animation* const reach = find_animation(file.animations, "reach");
  if (reach == nullptr) return 1;
  const marrow::Skeleton& skeleton = character.skeletons[0].pose.skeleton;
  std::vector<float> arm(4 * skeleton.soa_size());
  must(mask_below(skeleton, file.find_joint(skeleton, "clavicle.L"), 0, arm));
  must(pose_character(character, {{walk, clip_time(walking)}, {reach, 1.5f, 1, arm}}));
  std::printf("hand.L reaches %.3f %.3f %.3f m\n", double(hand.rows[0][3]), double(hand.rows[1][3]),
              double(hand.rows[2][3]));
}

// Prints:
//   4 animations, 1 skeletons, 6 meshes
//   hand.L is at 0.357 0.531 0.191 m
//   8581 vertices are skinned
//   hand.L reaches 0.327 1.208 0.211 m
