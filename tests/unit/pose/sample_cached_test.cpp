// sample_cached: the bits of sample(), whatever the cache was used for before; and that it unpacks a frame once.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "pose/sample_state.h"
#include "pose/unpack_frames.h"
#include "support/golden.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

// A coded clip, and a pose and memory for it.
struct Player {
  explicit Player(const test::AlignedBlock& block) {
    File file;
    EXPECT_EQ(load({block.data(), block.size()}, file), Status::ok);
    skeleton = file.skeleton(0);
    clip = file.clip(0);
    out.resize(skeleton.soa_size());
    frames.resize((sample_cache_bytes(clip) + sizeof(SoaTransform) - 1) / sizeof(SoaTransform));
  }
  Span<std::byte> memory() {
    return {reinterpret_cast<std::byte*>(frames.data()), frames.size() * sizeof(SoaTransform)};
  }
  // Whether the cached call at `time_s` gives what sample() does.
  bool is_same(float time_s, SampleCache& cache) {
    std::vector<SoaTransform> whole(out.size());
    EXPECT_EQ(sample(skeleton, clip, time_s, whole), Status::ok);
    EXPECT_EQ(sample_cached(skeleton, clip, time_s, out, cache), Status::ok);
    return std::memcmp(whole.data(), out.data(), out.size() * sizeof(SoaTransform)) == 0;
  }

  Skeleton skeleton;
  Clip clip;
  std::vector<SoaTransform> out, frames;
};

const float kTimes_s[] = {0, 0.01f, 0.02f, 0.5f, 0.49f, 0.02f, 9, 9, -1, 0.26f, 0.27f, 0.28f, 0.29f, 0.3f, 0.31f};

TEST(SampleCached, HasTheBitsOfSample) {
  const test::AlignedBlock even = test::golden_coded_copy(), uneven = test::golden_uneven_copy();
  for (const test::AlignedBlock* const block : {&even, &uneven}) {
    Player player(*block);
    ASSERT_GE(player.clip.coded.frame_count, 4u);
    ASSERT_GT(sample_cache_bytes(player.clip), 0u);
    SampleCache whole = {player.memory()}, none, little = {player.memory()};
    little.memory.size = 16;
    for (SampleCache* cache : {&whole, &none, &little})
      for (const float time_s : kTimes_s) EXPECT_TRUE(player.is_same(time_s, *cache)) << time_s;
  }
}

TEST(SampleCached, UnpacksAFrameOnce) {
  const test::AlignedBlock block = test::golden_coded_copy();
  Player player(block);
  SampleCache cache = {player.memory()};
  const auto between = [&](std::uint32_t frame, float share) {
    return player.clip.coded.time_of(frame) + share / player.clip.coded.frames_per_s;
  };
  std::vector<SoaTransform> whole(player.out.size());
  ASSERT_EQ(sample(player.skeleton, player.clip, between(1, 0.75f), whole), Status::ok);
  EXPECT_TRUE(player.is_same(between(1, 0.25f), cache));
  // Were it unpacked again, it would be of other numbers.
  std::byte* const payload = const_cast<std::byte*>(player.clip.coded.payload);
  for (std::size_t i = 16; i < 64; ++i) payload[i] ^= std::byte{0xFF};
  ASSERT_EQ(sample_cached(player.skeleton, player.clip, between(1, 0.75f), player.out, cache), Status::ok);
  EXPECT_EQ(std::memcmp(whole.data(), player.out.data(), whole.size() * sizeof(SoaTransform)), 0);
  EXPECT_TRUE(player.is_same(between(0, 0.25f), cache));  // another frame is
}

// Nor is a frame unpacked again that was the later of two, and is the earlier now.
TEST(SampleCached, UnpacksTheLaterFrameAlone) {
  for (const std::uint32_t frame : {1u, 2u}) {
    const test::AlignedBlock block = test::golden_coded_copy();
    Player player(block);
    const CodedTracks& coded = player.clip.coded;
    SampleCache cache = {player.memory()};
    const float time_s = coded.time_of(frame) + 0.25f / coded.frames_per_s;
    std::vector<SoaTransform> whole(player.out.size()), changed(player.out.size());
    ASSERT_EQ(sample(player.skeleton, player.clip, time_s, whole), Status::ok);
    EXPECT_TRUE(player.is_same(coded.time_of(frame) - 0.25f / coded.frames_per_s, cache));
    const TrackCursor first(coded.payload, coded.track_count, frame);
    for (std::size_t i = 0; i < first.frame_bytes; ++i) const_cast<std::byte*>(first.record)[i] ^= std::byte{0xFF};
    ASSERT_EQ(sample(player.skeleton, player.clip, time_s, changed), Status::ok);
    EXPECT_NE(std::memcmp(whole.data(), changed.data(), whole.size() * sizeof(SoaTransform)), 0);
    ASSERT_EQ(sample_cached(player.skeleton, player.clip, time_s, player.out, cache), Status::ok);
    EXPECT_EQ(std::memcmp(whole.data(), player.out.data(), whole.size() * sizeof(SoaTransform)), 0) << frame;
  }
}

