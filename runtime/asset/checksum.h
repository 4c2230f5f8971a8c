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

// Four independent lanes of 64-bit multiply and rotate.
struct Checksum {
  std::uint64_t lanes[4] = {1, 2, 3, 4};
  std::size_t at = 0;

  // Goes on to as many whole 32 bytes as there are before `end`.
  void add(const std::byte* data, std::size_t end) {
    std::uint64_t all[4] = {lanes[0], lanes[1], lanes[2], lanes[3]};
    std::size_t i = at;
    for (; i + 32 <= end; i += 32) {
      std::uint64_t words[4];
      std::memcpy(words, data + i, 32);
      for (int lane = 0; lane < 4; ++lane) all[lane] = mix_checksum(all[lane], words[lane]);
    }
    for (int lane = 0; lane < 4; ++lane) lanes[lane] = all[lane];
    at = i;
  }
  // Of all `bytes`, which may be any number.
  std::uint64_t finish(const std::byte* data, std::size_t bytes) {
    add(data, bytes);
    std::uint64_t tail[4] = {};
    std::memcpy(tail, data + at, bytes - at);
    std::uint64_t sum = bytes;
    for (int lane = 0; lane < 4; ++lane) sum = mix_checksum(mix_checksum(sum, lanes[lane]), tail[lane]);
    return sum ^ sum >> 32;
  }
};
inline std::uint64_t checksum(const std::byte* data, std::size_t bytes) {
  return Checksum().finish(data, bytes);
}

}  // namespace marrow::format
