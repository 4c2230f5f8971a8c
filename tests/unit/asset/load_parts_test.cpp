// load: the rules of meshes that go on with the mesh before them.
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/file.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

constexpr std::size_t kFlags = offsetof(format::MeshHeader, flags);

// Where the golden file's meshes stand.
std::vector<std::size_t> meshes_of(const test::AlignedBlock& block, File& file) {
  EXPECT_EQ(load(block, file), Status::ok);
  std::vector<std::size_t> out;
  for (const File::Section& s : file.sections())
    if (s.type == format::kTypes[format::kMeshes]) out.push_back(s.offset);
  return out;
}

TEST(LoadParts, TheFirstMeshGoesOnWithNothing) {
  File file;
  test::AlignedBlock block = test::golden_copy();
  const std::vector<std::size_t> meshes = meshes_of(block, file);
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_FALSE(file.mesh(0).is_next_part);
  EXPECT_FALSE(file.mesh(1).is_next_part);
  const test::DamageReport got = test::load_with(block, meshes[0] + kFlags, std::uint8_t{format::kNextPart});
  EXPECT_EQ(got.status, Status::bad_data);
  EXPECT_EQ(got.error.offset, meshes[0] + kFlags);
}

bool is_alike(const Mesh& mesh, const Mesh& other) {
  const Geometry &a = mesh.geometry, &b = other.geometry;
  return mesh.skeleton == other.skeleton && a.targets.size == b.targets.size &&
         a.source_slots.size == b.source_slots.size && (a.normals == nullptr) == (b.normals == nullptr) &&
         (a.tangents == nullptr) == (b.tangents == nullptr) && (a.uvs == nullptr) == (b.uvs == nullptr) &&
         (a.colours == nullptr) == (b.colours == nullptr);
}

// Any mesh of the golden files is called the next part of the one before it.
TEST(LoadParts, PartsAreOfOneKind) {
  int good = 0, refused = 0;
  for (test::AlignedBlock (*const copy)() : {test::golden_copy, test::golden_coded_copy, test::golden_channels_copy,
                                             test::golden_looks_copy, test::golden_lod_copy}) {
    test::AlignedBlock block = copy();
    File file;
    const std::vector<std::size_t> meshes = meshes_of(block, file);
    for (std::uint32_t m = 1; m < meshes.size(); ++m) {
      const test::DamageReport got = test::load_with(block, meshes[m] + kFlags, std::uint8_t{format::kNextPart});
      const bool alike = is_alike(file.mesh(m - 1), file.mesh(m));
      EXPECT_EQ(got.status, alike ? Status::ok : Status::bad_data);
      if (!alike) {
        EXPECT_EQ(got.error.offset, meshes[m] + kFlags);
      }
      ++(alike ? good : refused);
    }
  }
  EXPECT_GE(good, 1);
  EXPECT_GE(refused, 1);
}

TEST(LoadParts, OtherFlagsAreRefused) {
  File file;
  test::AlignedBlock block = test::golden_copy();
  const std::vector<std::size_t> meshes = meshes_of(block, file);
  EXPECT_EQ(test::load_with(block, meshes[1] + kFlags, std::uint8_t{4}).status, Status::bad_data);
}

}  // namespace
}  // namespace marrow
