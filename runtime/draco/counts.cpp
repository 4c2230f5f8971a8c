#include "draco/counts.h"

#include <cstring>

#include "core/byte_reader.h"

namespace marrow {
namespace {

void skip_name(ByteReader& reader) {
  reader.take_bytes(reader.take<std::uint8_t>());
}

// A tree of entries. Branches that are still to come are counted and not nested: so deep a file takes no more stack.
void skip_metadata(ByteReader& reader) {
  std::uint64_t to_come = 1;
  for (bool is_root = true; to_come > 0 && !reader.failed(); is_root = false) {
    if (!is_root) skip_name(reader);
    for (std::uint32_t entries = reader.take_varint(); entries > 0 && !reader.failed(); --entries) {
      skip_name(reader);
      reader.take_bytes(reader.take_varint());
    }
    to_come += reader.take_varint();
    --to_come;
  }
}

}  // namespace

Status draco_counts(Span<const std::byte> bytes, DracoCounts& out) {
  if (bytes.size < 5 || std::memcmp(bytes.data, "DRACO", 5) != 0) return Status::bad_magic;
  ByteReader reader(bytes.data + 5, bytes.size - 5);
  const auto major = reader.take<std::uint8_t>(), minor = reader.take<std::uint8_t>();
  reader.take<std::uint8_t>();  // points or triangles
  const auto method = reader.take<std::uint8_t>();
  const bool has_metadata = (reader.take<std::uint16_t>() & 0x8000) != 0;
  if (reader.failed()) return Status::truncated;
  if (major != 2 || minor != 2) return Status::unsupported;
  if (method > 1) return Status::bad_data;
  const bool edgebreaker = method == 1;
  if (has_metadata) {
    for (std::uint32_t attributes = reader.take_varint(); attributes > 0 && !reader.failed(); --attributes) {
      reader.take_varint();  // its id
      skip_metadata(reader);
    }
    skip_metadata(reader);
  }
  if (edgebreaker) reader.take<std::uint8_t>();  // how connectivity is traversed
  const std::uint64_t first = reader.take_varint(), second = reader.take_varint();
  const std::uint32_t seams = edgebreaker ? reader.take<std::uint8_t>() : 0u;
  if (reader.failed()) return Status::truncated;
  out = edgebreaker ? DracoCounts{first, second, seams, true} : DracoCounts{second, first, 0, false};
  return Status::ok;
}

}  // namespace marrow
