// Compact skeletons, clips, meshes and names written by hand: what unpacking must give, and what it must refuse.
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/aligned.h"
#include "unpack/clip/bounds_record.h"
#include "unpack/clip/clip_record.h"
#include "unpack/structure.h"

namespace marrow {
namespace {

struct RecordBytes {
  std::vector<std::byte> all;
  template <class T>
  RecordBytes& add(T value) {
    const auto* const first = reinterpret_cast<const std::byte*>(&value);
    all.insert(all.end(), first, first + sizeof value);
    return *this;
  }
  RecordBytes& u8(unsigned v) { return add(static_cast<std::uint8_t>(v)); }
  RecordBytes& varint(unsigned v) {
    for (; v > 127; v >>= 7) u8((v & 127) | 128);
    return u8(v);
  }
  RecordBytes& text(const std::string& s) {
    for (const char c : s) u8(static_cast<unsigned char>(c));
    return u8(0);
  }
  Span<const std::byte> span() const { return {all.data(), all.size()}; }
};

Span<const std::byte> span(const std::vector<std::byte>& bytes) {
  return {bytes.data(), bytes.size()};
}

// "", "hips", "hip_l", "hip_r": 1 + 5 + 6 + 6 bytes.
RecordBytes names_record() {
  RecordBytes b;
  b.u8(18).u8(0).text("hips");
  b.u8(3).text("_l");            // "hip" of the one before
  b.u8(1u << 6 | 3).text("_r");  // and of the one before that
  return b;
}

constexpr unsigned kOneChild = 1u << 6, kTwoChildren = 2u << 6;

// A quarter turn about z above two joints, 2.5 along x and 0.125 down z; the last stands for itself, named "hips"
// again.
RecordBytes skeleton_record() {
  RecordBytes b;
  b.u8(0 + 1).u8(3).u8(1);                                               // no name of its own: offset 0, plus one
  b.u8(0);                                                               // nothing above the root
  b.u8(kTwoChildren | packed::kJointRotates).u8(0x90).add(0.70710678f);  // z, and w is what is left
  b.u8(packed::kJointTranslates | packed::kJointTranslates << 2).add(2.5f).add(-0.125f);
  b.u8(packed::kJointScales | packed::kJointNameIsOld).u8(1).u8(0x15).add(2.0f).add(3.0f).add(4.0f);
  return b;
}

// Entry 0 follows joint 1, entry 1 joint 0.
RecordBytes mesh_record(unsigned flags = packed::kMeshIsDoubleSided) {
  RecordBytes b;
  b.varint(flags).u8(6).u8(12).u8(0).u8(0).u8(0).u8(2).u8(0);
  if ((flags & packed::kMeshHasHelpers) != 0) b.u8(1);
  if ((flags & packed::kMeshHasLods) != 0) b.u8(2);
  if ((flags & packed::kMeshHasColour) != 0) b.add(0.25f).add(0.5f).add(0.75f).add(1.0f);
  // 3, 0, 0, 3; 0, 3, 0, 0; 0, 0, 3, 0, two bits each: 2, 0, 0, 5; 0, 2, 0, 0; 0, 0, 2, 0.
  if ((flags & packed::kMeshHasPlace) != 0) b.u8(0xC3).u8(0x0C).u8(0x30).add(2.0f).add(5.0f).add(2.0f).add(2.0f);
  b.u8(2).u8(3);  // one on from 0; two back from 2
  // 1, 0, 0, 3; 0, 1, 0, 3; 0, 0, 2, 3: 1, 0, 0, 7; 0, 1, 0, 8; 0, 0, -1, 9.
  if ((flags & packed::kMeshGivesBinds) != 0) b.u8(2).u8(0xC1).u8(0xC4).u8(0xE0).add(7.0f).add(8.0f).add(9.0f);
  if ((flags & packed::kMeshHasHelpers) != 0) b.u8(1).u8(0);
  if ((flags & packed::kMeshSharesAreBytes) != 0) b.u8(192);
  if ((flags & packed::kMeshHasHelpers) != 0 && (flags & packed::kMeshSharesAreBytes) == 0) b.add(0.5f);
  if ((flags & packed::kMeshHasCentres) != 0) b.u8(0xFD).u8(6).u8(5).u8(0x80).u8(2);  // 3, -3 and 128 eighths
  if ((flags & packed::kMeshHasLods) != 0) b.u8(3).add(0.5f).u8(0xAC).u8(0x02).add(2.0f);
  return b;
}

// Of three joints, one group: the first turns in three frames of a byte, the second stays somewhere else. Two segments
// of one interval each; a key of a channel; the third frame is late. Of the symbols it is known from outside what they
// come to, and that clip_packer_test writes them.
RecordBytes clip_record() {
  RecordBytes b;
  b.u8(packed::kClipIsCoded | packed::kClipHasLists | packed::kClipStartsLater | packed::kClipIsUneven |
       packed::kClipGivesMean);
  b.u8(6).u8(0).u8(20).u8(40);            // 2 s, in twentieths
  b.u8(0).u8(1).u8(1).u8(1).u8(0).u8(0);  // one channel, time and value
  b.u8(3).u8(1).add(1.25f).add(0.25f);
  b.u8(1).u8(1).u8(1);  // one track; a byte a frame in each segment
  // The channel, whose key of 3 quarters is at 0.25; frames at 0.25, 0.5 and 1.85. Joint 0 turns; joint 1 has a
  // translation of its own. By a program apart, from docs/format.md.
  for (const unsigned symbols : {0x37u, 0x00u, 0x00u, 0x00u, 0xB5u, 0xFCu, 0xD3u, 0x7Du, 0x07u, 0xFFu, 0xFFu, 0xF7u,
                                 0xFFu, 0xFFu, 0x26u, 0x25u, 0x45u, 0x43u, 0x07u, 0x22u, 0x4Bu, 0x95u, 0xBAu, 0xF9u,
                                 0xD9u, 0x0Cu, 0x5Au, 0x5Au, 0x0Cu, 0x45u, 0x03u, 0x00u, 0x67u, 0x05u, 0x44u, 0x53u})
    b.u8(symbols);
  return b;
}

// Of two meshes in three clips, the last of which is like the first.
constexpr format::BoundsCodes kBounds[3][2] = {
    {{-5, {-10, 0, -12}, {10, 90, 12}, 60}, {-6, {-8, 100, -9}, {8, 127, -3}, 40}},
    {{-4, {-100, -1, -7}, {-60, 45, 6}, 30}, {-6, {-8, 100, -9}, {8, 127, -3}, 41}},
    {{-5, {-10, 0, -12}, {10, 90, 12}, 60}, {-6, {-8, 101, -9}, {8, 126, -3}, 200}}};

// The symbols are by a program apart, from docs/format.md.
RecordBytes bounds_record() {
  RecordBytes b;
  b.u8(1).u8(3).u8(2);
  for (const unsigned symbols :
       {0xA7u, 0x00u, 0x00u, 0x00u, 0x8Au, 0x52u, 0x0Au, 0x61u, 0x24u, 0x09u, 0xCCu, 0xA2u, 0xBEu, 0xE0u,
        0x6Cu, 0x72u, 0x9Du, 0xEAu, 0x53u, 0x13u, 0xDDu, 0x24u, 0x5Bu, 0xE6u, 0x3Eu, 0x95u, 0x03u, 0xD4u,
        0xA1u, 0x80u, 0x96u, 0x81u, 0x73u, 0x83u, 0xECu, 0xC3u, 0x56u, 0xC8u, 0x1Eu, 0x0Du})
    b.u8(symbols);
  return b;
}

// A file with the skeleton as its only section, and behind it room.
class Structure : public ::testing::Test {
 protected:
  static constexpr std::size_t kSection = 48, kMesh = 512;
  Structure() {
    const File::Section entry{format::kTypes[format::kSkeletons], kSection, 0, 0};
    std::memcpy(file_.data() + sizeof(format::Header), &entry, sizeof entry);
  }
  const char* skeleton(Span<const std::byte> record) {
    const RecordBytes pool = names_record();
    NameReader names(pool.span());
    return unpack_skeleton(record, names, {file_.data() + kSection, kMesh - kSection}, bytes_);
  }
  const char* mesh(Span<const std::byte> record, std::size_t room = 512) {
    return unpack_mesh(record, {file_.data(), 1, 0}, {scratch_.data(), scratch_.size()}, {file_.data() + kMesh, room},
                       bytes_);
  }
  const char* clip(Span<const std::byte> record, std::size_t room = 512) {
    bool has_models = false;
    return unpack_clip(record, {file_.data(), 1, 0}, has_models, {clip_scratch_.data(), clip_scratch_.size()},
                       {file_.data() + kMesh, room}, bytes_, codec_);
  }
  const float* floats(std::size_t offset) const { return reinterpret_cast<const float*>(file_.data() + offset); }

