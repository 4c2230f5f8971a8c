// Joints and weights beside Draco's streams: what is packed comes back, bits written by hand are read as
// docs/format.md says, and damaged ones are refused or harmless.
#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "cook/geometry/encode_streams.h"
#include "draco/decode_skin.h"
#include "draco/skin_codec.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

using cook::OwnedStreams;

struct Followed {
  std::vector<int> joints, weights;  // ascending; all weights
};

OwnedStreams mesh_of(const std::vector<std::array<int, 3>>& positions, const std::vector<std::uint32_t>& indices,
                     const std::vector<Followed>& skin, std::uint32_t influences, std::uint32_t bits,
                     std::uint32_t joint_count) {
  OwnedStreams out;
  out.mesh.vertex_count = static_cast<std::uint32_t>(positions.size());
  out.mesh.triangle_count = static_cast<std::uint32_t>(indices.size() / 3);
  out.mesh.joint_count = joint_count;
  out.mesh.influences = influences;
  out.indices = indices;
  out.add(StreamKind::position, 3, 14);
  out.add(StreamKind::joints, influences, 15);
  if (influences > 1) out.add(StreamKind::weights, influences - 1, bits);
  for (auto& values : out.values) values.clear();
  for (std::size_t v = 0; v < positions.size(); ++v) {
    out.values[0].insert(out.values[0].end(), positions[v].begin(), positions[v].end());
    for (std::size_t j = 0; j < influences; ++j) {
      out.values[1].push_back(skin[v].joints[std::min(j, skin[v].joints.size() - 1)]);
      if (j + 1 < influences) out.values[2].push_back(j + 1 < skin[v].joints.size() ? skin[v].weights[j] : 0);
    }
  }
  return out;
}

// A sheet whose weights change slowly, with seams, where vertices stand twice, and a vertex that no triangle names.
OwnedStreams sheet(Random& random, std::uint32_t influences, std::uint32_t bits, std::uint32_t joint_count) {
  constexpr std::uint32_t kSide = 14;
  const int one = (1 << bits) - 1;
  std::vector<std::array<int, 3>> positions;
  std::vector<std::uint32_t> indices;
  std::vector<Followed> skin;
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const bool on_seam = x == 6 || x == 7;
      positions.push_back({static_cast<int>(on_seam ? 6 : x) * 100, static_cast<int>(y) * 100, 7});
      if (x == 7) {
        skin.push_back(skin.back());
        if (y % 5 != 0) continue;
        skin.pop_back();
      }
      Followed at;
      std::vector<int> parts;
      const std::uint32_t count = std::min(1 + random.below(influences), joint_count);
      while (at.joints.size() < count) {
        const int joint = static_cast<int>((x / 3 + random.below(influences + 1)) * 7919 % joint_count);
        if (std::find(at.joints.begin(), at.joints.end(), joint) == at.joints.end())
          at.joints.push_back(joint);
        else
          at.joints.push_back(static_cast<int>(random.below(joint_count)));
        std::sort(at.joints.begin(), at.joints.end());
        at.joints.erase(std::unique(at.joints.begin(), at.joints.end()), at.joints.end());
      }
      int left = one;
      for (std::size_t j = 0; j + 1 < at.joints.size(); ++j) {
        at.weights.push_back(static_cast<int>(random.below(static_cast<std::uint32_t>(left) + 1)));
        left -= at.weights.back();
      }
      at.weights.push_back(left);
      skin.push_back(at);
    }
  for (std::uint32_t y = 0; y + 1 < kSide; ++y)
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      if (x == 6) continue;
      const std::uint32_t a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
      for (const std::uint32_t i : {a, b, c, c, b, d}) indices.push_back(i);
    }
  positions.push_back({9, 9, 9});
  skin.push_back(skin.front());
  OwnedStreams out = mesh_of(positions, indices, skin, influences, bits, joint_count);
  out.add(StreamKind::uv, 2, 14);  // tells vertices at one place apart
  out.values.back().clear();
  for (std::size_t v = 0; v < positions.size(); ++v)
    out.values.back().insert(out.values.back().end(), {3, static_cast<int>(v)});
  return out;
}

OwnedStreams with_empty_skin(OwnedStreams s) {
  for (const StreamKind kind : {StreamKind::joints, StreamKind::weights})
    if (std::vector<std::int32_t>* const values = s.values_of(kind)) std::fill(values->begin(), values->end(), 0);
  return s;
}

TEST(SkinApart, WhatIsPackedComesBack) {
  Random random(3);
  std::size_t meshes = 0;
  for (const std::uint32_t influences : {1u, 2u, 4u, 8u})
    for (const std::uint32_t bits : {1u, 8u, 12u, 15u})
      for (const std::uint32_t joint_count : {2u, 40u, 32767u}) {
        const OwnedStreams whole = sheet(random, std::min(influences, joint_count), bits, joint_count);
        OwnedStreams streams = whole;
        const std::optional<cook::SkinApart> skin = cook::SkinApart::take(streams);
        ASSERT_TRUE(skin.has_value());
        ASSERT_EQ(streams.streams.size(), 2u);
        const std::vector<std::byte> packed = skin->give_back(streams);
        EXPECT_EQ(streams.values, whole.values);
        OwnedStreams out = with_empty_skin(whole);
        ASSERT_TRUE(decode_skin({packed.data(), packed.size()}, out.view()));
        EXPECT_EQ(out.values, whole.values) << influences << ' ' << bits << ' ' << joint_count;
        ++meshes;
      }
  EXPECT_EQ(meshes, 48u);
}

