// load: what it refuses, with which status, and that it says where.
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/local_to_model.h"
#include "marrow/palette.h"
#include "support/bad_numbers.h"
#include "support/golden.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

using test::AlignedBlock;
using test::kInfinityBits;
using test::kNanBits;

// A golden file with one thing changed at a time.
class Load : public ::testing::Test {
 protected:
  explicit Load(AlignedBlock (*copy)() = &test::golden_copy) : block_(copy()), bytes_(block_.size()) {
    std::memcpy(bytes_.data(), block_.data(), block_.size());
    EXPECT_EQ(load(block_, original_), Status::ok);
    for (const File::Section& s : original_.sections()) sections_.push_back(s);
  }
  template <class T>
  void set(std::size_t offset, T value) {
    ASSERT_LE(offset + sizeof value, block_.size());
    std::memcpy(block_.data() + offset, &value, sizeof value);
  }
  // Offset of the first section of a kind.
  std::size_t at(format::Kind kind) const {
    for (const File::Section& s : sections_)
      if (s.type == format::kTypes[kind]) return s.offset;
    ADD_FAILURE();
    return 0;
  }
  template <class Header>
  Header header(format::Kind kind) {
    Header h;
    std::memcpy(&h, block_.data() + at(kind), sizeof h);
    return h;
  }
  // Loads the block with a right checksum, expects a refusal at `offset`, and mends the block.
  void expect_refused(Status status, std::size_t first, std::size_t last, const char* what) {
    test::forge_checksum(block_.data(), block_.size());
    File out;
    DataError error;
    EXPECT_EQ(load(block_, out, &error), status) << what;
    EXPECT_EQ(error.status, status) << what;
    EXPECT_GE(error.offset, first) << what << ": " << error.rule;
    EXPECT_LE(error.offset, last) << what << ": " << error.rule;
    EXPECT_GT(std::strlen(error.rule), 5u) << what;
    EXPECT_EQ(out.skeleton_count() + out.clip_count() + out.mesh_count(), 0u) << "written only on success";
    std::memcpy(block_.data(), bytes_.data(), block_.size());
    ++refused_;
  }
  template <class T>
  void refuse(std::size_t offset, T value, const char* what) {
    set(offset, value);
    expect_refused(Status::bad_data, 0, block_.size(), what);
  }

  AlignedBlock block_;
  std::vector<std::byte> bytes_;
  File original_;
  std::vector<File::Section> sections_;
  int refused_ = 0;
};

TEST_F(Load, SucceedsAndClearsTheError) {
  File out;
  DataError error{Status::bad_data, 7, "old"};
  ASSERT_EQ(load(block_, out, &error), Status::ok);
  EXPECT_EQ(error.status, Status::ok);
  ASSERT_EQ(load(block_, out), Status::ok) << "an error is optional";
  EXPECT_EQ(out.mesh_count(), 2u);
}

TEST_F(Load, BadCalls) {
  File out;
  EXPECT_EQ(load({}, out), Status::bad_argument);
  for (const std::size_t shift : {1u, 4u, 8u, 15u}) {
    AlignedBlock moved(block_.size() + 16);
    std::memcpy(moved.data() + shift, block_.data(), block_.size());
    EXPECT_EQ(load({moved.data() + shift, block_.size()}, out), Status::bad_argument) << shift;
  }
  EXPECT_EQ(out.mesh_count(), 0u);
}

TEST_F(Load, HeaderOfAnotherKind) {
  set(0, std::uint32_t{0x46546C67});  // "glTF"
  expect_refused(Status::bad_magic, 0, 0, "magic");
  set(4, std::uint32_t{2});
  expect_refused(Status::bad_version, 4, 4, "version");
  set(8, static_cast<std::uint32_t>(block_.size() + 1));
  expect_refused(Status::truncated, 8, 8, "longer than the block");
  set(8, static_cast<std::uint32_t>(block_.size() - 1));
  expect_refused(Status::bad_data, 8, 8, "shorter than the block");
  set(24, std::uint64_t{1});
  expect_refused(Status::bad_data, 24, 24, "reserved");
}

