#include "deform/animation_space.h"

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

TEST(AnimationSpace, LiftIsSsd) {
  const SkinnedMesh mesh = cylinder();
  const Coordinates lifted = lift(mesh);
  EXPECT_LT(farthest(at(animation_space(lifted), kBent), at(ssd(mesh), kBent)), 1e-12);
}

// In any pose: SSD's positions, smoothed, and what smoothing took from the bind pose carried by the smoothed weights.
// Nothing is left out here, as there are but two joints.
TEST(AnimationSpace, SmoothedSsdIsSmoothing) {
  const SkinnedMesh mesh = cylinder();
  const Surface surface(mesh);
  const int iterations = 12;
  const double step = 0.7;
  const auto smooth = [&](auto values) {
    auto scratch = values;
    for (int i = 0; i < iterations; ++i) surface.smooth(values, step, scratch);
    return values;
  };
  std::vector<double> weight(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < weight.size(); ++v)
    for (const Influence& i : mesh.influences[v])
      if (i.joint == 1) weight[v] = i.weight;
  weight = smooth(weight);
  const Positions bind = smooth(mesh.positions);
  Positions expected = smooth(at(ssd(mesh), kBent));
  for (std::size_t v = 0; v < expected.size(); ++v) {
    const glm::dvec3 lost = mesh.positions[v] - bind[v];
    expected[v] += linear_of(kBent[0]) * lost * (1 - weight[v]) + linear_of(kBent[1]) * lost * weight[v];
  }
  const Coordinates smoothed = smoothed_ssd(mesh, surface, iterations, step, 4);
  // Weights below a ten-thousandth are left out.
  EXPECT_LT(farthest(at(animation_space(smoothed), kBent), expected), 2e-3);
  EXPECT_LT(farthest(at(animation_space(smoothed), cylinder_pose(0, 0)), mesh.positions), 1e-12);
}

TEST(AnimationSpace, SmoothedWeightsSumToOneOnFewJoints) {
  SkinnedMesh mesh = cylinder();
  mesh.joint_count = 5;
  for (std::size_t v = 0; v < mesh.influences.size(); ++v)
    mesh.influences[v] = {{static_cast<std::uint32_t>(v % 5), 1.0}};
  const Coordinates smoothed = smoothed_ssd(mesh, Surface(mesh), 5, 0.5, 3);
  for (const std::vector<Coordinate>& vertex : smoothed) {
    double sum = 0;
    for (const Coordinate& c : vertex) sum += c.q.w;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_LE(vertex.size(), 3u);
  }
}

}  // namespace
}  // namespace marrow::deform
