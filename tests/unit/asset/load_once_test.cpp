// load: a skeleton has one section of limits, of springs and of bounds.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

// The file with its section of a type twice, one behind the other.
test::AlignedBlock with_twice(const test::AlignedBlock& block, std::uint32_t type) {
  format::Header header;
  std::memcpy(&header, block.data(), sizeof header);
  std::vector<File::Section> sections;
  std::vector<const std::byte*> from;
  for (std::uint32_t i = 0; i < header.section_count; ++i) {
    File::Section s;
    std::memcpy(&s, block.data() + sizeof header + i * sizeof s, sizeof s);
    for (int n = s.type == type ? 2 : 1; n > 0; --n) {
      sections.push_back(s);
      from.push_back(block.data() + s.offset);
    }
  }
  std::uint64_t end = sizeof header + sections.size() * sizeof(File::Section);
  for (File::Section& s : sections) {
    s.offset = static_cast<std::uint32_t>(format::align16(end));
    end = std::uint64_t{s.offset} + s.bytes;
  }
  header.section_count = static_cast<std::uint32_t>(sections.size());
  header.file_bytes = static_cast<std::uint32_t>(end);
  std::vector<std::byte> out(static_cast<std::size_t>(end));
  std::memcpy(out.data(), &header, sizeof header);
  std::memcpy(out.data() + sizeof header, sections.data(), sections.size() * sizeof(File::Section));
  for (std::size_t i = 0; i < sections.size(); ++i)
    std::memcpy(out.data() + sections[i].offset, from[i], sections[i].bytes);
  test::forge_checksum(out.data(), out.size());
  return test::AlignedBlock(out.data(), out.size());
}

// Expects a refusal of the second section.
void refuse_twice(const test::AlignedBlock& block, const char (&type)[5], const char* rule) {
  const test::AlignedBlock same = with_twice(block, 0), twice = with_twice(block, format::four_characters(type));
  ASSERT_GT(twice.size(), block.size()) << type;
  File file;
  ASSERT_EQ(load(same, file), Status::ok) << type;
  DataError error;
  EXPECT_EQ(load(twice, file, &error), Status::bad_data) << type;
  EXPECT_STREQ(error.rule, rule);
  std::uint32_t second = 0;
  for (std::size_t at = sizeof(format::Header); second == 0; at += sizeof(File::Section)) {
    File::Section pair[2];
    std::memcpy(pair, twice.data() + at, sizeof pair);
    if (pair[0].type == format::four_characters(type)) second = pair[1].offset;
  }
  EXPECT_EQ(error.offset, second) << type;
}

TEST(LoadOnce, ASkeletonHasOneSectionOfEach) {
  refuse_twice(test::golden_limits_copy(), "LIMI", "one section of limits a skeleton, in their order");
  refuse_twice(test::golden_springs_copy(), "SPRI", "one section of springs a skeleton, in their order");
  refuse_twice(test::golden_copy(), "BNDS", "one section of bounds a skeleton, in their order");
}

}  // namespace
}  // namespace marrow
