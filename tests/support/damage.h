// A file with one field changed, the checksum made to fit.
#pragma once

#include <cstring>

#include <gtest/gtest.h>

#include "marrow/file.h"
#include "support/aligned.h"
#include "support/pose_file.h"

namespace marrow::test {

struct DamageReport {
  Status status = Status::ok;
  DataError error;
  std::uint32_t mesh_count = 0;  // that load() left to the caller
};

// What load() makes of the change; `block` is afterwards as it was.
template <class T>
DamageReport load_with(AlignedBlock& block, std::size_t offset, T value) {
  DamageReport out;
  EXPECT_LE(offset + sizeof value, block.size());
  if (offset + sizeof value > block.size()) return out;
  const AlignedBlock before(block.data(), block.size());
  std::memcpy(block.data() + offset, &value, sizeof value);
  forge_checksum(block.data(), block.size());
  File file;
  out.status = load(block, file, &out.error);
  out.mesh_count = file.mesh_count();
  std::memcpy(block.data(), before.data(), block.size());
  return out;
}

}  // namespace marrow::test
