// Tracks that stay as keys, channels and their values as packed files have them: what is laid out here must come back
// to the bit, and what is damaged must be refused or become something within its bounds.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "cook/clip/compress/compress_clip.h"
#include "cook/write/clip_packer.h"
#include "cook/write/list_exponents.h"
#include "support/aligned.h"
#include "unpack/clip/clip_record.h"

namespace marrow::cook {
namespace {

using test::AlignedBlock;

constexpr std::uint32_t kListJoints = 6;

struct Lists {
  std::vector<Track> tracks;
  std::vector<Channel> channels;
  std::vector<float> times_s, values;

  std::vector<std::byte> section() const {
    const auto count = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
    const format::ClipHeader h{1, 0, 2.0f, count(tracks), count(times_s), count(values), count(channels), 0, 0};
    std::vector<std::byte> out;
    const auto add = [&](const void* from, std::size_t bytes) {
      const auto* const first = static_cast<const std::byte*>(from);
      out.insert(out.end(), first, first + bytes);
    };
    add(&h, sizeof h);
    add(tracks.data(), tracks.size() * sizeof(Track));
    add(channels.data(), channels.size() * sizeof(Channel));
    add(times_s.data(), times_s.size() * 4);
    add(values.data(), values.size() * 4);
    return out;
  }
};

// Each kind of track once, a channel of each kind, and values that none has.
Lists lists_of(std::mt19937& random, const std::vector<float>& numbers) {
  Lists out;
  for (int k = 0; k < 9; ++k) out.times_s.push_back(static_cast<float>(k) / 8);
  const auto add_values = [&](std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) out.values.push_back(numbers[random() % numbers.size()]);
  };
  for (std::uint16_t joint = 0; joint < kListJoints; ++joint)
    for (const TrackPath path : {TrackPath::translation, TrackPath::rotation, TrackPath::scale}) {
      const auto interpolation = static_cast<Interpolation>(random() % 3);
      const auto keys = static_cast<std::uint32_t>(1 + random() % 9),
                 end = static_cast<std::uint32_t>(out.values.size());
      const bool shares = random() % 8 == 0 && end > 200;
      out.tracks.push_back({joint, path, interpolation, keys, 0, shares ? end / 2 : end});
      if (!shares) add_values(keys * format::floats_per_key(path, interpolation));
    }
  for (std::uint32_t c = 0; c < 5; ++c) {
    const auto interpolation = static_cast<Interpolation>(c % 3);
    out.channels.push_back(
        {c, numbers[c % numbers.size()], 9, 0, static_cast<std::uint32_t>(out.values.size()), interpolation, {}});
    add_values(9 * format::floats_per_key(interpolation));
  }
  add_values(static_cast<std::uint32_t>(random() % 3));
  return out;
}

const char* unpack_record(const std::vector<std::byte>& record, AlignedBlock& scratch, AlignedBlock& out,
                          std::uint32_t& bytes) {
  std::vector<std::byte> file(sizeof(format::Header) + sizeof(File::Section) + sizeof(format::SkeletonHeader));
  const File::Section entry{format::kTypes[format::kSkeletons], 48, sizeof(format::SkeletonHeader), 0};
  const format::SkeletonHeader h{0, kListJoints, 1, 0};
  std::memcpy(file.data() + sizeof(format::Header), &entry, sizeof entry);
  std::memcpy(file.data() + 48, &h, sizeof h);
  bool has_models = false;
  std::uint32_t codec = 0;
  return unpack_clip({record.data(), record.size()}, {file.data(), 1, 0}, has_models, {scratch.data(), scratch.size()},
                     {out.data(), out.size()}, bytes, codec);
}

// Returns how many bytes the record has.
std::size_t expect_back(const Lists& lists) {
  const std::vector<std::byte> section = lists.section();
  ClipPacker packer;
  const std::vector<std::byte> record = packer.pack(section, format::kCodecRaw, kListJoints);
  AlignedBlock scratch(packer.scratch_bytes()), out(section.size());
  std::memset(out.data(), 0xCD, out.size());
  std::uint32_t bytes = 0;
  EXPECT_STREQ(unpack_record(record, scratch, out, bytes), nullptr);
  EXPECT_EQ(bytes, section.size());
  EXPECT_EQ(std::memcmp(out.data(), section.data(), section.size()), 0);
  return record.size();
}

TEST(ListPacker, GivesBackWhatItGot) {
  std::mt19937 random(23);
  const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  std::vector<float> any = {0.0f, -0.0f, 1, -1, most, -most, least, -least, 1e12f, 0x1p-126f, 16777215, -16777216};
  for (int i = 0; i < 40; ++i)
    any.push_back(std::ldexp(static_cast<float>(random()), -static_cast<int>(random() % 60)));
  std::vector<float> halves, fractions;
  for (int i = -50; i < 50; ++i) halves.push_back(static_cast<float>(i) / 2);
  for (int i = -50; i < 50; ++i) fractions.push_back(static_cast<float>(i) / 3);
  std::size_t bytes[3] = {}, floats = 0;
  for (int i = 0; i < 60; ++i) {
    expect_back(lists_of(random, any));
    const Lists even = lists_of(random, halves);
    bytes[0] += expect_back(even);
    bytes[1] += expect_back(lists_of(random, fractions));
    bytes[2] += even.section().size();
    floats += even.values.size();
  }
  EXPECT_LT(bytes[0], floats * 3 / 2) << "a hundred whole numbers: 6.7 bits each, and the tracks";
  EXPECT_LT(bytes[1], bytes[2]);
}

TEST(ListPacker, ExponentsByHand) {
  const float values[] = {0.75f, -3, 0, 6, 0.1f, 1024, 0.5f, 0, -0.0f, 1, 2, 4};
  const auto of = [&](std::uint32_t first, std::uint32_t count) {
    return choose_exponents({first, count, 1, false}, values).values;
  };
  EXPECT_EQ(of(0, 4), -2);
  EXPECT_EQ(of(3, 1), 1);
  EXPECT_EQ(of(2, 1), 0);
  EXPECT_EQ(of(4, 2), ListExponents::kAsBits) << "1024 in steps of 2^-27 is too much";
  EXPECT_EQ(of(7, 3), ListExponents::kAsBits) << "a 0 has no sign as a whole number";
  EXPECT_EQ(of(9, 3), 0);
  const ListExponents spline = choose_exponents({0, 3, 1, true}, values);
  EXPECT_EQ(spline.values, 0) << "3";
  EXPECT_EQ(spline.tangents, -2) << "3/4 and 0";
}

// Cut short, longer, or with any byte changed: it ends and touches only what belongs to it, which the sanitizers watch.
TEST(ListPacker, DamagedRecords) {
  std::mt19937 random(29);
  const std::vector<std::byte> section = lists_of(random, {0, 0.5f, 0.1f, -7}).section();
  ClipPacker packer;
  const std::vector<std::byte> record = packer.pack(section, format::kCodecRaw, kListJoints);
  AlignedBlock scratch(packer.scratch_bytes()), out(section.size());
  std::uint32_t bytes = 0;
  for (std::size_t size = 0; size < record.size(); ++size)
    ASSERT_NE(unpack_record({record.begin(), record.begin() + static_cast<std::ptrdiff_t>(size)}, scratch, out, bytes),
              nullptr);
  std::size_t tried = 0, refused = 0;
  for (std::size_t i = 0; i < record.size(); ++i)
    for (unsigned v = 0; v < 256; v += 5, ++tried) {
      std::vector<std::byte> changed = record;
      changed[i] = static_cast<std::byte>(v);
      if (unpack_record(changed, scratch, out, bytes) != nullptr)
        ++refused;
      else
        ASSERT_LE(bytes, out.size());
    }
  EXPECT_GT(refused, tried / 2);
}

TEST(RoundKeys, ByHand) {
  EXPECT_EQ(rounded_within(0.5, 2.4f), 2.0f);
  EXPECT_EQ(rounded_within(0.4, 2.4f), 2.5f) << "in halves";
  EXPECT_EQ(rounded_within(0.1, -0.7f), -0.75f) << "in eighths";
  EXPECT_EQ(std::signbit(rounded_within(1, -0.1f)), false);
  EXPECT_EQ(rounded_within(0, 0.3f), 0.3f) << "no slack";
  EXPECT_EQ(rounded_within(1e-33, 1e-32f), 1e-32f) << "less than any step";
  const float times_s[] = {0, 0.25f, 1};
  EXPECT_DOUBLE_EQ(tangent_lever(times_s), 0.75 * 8 / 27);
}

// A root and a joint 2 m above it: turns of the root count twice as much as its translations, and its tangents by the
// time between the keys.
TEST(RoundKeys, AsCoarseAsThePromise) {
  BuiltSkeleton skeleton;
  skeleton.rest = {{{}, {{}, {}, {}, {1, 1, 1, 1}}, {{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}}};
  skeleton.rest[0].translation[1][1] = 2;
  skeleton.parents = {kNoJoint, 0};
  skeleton.joint_names = {"root", "top"};
  skeleton.model_from_root = {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  const Rig rig(skeleton);
  Promise promise;
  promise.error = {0.02, 0.02};
  promise.reach = {0, 0};
  promise.points.resize(2);
  BuiltClip clip;
  clip.times_s = {0, 2};
  clip.tracks = {{0, TrackPath::translation, Interpolation::cubic_spline, 2, 0, 0},
                 {0, TrackPath::rotation, Interpolation::linear, 2, 0, 18}};
  std::mt19937 random(31);
  for (int i = 0; i < 26; ++i) clip.values.push_back(static_cast<float>(random()) * 0x1p-32f);
  const BuiltClip rounded = with_rounded_keys(clip, rig, promise, 1);
  // 0.02 / √3 is 0.01155: within it are steps of 2^-6; of tangents with 2 s · 8/27, within 0.01949, of 2^-5.
  bool coarse[2] = {};
  for (std::size_t i = 0; i < 18; ++i) {
    const bool is_tangent = i / 3 % 3 != 1;
    const float step = is_tangent ? 0x1p-5f : 0x1p-6f, number = rounded.values[i] / step;
    EXPECT_EQ(number, std::floor(number)) << i;
    EXPECT_LE(std::fabs(rounded.values[i] - clip.values[i]), step / 2) << i;
    coarse[is_tangent ? 1 : 0] |= std::floor(number / 2) * 2 != number;  // not only whole numbers of twice that
  }
  EXPECT_TRUE(coarse[0] && coarse[1]);
  for (std::size_t i = 18; i < 26; ++i) EXPECT_EQ(rounded.values[i], clip.values[i]) << "must stay a unit quaternion";
}

}  // namespace
}  // namespace marrow::cook
