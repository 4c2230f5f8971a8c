// Vertex data of version 1, written as KHR_meshopt_compression describes it: whatever choices there are, all are taken.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace marrow::cook {

using Octets = std::vector<std::uint8_t>;

// Sixteen deltas by `width` bits; what has all bits set, or more, as a byte behind them.
inline void add_group(const std::array<std::uint8_t, 16>& deltas, unsigned width, Octets& to) {
  if (width == 0) return;
  Octets behind;
  const unsigned most = width == 8 ? 256 : (1U << width) - 1, per_byte = 8 / width;
  for (unsigned i = 0; i < 16; ++i) {
    const unsigned coded = std::min<unsigned>(deltas[i], most), place = i % per_byte;
    if (place == 0) to.push_back(0);
    to.back() |= static_cast<std::uint8_t>(coded << (width == 1 ? place : 8 - width * (place + 1)));
    if (coded == most) behind.push_back(deltas[i]);
  }
  to.insert(to.end(), behind.begin(), behind.end());
}

// A block's deltas of one byte, by control mode 0 or 1. choose(n): one of 0 … n − 1.
inline void add_groups(const Octets& deltas, unsigned control, const std::function<unsigned(unsigned)>& choose,
                       Octets& to) {
  const std::size_t header = to.size(), groups = (deltas.size() + 15) / 16;
  to.resize(header + (groups + 3) / 4);
  for (std::size_t g = 0; g < groups; ++g) {
    std::array<std::uint8_t, 16> group{};
    std::copy(deltas.begin() + static_cast<std::ptrdiff_t>(16 * g),
              deltas.begin() + static_cast<std::ptrdiff_t>(std::min(16 * g + 16, deltas.size())), group.begin());
    const bool are_none = std::ranges::all_of(group, [](std::uint8_t d) { return d == 0; });
    const unsigned mode = control == 0 && !are_none ? 1 + choose(3) : choose(4);
    to[header + g / 4] |= static_cast<std::uint8_t>(mode << 2 * (g % 4));
    add_group(group, control == 0 ? std::array{0U, 1U, 2U, 4U}[mode] : 1U << mode, to);
  }
}

// What turns `before` into `after`, four bytes at a time, by a channel mode.
inline std::array<std::uint8_t, 4> delta_of(const std::uint8_t* before, const std::uint8_t* after, unsigned mode) {
  std::array<std::uint8_t, 4> out{};
  if (mode == 0) {
    for (unsigned b = 0; b < 4; ++b) {
      const unsigned v = (after[b] - 0U - before[b]) & 0xFF;
      out[b] = static_cast<std::uint8_t>((v & 0x80) != 0 ? ~(v << 1) : v << 1);
    }
  } else if (mode == 1) {
    for (unsigned b = 0; b < 4; b += 2) {
      const unsigned v = (after[b] + 256U * after[b + 1] - before[b] - 256U * before[b + 1]) & 0xFFFF;
      const unsigned coded = (v & 0x8000) != 0 ? ~(v << 1) : v << 1;
      out[b] = static_cast<std::uint8_t>(coded);
      out[b + 1] = static_cast<std::uint8_t>(coded >> 8);
    }
  } else {
    std::uint32_t v = 0;
    for (unsigned b = 0; b < 4; ++b) v |= std::uint32_t(before[b] ^ after[b]) << 8 * b;
    const unsigned r = mode >> 4;
    v = v << r | v >> ((32 - r) & 31);
    for (unsigned b = 0; b < 4; ++b) out[b] = static_cast<std::uint8_t>(v >> 8 * b);
  }
  return out;
}

// `modes`: a byte a channel of four bytes. The baseline is no element, as it need not be one.
inline Octets encode_vertices_1(const Octets& elements, std::size_t stride, const Octets& modes,
                                const std::function<unsigned(unsigned)>& choose) {
  Octets before(stride), out = {0xA1};
  for (std::size_t b = 0; b < stride; ++b) before[b] = static_cast<std::uint8_t>(37 * b + 5);
  const Octets baseline = before;
  const std::size_t most = std::min<std::size_t>(8192 / stride & ~std::size_t{15}, 256);
  for (std::size_t at = 0; at < elements.size(); at += most * stride) {
    const std::size_t count = std::min(most, (elements.size() - at) / stride);
    std::vector<Octets> columns(stride);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t* after = elements.data() + at + i * stride;
      for (std::size_t b = 0; b < stride; ++b)
        columns[b].push_back(delta_of(before.data() + b / 4 * 4, after + b / 4 * 4, modes[b / 4])[b % 4]);
      before.assign(after, after + stride);
    }
    const std::size_t controls = out.size();
    out.resize(controls + stride / 4);
    for (std::size_t b = 0; b < stride; ++b) {
      const bool are_none = std::ranges::all_of(columns[b], [](std::uint8_t d) { return d == 0; });
      unsigned control = choose(3);
      if (control == 2) control = are_none ? 2 : 3;
      out[controls + b / 4] |= static_cast<std::uint8_t>(control << 2 * (b % 4));
      if (control < 2) add_groups(columns[b], control, choose, out);
      if (control == 3) out.insert(out.end(), columns[b].begin(), columns[b].end());
    }
  }
  out.resize(out.size() + (stride + modes.size() < 24 ? 24 - stride - modes.size() : 0));
  out.insert(out.end(), baseline.begin(), baseline.end());
  out.insert(out.end(), modes.begin(), modes.end());
  return out;
}

}  // namespace marrow::cook
