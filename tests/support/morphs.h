// Morph targets of noise for a mesh in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "support/rig.h"

namespace marrow::test {

// For each target: a share of the blocks, with random changes. Every third moves positions only, every fifth nothing.
struct TestMorphs {
  TestMorphs(std::uint64_t seed, std::uint32_t slot_count, std::size_t target_count, bool wide = false) {
    Random random(seed);
    for (std::size_t t = 0; t < target_count; ++t) {
      MorphTarget target{};
      target.first_block = static_cast<std::uint32_t>(narrow.size());
      target.first_record = static_cast<std::uint32_t>(records.size() / 12);
      const std::uint32_t attributes =
          t % 3 == 2 ? kMorphsPositions : kMorphsPositions | kMorphsNormals | kMorphsTangents;
      for (std::uint32_t block = 0; block < slot_count / 4; ++block) {
        if (t % 5 == 4 || random.below(3) == 0) continue;
        narrow.push_back(static_cast<std::uint16_t>(block));
        for (int i = 0; i < (attributes == kMorphsPositions ? 12 : 36); ++i)
          records.push_back(static_cast<std::int16_t>(static_cast<int>(random.below(65535)) - 32767));
      }
      target.block_count = static_cast<std::uint32_t>(narrow.size()) - target.first_block;
      target.attributes = target.block_count > 0 ? attributes : 0;
      target.position_step = static_cast<float>(random.between(0.1, 0.5)) / 32767;
      target.normal_step = static_cast<float>(random.between(0.1, 0.3)) / 32767;
      target.tangent_step = static_cast<float>(random.between(0.1, 0.3)) / 32767;
      targets.push_back(target);
      weights.push_back(static_cast<float>(random.between(-1.5, 2)));
    }
    if (wide) blocks.assign(narrow.begin(), narrow.end());
  }
  void put(Geometry& g) const {
    g.targets = targets;
    g.target_records = records.data();
    g.index_bytes = blocks.empty() ? 2 : 4;
    g.target_blocks = blocks.empty() ? static_cast<const void*>(narrow.data()) : blocks.data();
  }

  std::vector<MorphTarget> targets;
  std::vector<std::uint16_t> narrow;
  std::vector<std::uint32_t> blocks;  // the same, if wide
  std::vector<std::int16_t> records;
  std::vector<float> weights;
};

}  // namespace marrow::test
