#include "cook/scene/whole_steps.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "unpack/rest.h"

namespace marrow::cook {
namespace {

constexpr std::int32_t kLeastExponent = -120, kMostExponent = 120;

}  // namespace

std::int32_t exponent_for(float longest, std::int32_t most) {
  if (!(longest > 0)) return 0;
  const auto bits = static_cast<std::int32_t>(std::bit_width(static_cast<std::uint32_t>(most)));
  std::int32_t exponent = std::max(std::ilogb(longest) + 1 - bits, kLeastExponent);
  if (std::round(std::ldexp(static_cast<double>(longest), -exponent)) > most) ++exponent;
  return std::min(exponent, kMostExponent);
}

float whole_steps(float number, std::int32_t exponent) {
  const double steps = std::ldexp(static_cast<double>(number), -exponent);
  return decode_centre(static_cast<std::int32_t>(std::round(steps)), exponent);
}

}  // namespace marrow::cook
