// What compilers spell differently, and what some libraries lack: bits of numbers, roots, signs.
#pragma once

#include <cstdint>

#if defined(_MSC_VER) && !defined(__clang__)
#include <math.h>
#endif

namespace marrow {

// std::bit_cast, which libraries of compilers that have it may not.
template <class To, class From>
constexpr To bit_cast(const From& from) {
  return __builtin_bit_cast(To, from);
}

inline constexpr float kInfinity = bit_cast<float>(std::uint32_t{0x7F800000u});

inline bool has_sign(float x) {
  return bit_cast<std::uint32_t>(x) >> 31 != 0;
}

#if defined(_MSC_VER) && !defined(__clang__)
inline float square_root(float x) {
  return ::sqrtf(x);
}
inline double square_root(double x) {
  return ::sqrt(x);
}
inline float without_sign(float x) {
  return ::fabsf(x);
}
#else
inline float square_root(float x) {
  return __builtin_sqrtf(x);
}
inline double square_root(double x) {
  return __builtin_sqrt(x);
}
inline float without_sign(float x) {
  return __builtin_fabsf(x);
}
#endif

}  // namespace marrow