  // Of a clip: models, one track, and two frames and one more.
  test::AlignedBlock file_{1024}, scratch_{3 * sizeof(Affine)}, clip_scratch_{22192 + 112 + 3 * 12};
  std::uint32_t bytes_ = 0, codec_ = 99;
};

TEST_F(Structure, SkeletonByHand) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  const format::SkeletonHeader h{0, 3, 1, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kSection, &h, sizeof h), 0);
  const format::SkeletonLayout l = layout(h);
  EXPECT_EQ(bytes_, l.bytes);
  const float* const root = floats(kSection + l.roots);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(root[i], i % 5 == 0 ? 1.0f : 0.0f) << i;
  const SoaTransform& rest = *reinterpret_cast<const SoaTransform*>(floats(kSection + l.rest));
  const float want[10][4] = {
      {0, 2.5f, 0, 0},        {0, 0, 0, 0},           {0, -0.125f, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0},
      {0.70710678f, 0, 0, 0}, {0.70710678f, 1, 1, 1}, {1, 1, 2, 1},       {1, 1, 3, 1}, {1, 1, 4, 1}};
  for (int i = 0; i < 40; ++i)
    EXPECT_NEAR((&rest.translation[0][0])[i], want[i / 4][i % 4], i / 4 == 5 || i / 4 == 6 ? 1e-7 : 0) << i;
  const std::uint32_t names[] = {1, 6, 1};
  EXPECT_EQ(std::memcmp(file_.data() + kSection + l.names, names, sizeof names), 0);
  const std::uint16_t parents[] = {kNoJoint, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kSection + l.parents, parents, sizeof parents), 0);
}

