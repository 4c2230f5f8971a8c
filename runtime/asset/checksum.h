// The checksum of files (docs/format.md): finds damage, not malice.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace marrow::format {
inline constexpr std::uint64_t kChecksumOdd = 0x9E3779B97F4A7C15u;  // 2⁶⁴ / golden ratio

inline std::uint64_t mix_checksum(std::uint64_t state, std::uint64_t word) {
  return std::rotl((state ^ word) * kChecksumOdd, 29);
}

// Four independent lanes of 64-bit multiply and rotate; `bytes` may be any number.
inline std::uint64_t checksum(const std::byte* data, std::size_t bytes) {
  std::uint64_t lanes[4] = {1, 2, 3, 4};
  std::size_t i = 0;
  for (; i + 32 <= bytes; i += 32) {
    std::uint64_t words[4];
    std::memcpy(words, data + i, 32);
    for (int lane = 0; lane < 4; ++lane) lanes[lane] = mix_checksum(lanes[lane], words[lane]);
  }
  std::uint64_t tail[4] = {};
  std::memcpy(tail, data + i, bytes - i);
  std::uint64_t sum = bytes;
  for (int lane = 0; lane < 4; ++lane) sum = mix_checksum(mix_checksum(sum, lanes[lane]), tail[lane]);
  return sum ^ sum >> 32;
}

}  // namespace marrow::format
