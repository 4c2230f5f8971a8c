// Step 1: loads a cooked file, plays a clip on the CPU, and prints where the head and a vertex are.
#include <marrow/draco.h>
#include <marrow/marrow.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

void must(marrow::Status status, const char* doing) {
  if (status == marrow::Status::ok) return;
  std::fprintf(stderr, "%s: %s\n", doing, to_string(status));
  std::exit(1);
}

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "hero.mrw";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::perror(path), 1;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::Span<const std::byte> block(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size());

  std::vector<std::byte> unpacked;
  if (marrow::is_packed(block)) {
    marrow::UnpackSizes sizes;
    must(unpack_sizes(block, sizes), "reading the header");
    unpacked.resize(sizes.memory_bytes);
    must(unpack(block, {marrow::draco_decoder()}, unpacked, block), "unpacking");
  }
  marrow::File file;
  must(load(block, file), "loading");

  std::vector<std::byte> animation_memory(animations_bytes(file, file));
  marrow::Animations animations;
  must(make_animations(file, file, animation_memory, animations), "animations");
  const marrow::Animation* const walk = find_animation(animations, "walk");
  if (walk == nullptr) return 1;

  std::vector<std::byte> character_memory(character_bytes(file, {}));
  marrow::Character newt;
  must(make_character(file, {}, character_memory, newt), "character");
  const marrow::Pose& pose = newt.skeletons[0].pose;
  const marrow::CharacterMesh& body = newt.meshes[0];
  const std::uint32_t head = file.find_joint(pose.skeleton, "head");
  if (head == pose.skeleton.joint_count) return 1;
  std::vector<float> positions(3 * body.mesh.geometry.slot_count);

  marrow::Playback playback;
  for (int frame = 0; frame < 60; ++frame) {
    must(advance(playback, walk->duration_s, 1.0f / 60), "time");
    must(pose_character(newt, {{walk, clip_time(playback)}}), "pose");
    must(finish_character(newt), "palettes");
    must(skin_ssd(body.mesh, body.palette, {.positions = positions}), "skinning");
    if (frame % 15 != 0) continue;
    const auto& at = pose.model_from_joint[head].rows;
    std::printf("%.2f s: head at %.3f %.3f %.3f m, vertex 0 of %s at %.3f %.3f %.3f m\n", playback.time_s,
                double(at[0][3]), double(at[1][3]), double(at[2][3]), body.mesh.name, double(positions[0]),
                double(positions[1]), double(positions[2]));
  }
}
