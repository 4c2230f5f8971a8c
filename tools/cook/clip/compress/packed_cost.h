// What the integers of a track take in a packed file, before they are there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "unpack/clip/clip_codec.h"

namespace marrow::cook {

using ClipFrames = std::vector<std::array<std::int32_t, 3>>;

bool moves(const ClipFrames& frames, std::size_t component);
// The predictor that a component of a track is coded with, and how far it is off at first. Of two that are about the
// same, the first.
ClipCurve choose_curve(const ClipFrames& frames, std::size_t component);

// An estimate: by the coder itself, but with models that stay as they are at first.
class PackedCost {
 public:
  static constexpr std::uint64_t kBit = 256;

  PackedCost();
  // In 1 / kBit of a bit. curves: of choose_curve for this track, or for the same one in other steps.
  std::uint64_t of(const ClipFrames& frames, const std::array<ClipCurve, 3>& curves);

 private:
  ClipModels models_;
  std::vector<std::uint16_t> cost_of_share_;
};

}  // namespace marrow::cook
