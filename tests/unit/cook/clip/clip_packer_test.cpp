// Coded clips as packed files have them: sections laid out here must come back to the bit, and what is damaged must be
// refused or become something within its bounds.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "cook/write/clip_packer.h"
#include "support/aligned.h"
#include "unpack/clip/clip_record.h"
#include "unpack/records.h"

namespace marrow::cook {
namespace {

using test::AlignedBlock;

constexpr std::uint32_t kPackedJoints = 6, kMaskedTracks = 5;

// A segment after docs/format.md: all tracks' numbers, three columns each, as few bits as they need.
std::vector<std::byte> segment_of(const std::vector<std::array<std::vector<std::int32_t>, 3>>& tracks,
                                  const std::vector<int>& steps, std::size_t frames) {
  std::vector<std::byte> heads;
  std::vector<std::vector<bool>> records(frames);
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    int shift = 0;
    const auto least = [&](std::size_t c) { return *std::min_element(tracks[t][c].begin(), tracks[t][c].end()); };
    for (std::size_t c = 0; c < 3; ++c)
      while (least(c) >> shift < -32768 || least(c) >> shift > 32767) ++shift;
    unsigned widths[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::int32_t from = (least(c) >> shift) * (1 << shift);
      const std::int32_t range = *std::max_element(tracks[t][c].begin(), tracks[t][c].end()) - from;
      const auto bits = static_cast<unsigned>(std::bit_width(static_cast<unsigned>(range)));
      widths[c] = bits > 14 ? 15 : bits;
      for (std::size_t f = 0; f < frames; ++f)
        for (unsigned i = 0; i < (widths[c] == 15 ? 19 : widths[c]); ++i)
          records[f].push_back(((tracks[t][c][f] - from) >> i & 1) != 0);
    }
    heads.push_back(static_cast<std::byte>(static_cast<unsigned>(shift) | widths[0] << 4));
    heads.push_back(static_cast<std::byte>(widths[1] | widths[2] << 4));
    heads.push_back(static_cast<std::byte>(steps[t]));
    for (std::size_t c = 0; c < 3; ++c)
      for (int i = 0; i < 16; i += 8) heads.push_back(static_cast<std::byte>(least(c) >> shift >> i));
  }
  const std::size_t bytes = frames > 0 ? (records[0].size() + 7) / 8 : 0;
  std::vector<std::byte> out(4 + heads.size() + frames * bytes);
  for (std::size_t i = 0; i < 4; ++i) out[i] = static_cast<std::byte>(bytes >> 8 * i);
  std::copy(heads.begin(), heads.end(), out.begin() + 4);
  for (std::size_t f = 0; f < frames; ++f)
    for (std::size_t i = 0; i < records[f].size(); ++i)
      if (records[f][i]) out[4 + heads.size() + f * bytes + i / 8] |= std::byte{1} << (i % 8);
  return out;
}

// A clip of five tracks on six joints, and two constants.
std::vector<std::byte> section_of(std::mt19937& random, std::uint32_t frames, std::uint32_t intervals, int wildness) {
  std::vector<std::byte> out;
  const auto add = [&](const auto& value) {
    const auto* const first = reinterpret_cast<const std::byte*>(&value);
    out.insert(out.end(), first, first + sizeof value);
  };
  const auto below = [&](std::uint32_t n) { return static_cast<std::int32_t>(random() % n); };
  add(format::ClipHeader{1, 0, 1.0f, 0, 0, 0, 0, 0, 0});
  format::CodedHeader h{frames, intervals, 0, 30, kMaskedTracks, 2, 0, 0};
  std::vector<std::byte> payload;
  std::vector<std::uint32_t> offsets;
  for (std::uint32_t first = 0; first + 1 < frames; first += intervals) {
    const std::uint32_t count = std::min(intervals, frames - 1 - first) + 1;
    std::vector<std::array<std::vector<std::int32_t>, 3>> tracks(kMaskedTracks);
    std::vector<int> steps;
    for (auto& track : tracks) {
      // Most tracks have the same step in all segments.
      const auto usual = 90 + static_cast<std::int32_t>(steps.size());
      steps.push_back(wildness > 1 ? below(256) : below(8) > 0 ? usual : 90 + below(8));
      for (auto& column : track) {
        std::int32_t x = wildness > 1 ? below(2000000000) - 1000000000 : below(2000) - 1000, speed = 0;
        const std::int32_t start = x, kind = below(4);
        for (std::uint32_t f = 0; f < count; ++f) {
          column.push_back(x);
          speed += below(3) - 1;
          if (kind == 1) x += speed;
          if (kind == 2) x = start + below(4);
          if (kind == 3) x = start + (wildness > 0 ? below(wildness > 1 ? 1 << 18 : 3000) : f > 5 ? 40 : 0);
        }
      }
    }
    offsets.push_back(static_cast<std::uint32_t>(payload.size()));
    const std::vector<std::byte> segment = segment_of(tracks, steps, count);
    payload.insert(payload.end(), segment.begin(), segment.end());
  }
  payload.insert(payload.end(), 8, std::byte{0});
  h.payload_bytes = static_cast<std::uint32_t>(payload.size());
  add(h);
  for (const std::uint32_t offset : offsets) add(offset);
  add(GroupMasks{0x0013, 0x0008});
  add(GroupMasks{0x0101, 0x0200});
  for (int constant = 0; constant < 2; ++constant) {  // as in the clip before, or near that, or anything
    format::Constant c{{1, 2, 3, 4}};
    const auto range = std::array{0u, 4000u, 65536u}[random() % 3];
    for (std::int16_t& v : c.v) v = static_cast<std::int16_t>(v + (range > 0 ? below(range) - 2000 : 0));
    add(c);
  }
  out.insert(out.end(), payload.begin(), payload.end());
  return out;
}

// The front of a file whose only skeleton has kPackedJoints joints.
std::vector<std::byte> skeleton_file() {
  std::vector<std::byte> out(sizeof(format::Header) + sizeof(File::Section) + sizeof(format::SkeletonHeader));
  const File::Section entry{format::kTypes[format::kSkeletons], 48, sizeof(format::SkeletonHeader), 0};
  const format::SkeletonHeader h{0, kPackedJoints, 1, 0};
  std::memcpy(out.data() + sizeof(format::Header), &entry, sizeof entry);
  std::memcpy(out.data() + 48, &h, sizeof h);
  return out;
}

struct Unpacked {
  const char* rule;
  std::uint32_t bytes = 0, codec = 0;
};

Unpacked unpack(const std::vector<std::byte>& record, bool has_models, AlignedBlock& scratch, AlignedBlock& out) {
  static const std::vector<std::byte> file = skeleton_file();
  Unpacked u{};
  bool with_models = has_models;
  u.rule = unpack_clip({record.data(), record.size()}, {file.data(), 1, 0}, with_models,
                       {scratch.data(), scratch.size()}, {out.data(), out.size()}, u.bytes, u.codec);
  return u;
}

TEST(ClipPacker, GivesBackWhatItGot) {
  std::mt19937 random(7);
  std::size_t coded = 0, plain = 0;
  for (int wildness = 0; wildness < 3; ++wildness) {
    ClipPacker packer;
    std::vector<std::vector<std::byte>> sections, records;
    for (int i = 0; i < 60; ++i) {
      const auto frames = static_cast<std::uint32_t>(2 + random() % 90);
      sections.push_back(section_of(random, frames, 1 + static_cast<std::uint32_t>(random() % 64), wildness));
      records.push_back(packer.pack(sections.back(), format::kCodecSegments, kPackedJoints));
    }
    AlignedBlock scratch(packer.scratch_bytes());
    for (std::size_t i = 0; i < sections.size(); ++i) {
      ClipNeeds needs;
      ASSERT_STREQ(measure_clip_record({records[i].data(), records[i].size()}, needs), nullptr);
      ASSERT_LE(needs.scratch_bytes, scratch.size());
      AlignedBlock out(sections[i].size());
      std::memset(out.data(), 0xCD, out.size());
      const Unpacked u = unpack(records[i], i > 0, scratch, out);
      ASSERT_STREQ(u.rule, nullptr) << wildness << ' ' << i;
      ASSERT_EQ(u.bytes, sections[i].size());
      ASSERT_EQ(u.codec, format::kCodecSegments);
      ASSERT_EQ(std::memcmp(out.data(), sections[i].data(), u.bytes), 0) << wildness << ' ' << i;
      coded += wildness == 0 ? records[i].size() : 0;
      plain += wildness == 0 ? sections[i].size() : 0;
    }
  }
  EXPECT_LT(coded, plain * 3 / 4) << "curves that go on as they did";
}

// Five tracks of forty thousand frames, the most of them in one segment: a step is so many numbers, wherever it stops.
TEST(ClipPacker, LongClipsAreUnpackedInSteps) {
  std::mt19937 random(23);
  ClipPacker packer;
  const std::vector<std::byte> section = section_of(random, 40000, 30000, 0),
                               record = packer.pack(section, format::kCodecSegments, kPackedJoints);
  AlignedBlock scratch(packer.scratch_bytes()), out(section.size());
  std::memset(out.data(), 0xCD, out.size());
  const std::vector<std::byte> file = skeleton_file();
  bool has_models = false, done = false;
  auto work = std::make_unique<ClipInWork>();
  std::uint32_t bytes = 0, codec = 0;
  int steps = 0;
  for (; !done; ++steps) {
    ASSERT_STREQ(unpack_clip({record.data(), record.size()}, {file.data(), 1, 0}, has_models,
                             {scratch.data(), scratch.size()}, *work, {out.data(), out.size()}, bytes, codec, done),
                 nullptr);
    work = std::make_unique<ClipInWork>(*work);  // it may move
  }
  EXPECT_GE(steps, 5) << "six hundred thousand numbers, decoded and written";
  ASSERT_EQ(bytes, section.size());
  EXPECT_EQ(std::memcmp(out.data(), section.data(), bytes), 0);
}

// The record that structure_test reads.
TEST(ClipPacker, WritesTheSymbolsThatTheRuntimesTestsRead) {
  std::vector<std::byte> section;
  const auto add = [&](const auto& value) {
    const auto* const first = reinterpret_cast<const std::byte*>(&value);
    section.insert(section.end(), first, first + sizeof value);
  };
  add(format::ClipHeader{6, 0, 2.0f, 0, 1, 1, 1, 0, 0});
  add(Channel{12, 0.5f, 1, 0, 0, Interpolation::linear, {}});
  for (const float x : {0.25f, 0.75f}) add(x);
  add(format::CodedHeader{3, 1, 0.25f, 1.25f, 1, 1, 2 * 15 + 8, 3});
  for (const float x : {0.25f, 0.5f, 1.85f}) add(x);
  for (const std::uint32_t x : {0u, 15u}) add(x);
  add(GroupMasks{1, 0x20});
  add(format::Constant{{1, 2, 3, 100}});
  const unsigned char payload[38] = {1, 0, 0, 0, 0x10, 0x01, 100, 0, 0, 0, 0, 0, 0, 1, 2,
                                     1, 0, 0, 0, 0x10, 0x01, 101, 0, 0, 0, 0, 0, 0, 2, 1};
  add(payload);
  const std::vector<std::byte> record = ClipPacker().pack(section, format::kCodecSegments, 3);
  const unsigned char symbols[] = {0x37, 0x00, 0x00, 0x00, 0xB5, 0xFC, 0xD3, 0x7D, 0x07, 0xFF, 0xFF, 0xF7,
                                   0xFF, 0xFF, 0x26, 0x25, 0x45, 0x43, 0x07, 0x22, 0x4B, 0x95, 0xBA, 0xF9,
                                   0xD9, 0x0C, 0x5A, 0x5A, 0x0C, 0x45, 0x03, 0x00, 0x67, 0x05, 0x44, 0x53};
  ASSERT_EQ(record.size(), 24 + sizeof symbols);
  EXPECT_EQ(std::memcmp(record.data() + 24, symbols, sizeof symbols), 0);
}

// Constants that are as they were take next to nothing, but no less in the file that is unpacked.
TEST(ClipPacker, ManyConstantsThatAreAsTheyWere) {
  constexpr std::uint32_t kJoints = 3000;
  std::vector<std::byte> section;
  const auto add = [&](const auto& value) {
    const auto* const first = reinterpret_cast<const std::byte*>(&value);
    section.insert(section.end(), first, first + sizeof value);
  };
  add(format::ClipHeader{1, 0, 1.0f, 0, 0, 0, 0, 0, 0});
  add(format::CodedHeader{2, 1, 0, 1, 0, 3 * kJoints, 4 + 8, 0});
  add(0u);
  for (std::uint32_t i = 0; i < kJoints; i += 4) add(GroupMasks{0, 0xFFF});
  for (std::uint32_t i = 0; i < 3 * kJoints; ++i) add(format::Constant{});
  for (int i = 0; i < 3; ++i) add(0u);
  ClipPacker packer;
  packer.pack(section, format::kCodecSegments, kJoints);
  const std::vector<std::byte> clip = packer.pack(section, format::kCodecSegments, kJoints);
  EXPECT_LT(clip.size(), 100u);
  RecordNeeds needs;
  std::vector<std::byte> skeleton = {std::byte{1}, std::byte{(kJoints & 127) | 128}, std::byte{kJoints >> 7},
                                     std::byte{1}};
  ASSERT_STREQ(add_needs({format::kSkeletons, packed::kCompact, {skeleton.data(), skeleton.size()}}, needs), nullptr);
  const std::uint64_t before = needs.most_file_bytes;
  ASSERT_STREQ(add_needs({format::kClips, packed::kCompact, {clip.data(), clip.size()}}, needs), nullptr);
  EXPECT_GE(needs.most_file_bytes - before, section.size());
}

// A clip of nothing but times of keys, which must come back to the bit. Returns how large its record is.
std::size_t bytes_of_times(const std::vector<float>& times_s, float duration_s) {
  const format::ClipHeader h{1, 0, duration_s, 0, static_cast<std::uint32_t>(times_s.size()), 0, 0, 0, 0};
  std::vector<std::byte> section(sizeof h + 4 * times_s.size());
  std::memcpy(section.data(), &h, sizeof h);
  if (!times_s.empty()) std::memcpy(section.data() + sizeof h, times_s.data(), 4 * times_s.size());
  ClipPacker packer;
  const std::vector<std::byte> record = packer.pack(section, format::kCodecRaw, kPackedJoints);
  AlignedBlock scratch(packer.scratch_bytes()), out(section.size());
  ClipNeeds needs;
  EXPECT_STREQ(measure_clip_record({record.data(), record.size()}, needs), nullptr);
  EXPECT_EQ(needs.most_section_bytes, 4 * times_s.size());
  EXPECT_EQ(format::align16(needs.scratch_bytes), format::align16(scratch.size()));
  EXPECT_STREQ(unpack(record, false, scratch, out).rule, nullptr);
  EXPECT_EQ(std::memcmp(out.data(), section.data(), section.size()), 0);
  EXPECT_NE(unpack({record.begin(), record.end() - 1}, false, scratch, out).rule, nullptr);
  return record.size();
}

TEST(ClipPacker, TimesOfKeys) {
  std::mt19937 random(17);
  constexpr std::size_t kTimes = 400;
  std::vector<float> even, thirtieths, milliseconds, summed, chance;
  double at_s = 0, ms = 0;
  float sum = 0;
  for (std::size_t i = 0; i < kTimes; ++i) {
    const auto at = static_cast<double>(i % 200);  // two lists
    even.push_back(static_cast<float>(at / 24));
    at_s += i % 7 == 0 ? 2 : 1;
    thirtieths.push_back(static_cast<float>(at_s / 30));
    ms = std::floor(static_cast<double>(i) * 1000 / 30 + 0.5);
    milliseconds.push_back(static_cast<float>(ms / 1000));
    summed.push_back(sum);
    sum += 1.0f / 30;
    chance.push_back(static_cast<float>(random()) * 0x1p-20f);
  }
  EXPECT_LT(bytes_of_times(even, 9), 50u);
  EXPECT_LT(bytes_of_times(thirtieths, thirtieths.back()), kTimes / 3);
  EXPECT_LT(bytes_of_times(milliseconds, milliseconds.back()), kTimes / 2);
  EXPECT_LT(bytes_of_times(summed, summed.back()), kTimes);
  EXPECT_LT(bytes_of_times(chance, 4096), kTimes * 9 / 2);
  for (const float far : {0.0f, 1e-40f, 1e12f, 16777217.5f}) bytes_of_times({0, far}, far);
  bytes_of_times({}, -0.0f);
}

// Cut short anywhere or longer by a byte: refused. Any byte changed to anything: it ends, and touches only what belongs
// to it, which the sanitizers watch; what it gives has the size that the record's counts say.
TEST(ClipPacker, DamagedRecords) {
  std::mt19937 random(11);
  std::size_t tried = 0, refused = 0;
  for (int wildness = 0; wildness < 3; ++wildness) {
    const std::vector<std::byte> section = section_of(random, 23, 9, wildness);
    ClipPacker packer;
    const std::vector<std::byte> record = packer.pack(section, format::kCodecSegments, kPackedJoints);
    AlignedBlock scratch(packer.scratch_bytes()), out(section.size());
    for (std::size_t size = 0; size < record.size(); ++size)
      ASSERT_NE(unpack({record.begin(), record.begin() + static_cast<std::ptrdiff_t>(size)}, false, scratch, out).rule,
                nullptr)
          << size;
    std::vector<std::byte> longer = record;
    longer.push_back(std::byte{0});
    ASSERT_NE(unpack(longer, false, scratch, out).rule, nullptr);
    for (std::size_t i = 0; i < record.size(); ++i)
      for (unsigned v = 0; v < 256; v += i < 64 ? 1 : 15, ++tried) {
        std::vector<std::byte> changed = record;
        changed[i] = static_cast<std::byte>(v);
        ClipNeeds needs;
        const bool measured = measure_clip_record({changed.data(), changed.size()}, needs) == nullptr;
        const bool fits = measured && needs.scratch_bytes <= scratch.size();
        const Unpacked u = unpack(changed, false, scratch, out);
        refused += u.rule != nullptr ? 1 : 0;
        if (u.rule == nullptr) {
          ASSERT_TRUE(fits) << i;
          ASSERT_LE(u.bytes, out.size());
        }
      }
  }
  EXPECT_GT(refused, tried / 2) << "others change a number; the file's checksum is for them";
}

// Symbols of nothing but chance, behind counts that are right.
TEST(ClipPacker, SymbolsOfChance) {
  std::mt19937 random(13);
  const std::vector<std::byte> section = section_of(random, 40, 13, 0);
  ClipPacker packer;
  std::vector<std::byte> record = packer.pack(section, format::kCodecSegments, kPackedJoints);
  AlignedBlock scratch(packer.scratch_bytes()), out(section.size());
  const std::size_t symbols = record.size() / 4;  // well behind the constants
  for (int round = 0; round < 3000; ++round) {
    for (std::size_t i = symbols; i < record.size(); ++i) record[i] = static_cast<std::byte>(random());
    ASSERT_NE(unpack(record, round % 2 == 1, scratch, out).rule, nullptr) << round;
  }
}

}  // namespace
}  // namespace marrow::cook
