// load: the rules of levels of detail, broken one at a time in a golden file, and what a level is.
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/file.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

class LoadLods : public ::testing::Test {
 protected:
  LoadLods() : block_(test::golden_lod_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kMeshes] && mesh_.bytes == 0) mesh_ = s;
    std::memcpy(&header_, block_.data() + mesh_.offset, sizeof header_);
    lods_ = mesh_.offset + layout(header_).lods;
  }
  // A change that load() must refuse at its place.
  template <class T>
  void refuse(std::size_t offset, T value, const char* what) {
    const test::DamageReport got = test::load_with(block_, offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << what;
    EXPECT_GE(got.error.offset, mesh_.offset) << what;
    EXPECT_LT(got.error.offset, mesh_.offset + mesh_.bytes) << what;
    EXPECT_GT(std::strlen(got.error.rule), 5u) << what;
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  File::Section mesh_{};
  format::MeshHeader header_{};
  std::size_t lods_ = 0;
  int refused_ = 0;
};

TEST_F(LoadLods, LevelsAreGeometriesOfOneMesh) {
  ASSERT_EQ(file_.mesh_count(), 2u);
  const Mesh full = file_.mesh(0);
  ASSERT_EQ(full.lods.size, 2u);
  EXPECT_EQ(full.geometry.index_count, 120u);
  EXPECT_EQ(file_.mesh(0, 0).geometry_index, full.geometry_index);
  EXPECT_EQ(file_.mesh(0, 1).geometry.index_count, 60u);
  EXPECT_EQ(file_.mesh(0, 1).geometry_index, full.lods[0].geometry);
  EXPECT_EQ(file_.mesh(0, 2).geometry_index, full.lods[1].geometry);
  EXPECT_EQ(file_.mesh(0, 3).geometry_index, full.lods[1].geometry) << "beyond the last is the last";
  EXPECT_EQ(file_.mesh(0, 2).joints, full.joints) << "one palette";
  for (const auto& run : file_.mesh(0, 2).geometry.runs) EXPECT_EQ(run.influences, 1u);
  EXPECT_GT(full.lods[0].error_m, 0);
  EXPECT_LT(full.lods[0].error_m, full.lods[1].error_m);
}

TEST_F(LoadLods, AFileWithoutHasTheFullMeshAlone) {
  const test::AlignedBlock block = test::golden_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  EXPECT_TRUE(file.mesh(0).lods.empty());
  EXPECT_EQ(file.mesh(0, 5).geometry_index, file.mesh(0).geometry_index);
}

TEST_F(LoadLods, RulesHold) {
  ASSERT_EQ(header_.lod_count, 2u);
  const std::uint32_t others = file_.mesh(1).geometry_index;
  ASSERT_NE(file_.mesh(1).geometry.joint_count, file_.mesh(0).geometry.joint_count);
  refuse(mesh_.offset + 21, std::uint8_t{1}, "fewer levels than there is room for");
  refuse(mesh_.offset + 21, std::uint8_t{255}, "more levels than there is room for");
  refuse(lods_, std::uint32_t{100}, "no such geometry");
  refuse(lods_ + 8, std::uint32_t{0xFFFFFFFF}, "no such geometry of level 2");
  refuse(lods_, others, "a geometry with another palette");
  refuse(lods_ + 4, std::uint32_t{0x7FC00000}, "an error that is not a number");
  refuse(lods_ + 12, -1.0f, "an error below 0");
  EXPECT_EQ(refused_, 7);
}

}  // namespace
}  // namespace marrow
