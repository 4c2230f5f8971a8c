// load: the rules of morph targets, broken one at a time in a golden file.
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "support/bad_numbers.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

using test::kNanBits;

class LoadMorphs : public ::testing::Test {
 protected:
  LoadMorphs() : block_(test::golden_channels_copy()) {
    EXPECT_EQ(load(block_, original_), Status::ok);
    for (const File::Section& s : original_.sections()) {
      if (s.type == format::kTypes[format::kGeometries] && geometry_.bytes == 0) geometry_ = s;
      if (s.type == format::kTypes[format::kMeshes] && mesh_.bytes == 0) mesh_ = s;
    }
    std::memcpy(&header_, block_.data() + geometry_.offset, sizeof header_);
    std::memcpy(&morphs_, block_.data() + geometry_.offset + format::morph_start(layout(header_)), sizeof morphs_);
    layout_ = layout(morphs_, layout(header_));
  }
  template <class T>
  T get(std::size_t offset) const {
    T value;
    std::memcpy(&value, block_.data() + offset, sizeof value);
    return value;
  }
  // A change that load() must refuse at its place.
  template <class T>
  void refuse(std::size_t offset, T value, const char* what) {
    const test::DamageReport got = test::load_with(block_, offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << what;
    EXPECT_GT(std::strlen(got.error.rule), 5u) << what;
    EXPECT_GE(got.error.offset, geometry_.offset) << what;
    EXPECT_EQ(got.mesh_count, 0u) << what;
    ++refused_;
  }

  test::AlignedBlock block_;
  File original_;
  File::Section geometry_{}, mesh_{};
  format::GeometryHeader header_{};
  format::MorphHeader morphs_{};
  format::MorphLayout layout_{};
  int refused_ = 0;
};

TEST_F(LoadMorphs, OfGeometries) {
  ASSERT_EQ(morphs_.target_count, 2u);
  const std::size_t start = geometry_.offset + layout_.header, first = geometry_.offset + layout_.targets,
                    second = first + sizeof(MorphTarget);
  refuse(start, std::uint32_t{0}, "no targets");
  refuse(start, std::uint32_t{1}, "a target fewer");
  refuse(start, std::uint32_t{0xFFFFFFFF}, "too many targets");
  refuse(start + 4, morphs_.block_count + 1, "a block more");
  refuse(start + 8, morphs_.record_count - 1, "a record fewer");
  refuse(start + 8, std::uint32_t{0xFFFFFFFF}, "too many records");
  refuse(start + 12, std::uint32_t{1}, "reserved");
  refuse(first, std::uint32_t{1}, "a first block that is not the first");
  refuse(first + 4, std::uint32_t{0xFFFFFFFF}, "too many blocks of a target");
  refuse(first + 4, std::uint32_t{0}, "attributes without blocks");
  refuse(second + 8, std::uint32_t{0}, "records twice");
  refuse(first + 12, std::uint32_t{0}, "blocks without attributes");
  refuse(first + 12, std::uint32_t{8}, "an unknown attribute");
  refuse(first + 12, std::uint32_t{kMorphsTangents}, "tangents that the geometry lacks");
  refuse(first + 12, std::uint32_t{kMorphsPositions}, "fewer attributes than records");
  refuse(first + 16, kNanBits, "a step that is not a number");
  refuse(second + 20, kNanBits, "a step of normals that is not a number");
  refuse(first + 28, std::uint32_t{1}, "reserved");
  refuse(geometry_.offset + layout_.blocks, static_cast<std::uint16_t>(header_.block_count), "a block too far");
  EXPECT_EQ(refused_, 19);
}

TEST_F(LoadMorphs, OfMeshes) {
  const auto h = get<format::MeshHeader>(mesh_.offset);
  const std::size_t first = mesh_.offset + layout(h).targets;
  ASSERT_EQ(h.target_count, 2u);
  refuse(mesh_.offset + 40, std::uint32_t{0}, "fewer targets than the geometry");
  refuse(mesh_.offset + 40, std::uint32_t{3}, "more targets than the geometry");
  refuse(first, std::uint32_t{100000}, "name");
  refuse(first + 4, std::uint32_t{100000}, "channel");
  refuse(first + 8, kNanBits, "a weight that is not a number");
  EXPECT_EQ(refused_, 5);
}

}  // namespace
}  // namespace marrow
