// What owns its memory is what the calls make of memory that the caller brings.
#include "marrow/owned.h"

#include <cstring>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "support/aligned.h"
#include "support/golden.h"

namespace marrow {
namespace {

static_assert(!std::is_copy_constructible_v<OwnedFile> && std::is_nothrow_move_constructible_v<OwnedFile>);
static_assert(!std::is_copy_constructible_v<OwnedCharacter> && std::is_nothrow_move_constructible_v<OwnedCharacter>);

// Bytes that begin anywhere.
std::vector<std::byte> off_boundary(const test::AlignedBlock& block) {
  std::vector<std::byte> out(block.size() + 1);
  std::memcpy(out.data() + 1, block.data(), block.size());
  return out;
}

TEST(Owned, IsWhatTheCallsMake) {
  const test::AlignedBlock block = test::golden_coded_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  test::AlignedBlock shared(animations_bytes(file, file)), own(character_bytes(file, {}));
  Animations animations;
  Character wanted;
  ASSERT_EQ(make_animations(file, file, shared, animations), Status::ok);
  ASSERT_EQ(make_character(file, {}, own, wanted), Status::ok);

  const std::vector<std::byte> bytes = off_boundary(block);
  OwnedFile owned;
  ASSERT_EQ(make_owned({bytes.data() + 1, block.size()}, owned), Status::ok);
  OwnedCharacter made;
  ASSERT_EQ(make_owned(owned, {.layers = 3}, made), Status::ok);
  EXPECT_EQ(made.skeletons[0].caches.size, 3u);
  const OwnedFile kept = std::move(owned);
  OwnedCharacter character = std::move(made);
  ASSERT_EQ(kept.animations.all.size, animations.all.size);
  ASSERT_GT(animations.all.size, 0u);
  for (std::size_t a = 0; a < animations.all.size; ++a) {
    ASSERT_EQ(pose_character(wanted, {{&animations.all[a], 0.3f}}), Status::ok);
    ASSERT_EQ(pose_character(character, {{&kept.animations.all[a], 0.3f}}), Status::ok);
    const Span<Affine> ours = character.skeletons[0].pose.model_from_joint,
                       theirs = wanted.skeletons[0].pose.model_from_joint;
    ASSERT_EQ(ours.size, theirs.size);
    EXPECT_EQ(std::memcmp(ours.data, theirs.data, ours.size * sizeof(Affine)), 0);
  }
}

TEST(Owned, SaysWhatIsWrong) {
  const test::AlignedBlock block = test::golden_coded_copy();
  std::vector<char> bytes(block.size());
  std::memcpy(bytes.data(), block.data(), block.size());
  bytes[bytes.size() - 1] ^= 1;
  OwnedFile owned;
  EXPECT_EQ(make_owned(bytes, owned), Status::bad_checksum);
  EXPECT_EQ(owned.error.status, Status::bad_checksum);
  EXPECT_EQ(make_owned(Span<const char>(), owned), Status::truncated);
  EXPECT_EQ(owned.skeleton_count(), 0u);
}

TEST(OwnedDeathTest, MustEndsTheProgram) {
  must(Status::ok);
  EXPECT_EXIT(must(Status::truncated), testing::ExitedWithCode(EXIT_FAILURE), "marrow: truncated");
}

}  // namespace
}  // namespace marrow
