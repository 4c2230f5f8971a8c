// Multi-weight residuals and pose-space examples of noise for a mesh in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "support/rig.h"

namespace marrow::test {

struct TestMultiWeights {
  TestMultiWeights(std::uint64_t seed, const Mesh& mesh, std::uint32_t root_) : root(root_) {
    Random random(seed);
    for (const Run& run : mesh.geometry.runs)
      for (std::uint32_t i = 0; i < (run.vertex_count + 3) / 4 * run.influences * 48; ++i)
        residual.push_back(static_cast<float>(random.between(-0.25, 0.25)));
  }
  void put(Geometry& g) const {
    g.mwe_residual = residual.data();
    g.mwe_root = root;
  }

  std::vector<float> residual;
  std::uint32_t root;
};

// For each example a share of the blocks; every fifth moves nothing. Every fourth palette entry has no parent.
struct TestPoseSpace {
  TestPoseSpace(std::uint64_t seed, const Mesh& mesh, std::size_t example_count, bool wide_ = false) : wide(wide_) {
    Random random(seed);
    const std::uint32_t blocks = mesh.geometry.slot_count / 4;
    for (std::uint32_t j = 0; j < mesh.joint_count; ++j)
      parents.push_back(j % 4 == 0 ? kNoJoint : static_cast<std::uint16_t>(random.below(mesh.joint_count)));
    for (std::size_t k = 0; k < example_count; ++k) {
      MorphTarget example{};
      example.first_block = example.first_record = static_cast<std::uint32_t>(narrow.size());
      for (std::uint32_t block = 0; block < blocks; ++block) {
        if (k % 5 == 4 || random.below(3) == 0) continue;
        narrow.push_back(static_cast<std::uint16_t>(block));
        for (int i = 0; i < 12; ++i)
          records.push_back(static_cast<std::int16_t>(static_cast<int>(random.below(65535)) - 32767));
      }
      example.block_count = static_cast<std::uint32_t>(narrow.size()) - example.first_block;
      example.attributes = example.block_count > 0 ? std::uint32_t{kMorphsPositions} : 0;
      example.position_step = static_cast<float>(random.between(0.1, 0.5)) / 32767;
      examples.push_back(example);
      for (std::uint32_t j = 0; j < mesh.joint_count; ++j)
        for (const double c : random.rotation())
          rotations.push_back(static_cast<std::int16_t>(parents[j] == kNoJoint ? 0 : c * 32767));
    }
    blocks_of_32_bits.assign(narrow.begin(), narrow.end());
  }
  void put(Geometry& g) const {
    const void* const list = wide ? static_cast<const void*>(blocks_of_32_bits.data()) : narrow.data();
    g.index_bytes = wide ? 4 : 2;
    g.pose_space = {sigma, examples, list, records.data(), rotations.data(), parents.data()};
  }

  bool wide;
  float sigma = 0.75f;
  std::vector<MorphTarget> examples;
  std::vector<std::uint16_t> narrow;
  std::vector<std::uint32_t> blocks_of_32_bits;
  std::vector<std::int16_t> records, rotations;
  std::vector<std::uint16_t> parents;
};

}  // namespace marrow::test
