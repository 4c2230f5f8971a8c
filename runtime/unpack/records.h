// The records of a packed file one by one, and what memory they need.
#pragma once

#include "core/byte_reader.h"
#include "unpack/packed.h"

namespace marrow {

// u8 kind, u8 codec, varint bytes.
struct Record {
  std::uint32_t kind = 0;
  std::uint32_t codec = 0;
  Span<const std::byte> bytes;
};

inline Record take_record(ByteReader& reader) {
  Record r;
  r.kind = reader.take<std::uint8_t>();
  r.codec = reader.take<std::uint8_t>();
  r.bytes = reader.take_bytes(reader.take_varint());
  return r;
}

// Of all records together, by what their counts say.
struct RecordNeeds {
  std::uint64_t scratch_bytes = 0;    // exactly: the most that one of them needs
  std::uint64_t most_file_bytes = 0;  // of the unpacked file
  std::uint64_t most_joints = 0;      // of any skeleton so far
};
// Adds a record's. Returns null, or the rule that is broken.
const char* add_needs(const Record& record, RecordNeeds& needs);

}  // namespace marrow
