// Mistakes that people make with the stages, and what the runtime says to each: the pages of docs/stages quote it.
// $ mistakes hero.mrw face.mrw
#include "asset.h"

#include <limits>

using namespace marrow;

struct Stage {
  Asset asset;
  Skeleton skeleton;
  Clip walk, stranger;
  Mesh body;
  std::vector<SoaTransform> pose, shorter;
  std::vector<Affine> joints, palette;
  std::vector<float> numbers;
  std::vector<std::byte> memory = std::vector<std::byte>(std::size_t(1) << 21);
};

// Every call here is to be refused.
void expect_refused(Status status) {
  if (status == Status::ok) std::printf("this was no mistake\n");
}

void of_files(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<char> chars{std::istreambuf_iterator<char>(stream), {}};
  std::vector<std::byte> memory(block_bytes(chars.size()) + 1);
  const Span<std::byte> block = block_in(memory);
  std::transform(chars.begin(), chars.end(), block.begin(), [](char c) { return std::byte(c); });
  const Span<const std::byte> packed(block.data, chars.size());
  DataError error;
  const auto tell = [&](Status status) {
    expect_refused(status);
    std::printf("%s: %s\n", to_string(status), error.rule);
  };
  File file;
  UnpackSizes sizes;
  Span<const std::byte> unpacked;
  tell(load(packed, file, &error));
  tell(load({block.data, 0}, file, &error));
  tell(unpack_sizes({packed.data, packed.size / 2}, sizes, &error));
  if (unpack_sizes(packed, sizes, &error) != Status::ok) return;
  std::vector<std::byte> room(block_bytes(sizes.memory_bytes));
  tell(unpack(packed, {}, block_in(room), unpacked, &error));
  tell(unpack(packed, {}, {block_in(room).data, 64}, unpacked, &error));
  block[0] = std::byte{0};
  tell(load(packed, file, &error));
  block[chars.size()] = std::byte{0};
  tell(load({packed.data + 1, packed.size}, file, &error));
}

void of_poses(Stage& s) {
  const std::size_t groups = s.skeleton.soa_size();
  expect_refused(sample(s.skeleton, s.walk, 0, s.shorter));
  expect_refused(sample(s.skeleton, s.stranger, 0, s.pose));
  expect_refused(sample(s.skeleton, s.walk, std::numeric_limits<float>::quiet_NaN(), s.pose));
  Clip additive = s.walk;
  additive.additive = true;
  expect_refused(sample(s.skeleton, additive, 0, s.pose));
  std::vector<AdditiveTransform> change(groups);
  expect_refused(sample_additive(s.skeleton, s.walk, 0, change));
  SampleCache cache{.memory = {block_in(s.memory).data + 4, 1024}};
  expect_refused(sample_cached(s.skeleton, s.walk, 0, s.pose, cache));
  Playback playback;
  expect_refused(advance(playback, -1, 0));

  const std::vector<float> mask(s.skeleton.joint_count - 1, 1.0f);
  expect_refused(blend(s.skeleton, {{s.shorter, 1}}, s.pose));
  expect_refused(blend(s.skeleton, {{s.pose, -0.5f}}, s.pose));
  expect_refused(blend(s.skeleton, {{s.pose, 1, mask}}, s.pose));
  expect_refused(overlay(s.skeleton, {.pose = s.pose, .weight = 1.5f}, s.pose));
  expect_refused(add(s.skeleton, {.change = change, .weight = 2}, s.pose));

  Inertia inertia;
  expect_refused(
      begin_inertia(s.skeleton, {.before = s.pose, .now = s.pose, .target = s.pose, .frame_s = 0.1f}, 0.2f, inertia));
  std::vector<InertialOffset> offsets(groups);
  inertia.offsets = offsets;
  expect_refused(begin_inertia(s.skeleton, {.before = s.pose, .now = s.pose, .target = s.pose}, 0.2f, inertia));
  expect_refused(cross_fade(s.skeleton, s.pose, s.pose, 1.2f, s.pose));

  const Span<Affine> few(s.joints.data(), groups);
  expect_refused(local_to_model(s.skeleton, s.pose, few));
  expect_refused(local_to_model_below(s.skeleton, s.pose, s.skeleton.joint_count, s.joints));
  JointTransform t;
  expect_refused(get_joint(s.pose, 4000, t));
}

