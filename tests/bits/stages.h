// What the stages of the runtime give, as hashes: the same bits on every processor, by every compiler, with SIMD or
// not.
#pragma once

#include <cstdint>
#include <vector>

#include "support/pose_file.h"
#include "support/poses.h"

namespace marrow::test {

struct StageHash {
  const char* stage;
  std::uint64_t hash;
};
using StageHashes = std::vector<StageHash>;

void hash_poses(StageHashes& out);    // sampling to skinning, blends, curves, playback, on creatures of noise
void hash_motions(StageHashes& out);  // events, root motion, phases, spaces
void hash_reach(StageHashes& out);    // limbs, aims, chains, feet and springs
void hash_files(StageHashes& out);    // files that are loaded, and unpacked

// Ends the program if a call did not end as it must.
void must(Status status, Status wanted = Status::ok);

template <class T>
std::uint64_t hash_of(const std::vector<T>& v, std::uint64_t state = kHashStart) {
  return hash(state, v.data(), v.size() * sizeof(T));
}

}  // namespace marrow::test