// (0.5, -0.5, 0.5, -w) with w what is left of 1; a length that no rotation has leaves 0.
TEST_F(Structure, RotationsByHand) {
  const auto rotation = [&](unsigned codes, const std::vector<float>& given) {
    RecordBytes b;
    b.u8(0 + 1).u8(1).u8(1).u8(0).u8(packed::kJointRotates).u8(codes);
    for (const float x : given) b.add(x);
    EXPECT_STREQ(skeleton(b.span()), nullptr);
    const format::SkeletonLayout l = layout(format::SkeletonHeader{0, 1, 1, 0});
    const SoaTransform& rest = *reinterpret_cast<const SoaTransform*>(file_.data() + kSection + l.rest);
    return std::vector<float>{rest.rotation[0][0], rest.rotation[1][0], rest.rotation[2][0], rest.rotation[3][0]};
  };
  EXPECT_EQ(rotation(0b11'01'01'01, {0.5f, -0.5f, 0.5f}), (std::vector<float>{0.5f, -0.5f, 0.5f, -0.5f}));
  EXPECT_EQ(rotation(0b00'00'00'11, {}), (std::vector<float>{-1, 0, 0, 0}));
  EXPECT_EQ(rotation(0b01'01'01'01, {0.5f, 0.5f, 0.5f, 0.25f}), (std::vector<float>{0.5f, 0.5f, 0.5f, 0.25f}));
  EXPECT_EQ(rotation(0b01'00'10'00, {2.0f}), (std::vector<float>{0, 0, 0, 2.0f}));
}

// The floats next to 1 are half a step of 2^-23 below and a whole one above.
TEST_F(Structure, ScalesByHand) {
  RecordBytes b;
  b.u8(0 + 1).u8(1).u8(1).u8(0).u8(packed::kJointScales).u8(0b10'00'10).u8(0xFF).u8(3);
  ASSERT_STREQ(skeleton(b.span()), nullptr);
  const format::SkeletonLayout l = layout(format::SkeletonHeader{0, 1, 1, 0});
  const SoaTransform& rest = *reinterpret_cast<const SoaTransform*>(file_.data() + kSection + l.rest);
  EXPECT_EQ(rest.scale[0][0], 1 - 0x1p-24f);
  EXPECT_EQ(rest.scale[1][0], 1.0f);
  EXPECT_EQ(rest.scale[2][0], 1 + 0x1.8p-22f);
}

TEST_F(Structure, MeshByHand) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  ASSERT_STREQ(mesh(mesh_record().span()), nullptr);
  const format::MeshHeader h{6, 12, 0, 0, 2, format::kDoubleSided, 0, 0, {1, 1, 1, 1}, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  const format::MeshLayout l = layout(h);
  EXPECT_EQ(bytes_, l.bytes);
  const std::uint16_t joints[] = {1, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.joints, joints, sizeof joints), 0);
  // Joint 1 stands at (0, 2.5, -0.125) and is turned as the root: back a quarter turn about z.
  const float want[24] = {0, 1, 0, -2.5f, -1, 0, 0, 0, 0, 0, 1, 0.125f, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0};
  for (std::size_t i = 0; i < 24; ++i) EXPECT_NEAR(floats(kMesh + l.inverse_bind)[i], want[i], 1e-6) << i;
}

TEST_F(Structure, MeshWithAHelper) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  const RecordBytes record = mesh_record(packed::kMeshHasHelpers);
  ASSERT_STREQ(mesh(record.span()), nullptr);
  const format::MeshHeader h{6, 12, 0, 0, 2, 0, 0, 1, {1, 1, 1, 1}, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  const Helper want{1, 0, 0.5f};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + layout(h).helpers, &want, sizeof want), 0);
  EXPECT_EQ(bytes_, layout(h).bytes);
  ASSERT_STRNE(mesh({record.span().data, record.span().size - 1}), nullptr);
}

TEST_F(Structure, MeshWithAHelperAboutACentre) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  const RecordBytes record = mesh_record(packed::kMeshHasHelpers | packed::kMeshSharesAreBytes |
                                         packed::kMeshHasCentres | packed::kMeshHasLods);
  ASSERT_STREQ(mesh(record.span()), nullptr);
  const format::MeshHeader h{6, 12, 0, 0, 2, format::kHelpersHaveCentres, 2, 1, {1, 1, 1, 1}, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  const Helper want{1, 0, 0.75f};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + layout(h).helpers, &want, sizeof want), 0);
  const float centre[] = {0.375f, -0.375f, 16};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + layout(h).centres, centre, sizeof centre), 0);
  const MeshLod lods[] = {{3, 0.5f}, {300, 2}};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + layout(h).lods, lods, sizeof lods), 0);
  EXPECT_EQ(bytes_, layout(h).bytes);
  for (std::size_t less = 1; less < 20; ++less)
    ASSERT_STRNE(mesh({record.span().data, record.span().size - less}), nullptr) << less;
}

