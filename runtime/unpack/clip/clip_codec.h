// The integers of coded clips as symbols: one text for the cooker, which writes them, and for unpacking. A component of
// a track is predicted from its own frames before; what is missing is coded by how far predictions were off lately.
#pragma once

#include <bit>

#include "asset/format.h"
#include "core/builtins.h"
#include "unpack/clip/list_codec.h"
#include "unpack/clip/signed_code.h"

namespace marrow {

// From two differences before, in sixteenths: x₁ + a · (x₁ − x₂) + b · (x₂ − x₃).
struct ClipPredictor {
  std::int16_t a, b;
};
inline constexpr std::uint32_t kClipPredictors = 8;
inline constexpr ClipPredictor kClipPredictor[kClipPredictors] = {{0, 0},  {8, 0},   {16, 0},   {32, -16},
                                                                  {-6, 0}, {12, -4}, {24, -12}, {4, 0}};

// A component is within so much of its first frame: more than its width allows.
inline constexpr std::int32_t kClipReach = 1 << 19;
// Of first frames.
inline constexpr std::int32_t kClipFarthest = kMostRescaled;

// How far predictions are off, in half octaves of sixteenths.
class ClipScale {
 public:
  static constexpr std::uint32_t kCount = 29;

  std::uint32_t code() const { return nearest(mean_); }
  static std::uint32_t nearest(std::int32_t distance) {
    const auto x = static_cast<std::uint32_t>(distance) + 4;
    const auto octave = static_cast<std::uint32_t>(std::bit_width(x)) - 1;
    const std::uint32_t out = 2 * octave + (x >> (octave - 1) & 1) - 4;
    return out < kCount ? out : kCount - 1;
  }
  void begin(std::uint32_t code) { mean_ = static_cast<std::int32_t>((5 + 2 * (code & 1)) << (code + 4) / 2 >> 2) - 4; }
  std::int32_t mean() const { return mean_; }
  void learn(std::int32_t distance) { mean_ += (distance - mean_) * 7 >> 4; }

 private:
  std::int32_t mean_ = 0;
};

// Seconds that are a whole number of a rate's parts, or nearly.
inline float time_of(std::int32_t parts, std::uint32_t rate) {
  return static_cast<float>(static_cast<double>(parts) / static_cast<double>(rate));
}
// Of frames that end with the clip.
inline float mean_rate(std::uint32_t frame_count, float start_s, float end_s) {
  return static_cast<float>((static_cast<double>(frame_count) - 1) /
                            (static_cast<double>(end_s) - static_cast<double>(start_s)));
}
// Of what is not below 0. An encoder's.
inline std::int32_t nearest_part(float time_s, std::uint32_t rate) {
  constexpr double kMostParts = 1 << 28;
  const double parts = static_cast<double>(time_s) * static_cast<double>(rate) + 0.5;
  return static_cast<std::int32_t>(parts < kMostParts ? parts : kMostParts);
}

struct ClipModels {
  // By how far predictions are off; by the last difference, none, small or large; by where the last prediction lay.
  SymbolModel numbers[ClipScale::kCount][3][3];
  SymbolModel gaps, strays;  // of times
  // Of the first segment and of others.
  SymbolModel steps[2], firsts[2];
  SymbolModel scales[2], predictors;  // scales: by whether the component before moves
  SymbolModel moves[2];               // of what goes on: by whether it moved in the segment before
  // By whether the one before was as it had been.
  SymbolModel masks[2], constants[2];
  SymbolModel mask_changes, constant_changes;
  ListModels lists;

  // What was last, by place: of places that fall together, one.
  static constexpr std::uint32_t kPlaces = 1024;
  std::uint16_t last_masks[kPlaces];
  format::Constant last_constants[kPlaces];

