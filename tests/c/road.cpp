// What road.c does, in C++: the same hash must come of it.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <marrow/draco.h>
#include <marrow/marrow.h>
#include <marrow/meshopt.h>

namespace {

std::uint32_t hash = 2166136261u;

void add(const void* words, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) hash = (hash ^ static_cast<const std::uint32_t*>(words)[i]) * 16777619u;
}

void need(marrow::Status status) {
  if (status == marrow::Status::ok) return;
  std::fprintf(stderr, "%s\n", to_string(status));
  std::exit(1);
}

marrow::Springs tail_of(const marrow::File& file, const marrow::Skeleton& skeleton, std::vector<std::byte>& memory) {
  marrow::SpringJoint joints[4];
  for (int i = 0; i < 4; ++i)
    joints[i].joint = static_cast<std::uint16_t>(file.find_joint(skeleton, ("tail_" + std::to_string(3 + i)).c_str()));
  const marrow::SpringChain chain = {joints, {}};
  marrow::Springs springs;
  memory.resize(springs_bytes(skeleton, {chain}));
  need(make_springs(skeleton, {chain}, memory, springs));
  return springs;
}

void reach(const marrow::File& file, const marrow::Pose& pose, marrow::Springs& springs, float dt_s) {
  const marrow::Skeleton& skeleton = pose.skeleton;
  const std::uint32_t neck[] = {file.find_joint(skeleton, "neck"), file.find_joint(skeleton, "head")};
  need(solve_look_at(pose, neck, {.target = {0.5f, 1.25f, 2}, .weight = 0.5f}, 0.5f));
  const marrow::TwoBoneLimb leg = {file.find_joint(skeleton, "thigh.L"), file.find_joint(skeleton, "shin.L"),
                                   file.find_joint(skeleton, "foot.L")};
  marrow::TwoBone step;
  for (int i = 0; i < 3; ++i) step.target[i] = pose.model_from_joint[leg.end].rows[i][3] + 0.0625f;
  need(solve_two_bone(pose, leg, step));
  marrow::SpringFrame frame;
  frame.dt_s = dt_s;
  need(simulate_springs(pose, frame, springs));
}

void skin(const marrow::CharacterMesh& m) {
  std::vector<float> positions(3 * m.mesh.geometry.slot_count), normals(positions.size());
  need(skin_ssd(m.mesh, m.palette, {positions, normals}));
  add(m.palette.data, 12 * m.palette.size);
  add(positions.data(), positions.size());
  add(normals.data(), normals.size());
  need(skin_as(m.mesh, m.coordinates, m.palette, {.positions = positions}));
  add(positions.data(), positions.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::ifstream stream(argc > 1 ? argv[1] : "newt.mrw", std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::Span<const std::byte> block(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size());
  std::vector<std::byte> memory, shared, own, of_springs;
  if (marrow::is_packed(block)) {
    const marrow::MeshDecoder decoders[] = {marrow::draco_decoder(), marrow::meshopt_decoder()};
    marrow::UnpackSizes sizes;
    need(unpack_sizes(block, sizes));
    memory.resize(sizes.memory_bytes);
    need(unpack(block, decoders, memory, block));
  }
  marrow::File file;
  need(load(block, file));
  marrow::Animations animations;
  marrow::Character character;
  const marrow::CharacterOptions options = {.animation_space = true};
  shared.resize(animations_bytes(file, file));
  own.resize(character_bytes(file, options));
  need(make_animations(file, file, shared, animations));
  need(make_character(file, options, own, character));
  const marrow::Animation *const walk = find_animation(animations, "walk"), *const idle =
                                                                                find_animation(animations, "idle");
  if (walk == nullptr || idle == nullptr) return 1;
  marrow::Springs tail = tail_of(file, character.skeletons[0].pose.skeleton, of_springs);
  marrow::Playback playback;
  for (int frame = 0; frame < 30; ++frame) {
    const marrow::Pose& pose = character.skeletons[0].pose;
    need(advance(playback, walk->duration_s, 1.0f / 60));
    const float time_s = clip_time(playback);
    need(pose_character(character, {{walk, time_s, 1}, {idle, time_s, 0.25f}}));
    reach(file, pose, tail, 1.0f / 60);
    need(finish_character(character));
    add(pose.local.data, 40 * pose.local.size);
    add(pose.model_from_joint.data, 12 * pose.model_from_joint.size);
    for (const marrow::CharacterMesh& m : character.meshes) skin(m);
  }
  std::printf("%08x\n", hash);
}
