// What meshes reach in clips, as symbols: one text for the cooker and for unpacking. Each number is guessed from the
// same mesh's in a clip before.
#pragma once

#include <cstddef>

#include "unpack/clip/signed_code.h"

namespace marrow {

// Coder: as ClipCodec's; may be another object each time. A section has one codec of its own.
template <class Coder>
class BoundsCodec {
 public:
  static constexpr std::uint32_t kBytes = 8;         // of format::BoundsCodes: exponent, lower ends, upper ends, radius
  static constexpr std::byte kNothing[kBytes] = {};  // what the first are guessed from

  BoundsCodec() { begin_evenly(models_, kModels); }

  // How many clips lie between a clip, not the first, and the one that it is guessed from.
  std::uint32_t code_between(Coder& coder, std::uint32_t wanted) {
    return folded(code_signed(coder, models_[kBetween], unfolded(wanted)));
  }
  // An encoder's `codes` are what is to be written; a decoder's are filled in.
  void code(Coder& coder, const std::byte* like, std::byte* codes) {
    std::uint32_t growth = 0;  // of the box; of either sign
    for (std::uint32_t i = 0; i < kBytes; ++i) {
      const bool is_exponent = i == 0, is_radius = i == kBytes - 1;
      std::int32_t guess = number(like, i);
      if (!is_exponent) guess = rescaled(guess, 4 * number(like, 0), 4 * number(codes, 0));
      if (is_radius) guess += static_cast<std::int32_t>(growth) >> 2;
      SymbolModel& model = models_[is_exponent ? kExponents : off_[i]];
      const std::int32_t off = code_signed(coder, model, Coder::kEncodes ? number(codes, i) - guess : 0);
      codes[i] = static_cast<std::byte>(wrapped_sum(guess, off));
      const std::uint32_t size = bit_length((folded(off) + 1) / 2) / 2;
      off_[i] = static_cast<std::uint8_t>(size < kExponents ? size : kExponents - 1);
      if (!is_exponent) growth += static_cast<std::uint32_t>(off) * (i > 3 ? 1 : 0xFFFFFFFF);
    }
  }

 private:
  static constexpr std::uint32_t kExponents = 4, kBetween = 5, kModels = 6;  // the others: by how far the last was off

  static std::int32_t number(const std::byte* codes, std::uint32_t i) {
    const auto bits = static_cast<std::uint8_t>(codes[i]);
    return i == kBytes - 1 ? bits : static_cast<std::int8_t>(bits);
  }

  SymbolModel models_[kModels];
  std::uint8_t off_[kBytes] = {};  // of the mesh before, how large that was
};

}  // namespace marrow
