#include "cook/clip/compress/coded_track.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdlib>
#include <optional>

#include <glm/geometric.hpp>

#include "unpack/clip/track_fit.h"

namespace marrow::cook {
namespace {

constexpr double kLargestInteger = 1e9;  // so that sums of two stay in 32 bits

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

void fit(CodedTrack& track) {
  std::int32_t low[3], high[3];
  for (std::size_t c = 0; c < 3; ++c) {
    low[c] = high[c] = track.values[0][c];
    for (const std::array<std::int32_t, 3>& n : track.values) {
      low[c] = std::min(low[c], n[c]);
      high[c] = std::max(high[c], n[c]);
    }
  }
  TrackFit found;
  track.fits = fit_track(low, high, found);
  if (!track.fits) return;
  track.shift = found.shift;
  for (std::size_t c = 0; c < 3; ++c) {
    track.least[c] = found.least[c];
    track.width_codes[c] = found.width_codes[c];
  }
  track.frame_bits = found.bits;
}

int code_of_step(double step) {
  int code = 255;
  while (code > 0 && static_cast<double>(format::step_size(static_cast<std::uint32_t>(code))) > step) --code;
  return code;
}

CodedTrack quantise(const std::vector<glm::dvec3>& frames, int step_code) {
  CodedTrack track;
  track.step_code = step_code;
  const double inverse = 1 / static_cast<double>(format::step_size(static_cast<std::uint32_t>(step_code)));
  track.values.reserve(frames.size());
  for (const glm::dvec3& v : frames) {
    std::array<std::int32_t, 3> n{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double exact = v[static_cast<int>(c)] * inverse;
      if (!(std::fabs(exact) < kLargestInteger)) return track;
      n[c] = static_cast<std::int32_t>(std::lround(exact));
    }
    track.values.push_back(n);
  }
  fit(track);
  return track;
}

CodedTrack part_of(const CodedTrack& track, std::size_t first_frame, std::size_t frame_count) {
  CodedTrack out;
  out.step_code = track.step_code;
  const auto begin = track.values.begin() + static_cast<std::ptrdiff_t>(first_frame);
  out.values.assign(begin, begin + static_cast<std::ptrdiff_t>(frame_count));
  fit(out);
  return out;
}

glm::dvec3 decode(const CodedTrack& track, std::size_t frame) {
  const double step = static_cast<double>(format::step_size(static_cast<std::uint32_t>(track.step_code)));
  const std::array<std::int32_t, 3>& n = track.values[frame];
  return step * glm::dvec3(n[0], n[1], n[2]);
}

glm::dvec3 to_rodrigues(const glm::dquat& q) {
  return glm::dvec3(q.x, q.y, q.z) / (1 + q.w);
}

glm::dquat from_rodrigues(const glm::dvec3& m) {
  const double squared = glm::dot(m, m), inverse = 1 / (1 + squared);
  return glm::dquat((1 - squared) * inverse, 2 * inverse * m.x, 2 * inverse * m.y, 2 * inverse * m.z);
}

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
