// What sample_cached() keeps of a clip in SampleCache::state.
#pragma once

#include <type_traits>

#include "marrow/sample.h"

namespace marrow {

inline constexpr std::uint32_t kNoFrame = 0xFFFFFFFF;

// Zeros: the cache is of no clip.
struct SampleState {
  std::uint64_t clip;   // which clip, skeleton and memory: a hash
  std::uint64_t out;    // the address where the last call wrote
  std::uint32_t frame;  // the frame that is unpacked; kNoFrame: none
  std::uint32_t room;   // 1: the memory has room for this clip's frames
};
static_assert(sizeof(SampleState) == sizeof(SampleCache::state) && alignof(SampleState) <= 8);
static_assert(std::is_trivially_copyable_v<SampleState>);

inline SampleState& state_of(SampleCache& cache) {
  return *reinterpret_cast<SampleState*>(cache.state);
}

}  // namespace marrow