TEST_F(Load, ADamagedByteIsSeen) {
  block_.data()[block_.size() / 2] ^= std::byte{0x10};
  File out;
  DataError error;
  EXPECT_EQ(load(block_, out, &error), Status::bad_checksum);
  EXPECT_EQ(error.offset, 16u);
}

TEST_F(Load, SectionTable) {
  const std::size_t entry = sizeof(format::Header);
  refuse(12, std::uint32_t{0}, "no sections");
  refuse(12, std::uint32_t{0xFFFFFFFF}, "four thousand million sections");
  refuse(12, static_cast<std::uint32_t>(sections_.size() - 1), "a section fewer");
  refuse(entry, format::kTypes[format::kMeshes], "types out of order");
  refuse(entry, std::uint32_t{0}, "an unknown type");
  refuse(entry + 4, sections_[0].offset + 16, "a gap");
  refuse(entry + 4, sections_[0].offset - 16, "an overlap");
  refuse(entry + 8, std::uint32_t{0xFFFFFFF0}, "a section past the end");
  refuse(entry + 8, sections_[0].bytes - 1, "a section too short for its counts");
  set(entry + 12, std::uint32_t{1});
  expect_refused(Status::unsupported, 0, block_.size(), "a codec");
  const std::size_t padding = sections_[0].offset + sections_[0].bytes;
  ASSERT_NE(padding % 16, 0u);
  refuse(padding, std::uint8_t{1}, "padding");
}

TEST_F(Load, Skeletons) {
  const std::size_t base = at(format::kSkeletons);
  const auto h = header<format::SkeletonHeader>(format::kSkeletons);
  const format::SkeletonLayout l = layout(h);
  refuse(base, std::uint32_t{100000}, "name outside the names");
  refuse(base + 4, std::uint32_t{0}, "no joints");
  refuse(base + 4, h.joint_count + 1, "a joint more");
  refuse(base + 4, std::uint32_t{0xFFFFFFFF}, "too many joints");
  refuse(base + 8, std::uint32_t{0}, "no roots");
  refuse(base + 12, std::uint32_t{1}, "reserved");
  refuse(base + l.roots, kNanBits, "a root that is not a number");
  refuse(base + l.rest + 44, kInfinityBits, "a rest pose that is not finite");
  refuse(base + l.names + 4, std::uint32_t{100000}, "a joint's name");
  refuse(base + l.parents, std::uint16_t{0}, "a root with a parent");
  refuse(base + l.parents + 2, std::uint16_t{1}, "its own parent");
  refuse(base + l.parents + 2, std::uint16_t{2}, "a parent behind its child");
  refuse(base + l.parents + 2, kNoJoint, "a root behind the roots");
  EXPECT_EQ(refused_, 13);
}

TEST_F(Load, Clips) {
  const std::size_t base = at(format::kClips);
  const auto h = header<format::ClipHeader>(format::kClips);
  const format::ClipLayout l = layout(h);
  refuse(base + 4, std::uint32_t{1}, "another skeleton");
  refuse(base + 8, kNanBits, "duration");
  refuse(base + 8, -1.0f, "a negative duration");
  refuse(base + 8, 1.0f, "a duration before the last key");
  refuse(base + 12, h.track_count + 1, "a track more");
  refuse(base + 20, std::uint32_t{0x40000000}, "too many values");
  refuse(base + 24, std::uint32_t{1}, "channels that are not there");
  refuse(base + 28, std::uint16_t{2}, "additive is 0 or 1");
  refuse(base + 30, std::uint16_t{1}, "a reference of an ordinary clip");
  const std::size_t track = base + l.tracks;
  refuse(track, std::uint16_t{3}, "a joint outside the skeleton");
  refuse(track + 2, std::uint8_t{3}, "a path");
  refuse(track + 3, std::uint8_t{3}, "an interpolation");
  refuse(track + 4, std::uint32_t{0}, "no keys");
  refuse(track + 4, std::uint32_t{0xFFFFFFFF}, "too many keys");
  refuse(track + 8, std::uint32_t{0xFFFFFFFF}, "times outside");
  refuse(track + 12, std::uint32_t{0xFFFFFFFF}, "values outside");
  refuse(track + 12, h.value_count, "values behind the last");
  refuse(base + l.times, -0.5f, "a negative time");
  refuse(base + l.times + 4, 0.0f, "times that stand still");
  refuse(base + l.times, kNanBits, "a time that is not a number");
  refuse(base + l.values + 4, kInfinityBits, "a value that is not finite");
  EXPECT_EQ(refused_, 21);
}

