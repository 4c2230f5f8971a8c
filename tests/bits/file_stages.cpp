// Files of every kind through every stage, and packed ones through unpacking.
#include "bits/stages.h"
#include "support/fan.h"
#include "support/golden.h"
#include "support/ring.h"

namespace marrow::test {
namespace {

std::uint64_t file_hash(const AlignedBlock& block) {
  File file;
  must(load({block.data(), block.size()}, file));
  return exercise(file);
}

// Poses of sets of joints over one another.
std::uint64_t some_joints_hash(const AlignedBlock& block) {
  File file;
  must(load({block.data(), block.size()}, file));
  std::uint64_t hash = kHashStart;
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) {
    const Clip clip = file.clip(c);
    const Skeleton skeleton = file.skeleton(clip.skeleton);
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::uint32_t seed = 0x9E3779B9u;
    for (int moment = 0; moment < 20; ++moment) {
      std::vector<std::uint32_t> joints((skeleton.joint_count + 31) / 32);
      for (std::uint32_t& word : joints) word = seed = seed * 1664525u + 1013904223u;
      must(sample(skeleton, clip, static_cast<float>(moment) * 0.0546875f, local, {joints}));
      hash = hash_of(local, hash);
    }
  }
  return hash;
}

std::uint64_t unpacked_hash(const std::vector<std::byte>& packed) {
  Unpacked memory;
  File file;
  DataError error;
  must(run(packed, memory, file, error));
  return exercise(file);
}

std::uint64_t unpacked_hash(const AlignedBlock& packed) {
  return unpacked_hash(std::vector<std::byte>(packed.data(), packed.data() + packed.size()));
}

std::uint64_t section_hash(const std::vector<std::byte>& record) {
  const UnpackedGeometry geometry = unpack_plain(record);
  std::uint64_t hash = geometry.rule == nullptr ? 0xCBF29CE484222325u : 0;
  for (const std::byte b : geometry.section) hash = (hash ^ static_cast<std::uint64_t>(b)) * 0x100000001B3u;
  return hash;
}

}  // namespace

void hash_files(StageHashes& out) {
  out.push_back({"a file", file_hash(golden_copy())});
  out.push_back({"channels, additive clips", file_hash(golden_channels_copy())});
  out.push_back({"a clip at uneven times", file_hash(golden_uneven_copy())});
  out.push_back({"a coded clip", file_hash(golden_coded_copy())});
  out.push_back({"some joints of a coded clip", some_joints_hash(golden_coded_copy())});
  out.push_back({"a clip pack", file_hash(golden_pack_copy())});
  out.push_back({"half-joints", file_hash(golden_half_joint_copy())});
  out.push_back({"a helper about a centre", file_hash(golden_centres_copy())});
  out.push_back({"materials, nodes", file_hash(golden_looks_copy())});
  out.push_back({"levels of detail", file_hash(golden_lod_copy())});
  out.push_back({"limits", file_hash(golden_limits_copy())});
  out.push_back({"example shapes", file_hash(golden_shapes_copy())});
  out.push_back({"an animator", file_hash(golden_graph_copy())});
  out.push_back({"unpack, a coded clip", unpacked_hash(golden_packed_copy())});  // into the clip pack
  out.push_back({"unpack", unpacked_hash(packed_fan())});
  out.push_back({"unpack, deformers", unpacked_hash(packed_deformers())});
  out.push_back({"unpack, a residual apart", section_hash(ring_record())});
}

}  // namespace marrow::test
