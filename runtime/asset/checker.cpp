#include "asset/checker.h"

#include <cstring>

namespace marrow {
namespace {

// The owner of a section that has none: it has no joints.
constexpr format::SkeletonHeader kNobody{};

}  // namespace

void Checker::keep_first(const void* where, const char* rule) {
  if (!good()) return;
  const auto offset = static_cast<const std::byte*>(where) - block_.data;
  error_ = {Status::bad_data, static_cast<std::uint32_t>(offset), rule};
}

bool Checker::begin(const File::Section& s, std::uint32_t header_bytes, std::uint32_t last_codec) {
  section_ = &s;
  base_ = block_.data + s.offset;
  owner_ = &kNobody;
  if (s.codec > last_codec) {
    error_ = {Status::unsupported, s.offset, "a codec that this build lacks"};
    return false;
  }
  return s.bytes >= header_bytes || fail(header(), "section too short for its header");
}

bool Checker::has_size(std::uint64_t bytes) {
  return bytes == section_->bytes || fail(header(), kWrongSize);
}

// In one pass without a branch a float.
const float* Checker::first_from(float limit, const float* first, std::uint64_t count) {
  const auto* words = reinterpret_cast<const std::uint32_t*>(first);
  const std::uint32_t bits = bit_cast<std::uint32_t>(limit);
  std::uint32_t bad = 0;
  const auto most = static_cast<std::int32_t>(bits);  // what has a sign is compared more quickly
  for (std::uint64_t i = 0; i < count; ++i) bad |= static_cast<std::int32_t>(words[i] & 0x7FFFFFFFu) >= most;
  if (bad == 0) return nullptr;
  while ((*words & 0x7FFFFFFFu) < bits) ++words;
  return reinterpret_cast<const float*>(words);
}

bool Checker::floats_below(float limit, const float* first, std::uint64_t count, const char* rule) {
  const float* const beyond = first_from(limit, first, count);
  return beyond == nullptr || fail(beyond, rule);
}

void Checker::floats(const float* first, std::uint64_t count, Floats which) {
  const bool bounded = which == Floats::bounded;
  floats_below(bounded ? kBeyondFarthest : kInfinity, first, count, bounded ? kNotBounded : kNotFinite);
}

void Checker::float_within(const float& value, float least, float most, const char* rule) {
  if (!(value >= least && value <= most)) fail(&value, rule);
}

void Checker::array_of_floats(std::uint64_t first, std::uint64_t count, Floats which) {
  if (leaves_arrays_ || count == 0) return;  // an empty one may stand where no float can
  floats(&at<float>(first), count, which);
}

void Checker::array_of_transforms(const format::Array<SoaTransform>& a) {
  if (leaves_arrays_) return;
  floats(&at<float>(a), a.bytes() / sizeof(float), Floats::bounded);
  for (const SoaTransform& four : in(a)) {
    if (!good() || !floats_below(kMostOfUnit, four.rotation[0], 16, kNoUnit)) return;
    for (const float& x : four.rotation[0])
      if (!(dot_of_rotations(&x, &x, 4) >= kShortestSquare)) fail(four.rotation, kNoUnit);
  }
}

void Checker::in_range(const void* where, std::uint32_t value, std::uint32_t least, std::uint32_t most,
                       const char* rule) {
  if (value < least || value > most) fail(where, rule);
}

void Checker::zero(const void* where, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i)
    if (static_cast<const std::uint8_t*>(where)[i] != 0) fail(where, "reserved must be 0");
}

bool Checker::is_text(const std::uint32_t& n) {
  return n < sections_[sections_.size - 1].bytes || fail(&n, "name outside the name section");
}

// Names are compared with others, so how long they are has a limit; texts are only handed out.
void Checker::is_name(const std::uint32_t& n) {
  if (!is_text(n)) return;
  const File::Section& s = sections_[sections_.size - 1];
  const std::uint64_t left = s.bytes - n;  // the last byte is a zero
  if (left > format::kLongestName + 1 &&
      std::memchr(block_.data + s.offset + n, 0, format::kLongestName + 1) == nullptr)
    fail(&n, "a name of more than 2047 bytes");
}

void Checker::find_owner(const std::uint32_t& number, format::Kind kind) {
  if (number >= counts_[kind]) {
    fail(&number, "no such skeleton");
  } else {
    owner_ = &nth<format::SkeletonHeader>(kind, number);
  }
}

void Checker::only_of_skeleton(const Field&, const std::uint32_t& n, const char* rule) {
  find_owner(n, format::kSkeletons);
  if (follows_its_like() && header_before<std::uint32_t>() >= n) fail(header(), rule);
}

}  // namespace marrow
