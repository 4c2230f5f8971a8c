// Writes records of packed files.
#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

// LEB128: seven bits a byte, lowest first.
inline void add_varint(std::uint32_t value, std::vector<std::byte>& out) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<std::byte>(value | 0x80));
  out.push_back(static_cast<std::byte>(value));
}

template <class T>
void add_value(const T& value, std::vector<std::byte>& out) {
  const auto* const first = reinterpret_cast<const std::byte*>(&value);
  out.insert(out.end(), first, first + sizeof value);
}

// A GEOM record: what undoes the quantisation, then the codec's bytes.
std::vector<std::byte> geometry_record(const OwnedStreams& streams, const std::vector<std::byte>& encoded);

}  // namespace marrow::cook
