// Bounds as packed files have them: what is packed must come back to the bit, in the bytes that the runtime's tests
// read.
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "cook/write/bounds_packer.h"
#include "support/aligned.h"
#include "unpack/clip/bounds_record.h"

namespace marrow::cook {
namespace {

using test::AlignedBlock;

// Unpacks and compares; how many bytes it took.
std::size_t bytes_there_and_back(const MeasuredBounds& bounds) {
  const std::vector<std::byte> record = pack_bounds(bounds);
  const std::size_t size = sizeof bounds.header + bounds.codes.size() * sizeof(format::BoundsCodes);
  EXPECT_EQ(measure_bounds_record({record.data(), record.size()}), size);
  AlignedBlock out(size);
  std::uint32_t bytes = 0;
  EXPECT_STREQ(unpack_bounds({record.data(), record.size()}, {out.data(), out.size()}, bytes), nullptr);
  EXPECT_EQ(bytes, size);
  EXPECT_EQ(std::memcmp(out.data(), &bounds.header, sizeof bounds.header), 0);
  EXPECT_EQ(std::memcmp(out.data() + sizeof bounds.header, bounds.codes.data(), size - sizeof bounds.header), 0);
  return record.size();
}

MeasuredBounds bounds_of(std::uint32_t clips, std::uint32_t meshes) {
  return {{0, clips, meshes}, std::vector<format::BoundsCodes>(std::size_t{clips} * meshes)};
}

TEST(BoundsPacker, GivesBackWhatItGot) {
  std::mt19937 random(5);
  for (const std::uint32_t clips : {1u, 2u, 9u, 300u})
    for (const std::uint32_t meshes : {1u, 2u, 15u}) {
      MeasuredBounds chance = bounds_of(clips, meshes);
      for (format::BoundsCodes& codes : chance.codes) {
        unsigned char bytes[8];
        for (unsigned char& b : bytes) b = static_cast<unsigned char>(random());
        std::memcpy(&codes, bytes, sizeof codes);
      }
      bytes_there_and_back(chance);
    }
  // Two motions in turn, each of which is the one before but for a little.
  MeasuredBounds turns = bounds_of(100, 4);
  for (std::size_t i = 0; i < turns.codes.size(); ++i) {
    format::BoundsCodes& codes = turns.codes[i];
    const auto near = [&](int x) { return static_cast<std::int8_t>(x + static_cast<int>(random() % 3)); };
    const int away = i / 4 % 2 == 0 ? -100 : 40;
    codes = {-5, {near(away), near(-60), near(-9)}, {near(away + 50), near(30), near(9)}, 77};
  }
  EXPECT_LT(bytes_there_and_back(turns), turns.codes.size() * 3);
  // As many as there are, all alike: hardly a bit each, and no more than the record's counts allow.
  EXPECT_LT(bytes_there_and_back(bounds_of(1000, 100)), 12000u);
}

// The record that structure_test reads.
TEST(BoundsPacker, WritesTheSymbolsThatTheRuntimesTestsRead) {
  MeasuredBounds bounds{{1, 3, 2}, {}};
  bounds.codes = {{-5, {-10, 0, -12}, {10, 90, 12}, 60},  {-6, {-8, 100, -9}, {8, 127, -3}, 40},
                  {-4, {-100, -1, -7}, {-60, 45, 6}, 30}, {-6, {-8, 100, -9}, {8, 127, -3}, 41},
                  {-5, {-10, 0, -12}, {10, 90, 12}, 60},  {-6, {-8, 101, -9}, {8, 126, -3}, 200}};
  const std::vector<std::byte> record = pack_bounds(bounds);
  const unsigned char want[] = {1,    3,    2,    0xA7, 0x00, 0x00, 0x00, 0x8A, 0x52, 0x0A, 0x61,
                                0x24, 0x09, 0xCC, 0xA2, 0xBE, 0xE0, 0x6C, 0x72, 0x9D, 0xEA, 0x53,
                                0x13, 0xDD, 0x24, 0x5B, 0xE6, 0x3E, 0x95, 0x03, 0xD4, 0xA1, 0x80,
                                0x96, 0x81, 0x73, 0x83, 0xEC, 0xC3, 0x56, 0xC8, 0x1E, 0x0D};
  ASSERT_EQ(record.size(), sizeof want);
  EXPECT_EQ(std::memcmp(record.data(), want, sizeof want), 0);
}

}  // namespace
}  // namespace marrow::cook
