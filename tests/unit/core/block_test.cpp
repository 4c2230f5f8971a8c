// Blocks on 16-byte boundaries out of memory that stands anywhere.
#include <vector>

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "support/call_errors.h"

namespace marrow {
namespace {

TEST(Block, EnoughWhereverMemoryBegins) {
  alignas(16) std::byte memory[64 + 32];
  int cases = 0;
  for (std::size_t size : {std::size_t{1}, std::size_t{16}, std::size_t{33}, std::size_t{48}}) {
    for (std::size_t first = 0; first < 16; ++first, ++cases) {
      const Span<std::byte> given{memory + first, block_bytes(size)};
      const Span<std::byte> block = block_in(given);
      EXPECT_TRUE(is_on_boundary(block.data));
      EXPECT_GE(block.size, size);
      EXPECT_LT(block.data - given.data, 16);
      EXPECT_EQ(block.end(), given.end());
    }
  }
  EXPECT_EQ(cases, 64);
}

TEST(Block, NoneInMemoryTooShort) {
  alignas(16) std::byte memory[32];
  EXPECT_TRUE(block_in({}).empty());
  EXPECT_TRUE(block_in({memory + 1, 15}).empty());
  EXPECT_EQ(block_in({memory + 1, 16}).size, 1u);
  EXPECT_EQ(block_in(memory).size, 32u);
  EXPECT_FALSE(is_on_boundary(memory + 8));
}

// An asset that is mapped out of an archive begins where the archive has it: the message says how far that is off.
TEST(Block, HowFarBehindABoundaryIsSaid) {
  test::CallErrors errors;
  alignas(16) static std::byte memory[64] = {};
  File file;
  for (std::size_t behind = 1; behind < 16; ++behind) {
    DataError error;
    ASSERT_EQ(load({memory + behind, 48}, file, &error), Status::bad_argument);
    const std::vector<test::CallError> heard = errors.take();
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].function, "load");
    const std::string said = "memory begins " + std::to_string(behind) + " bytes behind a boundary of 16 bytes";
    EXPECT_EQ(heard[0].condition.substr(0, said.size()), said);
    EXPECT_EQ(error.rule, heard[0].condition);
  }
  DataError error;
  EXPECT_EQ(load({}, file, &error), Status::bad_argument);
  EXPECT_STREQ(error.rule, "a block that is not null");
  EXPECT_EQ(load(memory, file, &error), Status::bad_magic) << "on a boundary it is read";
}

TEST(Joint, ReadAndSetInItsLaneAlone) {
  std::vector<SoaTransform> pose(2);
  for (std::uint32_t j = 0; j < 8; ++j) {
    const float x = static_cast<float>(j);
    const JointTransform to = {.translation = {x, x + 0.25f, x + 0.5f}, .rotation = {0, 0, x, 1}, .scale = {x, 1, 2}};
    ASSERT_EQ(set_joint(pose, j, to), Status::ok);
  }
  EXPECT_EQ(pose[1].translation[1][2], 6.25f);
  EXPECT_EQ(pose[1].rotation[2][3], 7.0f);
  EXPECT_EQ(pose[0].rotation[3][1], 1.0f);
  EXPECT_EQ(pose[0].scale[2][0], 2.0f);
  JointTransform five;
  ASSERT_EQ(get_joint(pose, 5, five), Status::ok);
  EXPECT_EQ(five.translation[0], 5.0f);
  EXPECT_EQ(five.translation[2], 5.5f);
  EXPECT_EQ(five.rotation[2], 5.0f);
  EXPECT_EQ(five.scale[0], 5.0f);
  EXPECT_EQ(get_joint(pose, 8, five), Status::bad_argument);
  EXPECT_EQ(set_joint(pose, 8, five), Status::bad_argument);
  EXPECT_EQ(five.translation[0], 5.0f);
}

}  // namespace
}  // namespace marrow
