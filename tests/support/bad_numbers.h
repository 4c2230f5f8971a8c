// Numbers that no file and no call may bring in.
#pragma once

#include <cstdint>
#include <limits>

namespace marrow::test {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
// As a file holds them: of 32 bits, and of a double.
inline constexpr std::uint32_t kNanBits = 0x7FC00000, kInfinityBits = 0x7F800000;
inline constexpr std::uint64_t kInfinityBits64 = 0x7FF0000000000000;

}  // namespace marrow::test