// Makes frames of a clip like the ones before them: bit k of `pattern` says whether interval k, modulo 8, rests.
void make_rest(const Clip& clip, std::uint32_t pattern) {
  const CodedTracks& coded = clip.coded;
  for (std::uint32_t i = 0; i + 1 < coded.frame_count; ++i) {
    if ((pattern >> i % 8 & 1u) == 0) continue;
    const std::uint32_t segment = i / coded.segment_intervals, in_segment = i % coded.segment_intervals;
    const TrackCursor first(coded.payload + coded.segment_offsets[segment], coded.track_count, in_segment);
    std::memcpy(const_cast<std::byte*>(first.record) + first.frame_bytes, first.record, first.frame_bytes);
  }
}

// Plays a clip on, three times between any two frames, then leaves out every other frame; compares with sample().
// Returns how often.
std::size_t play_through(Player& player, std::uint32_t pattern) {
  const CodedTracks& coded = player.clip.coded;
  make_rest(player.clip, pattern);
  std::size_t out = 0;
  for (const std::uint32_t step : {1u, 2u}) {
    SampleCache cache = {player.memory()};
    for (std::uint32_t i = 0; i + 1 < coded.frame_count; i += step) {
      const float from_s = coded.time_of(i), to_s = coded.time_of(i + 1);
      for (const float share : {0.25f, 0.5f, 0.75f}) {
        EXPECT_TRUE(player.is_same(from_s + (to_s - from_s) * share, cache)) << pattern << ' ' << i << ' ' << share;
        ++out;
      }
    }
  }
  return out;
}

// What rests is left as it stands while a clip plays on, and only then: not where it has moved since.
TEST(SampleCached, LeavesWhatRestsAsItStands) {
  std::size_t compared = 0;
  for (std::uint32_t pattern = 0; pattern < 256; ++pattern) {
    const test::AlignedBlock even = test::golden_coded_copy(), uneven = test::golden_uneven_copy();
    for (const test::AlignedBlock* const block : {&even, &uneven}) {
      Player player(*block);
      compared += play_through(player, pattern);
    }
  }
  EXPECT_GT(compared, 2000u);
}

// The second segment has the first one's integers with steps twice as large: what is alike in both rests elsewhere.
TEST(SampleCached, MovesWhatRestsFromSegmentToSegment) {
  const test::AlignedBlock block = test::golden_coded_copy();
  Player player(block);
  CodedTracks& coded = player.clip.coded;
  ASSERT_EQ(coded.segment_intervals, coded.frame_count - 1) << "one segment";
  const TrackCursor whole(coded.payload, coded.track_count, coded.frame_count);
  const auto bytes = static_cast<std::uint32_t>(whole.record - coded.payload);
  std::vector<std::byte> payload(2 * bytes + 8);
  std::memcpy(payload.data(), coded.payload, bytes);
  std::memcpy(payload.data() + bytes, coded.payload, bytes);
  for (std::uint32_t t = 0; t < coded.track_count; ++t) {
    std::byte& step = payload[bytes + 4 + t * sizeof(format::TrackHeader) + offsetof(format::TrackHeader, step)];
    step = std::byte(std::to_integer<int>(step) + 4);
  }
  const std::uint32_t offsets[] = {0, bytes};
  coded.frame_count = 2 * coded.segment_intervals + 1;
  coded.payload = payload.data();
  coded.segment_offsets = offsets;
  EXPECT_GT(play_through(player, 255), 10u);
}

// Two frames alike give the first one's bits at any time between them; a blend would round as the time says.
TEST(SampleCached, FramesThatAreAlikeAreNotBlended) {
  const test::AlignedBlock block = test::golden_coded_copy();
  Player player(block);
  make_rest(player.clip, 255);
  const CodedTracks& coded = player.clip.coded;
  const auto at = [&](float share) {
    std::vector<SoaTransform> out(player.out.size());
    EXPECT_EQ(sample(player.skeleton, player.clip, coded.time_of(0) + share / coded.frames_per_s, out), Status::ok);
    return out;
  };
  const std::vector<SoaTransform> first = at(0);
  for (const float share : {0.1f, 0.3f, 0.7f, 0.9f}) {
    const std::vector<SoaTransform> later = at(share);
    for (std::size_t g = 0; g < first.size(); ++g)
      EXPECT_EQ(std::memcmp(first[g].rotation, later[g].rotation, sizeof first[g].rotation), 0) << share << ' ' << g;
  }
}

