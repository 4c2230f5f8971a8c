// What unpacking makes of multi-weights and pose space, and what it and load() refuse of them.
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "support/fan.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

using namespace test;

TEST(UnpackDeformers, GivesThemByHand) {
  Unpacked memory;
  File file;
  DataError error;
  ASSERT_EQ(run(packed_deformers(), memory, file, error), Status::ok) << error.rule << " @" << error.offset;
  const Geometry g = file.mesh(0).geometry;
  ASSERT_NE(g.mwe_residual, nullptr);
  EXPECT_EQ(g.mwe_root, 1u);
  // Blocks of 1, then of 2 influences; vertex 3 in lanes 1 to 3 of the second block.
  for (int i = 0; i < 3 * 48; ++i) {
    const int influence = i / 48, element = i % 48 / 4, lane = i % 4;
    const float want = lane == 0                         ? 0.0f
                       : influence == 1 && element == 5  ? 0.5f
                       : influence == 2 && element == 11 ? -0.25f
                                                         : 0.0f;
    EXPECT_EQ(g.mwe_residual[i], want) << i;
  }
  const PoseSpace& space = g.pose_space;
  ASSERT_EQ(space.examples.size, 2u);
  EXPECT_EQ(space.sigma, 0.5f);
  EXPECT_EQ(space.examples[0].block_count, 1u);
  EXPECT_EQ(space.examples[0].position_step, 0.25f);
  EXPECT_EQ(space.examples[1].block_count + space.examples[1].attributes, 0u);
  EXPECT_EQ(static_cast<const std::uint16_t*>(space.blocks)[0], 1);
  const std::int16_t record[] = {0, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0, 0};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(space.records[i], record[i]) << i;
  const std::int16_t rotations[] = {0, 0, 0, 32767, 1000, 0, 0, 32000, -32000, 0, 0, 1000,
                                    0, 0, 0, 32767, 3,    0, 0, 4,     5,      0, 0, 6};
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(space.rotations[i], rotations[i]) << i;
  const std::uint16_t parents[] = {kNoJoint, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(space.parents[i], parents[i]) << i;
  EXPECT_NE(test::exercise(file), 0u);
}

// The plain file that it unpacks to, damaged in every byte: refused, or harmless all the way to the vertices.
TEST(UnpackDeformers, DamagedOnesAreRefusedOrHarmless) {
  Unpacked memory;
  File file;
  DataError error;
  ASSERT_EQ(run(packed_deformers(), memory, file, error), Status::ok);
  std::uint32_t bytes = 0;
  std::memcpy(&bytes, memory->data() + 8, sizeof bytes);
  const test::AlignedBlock whole(memory->data(), bytes);
  std::size_t refused = 0, harmless = 0;
  const auto attempt = [&](test::AlignedBlock& block) {
    const auto stated = static_cast<std::uint32_t>(block.size());
    std::memcpy(block.data() + 8, &stated, sizeof stated);
    test::forge_checksum(block.data(), block.size());
    File out;
    const bool loads = load(block, out) == Status::ok;
    if (loads) test::exercise(out);
    (loads ? harmless : refused) += 1;
  };
  for (std::size_t size = sizeof(format::Header); size < bytes; ++size) {
    test::AlignedBlock prefix(whole.data(), size);
    attempt(prefix);
  }
  EXPECT_EQ(refused, bytes - sizeof(format::Header));
  for (std::size_t i = sizeof(format::Header); i < bytes; ++i) {
    for (const std::byte now : {std::byte{0x00}, std::byte{0x01}, std::byte{0x7F}, std::byte{0x80}, std::byte{0xFF}}) {
      test::AlignedBlock block(whole.data(), bytes);
      block.data()[i] = now;
      attempt(block);
    }
  }
  EXPECT_GT(refused, 1500u);
  EXPECT_GT(harmless, 2000u);
}

// Of the plain file: sigma and a parent at their limits, and one step beyond.
TEST(UnpackDeformers, LoadKnowsTheLimitsOfPoseSpace) {
  Unpacked memory;
  File file;
  DataError error;
  ASSERT_EQ(run(packed_deformers(), memory, file, error), Status::ok);
  std::uint32_t bytes = 0;
  std::memcpy(&bytes, memory->data() + 8, sizeof bytes);
  const Geometry g = file.mesh(0).geometry;
  const auto place_of = [&](const void* p) {
    return static_cast<std::size_t>(static_cast<const std::byte*>(p) - memory->data());
  };
  const std::size_t parent = place_of(g.pose_space.parents),
                    sigma = place_of(g.pose_space.examples.data) - sizeof(format::PoseSpaceHeader) + 8;
  const auto rule_with = [&](std::size_t offset, const auto& now) {
    test::AlignedBlock block(memory->data(), bytes);
    std::memcpy(block.data() + offset, &now, sizeof now);
    test::forge_checksum(block.data(), block.size());
    File out;
    DataError found;
    const Status status = load(block, out, &found);
    EXPECT_EQ(found.offset, status == Status::ok ? 0 : offset);
    return std::string(status == Status::ok ? "" : found.rule);
  };
  EXPECT_EQ(rule_with(parent, static_cast<std::uint16_t>(g.joint_count - 1)), "");
  EXPECT_EQ(rule_with(parent, static_cast<std::uint16_t>(g.joint_count)), "a parent outside the palette");
  EXPECT_EQ(rule_with(parent, kNoJoint), "");
  for (const float good : {1e-3f, 1e3f}) EXPECT_EQ(rule_with(sigma, good), "") << good;
  for (const float bad : {0.000999f, 1000.1f, -1.0f, 0.0f})
    EXPECT_EQ(rule_with(sigma, bad), "sigma from 0.001 to 1000") << bad;
}

TEST(UnpackDeformers, RefusesWhatTheyMustNotBe) {
  const std::vector<std::byte> good = fan_with_deformers();
  struct Case {
    std::size_t offset;
    std::uint32_t now;
    const char* rule;
  };
  const std::size_t weights = 7 + 32, space = weights + 6;
  const Case cases[] = {{6, 0, "a count of examples out of range"},
                        {6, 33, "a count of examples out of range"},
                        {weights, 0, "a stream's bits, origin or step out of range"},
                        {weights, 25, "a stream's bits, origin or step out of range"},
                        {weights + 5, 3, "a root outside the palette, or of nothing"},
                        {space + 3, 0x7F, "sigma from 0.001 to 1000"},
                        {space + 5, 4, "a stream's bits, origin or step out of range"},
                        {space + 7, 17, "a stream's bits, origin or step out of range"},
                        {good.size() - 4 * 15, 16, "a change beyond its bits"},
                        {good.size() - 4 * 16, 16, "a change beyond its bits"}};
  std::size_t refused = 0;
  for (const Case& c : cases) {
    std::vector<std::byte> record = good;
    record[c.offset] = static_cast<std::byte>(c.now);
    Unpacked memory;
    File file;
    DataError error;
    EXPECT_EQ(run(packed_deformers(record), memory, file, error), Status::bad_data) << c.rule;
    EXPECT_STREQ(error.rule, c.rule);
    ++refused;
  }
  EXPECT_EQ(refused, std::size(cases));
}

}  // namespace
}  // namespace marrow
