// The vertex codec of KHR_meshopt_compression: the specification's own example, streams written by hand, and elements
// that an encoder after its text has written.
#include "cook/gltf/document/meshopt.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "support/places.h"
#include "support/rig.h"
#include "unit/cook/gltf/meshopt_stream.h"

namespace marrow::cook {
namespace {

using gltf::decode_vertices;

bool decode(const Octets& coded, std::size_t stride, Octets& elements) {
  // As long as it is, so that a sanitizer sees what is read beyond.
  const Octets exactly(coded.begin(), coded.end());
  return decode_vertices(std::as_bytes(std::span(exactly)), static_cast<std::uint32_t>(stride),
                         std::as_writable_bytes(std::span(elements)));
}

// Header, blocks, padding, baseline, channel modes.
Octets stream(std::uint8_t header, const Octets& blocks, const Octets& baseline, const Octets& modes) {
  Octets out = {header};
  out.insert(out.end(), blocks.begin(), blocks.end());
  out.resize(out.size() + (header == 0xA0 ? 32 : 24) - baseline.size() - modes.size());
  out.insert(out.end(), baseline.begin(), baseline.end());
  out.insert(out.end(), modes.begin(), modes.end());
  return out;
}

// Appendix A: sixteen deltas by four bits, and what they stand for.
TEST(MeshoptVertices, TheSpecificationsExample) {
  const Octets example = {0x17, 0x5f, 0xf0, 0xbc, 0x77, 0xa9, 0x21, 0x00, 0x34, 0xb5};
  const int deltas[] = {-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0};
  // Four bits are mode 3 of control 0, mode 2 of control 1 and of version 0.
  for (const int way : {0, 1, 2}) {
    Octets blocks;
    if (way < 2) blocks = {static_cast<std::uint8_t>(way | 0xA8)};  // nothing for the other three bytes
    blocks.push_back(way == 0 ? 3 : 2);
    blocks.insert(blocks.end(), example.begin(), example.end());
    if (way == 2) blocks.insert(blocks.end(), {0, 0, 0});
    Octets elements(64);
    ASSERT_TRUE(
        decode(stream(way == 2 ? 0xA0 : 0xA1, blocks, {100, 7, 8, 9}, way == 2 ? Octets{} : Octets{0}), 4, elements));
    int sum = 100;
    for (std::size_t i = 0; i < 16; ++i) {
      sum += deltas[i];
      EXPECT_EQ(elements[4 * i], static_cast<std::uint8_t>(sum)) << i;
      EXPECT_EQ((Octets{elements[4 * i + 1], elements[4 * i + 2], elements[4 * i + 3]}), (Octets{7, 8, 9})) << i;
    }
  }
}

// 0x00FF + 1, then + 0; 0x0001 − 2, then − 0x8000, which is 0xFFFF in zigzag.
TEST(MeshoptVertices, PairsOfBytes) {
  Octets elements(8);
  ASSERT_TRUE(decode(stream(0xA1, {0xFF, 2, 0, 0, 0, 3, 0xFF, 0, 0xFF}, {0xFF, 0, 1, 0}, {1}), 4, elements));
  EXPECT_EQ(elements, (Octets{0x00, 0x01, 0xFF, 0xFF, 0x00, 0x01, 0xFF, 0x7F}));
}

// 0x0000000F and 0x80000001 differ by 0x8000000E, which is 0xE8 when turned left by four bits.
TEST(MeshoptVertices, ExclusiveOrTurned) {
  Octets elements(4);
  ASSERT_TRUE(decode(stream(0xA1, {0xFF, 0xE8, 0, 0, 0}, {0x0F, 0, 0, 0}, {0x42}), 4, elements));
  EXPECT_EQ(elements, (Octets{1, 0, 0, 0x80}));
}

// Deltas by 1 bit go from the lowest bit up: of 0x05 and 0x80 those 0, 2 and 15 are bytes behind.
TEST(MeshoptVertices, SingleBits) {
  Octets elements(64);
  ASSERT_TRUE(decode(stream(0xA1, {0xA9, 0, 0x05, 0x80, 20, 3, 2}, {0, 0, 0, 0}, {0}), 4, elements));
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(elements[4 * i], i < 2 ? 10 : i < 15 ? 8 : 9) << i;
}

Octets some_elements(test::Random& random, std::size_t size, std::size_t stride) {
  Octets out(size);
  const std::uint32_t spread = random.below(3) == 0 ? 256 : 3;
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_still = i % stride / 4 % 3 == 1;
    out[i] = static_cast<std::uint8_t>((i < stride ? 0U : out[i - stride]) + (is_still ? 0 : random.below(spread)));
  }
  return out;
}

TEST(MeshoptVertices, WhatWasWrittenIsRead) {
  test::Random random(5);
  const auto choose = [&](unsigned n) { return random.below(n); };
  const std::uint8_t kinds[] = {0, 1, 2, 0x12, 0x72, 0xF2};
  for (int i = 0; i < 150; ++i) {
    const std::size_t stride = 4 * (1 + choose(i % 10 == 0 ? 64 : 6)), count = 1 + choose(i % 5 == 0 ? 600 : 40);
    Octets modes(stride / 4);
    for (std::uint8_t& mode : modes) mode = kinds[choose(6)];
    const Octets elements = some_elements(random, count * stride, stride);
    Octets coded = encode_vertices_1(elements, stride, modes, choose), found(elements.size());
    EXPECT_LE(gltf::least_vertex_bytes(std::as_bytes(std::span(coded)), count, static_cast<std::uint32_t>(stride)),
              coded.size());
    ASSERT_TRUE(decode(coded, stride, found)) << stride << " x " << count;
    ASSERT_EQ(found, elements) << stride << " x " << count;
    coded.insert(coded.begin() + 1, 0);
    EXPECT_FALSE(decode(coded, stride, found)) << "a byte too many";
  }
}

TEST(MeshoptVertices, Version0IsTheLibrarys) {
  test::Random random(6);
  for (const std::size_t stride : {4U, 12U, 20U, 64U, 256U}) {
    const std::size_t count = 300;
    const Octets elements = some_elements(random, count * stride, stride);
    Octets coded(meshopt_encodeVertexBufferBound(count, stride)), found(elements.size());
    meshopt_encodeVertexVersion(0);
    coded.resize(meshopt_encodeVertexBuffer(coded.data(), coded.size(), elements.data(), count, stride));
    ASSERT_TRUE(decode(coded, stride, found));
    EXPECT_EQ(found, elements);
  }
}

TEST(MeshoptVertices, WhatIsNoStreamIsRefused) {
  test::Random random(7);
  const Octets elements = some_elements(random, 40 * 12, 12);
  const Octets coded = encode_vertices_1(elements, 12, {0, 1, 2}, [&](unsigned n) { return n == 3 ? 0 : n - 1; });
  Octets found(elements.size());
  for (std::size_t size = 0; size < coded.size(); ++size)
    EXPECT_FALSE(decode(Octets(coded.begin(), coded.begin() + static_cast<std::ptrdiff_t>(size)), 12, found)) << size;
  for (const unsigned header : {0x00U, 0xA2U, 0xAFU, 0xE1U}) {
    Octets other = coded;
    other[0] = static_cast<std::uint8_t>(header);
    EXPECT_FALSE(decode(other, 12, found));
  }
  // Of 256 modes 18 are defined: bytes, pairs, and sixteen turns.
  int taken = 0;
  for (unsigned mode = 0; mode < 256; ++mode) {
    Octets other = coded;
    other.back() = static_cast<std::uint8_t>(mode);
    taken += decode(other, 12, found) ? 1 : 0;
  }
  EXPECT_EQ(taken, 18);
}

// What the fuzz target starts with: stride / 4 − 1, count, and a stream with all that there is.
TEST(MeshoptVertices, TheFuzzTargetsSeedIsSuchAStream) {
  test::Random random(8);
  const auto choose = [&](unsigned n) { return random.below(n); };
  const Octets elements = some_elements(random, 70 * 24, 24);
  Octets seed = encode_vertices_1(elements, 24, {0, 1, 2, 0x52, 0, 1}, choose);
  seed.insert(seed.begin(), {5, 70, 0});
  std::ifstream file(test::in_source("tests/fuzz/seeds/wave.vertices"), std::ios::binary);
  EXPECT_EQ(seed, Octets(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace
}  // namespace marrow::cook