void of_vertices(Stage& s) {
  const std::size_t vertices = 3 * std::size_t(s.body.geometry.vertex_count);
  expect_refused(build_palette(s.body, {s.joints.data(), 8}, s.palette));
  expect_refused(build_palette(s.body, s.joints, {s.palette.data(), 8}));
  MeshExtents extents;
  expect_refused(make_extents(s.body, {block_in(s.memory).data, 16}, extents));
  expect_refused(skin_ssd(s.body, s.palette, {.positions = {s.numbers.data(), vertices}}));
  expect_refused(skin_ssd(s.body, {}, {.positions = s.numbers}));
  expect_refused(skin_ssd(s.body, s.palette, {.positions = s.numbers, .normals = {s.numbers.data(), vertices}}));
  expect_refused(skin_ssd(s.body, s.palette, {.positions = s.numbers, .normals = s.numbers, .tangents = s.numbers}));
  expect_refused(skin_as(s.body, {}, s.palette, {.positions = s.numbers}));
  expect_refused(skin_mwe(s.body, s.palette, {.positions = s.numbers}));
}

void of_characters(Stage& s) {
  const File& file = s.asset.file;
  Animations animations;
  Character character;
  expect_refused(make_animations(file, file, {block_in(s.memory).data, 16}, animations));
  expect_refused(make_character(file, {}, {block_in(s.memory).data, 16}, character));
  if (make_character(file, {}, block_in(s.memory), character) != Status::ok) return;
  expect_refused(pose_character(character, {{nullptr, 0}}));
  expect_refused(pose_character(character, {{nullptr, 0}, {nullptr, 0}, {nullptr, 0}}));
  JointMisfit misfits[1];
  expect_refused(bind_clips(file, 0, file, 0, misfits));
}

void of_morphs(const char* path) {
  Asset asset;
  if (asset.open(path) != Status::ok) return;
  const File& file = asset.file;
  const Mesh face = file.mesh(0);
  const float one[] = {1}, nothing[] = {0, std::numeric_limits<float>::quiet_NaN()};
  float out[1], weights[8];
  MorphedGeometry morphed;
  expect_refused(make_morphed(face.geometry, {}, morphed));
  std::vector<std::byte> memory(block_bytes(morphed_bytes(face.geometry)));
  if (make_morphed(face.geometry, block_in(memory), morphed) != Status::ok) return;
  expect_refused(morph_weights(face, {}, {}, out));
  expect_refused(morph(one, morphed));
  ExampleSpace space;
  if (file.example_space(0, space) != Status::ok) return;
  expect_refused(evaluate_examples(space, nothing, weights));
}

void of_numbers(Stage& s) {
  const float times_s[] = {0, 1}, values[] = {0, 1};
  float out[1];
  Curve curve{.kind = CurveKind::linear, .components = 3, .times_s = times_s, .values = values};
  expect_refused(evaluate_curve(curve, 0, out));
  curve.components = 5;
  expect_refused(check_curve(curve));
  DebugLines lines;
  expect_refused(joint_lines(s.skeleton, s.joints, -1, lines));
  lines.count = 5;
  expect_refused(joint_lines(s.skeleton, s.joints, 0, lines));
}

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "hero.mrw";
  Stage s;
  if (s.asset.open(path) != Status::ok) return 1;
  s.skeleton = s.asset.file.skeleton(0);
  s.walk = s.asset.file.clip(s.asset.file.find_clip("walk"));
  s.stranger = s.walk;
  s.stranger.joint_count = 7;  // as of another skeleton
  s.body = s.asset.file.mesh(0);
  s.pose.resize(s.skeleton.soa_size());
  s.shorter.resize(s.skeleton.soa_size() - 1);
  s.joints.resize(s.skeleton.joint_count);
  s.palette.resize(s.body.palette_size());
  s.numbers.resize(4 * std::size_t(s.body.geometry.slot_count));
  set_call_error_handler(
      [](const char* function, const char* condition) { std::printf("%s: %s\n", function, condition); });
  of_files(path);
  of_poses(s);
  of_vertices(s);
  of_characters(s);
  if (argc > 2) of_morphs(argv[2]);
  of_numbers(s);
}
