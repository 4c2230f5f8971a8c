// What a new kind of section takes: the file that describes it (support/cloth_section.h) and one line.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "asset/checker.h"
#include "support/cloth_section.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

constexpr std::uint32_t kCloths = format::kKindCount;

// Those of every file, and before the last, which is names', the new one.
std::vector<SectionKind> kinds_with_cloth() {
  std::vector<SectionKind> kinds(kSectionKinds.begin(), kSectionKinds.end());
  kinds.insert(kinds.end() - 1, section_kind<format::ClothHeader>(kCloths, format::four_characters("CLOT"), 0));
  return kinds;
}

// Two points and a thread, by hand: header, six floats, two halves, two threads.
constexpr format::ClothHeader kHeader{0, 0, 2, 1, 0};
constexpr std::size_t kPoints = 16, kPinned = 40, kThreads = 44, kBytes = 60;

std::vector<std::byte> make_cloth() {
  const float points[6] = {0, 1, 2, 3, 4, 5};
  const std::uint16_t pinned[2] = {1, 0};
  const format::ClothThread threads[2] = {{0, 1, 0.5f}, {1, 0, 0.25f}};
  std::vector<std::byte> out(kBytes);
  std::memcpy(out.data(), &kHeader, sizeof kHeader);
  std::memcpy(out.data() + kPoints, points, sizeof points);
  std::memcpy(out.data() + kPinned, pinned, sizeof pinned);
  std::memcpy(out.data() + kThreads, threads, sizeof threads);
  return out;
}

class NewKind : public ::testing::Test {
 protected:
  // A golden file with the section before its names.
  NewKind() {
    const test::AlignedBlock golden = test::golden_copy();
    File file;
    EXPECT_EQ(load(golden, file), Status::ok);
    std::vector<File::Section> sections(file.sections().begin(), file.sections().end());
    const std::vector<std::byte> cloth = make_cloth();
    sections.insert(sections.end() - 1, {format::four_characters("CLOT"), 0, kBytes, 0});
    std::vector<std::byte> out(sizeof(format::Header) + sections.size() * sizeof(File::Section));
    for (File::Section& s : sections) {
      const bool is_new = s.type == format::four_characters("CLOT");
      const std::byte* const from = is_new ? cloth.data() : golden.data() + s.offset;
      s.offset = static_cast<std::uint32_t>(format::align16(out.size()));
      out.resize(s.offset);
      out.insert(out.end(), from, from + s.bytes);
      if (is_new) base_ = s.offset;
    }
    format::Header header;
    std::memcpy(&header, golden.data(), sizeof header);
    header.section_count = static_cast<std::uint32_t>(sections.size());
    header.file_bytes = static_cast<std::uint32_t>(out.size());
    std::memcpy(out.data(), &header, sizeof header);
    std::memcpy(out.data() + sizeof header, sections.data(), sections.size() * sizeof(File::Section));
    bytes_ = std::move(out);
  }
  static DataError check(const std::vector<std::byte>& bytes) {
    test::AlignedBlock block(bytes.data(), bytes.size());
    test::forge_checksum(block.data(), block.size());
    std::uint32_t first[format::kKindCount + 1] = {}, counts[format::kKindCount + 1] = {};
    const DataError error = check_file(block, kinds_with_cloth(), first, counts);
    if (error.status == Status::ok) {
      EXPECT_EQ(counts[kCloths], 1u);
    }
    return error;
  }
  // Expects a refusal at the changed field.
  template <class T>
  void refuse(std::size_t offset, T value, const char* rule) {
    std::vector<std::byte> changed = bytes_;
    std::memcpy(changed.data() + base_ + offset, &value, sizeof value);
    const DataError error = check(changed);
    EXPECT_EQ(error.status, Status::bad_data) << rule;
    EXPECT_STREQ(error.rule, rule);
    EXPECT_EQ(error.offset, base_ + offset) << rule;
  }

  std::vector<std::byte> bytes_;
  std::size_t base_ = 0;
};

TEST_F(NewKind, IsLaidOutByItsDescription) {
  const format::ClothLayout l = layout(kHeader);
  EXPECT_EQ(l.points, kPoints);
  EXPECT_EQ(l.pinned, kPinned);
  EXPECT_EQ(l.threads, kThreads);
  EXPECT_EQ(l.bytes, kBytes);
  const Span<const format::ClothThread> threads = l.threads.in(bytes_.data() + base_);
  ASSERT_EQ(threads.size, 2u);
  EXPECT_EQ(threads[1].length_m, 0.25f);
  // An odd count: the threads begin on the next boundary of four bytes, at 16 + 3 · 12 + 6 + 2.
  EXPECT_EQ(layout(format::ClothHeader{0, 0, 3, 0, 0}).threads, 60u);
}

TEST_F(NewKind, IsTakenByWhoHasItsLine) {
  EXPECT_EQ(check(bytes_).status, Status::ok);
  test::AlignedBlock block(bytes_.data(), bytes_.size());
  test::forge_checksum(block.data(), block.size());
  File file;
  DataError error;
  EXPECT_EQ(load(block, file, &error), Status::bad_data);
  EXPECT_STREQ(
      error.rule,
      "section types in order: SKEL SREF CLIP GEOM MESH MATL IMAG NODE LIMI SPRI ROLE MOTN PMAP SHAP GRPH BNDS NAME");
}

TEST_F(NewKind, IsHeldToItsDescription) {
  refuse(0, std::uint32_t{100000}, "name outside the name section");
  refuse(4, std::uint32_t{1}, "no such skeleton");
  refuse(12, std::uint16_t{100}, "a joint outside the skeleton");
  refuse(14, std::uint16_t{1}, "reserved must be 0");
  refuse(kPoints + 8, 1.01e12f, "a number that is not finite, or beyond 1e12");
  refuse(kThreads, std::uint16_t{2}, "a thread of no point");
  refuse(kThreads + 10, std::uint16_t{2}, "a thread of no point");
  refuse(kThreads + 4, -1.0f, "a length is not negative");
  const std::uint32_t infinity = 0x7F800000;
  refuse(kThreads + 12, infinity, "a number that is not finite");
  std::vector<std::byte> longer = bytes_;
  longer[base_ + 8] = std::byte{3};
  EXPECT_STREQ(check(longer).rule, "section size differs from its counts");
}

}  // namespace
}  // namespace marrow
