// Fuzzes the BVH reader: any bytes must end in a scene or in a located failure.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/failure.h"
#include "cook/bvh/read_bvh.h"

namespace {

// What the build stage relies on.
void require(bool holds) {
  if (!holds) std::abort();
}

void check_scene(const marrow::cook::RawScene& scene) {
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) require(scene.nodes[n].parent < static_cast<int>(n));
  require(scene.clips.size() == 1 && !scene.clips[0].channels.empty());
  for (const auto& channel : scene.clips[0].channels) {
    require(channel.node >= 0 && static_cast<std::size_t>(channel.node) < scene.nodes.size());
    require(channel.times_s == scene.clips[0].channels[0].times_s && channel.values.size() == channel.times_s.size());
    for (std::size_t i = 1; i < channel.times_s.size(); ++i) require(channel.times_s[i - 1] < channel.times_s[i]);
    for (const auto& value : channel.values)
      for (int c = 0; c < 4; ++c) require(std::isfinite(value[c]));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check_scene(marrow::cook::read_bvh("fuzz.bvh", std::as_bytes(std::span(data, size))));
  } catch (const marrow::tools::Failure& failure) {
    require(failure.where().starts_with("line ") && !failure.rule().empty());
  }
  return 0;
}
