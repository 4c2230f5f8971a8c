// Reads the numbers that a clip moves beside the joints.
// $ channels morphs.mrw
#include "asset.h"

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "morphs.mrw") != marrow::Status::ok) return 1;
  const marrow::File& file = asset.file;
  const std::uint32_t walk = file.find_clip("walk");
  if (walk == file.clip_count()) return 1;
  const marrow::Clip clip = file.clip(walk);

  // Once a load: which channel is which.
  const std::uint32_t first = file.find_channel(clip, "body.eigenskin[0]");
  if (first == clip.channels.size) return 1;

  // Every frame: all channels at once.
  std::vector<float> values(clip.channels.size);
  for (const float time_s : {0.0f, 0.4f, 0.8f}) {
    if (sample_channels(clip, time_s, values) != marrow::Status::ok) return 1;
    std::printf("%.1f s: %s is %.4f\n", double(time_s), file.text(clip.channels[first].name), double(values[first]));
  }
}

// Prints:
//   0.0 s: body.eigenskin[0] is 0.0024
//   0.4 s: body.eigenskin[0] is 0.0020
//   0.8 s: body.eigenskin[0] is 0.0020
