// The mesh that `marrow bench` skins is the one that docs/benchmarks.md describes.
#include "bench/vertices.h"

#include <cmath>

#include <gtest/gtest.h>

#include "bench/workload.h"
#include "marrow/skin.h"

namespace marrow::tools {
namespace {

TEST(BenchNoise, IsXorshift32) {
  Noise noise;  // by hand from Marsaglia's shifts 13, 17, 5
  EXPECT_EQ(noise.next(), static_cast<float>(8886362) / 16777216);
  EXPECT_EQ(noise.next(), static_cast<float>(1399588) / 16777216);
  EXPECT_EQ(noise.next(), static_cast<float>(4727028) / 16777216);
}

// Walks one mesh vertex by vertex.
void expect_described_mesh(std::uint32_t vertex_count, std::uint32_t influences) {
  const GeneratedMesh mesh(vertex_count, influences);
  const Geometry& g = mesh.view().geometry;
  ASSERT_EQ(g.runs.size, 67u);
  std::uint32_t v = 0, block = 0;
  for (std::uint32_t r = 0; r < 67; ++r) {
    ASSERT_EQ(g.runs[r].influences, influences);
    for (std::uint32_t i = 0; i < g.runs[r].vertex_count; ++i, ++v) {
      EXPECT_EQ(67 * v / vertex_count, r) << v;
      const std::size_t lane = i % 4, at = block + i / 4;
      const float* const skin = g.skin + at * 4 * (3 + influences - 1) + lane;
      float last = 1;
      for (std::uint32_t k = 0; k < influences; ++k) {
        const float w = k + 1 < influences ? skin[4 * (3 + k)] : last;
        EXPECT_GT(w, 0.01f) << v;
        last -= w;
      }
      const float* const d = g.as_residual + at * 16 * influences + lane;
      float sum = 0;
      for (std::uint32_t k = 0; k < influences; ++k) {
        EXPECT_NE(d[16 * k], 0) << v;
        sum += d[16 * k + 12];
      }
      EXPECT_EQ(sum, 0) << v;
      const float* const n = g.normals + at * 12 + lane;
      EXPECT_NEAR(std::hypot(n[0], n[4], n[8]), 1, 1e-6) << v;
      const float* const t = g.tangents + at * 16 + lane;
      EXPECT_NEAR(std::hypot(t[0], t[4], t[8]), 1, 1e-6) << v;
      EXPECT_EQ(std::abs(t[12]), 1) << v;
    }
    for (std::uint32_t k = 0; k < influences; ++k) EXPECT_EQ(g.sets[r * influences + k], (r + k) % 67);
    block += (g.runs[r].vertex_count + 3) / 4;
  }
  EXPECT_EQ(v, vertex_count);
  EXPECT_EQ(g.vertex_count, vertex_count);
  EXPECT_EQ(g.slot_count, 4 * block);
}

TEST(BenchVertices, AreAsDescribed) {
  for (const std::uint32_t influences : {1u, 2u, 3u, 4u, 8u}) {
    expect_described_mesh(1000, influences);
    expect_described_mesh(67, influences);
  }
  expect_described_mesh(100000, 4);
}

// Also: nothing is read outside the streams, which a sanitizer would see.
TEST(BenchVertices, StayWhereTheyAreUnderTheIdentity) {
  const GeneratedMesh mesh(1000, 4);
  const Geometry& g = mesh.view().geometry;
  const std::vector<Affine> identity(kMeshJoints, Affine{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  std::vector<float> positions(3 * g.slot_count), normals(positions.size()), tangents(4 * g.slot_count);
  ASSERT_EQ(skin_ssd(mesh.view(), identity, {.positions = positions, .normals = normals, .tangents = tangents}),
            Status::ok);
  for (std::size_t slot = 0; slot < g.slot_count; ++slot)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(positions[3 * slot + c], g.skin[slot / 4 * 24 + 4 * c + slot % 4], 1e-6) << slot;
}

TEST(BenchVertices, PaletteTurnsAndMoves) {
  const std::vector<Affine> palette = noise_palette(67);
  ASSERT_EQ(palette.size(), 67u);
  for (const Affine& m : palette) {
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        float dot = 0;
        for (int c = 0; c < 3; ++c) dot += m.rows[a][c] * m.rows[b][c];
        EXPECT_NEAR(dot, a == b ? 1 : 0, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace marrow::tools
