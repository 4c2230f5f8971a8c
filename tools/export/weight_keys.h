// Channels of morph targets, each with keys of its own, as the one list of keys that glTF gives all weights of a node.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/file.h"

namespace marrow::tools {

struct WeightKeys {
  Interpolation interpolation;
  std::vector<float> times_s;
  std::vector<float> values;  // a key: all weights; of a spline all in-tangents, all weights, all out-tangents
};

// Keys at every time at which a channel has one. But for rounding they are the same curves: pieces of a line or of a
// cubic are lines and cubics; beside others a step is a line from one float to the next, and a line a cubic.
// channels: for each target one of the clip's or kNoChannel, one at least; weights: where there is none.
WeightKeys weight_keys(const Clip& clip, const std::vector<std::uint32_t>& channels, const std::vector<float>& weights);

}  // namespace marrow::tools
