#include "unpack/bit_coder.h"

namespace marrow {
namespace {

// Of 2^16, less a half.
std::int16_t moved(std::int16_t from, bool bit, std::uint32_t shift) {
  constexpr std::int32_t kOne = 1 << 16, kHalf = kOne / 2, kLeast = 32;
  std::int32_t chance = from + kHalf;
  chance += bit ? (kOne - chance) >> shift : -(chance >> shift);
  chance = chance < kLeast ? kLeast : chance > kOne - kLeast ? kOne - kLeast : chance;
  return static_cast<std::int16_t>(chance - kHalf);
}

}  // namespace

void BitModel::learn(bool bit) {
  constexpr std::uint32_t kSeenMost = 32, kFast = 4;
  const auto seen = static_cast<std::uint32_t>(seen_);
  fast_ = moved(fast_, bit, seen + 1 < kFast ? seen + 1 : kFast);
  slow_ = moved(slow_, bit, 1 + bit_length(seen));
  if (seen < kSeenMost) ++seen_;
}

BitDecoder::BitDecoder(Span<const std::byte> bytes) : bytes_(bytes) {
  for (int i = 0; i < 4; ++i) code_ = code_ << 8 | next();
}

bool BitDecoder::bit(BitModel& model, bool) {
  const bool bit = take(model.chance());
  model.learn(bit);
  return bit;
}

bool BitDecoder::take(std::uint32_t chance) {
  const std::uint32_t middle = interval_.middle(chance);
  const bool bit = code_ <= middle;
  interval_.take(bit, middle);
  for (; interval_.agrees(); interval_.shift()) code_ = code_ << 8 | next();
  return bit;
}

std::uint32_t BitDecoder::next() {
  const std::size_t at = read_++;
  return at < bytes_.size ? static_cast<std::uint32_t>(bytes_[at]) : 0;
}

}  // namespace marrow