class LoadChannels : public Load {
 protected:
  LoadChannels() : Load(&test::golden_channels_copy) {}
};

TEST_F(LoadChannels, EveryRule) {
  const std::size_t base = at(format::kClips);
  const auto h = header<format::ClipHeader>(format::kClips);
  const format::ClipLayout l = layout(h);
  ASSERT_EQ(h.channel_count, 7u);
  const std::size_t first = base + l.channels, last = first + 6 * sizeof(Channel);
  refuse(base + 24, std::uint32_t{8}, "a channel more");
  refuse(base + 24, std::uint32_t{0xFFFFFFFF}, "too many channels");
  for (const std::size_t channel : {first, last}) {
    refuse(channel, std::uint32_t{100000}, "a name outside");
    refuse(channel + 4, kNanBits, "a rest that is not a number");
    refuse(channel + 4, kInfinityBits, "a rest that is not finite");
    refuse(channel + 8, std::uint32_t{0}, "no keys");
    refuse(channel + 8, std::uint32_t{0xFFFFFFFF}, "too many keys");
    refuse(channel + 12, std::uint32_t{0xFFFFFFFF}, "times outside");
    refuse(channel + 12, h.time_count - 1, "a list that does not follow");
    refuse(channel + 16, std::uint32_t{0xFFFFFFFF}, "values outside");
    refuse(channel + 16, h.value_count, "values behind the last");
    refuse(channel + 20, std::uint8_t{3}, "an interpolation");
    for (std::size_t i = 21; i < 24; ++i) refuse(channel + i, std::uint8_t{1}, "reserved");
  }
  refuse(base + 8, 1.25f, "a duration before the last key of a channel");
  refuse(base + l.values + 4 * (h.value_count - std::size_t{1}), kInfinityBits, "a value that is not finite");
  refuse(base + l.times + 4 * (h.time_count - std::size_t{1}), 0.0f, "times that stand still");
  ASSERT_EQ(h.additive, 1);
  ASSERT_EQ(h.reference_groups, 1);
  refuse(base + 28, std::uint16_t{0}, "an ordinary clip with a reference");
  refuse(base + 30, std::uint16_t{0}, "a reference that is there");
  refuse(base + 30, std::uint16_t{2}, "a reference of too many joints");
  refuse(base + 30, std::uint16_t{0xFFFF}, "a reference of far too many joints");
  refuse(base + l.reference + 8, kNanBits, "a reference that is not a number");
  EXPECT_EQ(refused_, 2 + 2 * 13 + 3 + 5);
}

class LoadCoded : public Load {
 protected:
  LoadCoded() : Load(&test::golden_coded_copy) {}
};

