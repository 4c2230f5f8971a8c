// What symbols are coded as: states worked out by hand, and models that stay what they are whatever they see.
#include <vector>

#include <gtest/gtest.h>

#include "unpack/symbol_coder.h"

namespace marrow {
namespace {

constexpr std::uint8_t kEven[SymbolModel::kCount] = {16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16};

SymbolModel even_model() {
  SymbolModel model;
  model.begin(kEven, false);
  return model;
}

// Two halves of a state, the higher first, and words behind it; lowest byte first in each.
std::vector<std::byte> bytes_of(const std::vector<std::uint32_t>& words) {
  std::vector<std::byte> out;
  for (const std::uint32_t word : words)
    for (std::uint32_t shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>(word >> shift));
  return out;
}

SymbolDecoder decoder_of(const std::vector<std::byte>& bytes) {
  return SymbolDecoder({bytes.data(), bytes.size()});
}

// Symbol 5 of 16 that are alike, then the bits 110. Backwards from 2^32: times 8 and 6; the bits are 6 more than 2^25
// times 1024, the symbol's size, so the state is 2^25 times 2^14, and 5 times 1024, where the symbol begins, and 6.
TEST(Symbols, ByHand) {
  const std::uint64_t state = (std::uint64_t{1} << 39) + 5 * 1024 + 6;
  const std::vector<std::byte> bytes =
      bytes_of({static_cast<std::uint32_t>(state >> 32), static_cast<std::uint32_t>(state)});
  SymbolModel model = even_model();
  SymbolDecoder decoder = decoder_of(bytes);
  EXPECT_EQ(decoder.symbol(model, 0), 5u);
  EXPECT_EQ(decoder.raw_bits(3, 0), 6u);
  EXPECT_TRUE(decoder.at_end());
  // The first symbol that is seen moves all ends by an eighth of their way: to 8 for each symbol before them, and 16256
  // more for those behind it.
  EXPECT_EQ(model.share(5).start, 5 * 1024u - (5 * 1024 - 5 * 8) / 8);
  EXPECT_EQ(model.share(6).start, 6 * 1024u + (16256 + 6 * 8 - 6 * 1024) / 8);
}

// A bit that is 1 by half, twice: 2^32 - 16 bits each - is halved in size both times. From 2^32: the last is 0, so the
// state doubles and has 2^15 more; then 1: it doubles.
TEST(Symbols, BitsByHand) {
  const std::uint64_t last = (((std::uint64_t{1} << 32) / 32768) << 16) + 32768;
  const std::uint64_t state = ((last / 32768) << 16) + last % 32768;
  const std::vector<std::byte> bytes =
      bytes_of({static_cast<std::uint32_t>(state >> 32), static_cast<std::uint32_t>(state)});
  BitModel first, second;
  SymbolDecoder decoder = decoder_of(bytes);
  EXPECT_TRUE(decoder.bit(first, false));
  EXPECT_FALSE(decoder.bit(second, false));
  EXPECT_TRUE(decoder.at_end());
  EXPECT_GT(first.chance(), 32768u);
  EXPECT_LT(second.chance(), 32768u);
}

// 40 bits as they are: a word is read as soon as the state is below 2^32.
TEST(Symbols, TakesWords) {
  // Backwards: 2^32, then 16 bits 0xBEEF and 16 bits 0xDEAD make 65 bits, one too many: a word goes out before the
  // second.
  const std::uint64_t once = (std::uint64_t{1} << 48) | 0xBEEF;
  const std::uint64_t state = (once >> 32) << 16 | 0xDEAD;
  const std::vector<std::byte> bytes = bytes_of(
      {static_cast<std::uint32_t>(state >> 32), static_cast<std::uint32_t>(state), static_cast<std::uint32_t>(once)});
  SymbolDecoder decoder = decoder_of(bytes);
  EXPECT_EQ(decoder.raw_bits(16, 0), 0xDEADu);
  EXPECT_FALSE(decoder.at_end());
  EXPECT_EQ(decoder.raw_bits(16, 0), 0xBEEFu);
  EXPECT_TRUE(decoder.at_end());
}

TEST(Symbols, EndWhereTheyEnd) {
  const std::vector<std::byte> whole = bytes_of({1, 0});
  EXPECT_TRUE(decoder_of(whole).at_end());
  EXPECT_FALSE(decoder_of({}).at_end());
  EXPECT_FALSE(decoder_of({whole.begin(), whole.end() - 1}).at_end()) << "a byte less";
  EXPECT_FALSE(decoder_of(bytes_of({1, 0, 0})).at_end()) << "a word more";
  EXPECT_FALSE(decoder_of(bytes_of({2, 0})).at_end()) << "another state";
}

// Whatever is seen, every symbol keeps a place, and together they have all.
TEST(Symbols, ModelsKeepAllSymbols) {
  SymbolModel model = even_model();
  std::uint32_t random = 1;
  for (int round = 0; round < 40000; ++round) {
    random = random * 1664525 + 1013904223;
    const std::uint32_t kind = static_cast<std::uint32_t>(round) / 4000 % 4;
    const std::uint32_t symbol = kind == 0 ? 0 : kind == 1 ? 15 : kind == 2 ? random >> 28 : random >> 31 ? 7 : 8;
    model.learn(symbol);
    std::uint32_t end = 0;
    for (std::uint32_t i = 0; i < SymbolModel::kCount; ++i) {
      const SymbolShare share = model.share(i);
      ASSERT_EQ(share.start, end);
      ASSERT_GE(share.size, 1u);
      ASSERT_LT(share.size, 1u << SymbolModel::kBits);
      end += share.size;
      ASSERT_EQ(model.find(share.start), i);
      ASSERT_EQ(model.find(end - 1), i);
    }
    ASSERT_EQ(end, 1u << SymbolModel::kBits);
    const bool are_alike = round % 4000 == 3999 && kind < 2;
    EXPECT_TRUE(!are_alike || model.share(symbol).size > 15000u);
  }
}

}  // namespace
}  // namespace marrow
