// Boxes and spheres of a palette: by hand arithmetic, and about every vertex that a blend gives.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "support/aligned.h"
#include "support/family.h"
#include "support/morphs.h"
#include "support/rig.h"
#include "support/skinned.h"

namespace marrow {
namespace {

using test::AlignedBlock;

// A extents with its memory, exactly as long as it must be.
struct Reached {
  explicit Reached(const Mesh& mesh) : block(extents_bytes(mesh)) {
    EXPECT_EQ(make_extents(mesh, {block.data(), block.size()}, extents), Status::ok);
  }
  AlignedBlock block;
  MeshExtents extents;
};

test::TestVertex vertex(double x, double y, double z, const std::vector<double>& weights) {
  return {{x, y, z}, {0, 0, 1}, {1, 0, 0}, 1, weights, {}};
}

// Entry 0 holds (±1, ±2, 0), entry 1 holds (1, 2, 0) too, and (3, 2, 4) alone; entry 2 nothing.
test::TestMesh three_entries() {
  return test::TestMesh({{{0}, {vertex(-1, -2, 0, {1}), vertex(1, 2, 0, {1})}},
                         {{0, 1}, {vertex(1, 2, 0, {0.5, 0.5}), vertex(3, 2, 4, {0, 1})}}},
                        std::vector<test::Map>(3));
}

constexpr Affine kNowhere = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

TEST(PaletteBounds, AreWhatHandArithmeticSays) {
  const test::TestMesh mesh = three_entries();
  const Reached r(mesh.view());
  ASSERT_EQ(r.extents.joints.size, 3u);
  EXPECT_LT(r.extents.joints[2].half[0], 0) << "nothing follows it";
  // Entry 0: x to y, y to -x, then 10 along x. Its box is 4 × 2 × 0 about (10, 0, 0).
  // Entry 1: twice as large. Its box, (1 … 3, 2, 0 … 4), becomes (2 … 6, 4, 0 … 8). Entry 2 is far away.
  const std::vector<Affine> palette = {{{{0, -1, 0, 10}, {1, 0, 0, 0}, {0, 0, 1, 0}}},
                                       {{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}}},
                                       {{{1, 0, 0, 1e6f}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  Bounds b;
  ASSERT_EQ(palette_bounds(r.extents, palette, {}, b), Status::ok);
  const float least[] = {2, -1, 0}, most[] = {12, 4, 8};
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(b.box_min[c], least[c]);
    EXPECT_EQ(b.box_max[c], most[c]);
  }
  // From (7, 1.5, 4): entry 0's farthest corner is (12, -1, 0), entry 1's (2, 4, 0 or 8): both √(25 + 6.25 + 16).
  EXPECT_FLOAT_EQ(b.radius_m, std::sqrt(47.25f));
}

// Squares of such numbers are beyond a float; their root is not. Far apart, and as far as numbers go.
TEST(PaletteBounds, HaveARadiusWhereverTheyAre) {
  const test::TestMesh mesh = three_entries();
  const Reached r(mesh.view());
  for (const float scale : {1.0f, 1e12f, 1e19f, 1e29f, 1e36f}) {
    const std::vector<Affine> palette(3, Affine{{{scale, 0, 0, 0}, {0, scale, 0, 0}, {0, 0, scale, 0}}});
    Bounds b;
    ASSERT_EQ(palette_bounds(r.extents, palette, {}, b), Status::ok);
    // Boxes (-1 … 1, -2 … 2, 0) and (1 … 3, 2, 0 … 4): from (1, 0, 2) to (-1, ±2, 0) and (3, 2, 0 or 4), √12.
    EXPECT_NEAR(b.radius_m / scale, std::sqrt(12.0f), 1e-5f) << scale;
  }
}

TEST(PaletteBounds, FollowTheWeightsOfMorphTargets) {
  const test::TestMesh mesh = three_entries();
  Mesh view = mesh.view();
  // Moves the first vertex by (-2, 0, 1), the second by (0, 4, 0).
  const std::int16_t records[12] = {-4, 0, 0, 0, 0, 8, 0, 0, 2, 0, 0, 0};
  const MorphTarget target{0, 1, 0, kMorphsPositions, 0.5f, 0, 0, 0};
  const std::uint16_t block = 0;
  view.geometry.targets = {&target, 1};
  view.geometry.target_blocks = &block;
  view.geometry.target_records = records;
  const Reached r(view);
  ASSERT_EQ(r.extents.targets.size, 1u);
  const std::vector<Affine> palette(3, kNowhere);
  const auto expect_box = [&](float weight, const test::Vec3& least, const test::Vec3& most) {
    Bounds b;
    ASSERT_EQ(palette_bounds(r.extents, palette, {&weight, 1}, b), Status::ok);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(static_cast<double>(b.box_min[c]), least[c]) << weight;
      EXPECT_EQ(static_cast<double>(b.box_max[c]), most[c]) << weight;
    }
  };
  expect_box(0, {-1, -2, 0}, {3, 2, 4});
  expect_box(1, {-3, -2, 0}, {3, 6, 5});
  expect_box(-1, {-1, -6, -1}, {5, 2, 4});
}

Affine affine_of_noise(test::Random& random) {
  Affine out;
  for (auto& row : out.rows)
    for (float& x : row) x = static_cast<float>(random.between(-2, 2));
  return out;
}

std::size_t outside(const std::vector<float>& positions, const Bounds& b) {
  const float slack = 1e-5f * b.radius_m;
  std::size_t count = 0;
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    double squared = 0;
    bool in = true;
    for (int c = 0; c < 3; ++c) {
      const float x = positions[i + static_cast<std::size_t>(c)];
      in = in && x >= b.box_min[c] - slack && x <= b.box_max[c] + slack;
      squared += std::pow(static_cast<double>(x - b.centre(c)), 2);
    }
    count += !in || std::sqrt(squared) > static_cast<double>(b.radius_m + slack);
  }
  return count;
}

TEST(PaletteBounds, AreAboutEveryVertexOfAnyBlend) {
  std::size_t vertices = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const test::TestCharacter creature = test::make_character(seed, 9, 7, false);
    Mesh mesh = creature.mesh.view();
    const test::TestMorphs morphs(seed, mesh.geometry.slot_count, 5);
    const test::TestPoseSpace space(seed, mesh, 4);
    morphs.put(mesh.geometry);
    space.put(mesh.geometry);
    const Reached r(mesh);
    AlignedBlock memory(morphed_bytes(mesh.geometry));
    MorphedGeometry morphed;
    ASSERT_EQ(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed), Status::ok);
    ASSERT_EQ(morph(morphs.weights, morphed), Status::ok);
    Mesh moved = mesh;
    moved.geometry = morphed.geometry;
    test::Random random(seed);
    std::vector<Affine> palette(mesh.palette_size());
    for (Affine& a : palette) a = affine_of_noise(random);
    Bounds b;
    ASSERT_EQ(palette_bounds(r.extents, palette, morphs.weights, b), Status::ok);
    test::Skinned out(mesh.geometry.slot_count);
    ASSERT_EQ(skin_rigid(moved, palette, {out.positions, {}, {}}), Status::ok);
    EXPECT_EQ(outside(out.positions, b), 0u) << seed;
    ASSERT_EQ(skin_ssd(moved, palette, {out.positions, {}, {}}), Status::ok);
    EXPECT_EQ(outside(out.positions, b), 0u) << seed;
    std::vector<float> distances(psd_distance_count(mesh.geometry));
    ASSERT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
    ASSERT_EQ(skin_psd(moved, distances, palette, {out.positions, {}, {}}), Status::ok);
    EXPECT_EQ(outside(out.positions, b), 0u) << seed;
    vertices += out.positions.size() / 3;
  }
  EXPECT_GT(vertices, 2000u);
}

