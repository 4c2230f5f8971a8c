// Plays a clip, and reads what it does to a joint.
// $ sampling hero.mrw
#include "asset.h"

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "hero.mrw") != marrow::Status::ok) return 1;
  const marrow::Skeleton skeleton = asset.file.skeleton(0);
  const std::uint32_t walk = asset.file.find_clip("walk");
  const std::uint32_t hand = asset.file.find_joint(skeleton, "hand.L");
  if (walk == asset.file.clip_count() || hand == skeleton.joint_count) return 1;
  const marrow::Clip clip = asset.file.clip(walk);

  // Once a character: a pose, and room for the two frames that a playing clip is between.
  std::vector<marrow::SoaTransform> pose(skeleton.soa_size());
  std::vector<std::byte> frames(marrow::block_bytes(sample_cache_bytes(clip)));
  marrow::SampleCache cache{.memory = marrow::block_in(frames)};
  std::printf("%zu groups of four joints, %zu bytes; a cache of %zu bytes\n", pose.size(), 160 * pose.size(),
              sample_cache_bytes(clip));

  // Every frame: move time on, then sample.
  marrow::Playback playback;
  for (int frame = 0; frame < 90; ++frame) {
    if (advance(playback, clip.duration_s, 1.0f / 60) != marrow::Status::ok) return 1;
    if (sample_cached(skeleton, clip, clip_time(playback), pose, cache) != marrow::Status::ok) return 1;
    if (playback.turns != 0) std::printf("frame %d: the walk begins again\n", frame);
  }

  marrow::JointTransform local;
  if (get_joint(pose, hand, local) != marrow::Status::ok) return 1;
  std::printf("after 1.5 s the walk is at %.3f s\n", playback.time_s);
  std::printf("hand.L: translation %.3f %.3f %.3f m, rotation %.4f %.4f %.4f %.4f\n", double(local.translation[0]),
              double(local.translation[1]), double(local.translation[2]), double(local.rotation[0]),
              double(local.rotation[1]), double(local.rotation[2]), double(local.rotation[3]));

  // Any moment, in any order: sample() keeps nothing.
  if (sample(skeleton, clip, 0.1f, pose) != marrow::Status::ok) return 1;
  cache = {.memory = cache.memory};  // as the pose was written by another call
  if (get_joint(pose, hand, local) != marrow::Status::ok) return 1;
  std::printf("at 0.1 s its rotation is %.4f %.4f %.4f %.4f\n", double(local.rotation[0]), double(local.rotation[1]),
              double(local.rotation[2]), double(local.rotation[3]));
}

// Prints:
//   11 groups of four joints, 1760 bytes; a cache of 2080 bytes
//   frame 71: the walk begins again
//   after 1.5 s the walk is at 0.300 s
//   hand.L: translation 0.000 0.227 0.000 m, rotation 0.0193 0.0018 -0.1099 0.9937
//   at 0.1 s its rotation is 0.0186 0.0010 -0.0675 0.9975
