// Fuzz target: the bytes of a coded clip, in a file that is good but for them → load → every joint at many times.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "fuzz/container.h"
#include "support/golden.h"
#include "support/pose_file.h"

namespace {

using namespace marrow;

// The dance, whose clip is coded, with these bytes for it.
std::vector<std::byte> dance_with(const std::uint8_t* data, std::size_t size) {
  static const test::AlignedBlock golden = test::golden_coded_copy();
  std::vector<test::Section> sections = test::sections_of(golden.data(), golden.size());
  for (test::Section& s : sections) {
    if (s.type != format::kTypes[format::kClips]) continue;
    s.codec = format::kCodecSegments;
    s.body.assign(reinterpret_cast<const std::byte*>(data), reinterpret_cast<const std::byte*>(data) + size);
  }
  return test::file_of(sections);
}

void play(const File& file) {
  const Clip clip = file.clip(0);
  const Skeleton skeleton = file.skeleton(clip.skeleton);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> joints(skeleton.joint_count);
  for (int i = -1; i <= 33; ++i) {
    const float time_s = clip.duration_s * static_cast<float>(i) / 32;
    if (sample(skeleton, clip, time_s, local) != Status::ok || local_to_model(skeleton, local, joints) != Status::ok)
      std::abort();
    for (const SoaTransform& group : local)
      for (const auto& component : group.rotation)
        for (const float x : component)
          if (!(std::abs(x) < 1.01f)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::byte> bytes = dance_with(data, size);
  test::AlignedBlock block(bytes.data(), bytes.size());
  test::forge_checksum(block.data(), block.size());
  File file;
  if (load(block, file) == Status::ok && !file.clip(0).additive) play(file);
  return 0;
}