TEST_F(Structure, MeshWithLevels) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  const RecordBytes record = mesh_record(packed::kMeshHasLods);
  ASSERT_STREQ(mesh(record.span()), nullptr);
  const format::MeshHeader h{6, 12, 0, 0, 2, 0, 2, 0, {1, 1, 1, 1}, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  const MeshLod want[] = {{3, 0.5f}, {300, 2}};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + layout(h).lods, want, sizeof want), 0);
  EXPECT_EQ(bytes_, layout(h).bytes);
  ASSERT_STRNE(mesh({record.span().data, record.span().size - 1}), nullptr);
}

TEST_F(Structure, MeshThatStandsElsewhere) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  ASSERT_STREQ(mesh(mesh_record(packed::kMeshHasColour | packed::kMeshHasPlace | packed::kMeshGivesBinds).span()),
               nullptr);
  const format::MeshHeader h{6, 12, 0, 0, 2, 0, 0, 0, {0.25f, 0.5f, 0.75f, 1}, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  // Twice as large and 5 along x, which the quarter turn back makes -y; the second is given.
  const float want[24] = {0, 2, 0, -2.5f, -2, 0, 0, -5, 0, 0, 2, 0.125f, 1, 0, 0, 7, 0, 1, 0, 8, 0, 0, -1, 9};
  for (std::size_t i = 0; i < 24; ++i) EXPECT_NEAR(floats(kMesh + layout(h).inverse_bind)[i], want[i], 2e-6) << i;
}

