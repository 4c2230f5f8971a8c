#include "cook/gltf/meshopt/meshopt_filters.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace marrow::cook::gltf {
namespace {

// Applies `change` to each element of four numbers.
template <class T, class Change>
void for_each_four(std::span<std::byte> elements, Change change) {
  std::array<T, 4> four;
  for (; elements.size() >= sizeof four; elements = elements.subspan(sizeof four)) {
    std::memcpy(four.data(), elements.data(), sizeof four);
    change(four);
    std::memcpy(elements.data(), four.data(), sizeof four);
  }
}

// A fraction as a normalised integer; 0 for what is no number.
template <class T>
T normalised(double fraction) {
  constexpr double kOne = std::numeric_limits<T>::max();
  constexpr double kLeast = std::is_signed_v<T> ? -1 : 0;
  if (std::isnan(fraction)) return 0;
  return static_cast<T>(std::round(std::clamp(fraction, kLeast, 1.0) * kOne));
}

template <class T>
void unfold_octahedron(std::array<T, 4>& v) {
  const double one = v[2];
  double x = v[0] / one, y = v[1] / one;
  const double z = 1 - std::abs(x) - std::abs(y);
  const double below = std::min(z, 0.0);
  x -= std::copysign(below, x);
  y -= std::copysign(below, y);
  const double length = std::sqrt(x * x + y * y + z * z);
  v[0] = normalised<T>(x / length);
  v[1] = normalised<T>(y / length);
  v[2] = normalised<T>(z / length);
}

void restore_quaternion(std::array<std::int16_t, 4>& v) {
  const unsigned largest = static_cast<std::uint16_t>(v[3]) & 3U;
  const double one = std::sqrt(2.0) * (v[3] | 3);
  const double x = v[0] / one, y = v[1] / one, z = v[2] / one;
  const double w = std::sqrt(std::max(0.0, 1 - x * x - y * y - z * z));
  v[(largest + 1) % 4] = normalised<std::int16_t>(x);
  v[(largest + 2) % 4] = normalised<std::int16_t>(y);
  v[(largest + 3) % 4] = normalised<std::int16_t>(z);
  v[largest] = normalised<std::int16_t>(w);
}

// Luma and two chromas; the highest bit of the fourth number tells how many bits there are.
template <class T>
void restore_colour(std::array<T, 4>& v) {
  const int bits = std::bit_width(v[3]);
  const int whole = (1 << bits) - 1;
  const int luma = v[0], orange = static_cast<std::make_signed_t<T>>(v[1]),
            green = static_cast<std::make_signed_t<T>>(v[2]);
  const int alpha = v[3] & (whole >> 1);
  const double scale = whole == 0 ? 0 : 1.0 / whole;
  v[0] = normalised<T>((luma + orange - green) * scale);
  v[1] = normalised<T>((luma + green) * scale);
  v[2] = normalised<T>((luma - orange - green) * scale);
  v[3] = normalised<T>((alpha << 1 | (alpha & 1)) * scale);
}

}  // namespace

void unfold_octahedra(std::span<std::byte> elements, std::uint32_t stride) {
  if (stride == 4) for_each_four<std::int8_t>(elements, unfold_octahedron<std::int8_t>);
  if (stride == 8) for_each_four<std::int16_t>(elements, unfold_octahedron<std::int16_t>);
}

void restore_quaternions(std::span<std::byte> elements) {
  for_each_four<std::int16_t>(elements, restore_quaternion);
}

void restore_exponents(std::span<std::byte> elements) {
  for (; elements.size() >= 4; elements = elements.subspan(4)) {
    std::int32_t coded;
    std::memcpy(&coded, elements.data(), 4);
    const int exponent = coded >> 24, mantissa = static_cast<std::int32_t>(static_cast<std::uint32_t>(coded) << 8) >> 8;
    const auto number = static_cast<float>(std::ldexp(mantissa, exponent));
    std::memcpy(elements.data(), &number, 4);
  }
}

void restore_colours(std::span<std::byte> elements, std::uint32_t stride) {
  if (stride == 4) for_each_four<std::uint8_t>(elements, restore_colour<std::uint8_t>);
  if (stride == 8) for_each_four<std::uint16_t>(elements, restore_colour<std::uint16_t>);
}

}  // namespace marrow::cook::gltf