// In an order of the codec's, with a vertex more than there were.
TEST(SkinApart, FollowsTheCodecsOrder) {
  Random random(4);
  const OwnedStreams whole = sheet(random, 3, 10, 20);
  OwnedStreams streams = whole;
  const std::optional<cook::SkinApart> skin = cook::SkinApart::take(streams);
  ASSERT_TRUE(skin.has_value());
  const std::size_t count = whole.mesh.vertex_count;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<std::int32_t> old = std::move(streams.values[i]);
    const std::ptrdiff_t width = streams.streams[i].components;
    streams.values[i].clear();
    for (std::size_t v = 0; v <= count; ++v) {
      const auto from = old.begin() + static_cast<std::ptrdiff_t>(v == count ? 5 : count - 1 - v) * width;
      streams.values[i].insert(streams.values[i].end(), from, from + width);
    }
  }
  ++streams.mesh.vertex_count;
  const std::vector<std::byte> packed = skin->give_back(streams);
  ASSERT_TRUE(decode_skin({packed.data(), packed.size()}, with_empty_skin(streams).view()));
  EXPECT_EQ(streams.values[1][3 * count], whole.values[1][15]);
  for (std::size_t v = 0; v < count; ++v) EXPECT_EQ(streams.values[2][2 * v], whole.values[2][2 * (count - 1 - v)]);
}

// Two vertices of a sheet that were told apart by their weights alone.
TEST(SkinApart, StaysWhereNothingElseTellsVerticesApart) {
  const std::vector<std::array<int, 3>> positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 0}};
  const Followed a{{0}, {255}}, b{{0, 1}, {100, 155}};
  OwnedStreams streams = mesh_of(positions, {0, 1, 2, 3, 2, 1}, {a, a, a, b}, 2, 8, 2);
  const OwnedStreams before = streams;
  EXPECT_FALSE(cook::SkinApart::take(streams).has_value());
  EXPECT_EQ(streams.values, before.values);
  OwnedStreams fine = mesh_of(positions, {0, 1, 2, 3, 2, 1}, {a, a, a, a}, 2, 16, 2);
  EXPECT_FALSE(cook::SkinApart::take(fine).has_value()) << "weights of 16 bits";
}

// Seven vertices, two of which stand at one place, bound to joints 2, 5, 7 and 9; the bytes are those of an encoder
// that was written in Python from docs/format.md.
TEST(SkinApart, ReadsWhatTheDocumentSays) {
  const std::uint8_t bytes[] = {0x5f, 0x83, 0xc0, 0x0e, 0x3c, 0x0a, 0x31, 0x36,
                                0xc1, 0xf5, 0x42, 0x95, 0xcb, 0xc9, 0x0b, 0x68};
  const std::vector<std::array<int, 3>> positions = {{0, 0, 0},   {10, 0, 0},  {0, 10, 0}, {10, 10, 0},
                                                     {10, 10, 0}, {20, 10, 3}, {20, 0, 3}};
  const std::vector<Followed> skin = {{{2}, {255}},         {{2, 5}, {200, 55}},  {{2}, {255}},
                                      {{2, 5}, {100, 155}}, {{2, 5}, {100, 155}}, {{5, 7, 9}, {90, 65, 100}},
                                      {{9}, {255}}};
  const OwnedStreams want = mesh_of(positions, {0, 1, 2, 1, 3, 2, 4, 6, 5, 1, 6, 4}, skin, 3, 8, 12);
  OwnedStreams out = with_empty_skin(want);
  ASSERT_TRUE(decode_skin({reinterpret_cast<const std::byte*>(bytes), sizeof bytes}, out.view()));
  EXPECT_EQ(out.values, want.values);
}

TEST(SkinApart, DamagedOnesAreRefusedOrHarmless) {
  Random random(5);
  const OwnedStreams whole = sheet(random, 4, 12, 60);
  OwnedStreams streams = whole;
  const std::vector<std::byte> packed = cook::SkinApart::take(streams)->give_back(streams);
  std::size_t refused = 0, harmless = 0;
  const auto decode = [&](const std::vector<std::byte>& bytes) {
    OwnedStreams out = with_empty_skin(whole);
    if (!decode_skin({bytes.data(), bytes.size()}, out.view())) {
      ++refused;
      return;
    }
    ++harmless;
    for (std::size_t v = 0; v < out.mesh.vertex_count; ++v) {
      int sum = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_GE(out.values[1][4 * v + j + 1], out.values[1][4 * v + j]);
        EXPECT_GE(out.values[2][3 * v + j], 0);
        sum += out.values[2][3 * v + j];
      }
      EXPECT_GE(out.values[1][4 * v], 0);
      EXPECT_LT(out.values[1][4 * v + 3], 60);
      EXPECT_LE(sum, 4095);
    }
  };
  for (std::size_t i = 0; i < packed.size(); ++i) {
    std::vector<std::byte> bytes = packed;
    bytes[i] ^= static_cast<std::byte>(1u << random.below(8));
    decode(bytes);
    if (i % 16 == 0) decode({packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(i)});
  }
  EXPECT_GT(refused, packed.size() / 2);
  std::printf("%zu refused, %zu read as others\n", refused, harmless);
  OwnedStreams rigid = mesh_of({{0, 0, 0}}, {}, {{{0}, {255}}}, 1, 8, 1);
  rigid.streams.pop_back();
  rigid.values.pop_back();
  EXPECT_FALSE(decode_skin({packed.data(), packed.size()}, rigid.view())) << "a mesh without joints";
}

}  // namespace
}  // namespace marrow::test