TEST_F(Structure, ClipByHand) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  ASSERT_STREQ(clip(clip_record().span()), nullptr);
  EXPECT_EQ(codec_, format::kCodecSegments);
  const format::ClipHeader h{6, 0, 2.0f, 0, 1, 1, 1, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  const std::uint64_t start = layout(h).bytes;
  ASSERT_EQ(start, 32u + 24 + 4 + 4);
  EXPECT_EQ(floats(kMesh + 56)[0], 0.25f);
  EXPECT_EQ(floats(kMesh + 56)[1], 0.75f);
  const format::CodedHeader c{3, 1, 0.25f, 1.25f, 1, 1, 2 * 15 + 8, 3};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + start, &c, sizeof c), 0);
  const format::CodedLayout l = layout(c, start, 3);
  EXPECT_EQ(bytes_, l.bytes);
  const float times_s[] = {0.25f, 0.5f, 1.85f};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.times, times_s, sizeof times_s), 0);
  const std::uint32_t offsets[] = {0, 15};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.offsets, offsets, sizeof offsets), 0);
  const GroupMasks masks{1, 0x20};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.masks, &masks, sizeof masks), 0);
  const format::Constant constant{{1, 2, 3, 100}};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.constants, &constant, sizeof constant), 0);
  // Its x and y have a bit each, its z none.
  const unsigned char payload[38] = {1, 0, 0, 0, 0x10, 0x01, 100, 0, 0, 0, 0, 0, 0, 1, 2,
                                     1, 0, 0, 0, 0x10, 0x01, 101, 0, 0, 0, 0, 0, 0, 2, 1};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.payload, payload, sizeof payload), 0);
}

