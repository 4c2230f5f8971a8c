// Poses are the same bits on every processor, with SIMD or without: hashes of what every stage gives, stored here.
//
// A hash that differs on one processor only is a bug there. One that differs on all is a change of results: see that
// the road tests still hold, then store the new one and say why in the commit.
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "support/golden.h"
#include "support/pose_file.h"
#include "support/rig.h"

namespace marrow {
namespace {

template <class T>
std::uint64_t hash_of(const std::vector<T>& v, std::uint64_t state = test::kHashStart) {
  return test::hash(state, v.data(), v.size() * sizeof(T));
}

struct Hashes {
  std::uint64_t local = test::kHashStart, model = test::kHashStart, palette = test::kHashStart;
  std::uint64_t vertices[3] = {test::kHashStart, test::kHashStart, test::kHashStart};  // rigid, SSD, AS
};

void expect_hashes(const Hashes& got, const Hashes& want) {
  EXPECT_EQ(got.local, want.local) << "sample";
  EXPECT_EQ(got.model, want.model) << "local_to_model";
  EXPECT_EQ(got.palette, want.palette) << "build_palette";
  const char* const names[] = {"rigid", "ssd", "as"};
  for (int d = 0; d < 3; ++d) EXPECT_EQ(got.vertices[d], want.vertices[d]) << names[d];
  if (::testing::Test::HasFailure()) {
    std::printf("{0x%016llX, 0x%016llX, 0x%016llX, {0x%016llX, 0x%016llX, 0x%016llX}}\n", 0ULL + got.local,
                0ULL + got.model, 0ULL + got.palette, 0ULL + got.vertices[0], 0ULL + got.vertices[1],
                0ULL + got.vertices[2]);
  }
}

// Forty moments of a creature of noise; vertices by each deformer.
Hashes pose_character(const test::TestCharacter& c) {
  const Skeleton skeleton = c.skeleton.view();
  const Clip clip = c.clip.view();
  const Mesh mesh = c.mesh.view();
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.joint_count);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), positions(mesh.geometry.slot_count * 3);
  std::vector<float> normals(positions.size()), tangents(mesh.geometry.slot_count * 4);
  const SkinOutput out{positions, normals, tangents};
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  Hashes h;
  for (int moment = 0; moment < 40; ++moment) {
    EXPECT_EQ(sample(skeleton, clip, static_cast<float>(moment) * 0.0546875f, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
    EXPECT_EQ(build_palette(mesh, model, palette), Status::ok);
    h.local = hash_of(local, h.local);
    h.model = hash_of(model, h.model);
    h.palette = hash_of(palette, h.palette);
    for (int d = 0; d < 3; ++d) {
      EXPECT_EQ(d == 0   ? skin_rigid(mesh, palette, out)
                : d == 1 ? skin_ssd(mesh, palette, out)
                         : skin_as(mesh, coordinates, palette, out),
                Status::ok);
      h.vertices[d] = hash_of(tangents, hash_of(normals, hash_of(positions, h.vertices[d])));
    }
  }
  return h;
}

TEST(Bits, TheCreatureOfNoiseIsItselfTheSame) {
  const test::TestCharacter c = test::make_character(51, 67, 150, false);
  std::uint64_t h = hash_of(c.clip.values, hash_of(c.mesh.skin, hash_of(c.skeleton.rest)));
  h = hash_of(c.mesh.inverse_bind, hash_of(c.mesh.tangents, hash_of(c.mesh.normals, h)));
  EXPECT_EQ(h, 0x9710868BCF1CFB79u) << "the input of the tests below";
}

TEST(Bits, CreatureOfNoise) {
  expect_hashes(pose_character(test::make_character(51, 67, 150, false)),
                {0xD7885F5C53EEE295,
                 0xC37D058FF32F6F79,
                 0x5EF9EA3346008E53,
                 {0xCD9A9BD3C93216B7, 0x7DB7971F09C904D5, 0x60DC7A4982E15055}});
}

TEST(Bits, CreatureOfNoiseWithResiduals) {
  expect_hashes(pose_character(test::make_character(52, 34, 90, true)),
                {0x864A09F7B392E4DA,
                 0x87E0E1E053627420,
                 0x2991113F2FC9A40C,
                 {0x734C3F0E1F5BA270, 0x2B2438A337C8A20D, 0xEBC19E0B4B90A051}});
}

TEST(Bits, GoldenFile) {
  test::AlignedBlock block = test::golden_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  EXPECT_EQ(test::exercise(file), 0x8418D68D2F630DB2u);
}

}  // namespace
}  // namespace marrow
