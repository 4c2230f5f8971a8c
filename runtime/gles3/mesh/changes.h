// Sparse changes of vertices, as morph targets and the examples of a pose space have them.
#pragma once

#include "marrow/file.h"

namespace marrow::gles3 {

// Blocks and records of all targets, one after the other.
struct Changes {
  const void* blocks;
  bool wide;  // blocks of 32 bits
  const std::int16_t* records;

  std::uint32_t block(std::uint32_t i) const {
    return wide ? static_cast<const std::uint32_t*>(blocks)[i] : static_cast<const std::uint16_t*>(blocks)[i];
  }
};

inline std::uint32_t record_count(const MorphTarget& t) {
  return (t.attributes & 1u) + (t.attributes >> 1 & 1u) + (t.attributes >> 2);
}

inline bool moves_lane(const std::int16_t* records, std::uint32_t count, std::uint32_t lane) {
  for (std::uint32_t i = 0; i < 3 * count; ++i)
    if (records[4 * i + lane] != 0) return true;
  return false;
}

// Calls visit(slot, records, lane) for every slot that a target moves, with its block's records.
template <class Visit>
void for_each_moved(const Changes& changes, const MorphTarget& t, const Visit& visit) {
  const std::uint32_t count = record_count(t);
  for (std::uint32_t i = 0; i < t.block_count; ++i) {
    const std::int16_t* const records = changes.records + std::size_t{12} * (t.first_record + std::size_t{i} * count);
    for (std::uint32_t lane = 0; lane < 4; ++lane)
      if (moves_lane(records, count, lane)) visit(4 * changes.block(t.first_block + i) + lane, records, lane);
  }
}

}  // namespace marrow::gles3