// A spline of two keys, a rotation that stays, whose numbers are whole ones of nothing coarser than their bits, a scale
// that has the spline's values, and a channel, all in the same list of times; behind them a value that none has.
TEST_F(Structure, ListsByHand) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  RecordBytes record;
  record.u8(packed::kClipHasLists).u8(6).u8(0).u8(30).u8(30);
  record.u8(3).u8(1).u8(2).u8(25).u8(0).u8(0);
  // By a program apart, from docs/format.md.
  for (const unsigned symbols :
       {0x28u, 0x0Du, 0x00u, 0x00u, 0xCCu, 0xFFu, 0x1Au, 0xD6u, 0x00u, 0x80u, 0x00u, 0x0Cu, 0x83u, 0xC7u, 0x8Fu, 0xD7u,
        0x93u, 0xACu, 0xA1u, 0x43u, 0xFFu, 0x33u, 0xEBu, 0x9Bu, 0x6Cu, 0xF0u, 0xAFu, 0x91u, 0xD1u, 0x3Fu, 0x20u, 0x40u,
        0x00u, 0x00u, 0x17u, 0xFAu, 0xD7u, 0xACu, 0x6Bu, 0x62u, 0x3Eu, 0x3Eu, 0x5Au, 0xA5u, 0x2Au, 0x3Du, 0x5Cu, 0xDBu,
        0x10u, 0x01u, 0xE6u, 0x82u, 0x20u, 0xFAu, 0x7Fu, 0x80u, 0x99u, 0x19u, 0x0Eu, 0xBFu, 0x99u, 0x99u, 0x30u, 0xDFu,
        0x66u, 0xFAu, 0x99u, 0x59u, 0x16u, 0x7Du, 0x31u, 0xCCu, 0xA8u, 0xFDu, 0xBEu, 0x57u, 0xC7u, 0x56u, 0x75u, 0x7Du})
    record.u8(symbols);
  ASSERT_STREQ(clip(record.span()), nullptr);
  EXPECT_EQ(codec_, format::kCodecRaw);
  const format::ClipHeader h{6, 0, 1.0f, 3, 2, 25, 1, 0, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  const format::ClipLayout l = layout(h);
  EXPECT_EQ(bytes_, l.bytes);
  const Track tracks[] = {{1, TrackPath::translation, Interpolation::cubic_spline, 2, 0, 0},
                          {2, TrackPath::rotation, Interpolation::step, 1, 0, 18},
                          {2, TrackPath::scale, Interpolation::linear, 6, 0, 0}};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.tracks, tracks, sizeof tracks), 0);
  const Channel channel{7, -1.0f, 2, 0, 22, Interpolation::linear, {}};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.channels, &channel, sizeof channel), 0);
  const float times_s[] = {0, 1}, values[] = {0,    0,       0,      1,           -1.015625f, 0.046875f, 1, -1, 0.125f,
                                              1,    -1.125f, 0.125f, 1.09375f,    -1.015625f, 0.046875f, 0, 0,  0,
                                              0.1f, 0.2f,    0.3f,   0.92736185f, -6,         10,        1};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.times, times_s, sizeof times_s), 0);
  EXPECT_EQ(std::memcmp(file_.data() + kMesh + l.values, values, sizeof values), 0);
}

// No lists and nothing coded: a header. Its duration as it is, or in thirds.
TEST_F(Structure, ClipOfNothing) {
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  ASSERT_STREQ(clip(RecordBytes().u8(0).u8(6).u8(0).u8(3).u8(4).span()), nullptr);
  EXPECT_EQ(floats(kMesh + 8)[0], 1.3333334f);
  ASSERT_STREQ(
      clip(RecordBytes().u8(packed::kClipIsAdditive | packed::kClipGivesDuration).u8(6).u8(0).u8(3).add(1.5f).span()),
      nullptr);
  const format::ClipHeader h{6, 0, 1.5f, 0, 0, 0, 0, 1, 0};
  EXPECT_EQ(std::memcmp(file_.data() + kMesh, &h, sizeof h), 0);
  EXPECT_EQ(bytes_, 32u);
  EXPECT_EQ(codec_, format::kCodecRaw);
}

TEST(Bounds, ByHand) {
  test::AlignedBlock out(12 + sizeof kBounds);
  std::uint32_t bytes = 0;
  ASSERT_STREQ(unpack_bounds(bounds_record().span(), {out.data(), out.size()}, bytes), nullptr);
  EXPECT_EQ(bytes, out.size());
  EXPECT_EQ(measure_bounds_record(bounds_record().span()), out.size());
  const std::uint32_t header[] = {1, 3, 2};
  EXPECT_EQ(std::memcmp(out.data(), header, sizeof header), 0);
  EXPECT_EQ(std::memcmp(out.data() + sizeof header, kBounds, sizeof kBounds), 0);
  EXPECT_STREQ(unpack_bounds(bounds_record().span(), {out.data(), out.size() - 1}, bytes), "file_bytes too small");
}