TEST_F(LoadCoded, Clips) {
  const std::size_t base = at(format::kClips);
  const format::ClipLayout raw = layout(header<format::ClipHeader>(format::kClips));
  format::CodedHeader h;
  std::memcpy(&h, block_.data() + base + raw.bytes, sizeof h);
  const std::uint32_t joints = original_.skeleton(0).joint_count;
  const format::CodedLayout l = layout(h, raw.bytes, joints);
  ASSERT_EQ(joints, 7u);
  ASSERT_EQ(h.constant_count, 3u);
  const std::size_t start = base + l.header;
  refuse(start, std::uint32_t{1}, "one frame");
  refuse(start, h.frame_count - 1, "a frame fewer");
  refuse(start, std::uint32_t{0xFFFFFFFF}, "too many frames");
  refuse(start + 4, std::uint32_t{0}, "no intervals a segment");
  refuse(start + 8, kNanBits, "a start that is not a number");
  refuse(start + 12, 0.0f, "no frames a second");
  refuse(start + 12, kInfinityBits, "frames a second without end");
  refuse(start + 16, h.track_count + 1, "a track more");
  refuse(start + 20, h.constant_count - 1, "a constant fewer");
  refuse(start + 20, std::uint32_t{0xFFFFFFFF}, "too many constants");
  refuse(start + 24, h.payload_bytes - 1, "a payload too short");
  refuse(start + 24, std::uint32_t{0}, "no payload");
  refuse(start + 28, std::uint32_t{1}, "reserved");
  refuse(base + l.offsets, std::uint32_t{4}, "a segment that does not begin the payload");
  GroupMasks last;
  std::memcpy(&last, block_.data() + base + l.masks + sizeof last, sizeof last);
  refuse(base + l.masks + sizeof last, static_cast<std::uint16_t>(last.moving ^ 8), "a joint outside the skeleton");
  refuse(base + l.masks + sizeof last, static_cast<std::uint16_t>(last.moving | last.constant), "both kinds at once");
  refuse(base + l.masks + sizeof last, std::uint16_t{0}, "tracks without a bit");
  refuse(base + l.constants + 6, std::int16_t{256}, "a step of a constant");
  refuse(base + l.constants + 6, std::int16_t{-1}, "a negative step of a constant");
  refuse(base + l.constants + 16, std::uint64_t{0}, "a rotation that is zero");
  refuse(base + l.payload, std::uint32_t{0}, "an empty frame");
  refuse(base + l.payload, std::uint32_t{0xFFFFFFFF}, "a frame too long");
  refuse(base + l.payload + 4, std::uint8_t{0xFF}, "a track too wide");
  EXPECT_EQ(refused_, 23);
}

class LoadUneven : public Load {
 protected:
  LoadUneven() : Load(&test::golden_uneven_copy) {}
};

TEST_F(LoadUneven, Times) {
  const std::size_t base = at(format::kClips);
  const format::ClipLayout raw = layout(header<format::ClipHeader>(format::kClips));
  format::CodedHeader h;
  std::memcpy(&h, block_.data() + base + raw.bytes, sizeof h);
  ASSERT_EQ(h.frame_count, 7u);
  ASSERT_EQ(h.time_count, 7u);
  const std::size_t start = base + raw.bytes, times = start + sizeof h;
  refuse(start + 28, std::uint32_t{6}, "a time fewer");
  refuse(start + 28, std::uint32_t{0}, "no times, but room for them");
  refuse(start + 28, std::uint32_t{0xFFFFFFFF}, "too many times");
  refuse(times, -0.5f, "a first time that is not start_s");
  refuse(times + 8, 0.25f, "a time twice");
  refuse(times + 12, kNanBits, "a time that is not a number");
  refuse(times + 24, kInfinityBits, "no last time");
  EXPECT_EQ(refused_, 7);
}

class LoadPack : public Load {
 protected:
  LoadPack() : Load(&test::golden_pack_copy) {}
};

TEST_F(LoadPack, References) {
  const std::size_t base = at(format::kReferences);
  const auto h = header<format::ReferenceHeader>(format::kReferences);
  const format::ReferenceLayout l = layout(h);
  ASSERT_EQ(h.joint_count, 7u);
  refuse(base, std::uint32_t{100000}, "name");
  refuse(base + 4, std::uint32_t{0}, "no joints");
  refuse(base + 4, h.joint_count - 1, "a joint fewer");
  refuse(base + 4, std::uint32_t{0xFFFFFFFF}, "too many joints");
  refuse(base + l.names + 8, std::uint32_t{100000}, "a joint's name");
  refuse(base + l.parents, std::uint16_t{0}, "no root");
  refuse(base + l.parents + 2 * 3, std::uint16_t{3}, "a joint below itself");
  refuse(base + l.parents + 2 * 3, std::uint16_t{0xFFFF}, "a root behind children");
  refuse(base + l.parents + 2 * 6, std::uint16_t{0}, "not breadth-first");
  refuse(at(format::kClips) + 4, std::uint32_t{1}, "another reference");
  EXPECT_EQ(refused_, 10);
}