  void begin();
};

// How a component is coded: an encoder's choice.
struct ClipCurve {
  bool moves = false;
  std::uint32_t predictor = 0, scale = 0;
};

// A component on its way: its number less the segment's first, its last two differences, and how far the last
// prediction was off.
struct ClipWalk {
  std::int32_t x = 0, d1 = 0, d2 = 0, off = 0;
  ClipPredictor predictor{};
  ClipScale scale;
  bool begun = false, moves = false;  // moves: in the last segment

  void begin(const ClipCurve& curve) {
    *this = {};
    predictor = kClipPredictor[curve.predictor];
    scale.begin(curve.scale);
    begun = true;
  }
  // Into the next segment, of the same steps.
  void go_on(bool now_moves) {
    x = 0;
    if (!now_moves) d1 = d2 = off = 0;
    moves = now_moves;
  }
};

// A track of a segment.
struct ClipTrack {
  std::int32_t (*numbers)[3] = nullptr;  // a frame
  std::uint32_t frame_count = 0;
  std::int32_t step = 0;
  ClipCurve curves[3];
};

// What a segment leaves of a track for the next one.
struct ClipTrackEnd {
  std::int32_t step, numbers[3];
  ClipWalk walks[3];
};

// What a codec keeps from one number to the next, beside the models.
struct ClipCodecState {
  std::int32_t step = 100, scale = 10;  // of the track and of the moving component before
  std::uint32_t mask_same = 0, constant_same = 0;
  std::int32_t part = 0, gap = 0;  // the time before, and how far it was from the one before that
};

// Coder: SymbolDecoder, or an encoder that has the same functions. An encoder's track holds what is to be written; a
// decoder's is filled in. A clip has one of its own; models go on from clip to clip.
template <class Coder>
class ClipCodec {
 public:
  ClipCodec(ClipModels& models, Coder& coder, const ClipCodecState& at = {})
      : models_(models), coder_(coder), at_(at) {}
  const ClipCodecState& state() const { return at_; }

  // place: which mask of the clip it is.
  std::uint16_t code_mask(std::uint32_t place, std::uint16_t wanted) {
    std::uint16_t& last = models_.last_masks[place % ClipModels::kPlaces];
    if (!code_same(models_.masks[at_.mask_same], at_.mask_same, wanted == last))
      last = static_cast<std::uint16_t>(last ^ code_number(models_.mask_changes, wanted ^ last));
    return last;
  }
  // place: which of the skeleton's sub-tracks it is. What is far from what was last has all its bits.
  format::Constant code_constant(std::uint32_t place, const format::Constant& wanted) {
    format::Constant& last = models_.last_constants[place % ClipModels::kPlaces];
    bool same = Coder::kEncodes, near = Coder::kEncodes;
    for (std::uint32_t i = 0; Coder::kEncodes && i < 4; ++i) {
      const std::int32_t change = wanted.v[i] - last.v[i];
      same = same && change == 0;
      near = near && change >= -kNear && change <= kNear;
    }
    if (code_same(models_.constants[at_.constant_same], at_.constant_same, same)) return last;
    near = coder_.raw_bits(1, near ? 1 : 0) != 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      std::int16_t& number = last.v[i];
      const std::int32_t to = Coder::kEncodes ? wanted.v[i] : 0;
      number = near ? static_cast<std::int16_t>(wrapped_sum(number, code_number(models_.constant_changes, to - number)))
                    : static_cast<std::int16_t>(coder_.raw_bits(16, static_cast<std::uint16_t>(to)));
    }
    return last;
  }

  // A moment close to a whole number of the rate's parts of a second, which goes on by what it went on by before.
  float code_time(std::uint32_t rate, float wanted) {
    at_.gap = wrapped_sum(
        at_.gap, code_number(models_.gaps, Coder::kEncodes ? nearest_part(wanted, rate) - at_.part - at_.gap : 0));
    at_.part = wrapped_sum(at_.part, at_.gap);
    const auto guess = bit_cast<std::int32_t>(time_of(at_.part, rate));
    const std::int32_t stray = Coder::kEncodes ? bit_cast<std::int32_t>(wanted) - guess : 0;
    return bit_cast<float>(wrapped_sum(guess, code_number(models_.strays, stray)));
  }

