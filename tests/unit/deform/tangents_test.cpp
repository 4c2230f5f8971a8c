#include "deform/tangents.h"

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

TEST(Tangents, SpanTheSurfaceOfASphereLikeCylinder) {
  const SkinnedMesh mesh = cylinder();
  const Surface surface(mesh);
  const std::vector<glm::dvec3> normals = vertex_normals(mesh.positions, mesh.indices);
  const TangentOperator tangents(surface, mesh.positions, normals);
  for (std::size_t v = 80; v < 1920; ++v) {  // not on the rims
    const auto [s, t] = tangents.at(v, mesh.positions);
    EXPECT_NEAR(glm::length(s), 1, 0.02);
    EXPECT_NEAR(glm::length(t), 1, 0.02);
    EXPECT_NEAR(glm::dot(glm::normalize(glm::cross(s, t)), glm::dvec3(0, mesh.positions[v].y, mesh.positions[v].z)), 1,
                1e-4);
  }
}

// A linear map takes tangents along exactly.
TEST(Tangents, FollowALinearMap) {
  const SkinnedMesh mesh = cylinder();
  const Surface surface(mesh);
  const TangentOperator tangents(surface, mesh.positions, vertex_normals(mesh.positions, mesh.indices));
  const glm::dmat3 m(1, 2, 0, -1, 3, 1, 0.5, 0, 2);
  Positions mapped;
  for (const glm::dvec3& p : mesh.positions) mapped.push_back(m * p + glm::dvec3(1, 2, 3));
  for (std::size_t v = 0; v < mapped.size(); ++v) {
    const auto before = tangents.at(v, mesh.positions), after = tangents.at(v, mapped);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(glm::length(after[i] - m * before[i]), 1e-10);
  }
}

TEST(Tangents, AreNoneWhereNeighboursLieOnALine) {
  SkinnedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.indices = {0, 1, 2};
  mesh.influences.assign(3, {{0, 1.0}});
  mesh.joint_count = 1;
  const Surface surface(mesh);
  const TangentOperator tangents(surface, mesh.positions, std::vector<glm::dvec3>(3, glm::dvec3(0, 0, 1)));
  for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(tangents.at(v, mesh.positions)[0], glm::dvec3(0));
}

}  // namespace
}  // namespace marrow::deform
