#include "cook/clip/compress/packed_cost.h"

#include <algorithm>
#include <compare>
#include <cstdlib>
#include <optional>

namespace marrow::cook {
namespace {

// A product of numbers from 1 to 2^64, which orders as the sum of their logarithms does: rest · 2^(512 · scales).
struct LongProduct {
  std::size_t scales = 0;
  double rest = 1;

  void times(double x) {
    rest *= x;
    if (rest < 0x1p512) return;
    rest *= 0x1p-512;
    ++scales;
  }
  auto operator<=>(const LongProduct&) const = default;
};

// Adds up what symbols would take.
struct BitCounter {
  static constexpr bool kEncodes = true;

  const std::uint16_t* cost_of_share;
  std::uint64_t sum = 0;

  std::uint32_t symbol(const SymbolModel& model, std::uint32_t symbol) {
    sum += cost_of_share[model.share(symbol).size];
    return symbol;
  }
  std::uint32_t raw_bits(std::uint32_t count, std::uint32_t value) {
    sum += count * PackedCost::kBit;
    return value;
  }
};

// Of a number of at least 1, in 1 / kBit, rounded down: a bit of the result for each squaring.
std::uint64_t binary_logarithm(double x) {
  std::uint64_t out = 0;
  for (; x >= 2; x /= 2) out += PackedCost::kBit;
  for (std::uint64_t bit = PackedCost::kBit / 2; bit > 0; bit /= 2) {
    x *= x;
    if (x < 2) continue;
    x /= 2;
    out += bit;
  }
  return out;
}

}  // namespace

bool moves(const ClipFrames& frames, std::size_t component) {
  return std::any_of(frames.begin(), frames.end(), [&](const auto& n) { return n[component] != frames[0][component]; });
}

ClipCurve choose_curve(const ClipFrames& frames, std::size_t component) {
  constexpr std::size_t kFirstFrames = 11;  // that say how far predictions are off at first
  ClipCurve best;
  const auto at = [&](std::size_t f) { return frames[f][component]; };
  best.moves = moves(frames, component);
  std::optional<LongProduct> least;
  for (std::uint32_t p = 0; best.moves && p < kClipPredictors; ++p) {
    LongProduct bits;  // 2 to their power
    std::int64_t first = 0, d1 = 0, d2 = 0;
    for (std::size_t f = 1; f < frames.size(); ++f) {
      const std::int64_t step = at(f) - at(f - 1);
      const std::int64_t off = std::abs(16 * step - kClipPredictor[p].a * d1 - kClipPredictor[p].b * d2);
      bits.times(static_cast<double>(8 + off));
      if (f <= kFirstFrames) first += off;
      d2 = d1;
      d1 = step;
    }
    if (least && bits >= *least) continue;
    least = bits;
    best.predictor = p;
    const auto count = static_cast<std::int64_t>(std::min(kFirstFrames, frames.size() - 1));
    best.scale = ClipScale::nearest(static_cast<std::int32_t>(first / count));
  }
  return best;
}

PackedCost::PackedCost() {
  models_.begin();
  constexpr std::uint32_t kAll = 1u << SymbolModel::kBits;
  cost_of_share_.push_back(0);  // there is none
  for (std::uint32_t share = 1; share <= kAll; ++share)
    cost_of_share_.push_back(static_cast<std::uint16_t>(SymbolModel::kBits * kBit - binary_logarithm(share)));
}

std::uint64_t PackedCost::of(const ClipFrames& frames, const std::array<ClipCurve, 3>& curves) {
  BitCounter counter{cost_of_share_.data()};
  ClipCodec<BitCounter> codec(models_, counter);
  ClipFrames copy = frames;
  ClipTrack track;
  track.numbers = reinterpret_cast<std::int32_t(*)[3]>(copy.data());
  track.frame_count = static_cast<std::uint32_t>(frames.size());
  ClipWalk walks[3];
  for (std::size_t c = 0; c < 3; ++c) {
    track.curves[c] = curves[c];
    if (curves[c].moves) walks[c].begin(curves[c]);
  }
  codec.code_numbers(track, walks);
  return counter.sum;
}

}  // namespace marrow::cook