TEST(PaletteBounds, OfNothingAreEmpty) {
  Bounds b{{1, 1, 1}, {2, 2, 2}, 3};
  ASSERT_EQ(palette_bounds({}, {}, {}, b), Status::ok);
  EXPECT_TRUE(b.is_empty());
}

TEST(PaletteBounds, RefuseWhatDoesNotDo) {
  const test::TestMesh mesh = three_entries();
  AlignedBlock block(extents_bytes(mesh.view()) + 16);
  MeshExtents extents;
  EXPECT_EQ(make_extents(mesh.view(), {block.data(), extents_bytes(mesh.view()) - 1}, extents), Status::bad_argument);
  EXPECT_EQ(make_extents(mesh.view(), {block.data() + 1, block.size() - 1}, extents), Status::bad_argument);
  EXPECT_TRUE(extents.joints.empty());
  ASSERT_EQ(make_extents(mesh.view(), {block.data(), block.size()}, extents), Status::ok);
  const std::vector<Affine> two(2, kNowhere), three(3, kNowhere);
  MorphExtent target;
  extents.targets = {&target, 1};
  Bounds b;
  EXPECT_EQ(palette_bounds(extents, two, {}, b), Status::bad_argument);
  const float bad = std::numeric_limits<float>::infinity();
  EXPECT_EQ(palette_bounds(extents, three, {&bad, 1}, b), Status::bad_argument);
  EXPECT_TRUE(b.is_empty());
}

}  // namespace
}  // namespace marrow