  // What stands in front of the numbers: step, first frame, and which components move. `end` is what the segment before
  // left of the same track, and gets its walks; is_first: there is none. Where steps go on as they were, so do walks.
  // False if it is nothing that an encoder writes.
  bool code_head(ClipTrack& track, ClipTrackEnd& end, bool is_first) {
    const std::uint32_t which = is_first ? 0 : 1;
    const std::int32_t step = is_first ? at_.step : end.step;
    track.step = wrapped_sum(step, code_number(models_.steps[which], Coder::kEncodes ? track.step - step : 0));
    bool fits = track.step >= 0 && track.step <= 255, moves = false;
    if (!fits) return false;
    at_.step = track.step;
    const bool goes_on = !is_first && track.step == end.step;
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::int32_t guess = is_first ? 0 : rescaled(end.numbers[c], end.step, track.step);
      std::int32_t& first = track.numbers[0][c];
      first = wrapped_sum(guess, code_number(models_.firsts[which], Coder::kEncodes ? first - guess : 0));
      fits = fits && first >= -kClipFarthest && first <= kClipFarthest;
      ClipWalk& walk = end.walks[c];
      if (goes_on) {
        code_going_on(track.curves[c], walk);
        continue;
      }
      code_curve(track.curves[c], moves);
      moves = track.curves[c].moves;
      walk = {};
      if (moves) walk.begin(track.curves[c]);
      walk.moves = moves;
    }
    return fits;
  }

  // All frames but the first; of components that do not move copies of it.
  bool code_numbers(const ClipTrack& track, ClipWalk (&walks)[3]) {
    return code_numbers(track, walks, 1, track.frame_count);
  }
  // Those of them from `from` on and before `end`.
  bool code_numbers(const ClipTrack& track, ClipWalk (&walks)[3], std::uint32_t from, std::uint32_t end) {
    ClipWalk now_at[3] = {walks[0], walks[1], walks[2]};
    const std::int32_t(&first)[3] = track.numbers[0];
    for (std::uint32_t f = from; f < end; ++f) {
      bool fits = true;
      std::int32_t(&now)[3] = track.numbers[f];
      for (std::uint32_t c = 0; c < 3; ++c) {
        const std::int32_t wanted = Coder::kEncodes ? now[c] - first[c] : 0;
        const std::int32_t x = track.curves[c].moves ? code_next(now_at[c], wanted) : 0;
        fits = fits && x > -kClipReach && x < kClipReach;
        if (!Coder::kEncodes) now[c] = first[c] + x;
      }
      if (!fits) return false;
    }
    for (std::uint32_t c = 0; c < 3; ++c) walks[c] = now_at[c];
    return true;
  }

 private:
  // Of the symbols of a number: the least that each stands for, and how many bits say which. The last has others.
  static constexpr std::uint32_t kEscape = SymbolModel::kCount - 1, kEscapeLow = 12, kEscapeHigh = 10;
  static constexpr std::uint32_t kFirstShifted = 10;  // scale from which the lowest bits are raw
  static constexpr std::uint8_t kLeast[SymbolModel::kCount] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 24, 32, 64, 128, 0};
  static constexpr std::uint8_t kRawBits[SymbolModel::kCount] = {0, 0, 0, 0, 0, 0, 0, 0, 2, 2, 3, 3, 5, 6, 7, 0};
  static constexpr std::uint32_t kEnd = 256;
  static constexpr std::int32_t kNear = 2047;  // of constants

  // The nearest whole number to the prediction first, then the next nearest, on either side of it.
  std::int32_t code_next(ClipWalk& w, std::int32_t wanted) {
    const std::int32_t exact = 16 * w.x + w.predictor.a * w.d1 + w.predictor.b * w.d2;
    const std::int32_t nearest = (exact + 8) >> 4;
    const std::int32_t flip = exact < 16 * nearest ? -1 : 0;  // or 0: towards where the prediction is
    const auto flipped = [flip](std::int32_t x) { return (x ^ flip) - flip; };
    const std::uint32_t scale = w.scale.code();
    const std::uint32_t shift = scale > kFirstShifted ? (scale - kFirstShifted) / 2 : 0;
    const std::uint32_t size = (w.d1 != 0 ? 1u : 0u) + (w.d1 > 2 || w.d1 < -2 ? 1u : 0u);
    const std::int32_t side = flipped(w.off), far = w.scale.mean() >> 2;
    SymbolModel& model = models_.numbers[scale][size][side > far ? 1 : side < -far ? 2 : 0];
    const std::int32_t off = flipped(unfolded(code_folded(model, shift, folded(flipped(wanted - nearest)))));
    const std::int32_t x = nearest + off;
    w.off = 16 * x - exact;
    w.scale.learn(w.off < 0 ? -w.off : w.off);
    w.d2 = w.d1;
    w.d1 = x - w.x;
    w.x = x;
    return x;
  }

  std::uint32_t code_folded(SymbolModel& model, std::uint32_t shift, std::uint32_t wanted) {
    std::uint32_t symbol = kEscape;
    if (Coder::kEncodes && wanted >> shift < kEnd) do
        --symbol;
      while (kLeast[symbol] > wanted >> shift);
    symbol = coder_.symbol(model, symbol);
    if (symbol == kEscape) [[unlikely]] {
      const std::uint32_t low = coder_.raw_bits(kEscapeLow, wanted & ((1u << kEscapeLow) - 1));
      return coder_.raw_bits(kEscapeHigh, wanted >> kEscapeLow) << kEscapeLow | low;
    }
    const std::uint32_t least = std::uint32_t{kLeast[symbol]} << shift;
    return least + coder_.raw_bits(kRawBits[symbol] + shift, wanted - least);
  }

  std::int32_t code_number(SymbolModel& model, std::int32_t wanted) { return code_signed(coder_, model, wanted); }

  bool code_same(SymbolModel& model, std::uint32_t& was_same, bool wanted) {
    was_same = coder_.symbol(model, wanted ? 1 : 0) == 1 ? 1 : 0;
    coder_.raw_bits(0, 0);
    return was_same != 0;
  }

  // A component whose walk goes on, or begins only now.
  void code_going_on(ClipCurve& curve, ClipWalk& walk) {
    curve.moves = coder_.symbol(models_.moves[walk.moves ? 1 : 0], curve.moves ? 1 : 0) != 0;
    coder_.raw_bits(0, 0);
    if (curve.moves && !walk.begun) {
      code_curve(curve, true);
      if (curve.moves) walk.begin(curve);
    }
    walk.go_on(curve.moves);
  }

  // Scales are close to the last one.
  void code_curve(ClipCurve& curve, bool is_after_moving) {
    constexpr std::int32_t kFarthest = 7, kMost = ClipScale::kCount - 1;
    std::int32_t off = static_cast<std::int32_t>(curve.scale) - at_.scale;
    off = off < -kFarthest ? -kFarthest : off > kFarthest ? kFarthest : off;
    const std::uint32_t code =
        coder_.symbol(models_.scales[is_after_moving ? 1 : 0], curve.moves ? 1 + folded(off) : 0);
    coder_.raw_bits(0, 0);
    curve.moves = code != 0;
    if (!curve.moves) return;
    at_.scale += unfolded(code - 1);
    at_.scale = at_.scale < 0 ? 0 : at_.scale > kMost ? kMost : at_.scale;
    curve.scale = static_cast<std::uint32_t>(at_.scale);
    curve.predictor = coder_.symbol(models_.predictors, curve.predictor) % kClipPredictors;
    coder_.raw_bits(0, 0);
  }

  ClipModels& models_;
  Coder& coder_;
  ClipCodecState at_;
};

}  // namespace marrow
