// Writes records of packed files: numbers, symbols, and a mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "cook/geometry/owned_streams.h"
#include "unpack/symbol_coder.h"

namespace marrow::cook {

// Keeps what is to be written and writes it from its end, as the decoder takes it off the other way round.
class SymbolEncoder {
 public:
  static constexpr bool kEncodes = true;

  std::uint32_t symbol(SymbolModel& model, std::uint32_t symbol) {
    parts_.push_back({model.share(symbol), SymbolModel::kBits, 0, 0});
    model.learn(symbol);
    is_open_ = true;
    return symbol;
  }
  std::uint32_t raw_bits(std::uint32_t count, std::uint32_t value) {
    if (!is_open_) parts_.push_back({{0, 1}, 0, 0, 0});
    parts_.back().raw_bits = count;
    parts_.back().value = value;
    is_open_ = false;
    return value;
  }
  bool bit(BitModel& model, bool bit) {
    const std::uint32_t chance = model.chance();
    parts_.push_back(
        {bit ? SymbolShare{0, chance} : SymbolShare{chance, (1u << BitModel::kBits) - chance}, BitModel::kBits, 0, 0});
    model.learn(bit);
    return bit;
  }
  bool even_bit(bool bit) { return raw_bits(1, bit ? 1 : 0) != 0; }

  std::vector<std::byte> finish() {
    std::vector<std::uint32_t> words;
    std::uint64_t state = SymbolDecoder::kLeastState;
    for (std::size_t i = parts_.size(); i-- > 0;) {
      const Part& p = parts_[i];
      // Beyond, the state that the decoder comes from would have more than 64 bits.
      const std::uint32_t shift = 64 - p.bits - p.raw_bits;
      if (shift < 64 && state >> shift >= p.share.size) {
        words.push_back(static_cast<std::uint32_t>(state));
        state >>= 32;
      }
      state = state << p.raw_bits | p.value;
      state = (state / p.share.size << p.bits) + state % p.share.size + p.share.start;
    }
    words.push_back(static_cast<std::uint32_t>(state));
    words.push_back(static_cast<std::uint32_t>(state >> 32));
    std::vector<std::byte> out;
    for (std::size_t i = words.size(); i-- > 0;)
      for (std::uint32_t shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>(words[i] >> shift));
    parts_.clear();
    return out;
  }

 private:
  // One step of the decoder.
  struct Part {
    SymbolShare share;  // of 2^bits
    std::uint32_t bits, raw_bits, value;
  };
  std::vector<Part> parts_;
  bool is_open_ = false;  // raw bits are to follow the last symbol
};

// LEB128: seven bits a byte, lowest first.
inline void add_varint(std::uint32_t value, std::vector<std::byte>& out) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<std::byte>(value | 0x80));
  out.push_back(static_cast<std::byte>(value));
}

template <class T>
void add_value(const T& value, std::vector<std::byte>& out) {
  const auto* const first = reinterpret_cast<const std::byte*>(&value);
  out.insert(out.end(), first, first + sizeof value);
}

// A GEOM record: what undoes the quantisation, then the codec's bytes.
std::vector<std::byte> geometry_record(const OwnedStreams& streams, const std::vector<std::byte>& encoded);

}  // namespace marrow::cook
