#include "deform/simplify/subdivide.h"

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

Positions placed(const std::vector<Combination>& vertices, const Positions& source) {
  Positions out;
  for (const Combination& c : vertices) out.push_back(combined(c, source));
  return out;
}

// By hand. A tetrahedron's points have three neighbours: β = (5/8 - (3/8 - 1/8)²) / 3 = 3/16.
TEST(Subdivide, TetrahedronByHand) {
  const Positions at = {{0, 0, 0}, {16, 0, 0}, {0, 16, 0}, {0, 0, 16}};
  const FinerSurface out = subdivide(plain(4, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}), 4);
  const Positions finer = placed(out.points, at);
  ASSERT_EQ(finer.size(), 10u);
  EXPECT_EQ(out.indices.size(), 16u * 3);
  EXPECT_LT(glm::length(finer[0] - glm::dvec3(3, 3, 3)), 1e-12);
  EXPECT_LT(glm::length(finer[1] - glm::dvec3(7, 3, 3)), 1e-12);
  // The edge 0-1, between 2 and 3: 3/8 (16, 0, 0) + 1/8 (0, 16, 16).
  EXPECT_LT(glm::length(finer[4] - glm::dvec3(6, 2, 2)), 1e-12);
}

// A square of two triangles: its corners lie on the border, and so do the middles of its sides.
TEST(Subdivide, BordersAreSplines) {
  const Positions at = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
  const FinerSurface out = subdivide(plain(4, {0, 1, 2, 0, 2, 3}), 4);
  const Positions finer = placed(out.points, at);
  ASSERT_EQ(finer.size(), 9u);
  EXPECT_LT(glm::length(finer[0] - glm::dvec3(1, 1, 0)), 1e-12);
  EXPECT_LT(glm::length(finer[4] - glm::dvec3(4, 0, 0)), 1e-12);  // 0-1
  EXPECT_LT(glm::length(finer[5] - glm::dvec3(4, 4, 0)), 1e-12);  // 0-2: 3/8 · 8 + 1/8 · 8
}

// Six neighbours: β = 1/16; a flat regular neighbourhood stays where it is.
TEST(Subdivide, FlatAndRegularStays) {
  Positions at = {{0, 0, 0}};
  std::vector<std::uint32_t> indices;
  for (std::uint32_t k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3;
    at.emplace_back(std::cos(angle), std::sin(angle), 0);
    indices.insert(indices.end(), {0, k + 1, (k + 1) % 6 + 1});
  }
  const FinerSurface out = subdivide(plain(7, indices), 7);
  ASSERT_EQ(out.points[0].size(), 7u);
  EXPECT_NEAR(out.points[0][0].share, 10.0 / 16, 1e-15);
  EXPECT_NEAR(out.points[0][1].share, 1.0 / 16, 1e-15);
  EXPECT_LT(glm::length(placed(out.points, at)[0]), 1e-15);
}

// Vertices of a seam have middles of their own, of their own two ends, at one point.
TEST(Subdivide, SeamsStaySeams) {
  SeamedSurface surface = plain(4, {0, 1, 2, 4, 5, 3});
  surface.point_of = {0, 1, 2, 3, 0, 2};
  surface.chart_of = {0, 1, 2, 3, 4, 5};
  const FinerSurface out = subdivide(surface, 4);
  EXPECT_EQ(out.points.size(), 9u);
  EXPECT_EQ(out.vertices.size(), 6u + 6);
  std::size_t doubled = 0;
  for (std::uint32_t v = 6; v < 12; ++v)
    for (std::uint32_t w = v + 1; w < 12; ++w) {
      if (out.point_of[v] != out.point_of[w]) continue;
      ++doubled;
      EXPECT_EQ(out.vertices[v][0].vertex + out.vertices[w][0].vertex, 0u + 4);
      EXPECT_EQ(out.vertices[v][1].vertex + out.vertices[w][1].vertex, 2u + 5);
      EXPECT_EQ(out.vertices[v][0].share, 0.5);
    }
  EXPECT_EQ(doubled, 1u);
}

TEST(Subdivide, TakesWhatIsNoManifold) {
  const Positions at = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  const FinerSurface out = subdivide(plain(5, {0, 1, 2, 0, 1, 3, 0, 1, 4, 2, 2, 3}), 5);
  const Positions finer = placed(out.points, at);
  for (const glm::dvec3& v : finer) EXPECT_TRUE(glm::length(v) <= 2);
  EXPECT_EQ(finer[0], at[0]) << "more than two triangles meet at its edge";
}

// Exactly, as it is linear: the cylinder in a pose, subdivided, is the subdivided cylinder's coordinates in that pose.
TEST(Subdivide, PosingThenSubdividingIsSubdividingThenPosing) {
  const SkinnedMesh mesh = cylinder();
  const FinerSurface out = subdivide(plain(mesh.positions.size(), mesh.indices), mesh.positions.size());
  Coordinates finer;
  const Coordinates lifted = lift(mesh);
  for (const Combination& c : out.points) {
    double sum = 0;
    for (const Share& s : c) sum += s.share;
    EXPECT_NEAR(sum, 1, 1e-12);
    finer.push_back(combined(c, lifted));
  }
  EXPECT_EQ(out.indices.size(), 4 * mesh.indices.size());
  for (const Pose& pose : random_cylinder_poses(5, 1))
    EXPECT_LT(farthest(at(animation_space(finer), pose), placed(out.points, at(ssd(mesh), pose))), 1e-11);
}

}  // namespace
}  // namespace marrow::deform
