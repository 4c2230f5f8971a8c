// Tracks that are keys, channels and their values as symbols: one text for the cooker, which writes them, and for
// unpacking. A value is a whole number of its list's steps, guessed from the key before.
#pragma once

#include <cmath>
#include <cstring>

#include "asset/format.h"
#include "core/builtins.h"
#include "unpack/clip/signed_code.h"

namespace marrow {

struct ListModels {
  static constexpr std::uint32_t kSizes = SymbolModel::kCount, kWords = 5;
  // By what stands in its place of a key, in-tangent, value or out-tangent, and by how far the last one there was off.
  SymbolModel values[3][kSizes];
  SymbolModel exponents, words[kWords];  // words: of tracks and channels

  void begin();
};

// Of a list's values and of its tangents: powers of two that they are whole numbers of, or kAsBits.
struct ListExponents {
  static constexpr std::int32_t kAsBits = -150, kLeast = -149, kMost = 96;
  std::int32_t values = 0, tangents = 0;
};

// The values of one track or channel: keys of so many numbers each, thrice that with tangents.
struct ValueList {
  std::uint32_t first = 0, count = 0, width = 1;
  bool has_tangents = false;
};

// What the tracks and channels have of the values, in their order; of what two share once, and what none has. `list` is
// the one before, or empty; which: the track or channel to look at next, 0 at first. False behind the last.
inline bool next_list(const format::ClipHeader& h, const Track* tracks, const Channel* channels, std::uint32_t& which,
                      ValueList& list) {
  const std::uint32_t end = list.first + list.count;
  const auto is = [&](std::uint32_t first, std::uint64_t keys, std::uint32_t width, bool has_tangents) {
    const std::uint64_t wanted = keys * width * (has_tangents ? 3 : 1), left = h.value_count - end;
    const auto count = static_cast<std::uint32_t>(wanted < left ? wanted : left);
    if (first != end || count == 0) return false;
    list = {end, count, width, has_tangents};
    return true;
  };
  while (which <= h.track_count + h.channel_count) {
    const std::uint32_t n = which++;
    if (n < h.track_count) {
      const Track& t = tracks[n];
      if (is(t.first_value, t.key_count, t.path == TrackPath::rotation ? 4 : 3,
             t.interpolation == Interpolation::cubic_spline))
        return true;
    } else if (n - h.track_count < h.channel_count) {
      const Channel& c = channels[n - h.track_count];
      if (is(c.first_value, c.key_count, 1, c.interpolation == Interpolation::cubic_spline)) return true;
    } else if (is(end, h.value_count, 1, false)) {
      return true;
    }
  }
  return false;
}
template <class Visit>
void for_each_list(const format::ClipHeader& h, const Track* tracks, const Channel* channels, Visit&& visit) {
  ValueList list;
  for (std::uint32_t which = 0; next_list(h, tracks, channels, which, list);) visit(list);
}

inline constexpr std::uint32_t kMostListWidth = 4;
// What a codec keeps from one number to the next, beside the models.
struct ListCodecState {
  std::int32_t exponents[2] = {};  // of values, of tangents
  std::uint32_t words[ListModels::kWords] = {}, kind = 0, end = 0;
  std::int32_t before[2][kMostListWidth] = {};  // of the list in work a value, and a tangent
  std::uint8_t sizes[3][kMostListWidth] = {};   // of what they were off by
};

// Coder: as ClipCodec's. A clip has one of its own; models go on from clip to clip.
template <class Coder>
class ListCodec {
 public:
  ListCodec(ListModels& models, Coder& coder, const ListCodecState& at = {})
      : models_(models), coder_(coder), at_(at) {}
  const ListCodecState& state() const { return at_; }

