// load: what holds for sections of every type, and a skeleton's one of limits, of springs and of bounds.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

std::vector<File::Section> sections_of(const test::AlignedBlock& block) {
  format::Header header;
  std::memcpy(&header, block.data(), sizeof header);
  std::vector<File::Section> out(header.section_count);
  std::memcpy(out.data(), block.data() + sizeof header, out.size() * sizeof(File::Section));
  return out;
}

// A file of these sections of another.
test::AlignedBlock file_of(const test::AlignedBlock& block, std::vector<File::Section> sections) {
  format::Header header;
  std::memcpy(&header, block.data(), sizeof header);
  std::vector<std::byte> out(sizeof header + sections.size() * sizeof(File::Section));
  for (File::Section& s : sections) {
    const std::byte* const from = block.data() + s.offset;
    s.offset = static_cast<std::uint32_t>(format::align16(out.size()));
    out.resize(s.offset);
    out.insert(out.end(), from, from + s.bytes);
  }
  header.section_count = static_cast<std::uint32_t>(sections.size());
  header.file_bytes = static_cast<std::uint32_t>(out.size());
  std::memcpy(out.data(), &header, sizeof header);
  std::memcpy(out.data() + sizeof header, sections.data(), sections.size() * sizeof(File::Section));
  test::forge_checksum(out.data(), out.size());
  return test::AlignedBlock(out.data(), out.size());
}

void refuse(const test::AlignedBlock& block, const std::vector<File::Section>& sections, std::size_t which,
            Status status, const char* rule) {
  const test::AlignedBlock changed = file_of(block, sections);
  File file;
  DataError error;
  EXPECT_EQ(load(changed, file, &error), status) << rule << which;
  EXPECT_STREQ(error.rule, rule) << which;
  EXPECT_EQ(error.offset, sections_of(changed)[which].offset) << rule << which;
}

void refuse_twice(const test::AlignedBlock& block, const char (&type)[5], const char* rule) {
  std::vector<File::Section> sections = sections_of(block);
  std::size_t i = 0;
  while (sections.at(i).type != format::four_characters(type)) ++i;
  sections.insert(sections.begin() + static_cast<std::ptrdiff_t>(i), sections[i]);
  refuse(block, sections, i + 1, Status::bad_data, rule);
}

// Each section of a file cut off in its header, and with a codec too many. Gives how many.
std::size_t refuse_each(const test::AlignedBlock& block) {
  const std::vector<File::Section> good = sections_of(block);
  File file;
  EXPECT_EQ(load(file_of(block, good), file), Status::ok);
  for (std::size_t i = 0; i + 1 < good.size(); ++i) {  // without names, which have no header
    std::vector<File::Section> sections = good;
    sections[i].bytes = 4;
    refuse(block, sections, i, Status::bad_data, "section too short for its header");
    sections = good;
    sections[i].codec = sections[i].type == format::four_characters("CLIP") ? 2 : 1;
    refuse(block, sections, i, Status::unsupported, "a codec that this build lacks");
  }
  return good.size() - 1;
}

TEST(LoadSections, HaveHeadersAndKnownCodecs) {
  EXPECT_GT(refuse_each(test::golden_copy()), 4u);        // SKEL CLIP GEOM MESH BNDS
  EXPECT_GT(refuse_each(test::golden_looks_copy()), 5u);  // and MATL IMAG NODE
  EXPECT_GT(refuse_each(test::golden_limits_copy()), 1u);
  EXPECT_GT(refuse_each(test::golden_springs_copy()), 1u);
  EXPECT_GT(refuse_each(test::golden_roles_copy()), 1u);
  EXPECT_GT(refuse_each(test::golden_maps_copy()), 1u);
  EXPECT_GT(refuse_each(test::golden_pack_copy()), 1u);  // SREF
}

TEST(LoadSections, OfSomeTypesASkeletonHasOne) {
  refuse_twice(test::golden_limits_copy(), "LIMI", "one section of limits a skeleton, in their order");
  refuse_twice(test::golden_springs_copy(), "SPRI", "one section of springs a skeleton, in their order");
  refuse_twice(test::golden_roles_copy(), "ROLE", "one section of roles a skeleton, in their order");
  refuse_twice(test::golden_copy(), "BNDS", "one section of bounds a skeleton, in their order");
}

}  // namespace
}  // namespace marrow
