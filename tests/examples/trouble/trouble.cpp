// Makes the mistakes of docs/troubleshooting.md, and prints what Marrow says of each.
#include <marrow/marrow.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

// Once, at the start of a game that is being made.
void tell_of_bad_calls() {
  marrow::set_call_error_handler(
      [](const char* function, const char* condition) { std::printf("%s() wants %s\n", function, condition); });
}

std::vector<char> read(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// What load() has against a file, and where.
void try_to_load(const char* what, const char* bytes, std::size_t size) {
  marrow::File file;
  marrow::DataError error;
  const marrow::Status status = load({reinterpret_cast<const std::byte*>(bytes), size}, file, &error);
  if (status != marrow::Status::ok)
    std::printf("%s: %s, byte %u: %s\n", what, to_string(status), error.offset, error.rule);
}

int main(int argc, char** argv) {
  if (argc < 3) return 1;
  const std::vector<char> packed = read(argv[1]), plain = read(argv[2]);

  try_to_load("packed", packed.data(), packed.size());
  try_to_load("cut short", plain.data(), 1000);
  try_to_load("empty", nullptr, 0);
  std::vector<char> bad = plain;
  bad[4] = 2;
  try_to_load("of another version", bad.data(), bad.size());
  bad = plain;
  bad[100000] = char(bad[100000] ^ 1);
  try_to_load("one bit changed", bad.data(), bad.size());
  bad[0] = 'g';
  try_to_load("another file", bad.data(), bad.size());

  tell_of_bad_calls();
  std::vector<char> askew(plain.size() + 16);
  std::memcpy(askew.data() + 12, plain.data(), plain.size());
  try_to_load("off its boundary", askew.data() + 12, plain.size());

  // unpack() without the codec that the file was packed with.
  const marrow::Span<const std::byte> block(reinterpret_cast<const std::byte*>(packed.data()), packed.size());
  marrow::UnpackSizes sizes;
  if (unpack_sizes(block, sizes) != marrow::Status::ok) return 1;
  std::vector<std::byte> memory(sizes.memory_bytes);
  marrow::Span<const std::byte> out;
  marrow::DataError error;
  const marrow::Status status = unpack(block, {}, memory, out, &error);
  std::printf("no decoder: %s: %s\n", to_string(status), error.rule);

  marrow::File file;
  if (load({reinterpret_cast<const std::byte*>(plain.data()), plain.size()}, file) != marrow::Status::ok) return 1;
  std::vector<std::byte> shared(animations_bytes(file, file)), own(character_bytes(file, {})), little(64);
  marrow::Animations animations;
  marrow::Character body;
  if (make_animations(file, file, shared, animations) != marrow::Status::ok) return 1;
  std::printf("find_animation(\"Walk\"): %s\n", find_animation(animations, "Walk") == nullptr ? "null" : "there");
  std::printf("%s\n", to_string(make_character(file, {}, little, body)));
  if (make_character(file, {}, own, body) != marrow::Status::ok) return 1;
  const marrow::Animation* const walk = find_animation(animations, "walk");
  std::printf("%s\n", to_string(pose_character(body, {{nullptr, 0}})));
  std::printf("%s\n", to_string(pose_character(body, {{walk, 0}, {walk, 0}, {walk, 0}})));
  std::printf("%s\n", to_string(pose_character(body, {{walk, std::nanf("")}})));
  std::vector<float> positions(3);
  std::printf("%s\n", to_string(skin_ssd(body.meshes[0].mesh, body.meshes[0].palette, {.positions = positions})));
  marrow::TwoBone reach;
  const marrow::Pose& pose = body.skeletons[0].pose;
  const std::uint32_t hand = file.find_joint(pose.skeleton, "hand.l");  // no such joint: joint_count
  std::printf("%s\n", to_string(solve_two_bone(pose, {0, 1, hand}, reach)));
}
