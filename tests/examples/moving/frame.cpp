// A frame by the stages themselves, as a game that comes from ozz-animation has it. See docs/moving/from_ozz.md.
#include <marrow/marrow.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  std::ifstream stream(argv[1], std::ios::binary);
  if (!stream) return std::perror(argv[1]), 1;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::File file;
  if (load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()}, file) != marrow::Status::ok) return 1;

  // Once a load. A clip belongs to a skeleton of the file, a mesh as well.
  const marrow::Skeleton skeleton = file.skeleton(0);
  const marrow::Clip idle = file.clip(file.find_clip("idle")), walk = file.clip(file.find_clip("walk"));
  const marrow::Mesh mesh = file.mesh(file.find_mesh("body"));

  // Once a character: what ozz::vector<SoaTransform>, SamplingJob::Context and ozz::vector<Float4x4> were.
  std::vector<marrow::SoaTransform> idle_pose(skeleton.soa_size()), walk_pose(skeleton.soa_size());
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  std::vector<marrow::Affine> scene(skeleton.joint_count), palette(mesh.palette_size());
  std::vector<marrow::Affine> frames(sample_cache_bytes(walk) / sizeof(marrow::Affine) + 1);
  marrow::SampleCache cache;
  cache.memory = {reinterpret_cast<std::byte*>(frames.data()), frames.size() * sizeof(marrow::Affine)};
  std::vector<float> positions(3 * std::size_t(mesh.geometry.slot_count));

  marrow::Playback playback;
  for (int frame = 0; frame < 60; ++frame) {
    if (advance(playback, walk.duration_s, 1.0f / 60) != marrow::Status::ok) return 1;
    // SamplingJob: seconds instead of a ratio.
    if (sample(skeleton, idle, clip_time(playback), idle_pose) != marrow::Status::ok ||
        sample_cached(skeleton, walk, clip_time(playback), walk_pose, cache) != marrow::Status::ok)
      return 1;
    // BlendingJob.
    const marrow::BlendLayer layers[] = {{idle_pose, 0.25f}, {walk_pose, 0.75f}};
    if (blend(skeleton, layers, local) != marrow::Status::ok) return 1;
    // LocalToModelJob, then the loop over joint_remaps and inverse_bind_poses.
    if (local_to_model(skeleton, local, scene) != marrow::Status::ok ||
        build_palette(mesh, scene, palette) != marrow::Status::ok)
      return 1;
    // SkinningJob.
    if (skin_ssd(mesh, palette, {.positions = positions}) != marrow::Status::ok) return 1;
  }
  std::printf("%u joints, %zu matrices, vertex 0 at %.3f %.3f %.3f m\n", skeleton.joint_count, palette.size(),
              double(positions[0]), double(positions[1]), double(positions[2]));
}
