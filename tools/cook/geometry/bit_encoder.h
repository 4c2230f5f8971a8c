// What BitDecoder reads.
#pragma once

#include <cstddef>
#include <vector>

#include "unpack/bit_coder.h"

namespace marrow::cook {

class BitEncoder {
 public:
  static constexpr bool kEncodes = true;

  bool bit(BitModel& model, bool bit) {
    put(bit, model.chance());
    model.learn(bit);
    return bit;
  }
  bool even_bit(bool bit) {
    put(bit, kEvenChance);
    return bit;
  }
  // The last byte with it, behind which zeros do.
  std::vector<std::byte> finish() {
    if (interval_.low > 0) out_.push_back(static_cast<std::byte>((interval_.low >> 24) + 1));
    return std::move(out_);
  }

 private:
  void put(bool bit, std::uint32_t chance) {
    interval_.take(bit, interval_.middle(chance));
    for (; interval_.agrees(); interval_.shift()) out_.push_back(static_cast<std::byte>(interval_.low >> 24));
  }

  BitInterval interval_;
  std::vector<std::byte> out_;
};

}  // namespace marrow::cook