TEST_F(Load, Geometries) {
  const std::size_t base = at(format::kGeometries);
  const auto h = header<format::GeometryHeader>(format::kGeometries);
  const format::GeometryLayout l = layout(h);
  refuse(base, h.flags | 512, "an unknown flag");
  refuse(base, h.flags | format::kHasMwe, "a flag whose array is not there");
  refuse(base, h.flags | format::kHasPoseSpace, "a flag whose header is not there");
  refuse(base, h.flags | format::kHasMorphTargets, "a flag whose arrays are not there");
  refuse(base, h.flags ^ format::kHasNormals, "a flag whose array is there");
  refuse(base + 4, h.vertex_count - 1, "a vertex fewer than the runs");
  refuse(base + 8, h.block_count + 1, "a block more");
  refuse(base + 8, std::uint32_t{0xFFFFFFFF}, "too many blocks");
  refuse(base + 12, std::uint32_t{0}, "no influences");
  refuse(base + 16, h.run_count + 1, "a run more");
  refuse(base + 24, std::uint32_t{0}, "no palette");
  refuse(base + 24, std::uint32_t{2}, "a set beyond the palette");
  refuse(base + 28, h.index_count - 1, "not three indices a triangle");
  refuse(base + 36, kNanBits, "a box that is not a number");
  refuse(base + 60, std::uint32_t{1}, "a root of no multi-weights");
  refuse(base + l.skin + 8, kNanBits, "a position that is not a number");
  refuse(base + l.normals + 8, kInfinityBits, "a normal that is not finite");
  refuse(base + l.runs, std::uint32_t{0}, "a run without vertices");
  refuse(base + l.runs, std::uint32_t{0xFFFFFFFF}, "a run with too many vertices");
  refuse(base + l.runs + 4, std::uint32_t{0}, "a run without influences");
  refuse(base + l.runs + 4, std::uint32_t{9}, "a run with nine influences");
  refuse(base + l.source_slots, h.block_count * 4, "a source vertex outside the slots");
  refuse(base + l.indices, static_cast<std::uint16_t>(h.block_count * 4), "an index outside the slots");
  refuse(base + l.sets, std::uint16_t{3}, "a set outside the palette");
  EXPECT_EQ(refused_, 24);
}

TEST_F(Load, Meshes) {
  const std::size_t base = at(format::kMeshes);
  const format::MeshLayout l = layout(header<format::MeshHeader>(format::kMeshes));
  refuse(base, std::uint32_t{100000}, "name");
  refuse(base + 4, std::uint32_t{100000}, "material");
  refuse(base + 8, std::uint32_t{1}, "another skeleton");
  refuse(base + 12, std::uint32_t{2}, "another geometry");
  refuse(base + 12, std::uint32_t{1}, "a geometry with fewer palette entries");
  refuse(base + 16, std::uint32_t{2}, "fewer joints");
  refuse(base + 20, std::uint32_t{2}, "an unknown flag");
  refuse(base + 24, kNanBits, "a colour that is not a number");
  refuse(base + 40, std::uint32_t{1}, "a morph target that the geometry lacks");
  refuse(base + 44, std::uint32_t{1}, "reserved");
  refuse(base + l.inverse_bind, kInfinityBits, "an inverse bind that is not finite");
  refuse(base + l.joints, std::uint16_t{3}, "a joint outside the skeleton");
  EXPECT_EQ(refused_, 12);
}

