#include "cook/write/list_exponents.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

namespace marrow::cook {
namespace {

// Key by key, each of `width` numbers.
using WholeNumbers = std::vector<std::int32_t>;

// Of which a number other than 0 is an odd multiple.
std::int32_t exponent_of(float value) {
  int exponent = 0;
  const auto mantissa = static_cast<std::uint32_t>(std::fabs(std::ldexp(std::frexp(value, &exponent), 24)));
  return exponent - 24 + std::countr_zero(mantissa);
}

// nullopt if they are not as many whole numbers, of which a float holds each.
std::optional<WholeNumbers> in_steps(const std::vector<float>& values, std::int32_t exponent) {
  constexpr float kMost = 1 << 24;
  WholeNumbers out;
  for (const float value : values) {
    const float number = std::ldexp(value, -exponent);
    if (!(std::fabs(number) <= kMost) || (value == 0 && std::signbit(value))) return std::nullopt;
    out.push_back(static_cast<std::int32_t>(number));
  }
  return out;
}

// About as many bits as they take.
std::size_t bits_of(const WholeNumbers& numbers, std::size_t width) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    out += bit_length(folded(wrapped_difference(numbers[i], i < width ? 0 : numbers[i - width])));
  return out;
}

std::int32_t choose_exponent(const std::vector<float>& values, std::size_t width) {
  std::optional<std::int32_t> exponent;
  WholeNumbers as_bits;
  for (const float value : values) {
    as_bits.push_back(std::bit_cast<std::int32_t>(value));
    if (value != 0) exponent = std::min(exponent.value_or(ListExponents::kMost), exponent_of(value));
  }
  const std::optional<WholeNumbers> numbers = in_steps(values, exponent.value_or(0));
  if (!numbers || bits_of(as_bits, width) < bits_of(*numbers, width)) return ListExponents::kAsBits;
  return exponent.value_or(0);
}

}  // namespace

ListExponents choose_exponents(const ValueList& list, const float* values) {
  std::vector<float> kinds[2];  // values, tangents
  for (std::uint32_t i = 0; i < list.count; ++i)
    kinds[list.has_tangents && i / list.width % 3 != 1 ? 1 : 0].push_back(values[list.first + i]);
  return {choose_exponent(kinds[0], list.width), choose_exponent(kinds[1], list.width)};
}

}  // namespace marrow::cook
