// Residuals beside a codec's streams: what unpacking makes of them, and what it refuses.
#include <memory>

#include <gtest/gtest.h>

#include "support/ring.h"
#include "unpack/residual.h"

namespace marrow {
namespace {

using namespace test;

struct Decoded {
  Decoded() : record(ring_record()) {
    GeometryNeeds needs{};
    EXPECT_EQ(measure_geometry_record({record.data(), record.size()}, needs), nullptr);
    scratch = std::make_unique<AlignedBlock>(static_cast<std::size_t>(needs.scratch_bytes));
    Status decoded = Status::ok;
    EXPECT_EQ(decode_geometry({record.data(), record.size()}, kPlainDecoder[0], {scratch->data(), scratch->size()},
                              mesh, decoded),
              nullptr);
  }
  std::vector<std::byte> record;
  Unpacked scratch;
  GeometryInWork mesh{};
};

TEST(ResidualApart, GivesTheWholeNumbersThatWerePacked) {
  const Ring ring;
  Decoded it;
  for (bool done = false; !done;) ASSERT_EQ(finish_streams(it.mesh, done), nullptr);
  const MeshStreams& mesh = it.mesh.streams;
  ASSERT_EQ(mesh.influences, 3u);
  const Stream &joints = *mesh.find(StreamKind::joints), &weights = *mesh.find(StreamKind::weights);
  const Stream* const residual = mesh.find(StreamKind::residual);
  ASSERT_EQ(residual + 3, mesh.streams + mesh.stream_count);
  std::size_t numbers = 0;
  for (std::size_t v = 0; v < ring.vertices.size(); ++v) {
    const RingVertex& want = ring.vertices[v];
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_EQ(joints.values[v * 3 + j], want.joints[std::min(j, want.joints.size() - 1)]) << v << ' ' << j;
      for (std::size_t c = 0; c < 4; ++c) {
        const int number = residual[j].values[v * 4 + c] - (1 << (residual[j].bits - 1));
        EXPECT_EQ(number, j < want.residual.size() ? want.residual[j][c] : 0) << v << ' ' << j << ' ' << c;
        numbers += number != 0 ? 1 : 0;
      }
    }
    for (std::size_t j = 0; j < 2; ++j) {
      int weight = 0;
      for (std::size_t i = 0; i < want.own.size() && j + 1 < want.joints.size(); ++i)
        if (want.joints[j] == want.own[i]) weight = want.weights[i];
      EXPECT_EQ(weights.values[v * 2 + j], weight) << v << ' ' << j;
    }
  }
  EXPECT_GT(numbers, 200u);
}

TEST(ResidualApart, DamagedOnesAreRefusedOrHarmless) {
  const std::vector<std::byte> whole = ring_record();
  ASSERT_EQ(unpack_plain(whole).rule, nullptr);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(unpack_plain({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}).rule, nullptr) << size;
  std::size_t refused = 0, harmless = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const std::byte now : {std::byte{0x00}, std::byte{0x01}, std::byte{0x7F}, std::byte{0x80}, std::byte{0xFF}}) {
      std::vector<std::byte> record = whole;
      record[i] = now;
      (unpack_plain(record).rule != nullptr ? refused : harmless) += 1;
    }
  EXPECT_GT(refused, 1500u);
  EXPECT_GT(harmless, 1500u);
}

TEST(ResidualApart, BitsThatAreMissingOrTooManyAreRefused) {
  const std::vector<std::byte> whole = ring_record();
  const std::size_t length = 2 + 1 + 1 + 3 + 17 + 13 + 1 + 1 + 2 + 8;
  ASSERT_EQ(static_cast<std::size_t>(whole[length]), sizeof kRingBits);
  std::vector<std::byte> none = whole, longer = whole;
  none[length] = std::byte{0};
  none.erase(none.begin() + length + 1, none.begin() + length + 1 + sizeof kRingBits);
  EXPECT_STREQ(unpack_plain(none).rule, "a residual that is none");
  longer[length] = static_cast<std::byte>(sizeof kRingBits + 2);
  longer.insert(longer.begin() + length + 1 + sizeof kRingBits, 2, std::byte{0});
  EXPECT_STREQ(unpack_plain(longer).rule, "a residual of more or fewer bytes");
}

TEST(ResidualApart, RefusesWhatItMustNotBe) {
  struct Case {
    std::size_t offset;
    std::uint32_t now;
    const char* rule;
  };
  constexpr const char* kApart = "a residual apart that none can be";
  constexpr const char* kRange = "a stream's bits, origin or step out of range";
  const std::size_t apart = 7 + 17 + 13 + 1;  // iterations, share, steps
  const Case cases[] = {{0, 0x84, kApart},    // flags, without a residual
                        {5, 1, kApart},       // influences
                        {6, 1, kApart},       // fewer than those
                        {6, 4, "more influences than joints"},
                        {apart + 2, 0x81, kRange},  // more than a whole step
                        {apart + 6, 0x80, kRange},  // negative steps
                        {apart + 10, 0xFF, kRange}};
  for (const Case& c : cases) {
    std::vector<std::byte> record = ring_record();
    record[c.offset] = static_cast<std::byte>(c.now);
    const char* const rule = unpack_plain(record).rule;
    ASSERT_NE(rule, nullptr) << c.offset;
    EXPECT_STREQ(rule, c.rule) << c.offset;
  }
}

// Each vertex of a grid with joints of its own, smoothed until each has spread over all: refused long before.
TEST(ResidualApart, WhatWouldTakeTooLongIsRefused) {
  constexpr int kSide = 48, kCount = kSide * kSide;
  const auto varint = [](Bytes& b, std::uint32_t x) {
    for (; x >= 0x80; x >>= 7) b.u8(x | 0x80);
    b.u8(x);
  };
  Bytes b;
  varint(b, format::kHasAsResidual | packed::kResidualIsApart);
  varint(b, kCount);
  varint(b, 2 * (kSide - 1) * (kSide - 1));
  varint(b, kCount);
  b.u8(2).u8(2).u8(12).f32(0).f32(0).f32(0).f32(1).u8(1);
  varint(b, 1000);
  b.u8(0).u8(0x40).f32(1).f32(1).u8(0);
  for (int y = 0; y + 1 < kSide; ++y)
    for (int x = 0; x + 1 < kSide; ++x) {
      const int a = y * kSide + x;
      b.numbers({a, a + 1, a + kSide, a + 1, a + kSide + 1, a + kSide});
    }
  for (int v = 0; v < kCount; ++v) b.numbers({v % kSide, v / kSide, 0});
  for (int v = 0; v < kCount; ++v) b.numbers({v == kCount - 1 ? v - 1 : v, v == kCount - 1 ? v : v + 1});
  for (int v = 0; v < kCount; ++v) b.numbers({1});
  const char* const rule = unpack_plain(b.all).rule;
  ASSERT_NE(rule, nullptr);
  EXPECT_STREQ(rule, "joints that spread too far to be smoothed");
}

}  // namespace
}  // namespace marrow