// What becomes matrices has bounds, so that their products are finite: 1e12, and 1 for rotations.
TEST_F(Load, NumbersOfMatricesBeyondTheirBounds) {
  const std::size_t skeleton = at(format::kSkeletons);
  const format::SkeletonLayout l = layout(header<format::SkeletonHeader>(format::kSkeletons));
  refuse(skeleton + l.roots, 1.01e12f, "what is above a root");
  refuse(skeleton + l.roots + 12, -3e38f, "where that stands");
  refuse(skeleton + l.rest, -1.01e12f, "a translation");
  refuse(skeleton + l.rest + 12 * 4, 1.02f, "a rotation");
  refuse(skeleton + l.rest + 28 * 4, 1.01e12f, "a scale");
  const std::size_t clip = at(format::kClips);
  const format::ClipLayout c = layout(header<format::ClipHeader>(format::kClips));
  const auto track = header<format::ClipHeader>(format::kClips).track_count;
  ASSERT_GT(track, 0u);
  Track first;
  std::memcpy(&first, block_.data() + clip + c.tracks, sizeof first);
  refuse(clip + c.values + 4 * first.first_value, 1.01e12f, "a key");
  refuse(clip + 8, 1.01e12f, "a duration");
  // The last track takes the first one's values for rotations, which are no units.
  Track last;
  const std::size_t last_at = clip + c.tracks + (track - 1) * sizeof last;
  std::memcpy(&last, block_.data() + last_at, sizeof last);
  last.path = TrackPath::rotation;
  last.interpolation = Interpolation::step;
  last.first_value = first.first_value;
  set(clip + c.values + 4 * first.first_value, 7.0f);
  refuse(last_at, last, "a translation as a rotation");
  const std::size_t mesh = at(format::kMeshes);
  const format::MeshLayout m = layout(header<format::MeshHeader>(format::kMeshes));
  refuse(mesh + m.inverse_bind, 1.01e12f, "an inverse bind");
  EXPECT_EQ(refused_, 9);
  // At the bound they load, and the palette is finite.
  set(skeleton + l.roots, 1e12f);
  set(skeleton + l.rest, -1e12f);
  set(skeleton + l.rest + 28 * 4, 1e12f);
  set(mesh + m.inverse_bind, 1e12f);
  test::forge_checksum(block_.data(), block_.size());
  File file;
  ASSERT_EQ(load(block_, file), Status::ok);
  const Skeleton s = file.skeleton(0);
  std::vector<Affine> scene(s.joint_count), palette(file.mesh(0).palette_size());
  ASSERT_EQ(local_to_model(s, {s.rest, s.soa_size()}, scene), Status::ok);
  ASSERT_EQ(build_palette(file.mesh(0), scene, palette), Status::ok);
  for (const Affine& entry : palette)
    for (const auto& row : entry.rows)
      for (const float x : row) EXPECT_TRUE(std::isfinite(x));
}

// Comparing names costs no more than 2047 bytes each. With a section of names of its own, all joints called alike.
TEST_F(Load, NamesThatAreTooLong) {
  const File::Section& names = sections_.back();
  const std::size_t skeleton = at(format::kSkeletons);
  const format::SkeletonLayout l = layout(header<format::SkeletonHeader>(format::kSkeletons));
  for (const std::size_t length : {1024u, 2047u, 2048u, 1000000u}) {
    const std::size_t begin = names.offset + names.bytes;
    AlignedBlock longer(begin + length + 1);
    std::memcpy(longer.data(), bytes_.data(), begin);
    std::memset(longer.data() + begin, 'n', length);
    longer.data()[begin + length] = std::byte{0};
    const std::uint32_t bytes = static_cast<std::uint32_t>(longer.size()),
                        pool = names.bytes + 1 + std::uint32_t(length);
    std::memcpy(longer.data() + 8, &bytes, 4);
    std::memcpy(longer.data() + sizeof(format::Header) + (sections_.size() - 1) * 16 + 8, &pool, 4);
    std::memcpy(longer.data() + skeleton + l.names, &names.bytes, 4);
    test::forge_checksum(longer.data(), longer.size());
    File file;
    DataError error;
    EXPECT_EQ(load(longer, file, &error), length <= 2047 ? Status::ok : Status::bad_data) << length;
    EXPECT_EQ(error.offset, length <= 2047 ? 0 : skeleton + l.names) << error.rule;
  }
}

TEST_F(Load, Names) {
  const std::size_t base = at(format::kNames);
  refuse(base, std::uint8_t{'x'}, "the first name must be empty");
  refuse(block_.size() - 1, std::uint8_t{'x'}, "the last name must end");
  EXPECT_EQ(refused_, 2);
}

}  // namespace
}  // namespace marrow
