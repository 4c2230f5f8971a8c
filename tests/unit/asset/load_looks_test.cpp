// load: what it refuses of materials, images and nodes.
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "support/bad_numbers.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

using test::AlignedBlock;
using test::kInfinityBits64;
using test::kNanBits;

// The golden file of looks with one thing changed at a time.
class LoadLooks : public ::testing::Test {
 protected:
  LoadLooks() : block_(test::golden_looks_copy()) { EXPECT_EQ(load(block_, original_), Status::ok); }
  std::size_t at(format::Kind kind) const {
    for (const File::Section& s : original_.sections())
      if (s.type == format::kTypes[kind]) return s.offset;
    ADD_FAILURE();
    return 0;
  }
  // Expects a refusal of the changed field itself.
  template <class T>
  void refuse(std::size_t offset, T value, const char* what) {
    const test::DamageReport got = test::load_with(block_, offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << what;
    EXPECT_LE(got.error.offset, offset) << what << ": " << got.error.rule;
    EXPECT_GT(got.error.offset + 65, offset) << what << ": " << got.error.rule;
    ++refused_;
  }
  void accept(std::size_t offset, std::uint8_t value) {
    EXPECT_EQ(test::load_with(block_, offset, value).status, Status::ok);
  }

  AlignedBlock block_;
  File original_;
  int refused_ = 0;
};

TEST_F(LoadLooks, Materials) {
  const std::size_t mesh = at(format::kMeshes);
  refuse(mesh + 40, std::uint32_t{1}, "reserved");
  refuse(mesh + 44, std::uint32_t{3}, "a material that is not there");
  const std::size_t base = at(format::kMaterials);
  refuse(base, std::uint32_t{100000}, "name");
  refuse(base + 4, kNanBits, "a cutoff that is not a number");
  refuse(base + 4, -0.25f, "a negative cutoff");
  refuse(base + 8, std::uint8_t{3}, "an unknown alpha mode");
  refuse(base + 9, std::uint8_t{1}, "a texture fewer than there are bytes");
  refuse(base + 9, std::uint8_t{255}, "textures beyond the section");
  refuse(base + 10, std::uint16_t{4}, "an unknown flag");
  refuse(base + 10, std::uint16_t{2}, "light without its numbers");
  refuse(base + 12, std::uint16_t{2}, "an image that is not there");
  refuse(base + 14, std::uint8_t{6}, "an unknown role");
  refuse(base + 15, std::uint8_t{3}, "an unknown wrap mode");
  refuse(base + 16, std::uint8_t{3}, "an unknown wrap mode");
  refuse(base + 17, std::uint8_t{3}, "an unknown magnification filter");
  refuse(base + 18, std::uint8_t{7}, "an unknown minification filter");
  refuse(base + 19, std::uint8_t{1}, "reserved");
  refuse(base + 22, std::uint8_t{0}, "two base colours");
  accept(base + 22, 4);  // any other role
  EXPECT_EQ(refused_, 18);
}

TEST_F(LoadLooks, Images) {
  const std::size_t base = at(format::kImages);
  refuse(base, std::uint32_t{100000}, "name");
  refuse(base + 4, std::uint32_t{100000}, "uri");
  refuse(base + 8, std::uint32_t{75}, "a byte fewer than there are");
  refuse(base + 8, std::uint32_t{0xFFFFFFFF}, "bytes beyond the section");
  refuse(base + 12, std::uint8_t{0}, "bytes of no format");
  refuse(base + 12, std::uint8_t{6}, "an unknown format");
  refuse(base + 14, std::uint16_t{1}, "a fallback of a PNG");
  // The format and the fallback together: itself, a WebP; one that is not there.
  EXPECT_STREQ(test::load_with(block_, base + 12, std::uint32_t{0x00010003}).error.rule,
               "a fallback that is no PNG or JPEG image");
  EXPECT_STREQ(test::load_with(block_, base + 12, std::uint32_t{0x00090004}).error.rule, "no such image");
  refuse(base + 13, std::uint8_t{1}, "reserved");
  accept(base + 16, 0);  // bytes are whoever decodes them's to check
  EXPECT_EQ(refused_, 8);
}

TEST_F(LoadLooks, Nodes) {
  std::size_t base = 0;
  for (const File::Section& s : original_.sections())
    if (s.type == format::kTypes[format::kNodes] && s.bytes > sizeof(format::NodeHeader)) base = s.offset;
  ASSERT_NE(base, 0u);
  refuse(base, std::uint32_t{100000}, "name");
  refuse(base + 4, std::uint32_t{1}, "a skeleton that is not there");
  refuse(base + 8, std::uint32_t{4}, "a property fewer than there are bytes");
  refuse(base + 8, std::uint32_t{0xFFFFFFFF}, "properties beyond the section");
  refuse(base + 12, std::uint16_t{2}, "a joint outside the skeleton");
  refuse(base + 14, std::uint16_t{1}, "reserved");
  refuse(base + 16, kNanBits, "a matrix that is not finite");
  // Properties in the order of their keys: a~1b, door/hinges/0, /1, door/open, item.
  const std::size_t number = base + 64, boolean = number + 3 * 16, text = number + 4 * 16;
  refuse(number, std::uint32_t{100000}, "name of a property");
  refuse(number + 4, std::uint8_t{3}, "an unknown type");
  refuse(number + 5, std::uint8_t{1}, "reserved");
  refuse(number + 8, kInfinityBits64, "a number that is not finite");
  refuse(boolean + 8, 0.5, "neither true nor false");
  refuse(boolean + 8, -0.0, "minus false");
  refuse(text + 8, std::uint32_t{100000}, "a text outside the names");
  refuse(text + 12, std::uint32_t{1}, "reserved");
  EXPECT_EQ(refused_, 15);
}

TEST_F(LoadLooks, OrderOfSections) {
  std::uint32_t type = 0;
  std::size_t entry = sizeof(format::Header);
  while (std::memcpy(&type, block_.data() + entry, 4), type != format::kTypes[format::kMaterials])
    entry += sizeof(File::Section);
  refuse(entry + sizeof(File::Section), format::kTypes[format::kMeshes], "a mesh behind a material");
  EXPECT_EQ(refused_, 1);
}

}  // namespace
}  // namespace marrow
