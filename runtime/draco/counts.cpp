#include "draco/counts.h"

#include "core/byte_reader.h"

namespace marrow {

bool draco_claims_more(Span<const std::byte> bytes, std::uint64_t points, std::uint64_t faces) {
  constexpr std::size_t kHeaderSize = 11;  // "DRACO", version, geometry type, method, flags
  constexpr std::uint32_t kMetadata = 0x80, kEdgebreaker = 1;
  if (bytes.size < kHeaderSize + 1) return false;
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(bytes[i]); };
  if (byte(5) != 2 || byte(6) != 2 || (byte(10) & kMetadata) != 0) return false;
  const bool edgebreaker = byte(8) == kEdgebreaker;
  const std::size_t start = edgebreaker ? kHeaderSize + 1 : kHeaderSize;
  ByteReader reader(bytes.data + start, bytes.size - start);
  const std::uint64_t first = reader.take_varint(), second = reader.take_varint();
  // Edgebreaker counts vertices, of which attribute seams make more points.
  return reader.failed() || (edgebreaker ? first : second) > points || (edgebreaker ? second : first) > faces;
}

}  // namespace marrow