  // An encoder's are what is to be written, a decoder's are filled in.
  void code_track(Track& t) {
    if (!Coder::kEncodes) t = {};
    const std::uint32_t kind = static_cast<std::uint32_t>(t.path) | static_cast<std::uint32_t>(t.interpolation) << 8;
    const std::uint32_t joint_and_kind = code_word(0, t.joint | kind << 16, at_.words[0]);
    t.joint = static_cast<std::uint16_t>(joint_and_kind);
    t.path = static_cast<TrackPath>(joint_and_kind >> 16 & 255);
    t.interpolation = static_cast<Interpolation>(joint_and_kind >> 24);
    code_place(t.key_count, t.first_time, t.first_value);
    at_.end += t.key_count * format::floats_per_key(t.path, t.interpolation);
  }
  void code_channel(Channel& c) {
    if (!Coder::kEncodes) c = {};
    c.name = code_word(0, c.name, at_.words[0]);
    c.rest = bit_cast<float>(code_word(4, bit_cast<std::uint32_t>(c.rest), at_.words[4]));
    code_place(c.key_count, c.first_time, c.first_value);
    c.interpolation = static_cast<Interpolation>(code_word(4, static_cast<std::uint32_t>(c.interpolation), at_.kind));
    at_.end += c.key_count * format::floats_per_key(c.interpolation);
  }

  // values: of the whole clip. False if it is nothing that an encoder writes.
  bool code_values(const ValueList& list, const ListExponents& wanted, float* values) {
    return code_values(list, wanted, values, 0, list.count);
  }
  // Those from the list's `from` on and before `end`.
  bool code_values(const ValueList& list, const ListExponents& wanted, float* values, std::uint32_t from,
                   std::uint32_t end) {
    if (from == 0 && !begin_values(list, wanted)) return false;
    auto& before = at_.before;
    auto& sizes = at_.sizes;
    for (std::uint32_t i = from; i < end; ++i) {
      const std::uint32_t c = i % list.width, place = list.has_tangents ? i / list.width % 3 : kValue;
      const std::uint32_t kind = place == kValue ? 0 : 1;
      float& value = values[list.first + i];
      std::int32_t &number = before[kind][c], wanted_off = 0;
      if (Coder::kEncodes) wanted_off = wrapped_difference(number_of(value, at_.exponents[kind]), number);
      const std::int32_t off = code_signed(coder_, models_.values[place][sizes[place][c]], wanted_off);
      number = wrapped_sum(number, off);
      sizes[place][c] = size_of(off);
      if (!Coder::kEncodes) value = value_of(number, at_.exponents[kind]);
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kValue = 1;

  bool begin_values(const ValueList& list, const ListExponents& wanted) {
    code_exponent(wanted.values, at_.exponents[0]);
    if (list.has_tangents) code_exponent(wanted.tangents, at_.exponents[1]);
    for (const std::int32_t exponent : at_.exponents)
      if (exponent != ListExponents::kAsBits && (exponent < ListExponents::kLeast || exponent > ListExponents::kMost))
        return false;
    std::memset(at_.before, 0, sizeof at_.before);
    std::memset(at_.sizes, 0, sizeof at_.sizes);
    return true;
  }
  static std::uint8_t size_of(std::int32_t off) {
    const std::uint32_t size = bit_length(folded(off));
    return static_cast<std::uint8_t>(size < ListModels::kSizes ? size : ListModels::kSizes - 1);
  }
  static float value_of(std::int32_t number, std::int32_t exponent) {
    return exponent == ListExponents::kAsBits ? bit_cast<float>(number)
                                              : std::ldexp(static_cast<float>(number), exponent);
  }
  static std::int32_t number_of(float value, std::int32_t exponent) {
    return exponent == ListExponents::kAsBits ? bit_cast<std::int32_t>(value)
                                              : static_cast<std::int32_t>(std::ldexp(value, -exponent));
  }
  void code_exponent(std::int32_t wanted, std::int32_t& last) {
    last = wrapped_sum(last, code_signed(coder_, models_.exponents, wanted - last));
  }
  // By what it differs by from the one in its column before.
  std::uint32_t code_word(std::uint32_t column, std::uint32_t wanted, std::uint32_t& last) {
    const auto off = static_cast<std::int32_t>(wanted - last);
    last += static_cast<std::uint32_t>(code_signed(coder_, models_.words[column], Coder::kEncodes ? off : 0));
    return last;
  }
  // Values stand one behind the other.
  void code_place(std::uint32_t& key_count, std::uint32_t& first_time, std::uint32_t& first_value) {
    key_count = code_word(1, key_count, at_.words[1]);
    first_time = code_word(2, first_time, at_.words[2]);
    first_value = code_word(3, first_value, at_.end);
  }

  ListModels& models_;
  Coder& coder_;
  ListCodecState at_;
};

}  // namespace marrow
