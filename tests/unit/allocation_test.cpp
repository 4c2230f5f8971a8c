// A frame allocates nothing: every stage works in memory that the caller gave.
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "support/aligned.h"
#include "support/allocations.h"
#include "support/family.h"
#include "support/morphs.h"
#include "support/rig.h"

namespace marrow {
namespace {

TEST(Allocation, TheCounterCounts) {
  const std::size_t before = test::allocation_count();
  int* volatile number = new int(1);
  void* volatile bytes = std::malloc(10);
  EXPECT_GE(test::allocation_count() - before, 2u);
  delete number;
  std::free(bytes);
}

TEST(Allocation, AThousandFramesAllocateNothing) {
  const test::TestCharacter c = test::make_character(21, 31, 20, true);
  const Skeleton skeleton = c.skeleton.view();
  const Clip clip = c.clip.view();
  Mesh mesh = c.mesh.view();
  const test::TestMorphs morphs(23, mesh.geometry.slot_count, 5);
  morphs.put(mesh.geometry);
  const test::TestMultiWeights multi_weights(24, mesh, 2);
  multi_weights.put(mesh.geometry);
  const test::TestPoseSpace pose_space(25, mesh, 6);
  pose_space.put(mesh.geometry);
  test::AlignedBlock memory(morphed_bytes(mesh.geometry));
  MorphedGeometry morphed;
  ASSERT_EQ(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed), Status::ok);
  std::vector<float> weights = morphs.weights;
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.joint_count);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), distances(psd_distance_count(mesh.geometry));
  std::vector<float> positions(mesh.geometry.slot_count * 3), normals(positions.size()),
      tangents(mesh.geometry.slot_count * 4);
  ASSERT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  std::vector<float> tau(as_tangent_count(mesh.geometry));
  const AsPart part{&mesh, coordinates, tau};
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / 4);
  const Span<std::byte> scratch_bytes(reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4);
  const SkinOutput out{positions, normals, tangents};
  std::vector<SoaTransform> first(local.size()), blended(local.size());
  std::vector<AdditiveTransform> change(local.size());
  const std::vector<float> mask(local.size() * 4, 0.5f);
  std::vector<InertialOffset> offsets(local.size());
  Inertia inertia;
  inertia.offsets = offsets;
  ASSERT_EQ(sample(skeleton, clip, 0, first), Status::ok);

  int failures = 0;
  const std::size_t before = test::allocation_count();
  failures += as_tangents({&part, 1}, scratch_bytes) != Status::ok;
  for (int frame = 0; frame < 1000; ++frame) {
    const float time_s = static_cast<float>(frame) * clip.duration_s / 999;
    failures += sample(skeleton, clip, time_s, local) != Status::ok;
    const BlendLayer layers[] = {{first, 0.5f, {}}, {local, 0.5f, mask}};
    failures += blend(skeleton, {layers, 2}, blended) != Status::ok;
    failures += overlay(skeleton, layers[1], blended) != Status::ok;
    failures += make_additive(skeleton, local, first, change) != Status::ok;
    failures += add(skeleton, {change, 0.25f, mask}, blended) != Status::ok;
    failures += begin_inertia(skeleton, {first, first, local, {}, 0.01f}, 0.5f, inertia) != Status::ok;
    failures += apply_inertia(skeleton, inertia, 0.1f, blended) != Status::ok;
    failures += local_to_model(skeleton, local, model) != Status::ok;
    failures += local_to_model_below(skeleton, blended, 3, model) != Status::ok;
    failures += build_palette(mesh, model, palette) != Status::ok;
    weights[0] = time_s;
    failures += morph(weights, morphed) != Status::ok;
    failures += morph_coordinates(morphed, coordinates) != Status::ok;
    mesh.geometry = morphed.geometry;
    failures += skin_rigid(mesh, palette, out) != Status::ok;
    failures += skin_ssd(mesh, palette, out) != Status::ok;
    failures += skin_as(mesh, coordinates, palette, out) != Status::ok;
    failures += skin_as(mesh, coordinates, palette, out, tau) != Status::ok;
    failures += skin_mwe(mesh, palette, out) != Status::ok;
    failures += psd_distances(mesh.geometry, palette, distances) != Status::ok;
    failures += skin_psd(mesh, distances, palette, out) != Status::ok;
  }
  const std::size_t after = test::allocation_count();
  EXPECT_EQ(after - before, 0u);
  EXPECT_EQ(failures, 0);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__aarch64__) || defined(__arm__)
constexpr int kCrowdFrames = 100;  // thinned under sanitizers, and where the processor may be emulated
#else
constexpr int kCrowdFrames = 10'000;
#endif

// A hundred characters with a playing clip each: everything that a frame of a game does.
struct Crowd {
  Crowd() : c(test::make_character(22, 4, 4, false)), skeleton(c.skeleton.view()), clip(c.clip.view()) {
    mesh = c.mesh.view();
    additive = clip;
    additive.additive = true;
    channels = {{0, 0, c.clip.tracks[0].key_count, c.clip.tracks[0].first_time, 0, Interpolation::linear, {}}};
    clip.channels = channels;
    for (std::size_t i = 0; i < 100; ++i) {
      players.emplace_back();
      players.back().mode = static_cast<PlayMode>(1 + i % 2);
      players.back().speed = 0.5f + 0.01f * static_cast<float>(i);
    }
  }
  int frame() {
    int failures = 0;
    for (Playback& player : players) {
      failures += advance(player, clip.duration_s, 1.0f / 60) != Status::ok;
      const float time_s = clip_time(player);
      failures += sample(skeleton, clip, time_s, first) != Status::ok;
      failures += sample(skeleton, clip, 0.5f * time_s, second) != Status::ok;
      failures += sample_additive(skeleton, additive, time_s, change) != Status::ok;
      failures += sample_channels(clip, time_s, numbers) != Status::ok;
      const BlendLayer layers[] = {{first, 0.75f, {}}, {second, 0.25f, {}}};
      failures += blend(skeleton, {layers, 2}, blended) != Status::ok;
      failures += add(skeleton, {change, 0.5f, {}}, blended) != Status::ok;
      failures += local_to_model(skeleton, blended, model) != Status::ok;
      failures += build_palette(mesh, model, palette) != Status::ok;
      failures += skin_ssd(mesh, palette, {positions, {}, {}}) != Status::ok;
      turns += player.turns;
    }
    return failures;
  }
  test::TestCharacter c;
  Skeleton skeleton;
  Clip clip, additive;
  Mesh mesh;
  std::vector<Channel> channels;
  std::vector<Playback> players;
  std::vector<SoaTransform> first = c.skeleton.rest, second = first, blended = first;
  std::vector<AdditiveTransform> change = std::vector<AdditiveTransform>(first.size());
  std::vector<Affine> model = std::vector<Affine>(skeleton.joint_count);
  std::vector<Affine> palette = std::vector<Affine>(c.mesh.joints.size());
  std::vector<float> positions = std::vector<float>(c.mesh.slot_count * 3), numbers = {0};
  std::int64_t turns = 0;
};

TEST(Allocation, TenThousandFramesOfAHundredCharactersAllocateNothing) {
  Crowd crowd;
  int failures = 0;
  const std::size_t before = test::allocation_count();
  for (int frame = 0; frame < kCrowdFrames; ++frame) failures += crowd.frame();
  EXPECT_EQ(test::allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
  EXPECT_GT(crowd.turns, 0) << "clips were looped and turned";
}

}  // namespace
}  // namespace marrow
