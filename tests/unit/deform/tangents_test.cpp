#include "deform/helpers/tangents.h"

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

// A tube's own normals, by its triangles' areas.
TEST(Tangents, NormalsOfABentCylinderAreItsOwn) {
  const SkinnedMesh mesh = cylinder();
  const Coordinates coordinates = lift(mesh);
  const TangentCoordinates tangents =
      tangent_coordinates(coordinates, mesh, vertex_normals(mesh.positions, mesh.indices), {});
  Positions posed;
  double sum = 0, worst = 0;
  std::size_t count = 0;
  for (const double bend : {0.0, 0.75, 1.5}) {
    const Pose pose = cylinder_pose(bend, bend / 2);
    animation_space(coordinates)(pose, posed);
    const std::vector<glm::dvec3> own = vertex_normals(posed, mesh.indices), got = surface_normals(tangents, pose);
    for (std::size_t v = 80; v < 1920; ++v, ++count) {  // not on the rims
      const double off = angle_deg(got[v], own[v]);
      EXPECT_LT(off, bend == 0 ? 1e-6 : 20.0) << "bend " << bend << ", vertex " << v;
      sum += off;
      worst = std::max(worst, off);
    }
  }
  std::printf("normals: %.3f deg on average, %.3f at most\n", sum / static_cast<double>(count), worst);
  EXPECT_LT(sum / static_cast<double>(count), 0.5);
}

// A linear map of everything takes normals through its inverse transpose, turned round where it mirrors.
TEST(Tangents, FollowALinearMap) {
  const SkinnedMesh mesh = cylinder();
  const std::vector<glm::dvec3> normals = vertex_normals(mesh.positions, mesh.indices);
  const TangentCoordinates tangents = tangent_coordinates(lift(mesh), mesh, normals, {});
  for (const double mirror : {1.0, -1.0}) {
    const glm::dmat3 m(mirror, 2 * mirror, 0, -1, 3, 1, 0.5, 0, 2);
    const Pose pose(2, Matrix(m[0], m[1], m[2], glm::dvec3(1, 2, 3)));
    const std::vector<glm::dvec3> got = surface_normals(tangents, pose);
    for (std::size_t v = 0; v < got.size(); ++v)
      EXPECT_LT(angle_deg(got[v], glm::inverse(glm::transpose(m)) * normals[v]), 1e-6);
  }
}

// Without an area the blend has the say: here ½ (1, 2) of two scales along x.
TEST(Tangents, OnALineGoThroughTheBlend) {
  SkinnedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.indices = {0, 1, 2};
  mesh.influences.assign(3, {{0, 0.5}, {1, 0.5}});
  mesh.joint_count = 2;
  const glm::dvec3 slanted = glm::normalize(glm::dvec3(3, 0, 1));
  const TangentCoordinates tangents = tangent_coordinates(lift(mesh), mesh, {slanted, slanted, slanted}, {});
  Pose pose(2, Matrix(1.0));
  pose[1][0].x = 2;
  for (const glm::dvec3& n : surface_normals(tangents, pose))
    EXPECT_LT(angle_deg(n, {2, 0, 1}), 1e-6);  // (3 / 1.5, 0, 1)
}

}  // namespace
}  // namespace marrow::deform