// Cut short anywhere, or longer by a byte: refused. Any byte changed to anything: nothing but what belongs to it is
// touched, which the sanitizers watch.
TEST(Bounds, Damaged) {
  const std::vector<std::byte> whole = bounds_record().all;
  const auto run = [&](const std::vector<std::byte>& record) {
    test::AlignedBlock out(12 + sizeof kBounds);
    std::uint32_t bytes = 0;
    return unpack_bounds(span(record), {out.data(), out.size()}, bytes);
  };
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(run({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), nullptr) << size;
  std::vector<std::byte> changed = whole;
  changed.push_back(std::byte{0});
  EXPECT_NE(run(changed), nullptr);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (unsigned v = 0; v < 256; ++v) {
      changed = whole;
      changed[i] = static_cast<std::byte>(v);
      refused += run(changed) != nullptr;
    }
  EXPECT_GT(refused, 200 * whole.size());
  changed = RecordBytes().varint(0).varint(0xFFFFFFFF).varint(0x80000000).all;
  EXPECT_EQ(measure_bounds_record(span(changed)), 0u) << "more than a file holds";
  EXPECT_NE(run(changed), nullptr);
  // Billions of clips of nothing, which would go on for minutes.
  for (const auto& [clips, meshes] : {std::pair(0xFFFFFFFFu, 0u), std::pair(0u, 0xFFFFFFFFu), std::pair(0u, 0u)}) {
    changed = RecordBytes().varint(0).varint(clips).varint(meshes).all;
    EXPECT_EQ(measure_bounds_record(span(changed)), 0u);
    EXPECT_NE(run(changed), nullptr);
  }
}

TEST(Names, ByHand) {
  const RecordBytes record = names_record();
  test::AlignedBlock pool(18);
  std::uint32_t bytes = 0;
  ASSERT_STREQ(unpack_names(record.span(), {pool.data(), pool.size()}, bytes), nullptr);
  EXPECT_EQ(bytes, 18u);
  const char want[] = "\0hips\0hip_l\0hip_r";
  static_assert(sizeof want == 18);
  EXPECT_EQ(std::memcmp(pool.data(), want, sizeof want), 0);
}

TEST(Names, Refused) {
  test::AlignedBlock pool(64);
  const auto refused = [&](const RecordBytes& record) {
    std::uint32_t bytes = 0;
    return unpack_names(record.span(), {pool.data(), pool.size()}, bytes) != nullptr;
  };
  EXPECT_TRUE(refused(RecordBytes())) << "nothing";
  EXPECT_TRUE(refused(RecordBytes().u8(0))) << "not even the empty name";
  EXPECT_TRUE(refused(RecordBytes().u8(65).u8(0).text(std::string(62, 'a')))) << "more than there is room for";
  EXPECT_TRUE(refused(RecordBytes().u8(6).u8(1).text("abc"))) << "shares with a name that is not there";
  EXPECT_TRUE(refused(RecordBytes().u8(9).u8(0).text("ab").u8(3).text("c"))) << "shares more than a name has";
  EXPECT_TRUE(refused(RecordBytes().u8(4).u8(0).text("abc"))) << "pool too small";
  EXPECT_TRUE(refused(RecordBytes().u8(6).u8(0).text("abc"))) << "pool not filled";
  EXPECT_FALSE(refused(RecordBytes().u8(5).u8(0).text("abc")));
}

TEST_F(Structure, Refused) {
  struct Case {
    const char* what;
    std::size_t byte;
    unsigned now;
  };
  const Case skeletons[] = {{"no joints", 1, 0},
                            {"no roots", 2, 0},
                            {"more roots than joints", 2, 4},
                            {"joints without a parent", 4, kOneChild | packed::kJointRotates},
                            {"more children than joints", 4, 3u << 6 | packed::kJointRotates}};
  for (const Case& c : skeletons) {
    RecordBytes record = skeleton_record();
    record.all[c.byte] = static_cast<std::byte>(c.now);
    EXPECT_NE(skeleton(record.span()), nullptr) << c.what;
  }
  ASSERT_STREQ(skeleton(skeleton_record().span()), nullptr);
  const Case meshes[] = {{"unknown flags", 0, 16},
                         {"no such skeleton", 4, 1},
                         {"a joint behind the last", 8, 6},
                         {"a joint before the first", 8, 1},
                         {"more joints than bytes", 6, 3}};
  for (const Case& c : meshes) {
    RecordBytes record = mesh_record();
    record.all[c.byte] = static_cast<std::byte>(c.now);
    EXPECT_NE(mesh(record.span()), nullptr) << c.what;
  }
  // At byte 11 the frames begin.
  const Case clips[] = {{"unknown flags", 0, 128},
                        {"no such skeleton", 2, 1},
                        {"one frame", 11, 1},
                        {"no intervals", 12, 0},
                        {"more tracks than in the masks", 21, 2},
                        {"more bytes a frame than tracks have bits for", 23, 2},
                        {"fewer", 23, 0},
                        {"more symbols than tracks", 24, 0},
                        {"more channels than room", 6, 100}};
  ASSERT_STREQ(clip(clip_record().span()), nullptr);
  for (const Case& c : clips) {
    RecordBytes record = clip_record();
    record.all[c.byte] = static_cast<std::byte>(c.now);
    EXPECT_NE(clip(record.span()), nullptr) << c.what;
  }
  EXPECT_STREQ(clip(clip_record().span(), 165), "file_bytes too small");
  EXPECT_STREQ(clip(clip_record().span(), 63), "file_bytes too small");
  bool has_models = false;
  EXPECT_STREQ(
      unpack_clip(clip_record().span(), {file_.data(), 1, 0}, has_models,
                  {clip_scratch_.data(), clip_scratch_.size() - 1}, {file_.data() + kMesh, 512}, bytes_, codec_),
      "memory_bytes too small");
  EXPECT_STREQ(mesh(mesh_record().span(), 147), "file_bytes too small");
  EXPECT_STREQ(unpack_mesh(mesh_record().span(), {file_.data(), 1, 0}, {scratch_.data(), 2 * sizeof(Affine)},
                           {file_.data() + kMesh, 512}, bytes_),
               "memory_bytes too small");
}

// Shorter by any number of bytes, or one byte longer: refused. Any byte changed to anything:
// nothing but what belongs to it is touched, which the sanitizers watch.
TEST_F(Structure, Damaged) {
  const std::vector<std::byte> whole[] = {
      mesh_record(packed::kMeshHasColour | packed::kMeshHasPlace | packed::kMeshGivesBinds).all, clip_record().all,
      skeleton_record().all};
  const auto run = [&](std::size_t kind, const std::vector<std::byte>& bytes) {
    return kind == 0 ? mesh(span(bytes)) : kind == 1 ? clip(span(bytes)) : skeleton(span(bytes));
  };
  ASSERT_STREQ(skeleton(span(whole[2])), nullptr);
  std::size_t refused = 0, tried = 0, bytes = 0;
  for (std::size_t kind = 0; kind < 3; ++kind) {
    bytes += whole[kind].size();
    for (std::size_t size = 0; size < whole[kind].size(); ++size)
      refused += run(kind, {whole[kind].begin(), whole[kind].begin() + static_cast<std::ptrdiff_t>(size)}) != nullptr;
    std::vector<std::byte> longer = whole[kind];
    longer.push_back(std::byte{0});
    EXPECT_NE(run(kind, longer), nullptr);
    ASSERT_STREQ(run(2, whole[2]), nullptr);
  }
  EXPECT_EQ(refused, bytes);
  for (std::size_t kind = 0; kind < 3; ++kind)
    for (std::size_t i = 0; i < whole[kind].size(); ++i)
      for (unsigned v = 0; v < 256; ++v, ++tried) {
        std::vector<std::byte> changed = whole[kind];
        changed[i] = static_cast<std::byte>(v);
        (void)run(kind, changed);
      }
  EXPECT_EQ(tried, 256 * bytes);
}

}  // namespace
}  // namespace marrow
