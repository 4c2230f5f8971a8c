#include "unpack/symbol_coder.h"

#include <cstring>

namespace marrow {
namespace {

// Moves a chance, out of 2^16 and less a half, by 1 / 2^shift of the way towards the bit.
std::int16_t moved(std::int16_t from, bool bit, std::uint32_t shift) {
  constexpr std::int32_t kOne = 1 << 16, kHalf = kOne / 2, kLeast = 32;
  std::int32_t chance = from + kHalf;
  chance += bit ? (kOne - chance) >> shift : -(chance >> shift);
  chance = chance < kLeast ? kLeast : chance > kOne - kLeast ? kOne - kLeast : chance;
  return static_cast<std::int16_t>(chance - kHalf);
}

constexpr std::int16_t kLeastOfSymbol = 8;  // the share that a symbol tends to while others are seen
constexpr std::int16_t kAllButLeast = (1 << SymbolModel::kBits) - SymbolModel::kCount * kLeastOfSymbol;

// Where the ends of symbols move to, beyond their least shares: kAllButLeast for the ends of the symbol seen and of
// those behind it, 0 for those before it. The 16 numbers for a symbol begin at of[15 - symbol].
struct EndSteps {
  std::int16_t of[2 * SymbolModel::kCount] = {};
  constexpr EndSteps() {
    for (std::uint32_t i = SymbolModel::kCount - 1; i < 2 * SymbolModel::kCount; ++i) of[i] = kAllButLeast;
  }
};
constexpr EndSteps kEndSteps;

// How far ends move, out of 2^16, by the number of symbols seen so far.
constexpr std::int16_t kRates[] = {1 << 13, 1 << 13, 1 << 12, 1 << 12, 1 << 11, 1 << 11, 1 << 11, 1 << 11, 1 << 10};
constexpr std::int16_t kMostSeen = sizeof(kRates) / sizeof(kRates[0]) - 1, kGuessSeen = 3;

}  // namespace

void BitModel::learn(bool bit) {
  constexpr std::uint32_t kSeenMost = 32, kFast = 4;
  const auto seen = static_cast<std::uint32_t>(seen_);
  fast_ = moved(fast_, bit, seen + 1 < kFast ? seen + 1 : kFast);
  slow_ = moved(slow_, bit, 1 + bit_length(seen));
  if (seen < kSeenMost) ++seen_;
}

void SymbolModel::begin(const std::uint8_t (&weights)[kCount], bool is_guess) {
  std::uint32_t start = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    starts_[i] = static_cast<std::int16_t>(start);
    start += weights[i] * ((1u << kBits) / kWeights);
  }
  starts_[kCount] = static_cast<std::int16_t>(start);
  seen_ = is_guess ? kGuessSeen : 0;
}

// Shares of 256: a number of `size` bits is the likeliest, each further bit half as likely.
void begin_near(std::uint32_t size, SymbolModel& model) {
  std::uint8_t weights[SymbolModel::kCount];
  std::uint32_t left = SymbolModel::kWeights;
  for (std::uint32_t i = 0; i < SymbolModel::kCount; ++i) {
    const std::uint32_t away = i < size ? size - i : i - size;
    weights[i] = static_cast<std::uint8_t>(away < 6 ? 64u >> away : 1u);
    left -= weights[i];
  }
  weights[size] = static_cast<std::uint8_t>(weights[size] + left);
  model.begin(weights, true);
}

void begin_evenly(SymbolModel* models, std::size_t count) {
  constexpr std::uint8_t kEven[SymbolModel::kCount] = {16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16};
  for (std::size_t i = 0; i < count; ++i) models[i].begin(kEven, false);
}

// Written so that compilers vectorise it in 16 bits. Not inlined: inlined, GCC 12 takes the count's lanes for negative.
[[gnu::noinline]] std::uint32_t SymbolModel::find(std::uint32_t place) const {
  const auto wanted = static_cast<std::int16_t>(place);
  std::int16_t out = 0;
  for (std::uint32_t i = 1; i <= kCount; ++i) out = static_cast<std::int16_t>(out + (starts_[i] <= wanted ? 1 : 0));
  return static_cast<std::uint32_t>(out);
}

// Vectorised likewise: vectors have an instruction for a product's upper half, but none for a shift by a loaded number.
void SymbolModel::learn(std::uint32_t symbol) {
  const std::int16_t* const steps = kEndSteps.of + (kCount - 1 - symbol);
  const std::int16_t rate = kRates[seen_];
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto least = static_cast<std::int16_t>((i + 1) * kLeastOfSymbol);
    const auto way = static_cast<std::int16_t>(least + steps[i] - starts_[i + 1]);
    starts_[i + 1] = static_cast<std::int16_t>(starts_[i + 1] + static_cast<std::int16_t>(way * rate >> 16));
  }
  if (seen_ < kMostSeen) ++seen_;
}

SymbolDecoder::SymbolDecoder(Span<const std::byte> bytes) : at_(bytes.data), left_(bytes.size) {
  for (int i = 0; i < 2; ++i) state_ = state_ << 32 | next();
}

std::uint32_t SymbolDecoder::symbol(SymbolModel& model, std::uint32_t) {
  const std::uint32_t place = static_cast<std::uint32_t>(state_) & ((1u << SymbolModel::kBits) - 1);
  const std::uint32_t symbol = model.find(place);
  const SymbolShare share = model.share(symbol);
  state_ = share.size * (state_ >> SymbolModel::kBits) + (place - share.start);
  model.learn(symbol);
  return symbol;
}

bool SymbolDecoder::bit(BitModel& model, bool) {
  const std::uint32_t place = static_cast<std::uint32_t>(state_) & ((1u << BitModel::kBits) - 1);
  const std::uint32_t chance = model.chance();
  const bool bit = place < chance;
  state_ >>= BitModel::kBits;
  state_ = bit ? chance * state_ + place : ((1u << BitModel::kBits) - chance) * state_ + (place - chance);
  refill();
  model.learn(bit);
  return bit;
}

std::uint32_t SymbolDecoder::next() {
  std::uint32_t out = 0;
  if (left_ < sizeof out) {
    left_ = 0;
    failed_ = true;
    return 0;
  }
  std::memcpy(&out, at_, sizeof out);
  at_ += sizeof out;
  left_ -= sizeof out;
  return out;
}

}  // namespace marrow