// Each time the pose holds another's bits, which the cache may not take for its own.
TEST(SampleCached, NoticesWhatIsAnother) {
  test::AlignedBlock block = test::golden_coded_copy();
  const test::AlignedBlock uneven = test::golden_uneven_copy();
  Player player(block);
  SampleCache cache = {player.memory()};
  EXPECT_TRUE(player.is_same(0.3f, cache));

  player.out = std::vector<SoaTransform>(player.out.size() + 1);  // another pose
  player.out.pop_back();
  EXPECT_TRUE(player.is_same(0.3f, cache));

  cache.memory = {};  // the memory is gone, and then there is another
  EXPECT_TRUE(player.is_same(0.3f, cache));
  std::vector<SoaTransform> frames(player.frames.size());
  cache.memory = {reinterpret_cast<std::byte*>(frames.data()), frames.size() * sizeof(SoaTransform)};
  EXPECT_TRUE(player.is_same(0.31f, cache));

  // Another clip in the same place, as after a pack was taken out of memory and another one read there.
  ASSERT_GE(block.size(), uneven.size());
  std::memcpy(block.data(), uneven.data(), uneven.size());
  File file;
  ASSERT_EQ(load({block.data(), uneven.size()}, file), Status::ok);
  player.skeleton = file.skeleton(0);
  player.clip = file.clip(0);
  player.out.resize(player.skeleton.soa_size());
  EXPECT_TRUE(player.is_same(0.31f, cache));
}

// The same file with another constant, read to the same place: as after a clip was cooked again.
TEST(SampleCached, NoticesAFileThatDiffersInOneNumber) {
  test::AlignedBlock block = test::golden_coded_copy();
  Player player(block);
  ASSERT_GT(player.clip.coded.constant_count, 1u);
  SampleCache cache = {player.memory()};
  EXPECT_TRUE(player.is_same(0.3f, cache));
  const std::uint64_t id = player.clip.id;
  const std::ptrdiff_t last = player.clip.coded.constants - block.data() + 8 * (player.clip.coded.constant_count - 1);
  block.data()[last + 1] ^= std::byte{1};
  test::forge_checksum(block.data(), block.size());
  Player changed(block);
  player.clip = changed.clip;
  EXPECT_NE(player.clip.id, id);
  EXPECT_TRUE(player.is_same(0.3f, cache));
}

// Keys as they are, which lie at the same place in each of two packs; in the second another joint stands still.
TEST(SampleCached, NoticesAnotherClipOfPlainKeys) {
  std::vector<SoaTransform> rest(1), other_rest(1), out(1), whole(1);
  for (int i = 0; i < 4; ++i) rest[0].rotation[3][i] = other_rest[0].rotation[3][i] = 1;
  other_rest[0].translation[0][2] = 5;
  const float times_s[] = {0, 1}, values[] = {1, 2, 3, 4, 5, 6};
  Track track;
  track.path = TrackPath::translation;
  track.interpolation = Interpolation::linear;
  track.key_count = 2;
  Skeleton skeleton;
  skeleton.joint_count = 4;
  skeleton.rest = rest.data();
  Clip clip;
  clip.joint_count = 4;
  clip.tracks = {&track, 1};
  clip.times_s = times_s;
  clip.values = values;
  clip.id = 7;
  SampleCache cache;
  const auto is_same = [&] {
    EXPECT_EQ(sample(skeleton, clip, 0.5f, whole), Status::ok);
    EXPECT_EQ(sample_cached(skeleton, clip, 0.5f, out, cache), Status::ok);
    return std::memcmp(whole.data(), out.data(), sizeof(SoaTransform)) == 0;
  };
  EXPECT_TRUE(is_same());
  track.joint = 1;  // as if another file stood there
  clip.id = 9;
  EXPECT_TRUE(is_same());
  skeleton.rest = other_rest.data();
  EXPECT_TRUE(is_same());
}

// Memory stays whole even if two files were made to have one id.
TEST(SampleCached, WritesNoFurtherThanItsMemory) {
  const test::AlignedBlock block = test::golden_coded_copy();
  Player player(block);
  const std::size_t bytes = sample_cache_bytes(player.clip);
  ASSERT_GE(bytes, 2 * sizeof(SoaTransform));
  std::vector<GroupMasks> few(player.clip.coded.masks, player.clip.coded.masks + player.out.size());
  for (std::size_t g = 1; g < few.size(); ++g) few[g].moving = 0;
  const GroupMasks* const all = player.clip.coded.masks;
  few[0].moving &= 15;
  ASSERT_NE(few[0].moving, 0);
  player.frames.assign(1, SoaTransform{});  // room for one pair; what stands behind it must stay
  player.frames.resize(4, player.skeleton.rest[0]);
  SampleCache cache = {player.memory()};
  cache.memory.size = sizeof(SoaTransform);
  player.clip.coded.masks = few.data();
  EXPECT_TRUE(player.is_same(0.3f, cache));
  EXPECT_EQ(state_of(cache).room, 1u);
  player.clip.coded.masks = all;
  EXPECT_EQ(sample_cached(player.skeleton, player.clip, 0.3f, player.out, cache), Status::ok);
  EXPECT_EQ(sample_cached(player.skeleton, player.clip, 9, player.out, cache), Status::ok);
  for (std::size_t i = 1; i < player.frames.size(); ++i)
    EXPECT_EQ(std::memcmp(&player.frames[i], player.skeleton.rest, sizeof(SoaTransform)), 0) << i;
}

}  // namespace
}  // namespace marrow
