// The words that file_rules.cpp writes rules in.
#pragma once

#include <cstddef>

#include "asset/file_rules.h"
#include "asset/format.h"

// Of their own namespace, for they are short.
namespace marrow::rule_table {

// A rule as it is written.
struct Limit {
  RuleNumber number;
  std::uint32_t value = 0;
  bool is_constant = false;
  constexpr Limit(RuleNumber n) : number(n) {}
  constexpr Limit(std::uint32_t constant) : number{}, value(constant), is_constant(true) {}
};
struct Line {
  How how;
  RuleNumber number;
  Limit limit;
  std::size_t count = 0;
  const char* text = "";
  std::size_t back = 0;
  constexpr Line at(std::size_t bytes_before) const {
    Line out = *this;
    out.back = bytes_before;
    return out;
  }
};

// No constant expression if the value is more.
inline void does_not_fit() {}
constexpr unsigned fitting(std::size_t value, unsigned most) {
  if (value > most) does_not_fit();
  return static_cast<unsigned>(value);
}

constexpr RuleNumber number(From from, std::size_t at, std::size_t bytes) {
  RuleNumber out{};
  out.from = static_cast<unsigned>(from) & 7u;
  out.bytes = bytes < 4 ? static_cast<unsigned>(bytes) & 7u : 4u;
  out.at = fitting(at, 1023u) & 1023u;
  return out;
}
// The first constant; also where no number counts.
inline constexpr RuleNumber kOne = number(From::constants, 0, 4);
constexpr RuleNumber byte(std::size_t at) {
  return number(From::record, at, 1);
}
constexpr RuleNumber half(std::size_t at) {
  return number(From::record, at, 2);
}
constexpr RuleNumber word(std::size_t at) {
  return number(From::record, at, 4);
}
constexpr RuleNumber array(std::size_t n) {
  return number(From::arrays, 8 * n, 4);
}
constexpr RuleNumber count_of(format::Kind kind) {
  return number(From::counts, 4 * std::size_t{kind}, 4);
}
// Of a geometry.
inline constexpr RuleNumber kIndexBytes = array(kIndexBytesPlace);
// Of the skeleton or reference.
inline constexpr RuleNumber kJointCount = number(From::owner, offsetof(format::SkeletonHeader, joint_count), 4);
static_assert(offsetof(format::SkeletonHeader, joint_count) == offsetof(format::ReferenceHeader, joint_count));
// A member of a record, or of the section's header.
#define MARROW_IN(type, member) number(From::record, offsetof(type, member), sizeof(type::member))
#define MARROW_OF_HEADER(type, member) number(From::header, offsetof(type, member), sizeof(type::member))

constexpr Line begins(std::uint32_t kind) {
  return {How::begins, kOne, 0u, kind};
}
constexpr Line equal(RuleNumber n, Limit limit, const char* text) {
  return {How::equal, n, limit, 0, text};
}
constexpr Line below(RuleNumber n, Limit limit, const char* text) {
  return {How::below, n, limit, 0, text};
}
constexpr Line at_most(RuleNumber n, Limit limit, const char* text) {
  return {How::at_most, n, limit, 0, text};
}
constexpr Line at_least(RuleNumber n, Limit limit, const char* text) {
  return {How::at_least, n, limit, 0, text};
}
constexpr Line from_1_to(RuleNumber n, Limit limit, const char* text) {
  return {How::from_1_to, n, limit, 0, text};
}
constexpr Line only_bits(RuleNumber n, Limit limit, const char* text) {
  return {How::only_bits, n, limit, 0, text};
}
constexpr Line differ(RuleNumber n, Limit limit, const char* text) {
  return {How::differ, n, limit, 0, text};
}
constexpr Line reserved(RuleNumber n) {
  return at_most(n, 0u, "reserved must be 0");
}
constexpr Line where_bits(RuleNumber n, Limit limit) {
  return {How::where_bits, n, limit};
}
constexpr Line where_lacks(RuleNumber n, Limit limit) {
  return {How::where_lacks, n, limit};
}
constexpr Line where_differ(RuleNumber n, Limit limit) {
  return {How::where_differ, n, limit};
}
constexpr Line floats(RuleNumber n, std::size_t count, std::uint32_t limit, const char* text) {
  return {How::floats, n, limit, count, text};
}
constexpr Line floats_until(std::size_t first, std::size_t last, std::uint32_t limit, const char* text) {
  return {How::floats_until, array(first), array(last), limit, text};
}
constexpr Line finite(RuleNumber n, std::size_t count = 1) {
  return floats(n, count, kFiniteBits, kNotFinite);
}
constexpr Line bounded(RuleNumber n, std::size_t count) {
  return floats(n, count, kBoundedBits, kNotBounded);
}
constexpr Line finite_until(std::size_t first, std::size_t last) {
  return floats_until(first, last, kFiniteBits, kNotFinite);
}
constexpr Line bounded_until(std::size_t first, std::size_t last) {
  return floats_until(first, last, kBoundedBits, kNotBounded);
}
constexpr Line not_negative(RuleNumber n, const char* text) {
  return {How::not_negative, n, 0u, 0, text};
}
constexpr Line positive(RuleNumber n, const char* text) {
  return {How::positive, n, 0u, 0, text};
}
constexpr Line name(RuleNumber n) {
  return {How::name, n, 0u};
}
constexpr Line text(RuleNumber n) {
  return {How::text, n, 0u};
}
constexpr Line owner(RuleNumber n) {
  return {How::owner, n, 0u, 0, "no such skeleton"};
}
constexpr Line owner_or_reference(RuleNumber n) {
  return {How::owner, n, 0u, 1, "no such skeleton"};
}
constexpr Line each(std::size_t first, std::size_t last, std::size_t bytes) {
  return {How::each, array(first), array(last), bytes};
}
constexpr Line short_rotations() {
  return floats(MARROW_IN(SoaTransform, rotation), 16, kUnitBits, kNoUnit);
}
constexpr Line ends() {
  return {How::ends, kOne, 0u};
}
// An array behind the header and those before it: n elements, times as many as `times` says.
constexpr Line array_of(RuleNumber n, std::size_t bytes, Limit times = 1u) {
  return {How::array, n, times, bytes};
}
// So many bytes.
constexpr Line array_of(std::size_t bytes) {
  return {How::array, kOne, 1u, bytes};
}
constexpr Line array_of_groups(RuleNumber n, std::size_t bytes) {
  return {How::groups, n, 0u, bytes};
}
constexpr Line aligned() {
  return {How::aligned, kOne, 0u};
}
constexpr Line fills() {
  return {How::fills, byte(0), 0u, 0, "section size differs from its counts"};
}
constexpr Line call(Check check, const char* text = "", RuleNumber n = byte(0), Limit limit = 0u) {
  return {How::call, n, limit, static_cast<std::size_t>(check), text};
}

constexpr Line long_rotations() {
  return call(Check::rotations, kNoUnit, number(From::record, offsetof(SoaTransform, rotation), 4));
}

// Of an enum.
template <class Enum>
constexpr std::uint32_t last(Enum value) {
  return static_cast<std::uint32_t>(value);
}

}  // namespace marrow::rule_table
