// Every truncated prefix of a cooked file and every change of one byte: refused, or harmless all the way to the
// vertices.
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "support/golden.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

using test::AlignedBlock;

// Clips raw, coded, additive with channels, in a pack of their own, and with frames at uneven times; looks and nodes; a
// half-joint; levels of detail; limits of joints; springs; roles; a pose map; a graph; a space of example shapes.
class Hostile : public ::testing::TestWithParam<AlignedBlock (*)()> {};
INSTANTIATE_TEST_SUITE_P(Golden, Hostile,
                         ::testing::Values(&test::golden_copy, &test::golden_coded_copy, &test::golden_channels_copy,
                                           &test::golden_pack_copy, &test::golden_looks_copy, &test::golden_uneven_copy,
                                           &test::golden_half_joint_copy, &test::golden_centres_copy,
                                           &test::golden_lod_copy, &test::golden_limits_copy,
                                           &test::golden_springs_copy, &test::golden_roles_copy,
                                           &test::golden_maps_copy, &test::golden_graph_copy,
                                           &test::golden_shapes_copy));

// Each in a block of its own size, so that a sanitizer sees a read past the end.
TEST_P(Hostile, EveryPrefixIsRefused) {
  const AlignedBlock golden = GetParam()();
  std::size_t refused = 0;
  for (std::size_t size = 0; size < golden.size(); ++size) {
    const AlignedBlock prefix(golden.data(), size);
    File file;
    const Status status = load(prefix, file);
    refused += status == Status::truncated;
    ASSERT_EQ(file.mesh_count(), 0u);
  }
  EXPECT_EQ(refused, golden.size());
}

// The same with the size and the checksum made to fit: only the rules of the format stand in the way.
TEST_P(Hostile, EveryForgedPrefixIsRefusedOrHarmless) {
  const AlignedBlock golden = GetParam()();
  std::size_t refused = 0;
  for (std::size_t size = sizeof(format::Header); size < golden.size(); ++size) {
    AlignedBlock prefix(golden.data(), size);
    const auto stated = static_cast<std::uint32_t>(size);
    std::memcpy(prefix.data() + 8, &stated, sizeof stated);
    test::forge_checksum(prefix.data(), size);
    File file;
    if (load(prefix, file) == Status::ok) {
      test::exercise(file);
    } else {
      ++refused;
    }
  }
  EXPECT_EQ(refused, golden.size() - sizeof(format::Header)) << "the last section ends the file, so none can be whole";
}

// Calls check(block) once for each changed byte; returns how many there were.
template <class Check>
std::size_t for_changes(AlignedBlock block, Check check) {
  std::size_t changes = 0;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const std::byte old = block.data()[i];
    for (const std::byte now : {old ^ std::byte{0x01}, old ^ std::byte{0x80}, std::byte{0x00}, std::byte{0xFF}}) {
      if (now == old) continue;
      block.data()[i] = now;
      check(block, i);
      ++changes;
    }
    block.data()[i] = old;
  }
  EXPECT_GT(changes, block.size() * 3);
  return changes;
}

TEST_P(Hostile, EveryChangedByteIsSeen) {
  std::size_t refused = 0;
  const std::size_t changes = for_changes(GetParam()(), [&](const AlignedBlock& block, std::size_t) {
    File file;
    refused += load(block, file) != Status::ok;
  });
  EXPECT_EQ(refused, changes);
}

TEST_P(Hostile, EveryForgedByteIsRefusedOrHarmless) {
  std::size_t refused = 0, harmless = 0;
  std::uint64_t sum = 0;
  for_changes(GetParam()(), [&](AlignedBlock& block, std::size_t i) {
    if (i >= 16 && i < 24) return;  // the checksum itself, which forging would mend
    test::forge_checksum(block.data(), block.size());
    File file;
    DataError error;
    if (load(block, file, &error) == Status::ok) {
      if (file.graph_count() == 0 || harmless % 16 == 0) sum ^= test::exercise(file);  // graphs are played for long
      ++harmless;
    } else {
      EXPECT_LT(error.offset, block.size());
      EXPECT_NE(error.rule[0], 0);
      ++refused;
    }
  });
  // Both happen: names, colours and most low bits of numbers are free; counts, indices and reserved bytes are not.
  // The pack is the shortest and most of it is frames, whose bits are free.
  EXPECT_GT(refused, 700u);
  EXPECT_GT(harmless, 1000u);
  EXPECT_NE(sum, 0u);
  RecordProperty("refused", static_cast<int>(refused));
  RecordProperty("harmless", static_cast<int>(harmless));
}

}  // namespace
}  // namespace marrow
