// The judge judged: the reference evaluator against numbers worked out by hand.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "road/reference.h"
#include "support/places.h"
#include "unit/cook/gltf/document.h"

namespace marrow::test {
namespace {

SourceChannel channel(const char* path, const char* interpolation, std::vector<double> times_s,
                      std::vector<Quat> values) {
  SourceChannel c;
  c.path = path;
  c.interpolation = interpolation;
  c.times_s = std::move(times_s);
  c.values = std::move(values);
  return c;
}

TEST(Reference, StepLinearAndCubicByHand) {
  const std::vector<Quat> two = {{1, 2, 3, 0}, {3, 2, 1, 0}};
  EXPECT_EQ(sample_channel(channel("translation", "STEP", {1, 2}, two), 1.9), two[0]);
  EXPECT_EQ(sample_channel(channel("translation", "STEP", {1, 2}, two), 2), two[1]);
  EXPECT_EQ(sample_channel(channel("translation", "LINEAR", {1, 2}, two), 1.5), (Quat{2, 2, 2, 0}));
  EXPECT_EQ(sample_channel(channel("translation", "LINEAR", {1, 2}, two), 0), two[0]);
  EXPECT_EQ(sample_channel(channel("translation", "LINEAR", {1, 2}, two), 5), two[1]);
  // At the middle of two seconds: ½ (v0 + v1) + 2 (out - in) / 8.
  const Quat cubic = sample_channel(
      channel("scale", "CUBICSPLINE", {1, 3}, {{}, {1, 1, 1, 0}, {4, 0, 0, 0}, {0, 8, 0, 0}, {3, 3, 3, 0}, {}}), 2);
  EXPECT_NEAR(cubic[0], 3, 1e-12);
  EXPECT_NEAR(cubic[1], 0, 1e-12);
  EXPECT_NEAR(cubic[2], 2, 1e-12);
}

TEST(Reference, SlerpTakesTheShorterArc) {
  const Quat a = {0, 0, 0, 1}, b = {0, 0, -std::sin(0.5), -std::cos(0.5)};  // -(half a radian's half angle)
  const Quat q = sample_channel(channel("rotation", "LINEAR", {0, 1}, {a, b}), 0.5);
  EXPECT_NEAR(q[2], std::sin(0.25), 1e-12);
  EXPECT_NEAR(q[3], std::cos(0.25), 1e-12);
}

TEST(Reference, MorphsByHand) {
  // face.gltf at rest: node 1 is turned by 0.6 + 0.8 k above; smile has 0.5 and moves vertex 0 by 0.1 along x.
  const Reference reference(in_golden("face.gltf"));
  const ReferencePose pose = reference.rest();
  ASSERT_EQ(pose.positions.size(), 8u);
  // (0.05, 0, 0) turned about z by 2 acos 0.8: cos 0.28, sin 0.96.
  EXPECT_NEAR(pose.positions[0][0], 0.05 * 0.28, 1e-8);
  EXPECT_NEAR(pose.positions[0][1], 0.05 * 0.96, 1e-8);
  // mask, moved by 2 along x before: 0.25 of the same, and 0.75 of 0.5 along z for every vertex.
  EXPECT_NEAR(pose.positions[4][0], 2.025 * 0.28, 1e-8);
  EXPECT_NEAR(pose.positions[4][2], 0.375, 1e-8);
}

TEST(Reference, KeepsTheEightLargestInfluences) {
  std::vector<SourceInfluence> all;
  for (int j = 0; j < 10; ++j) all.push_back({j, j == 4 ? 0.0 : 0.01 * (j + 1)});
  all.push_back({0, 0.5});  // joint 0 again
  const std::vector<SourceInfluence> kept = kept_influences(all);
  ASSERT_EQ(kept.size(), 8u);
  EXPECT_EQ(kept[0].joint, 0);
  EXPECT_EQ(kept[1].joint, 9);
  double sum = 0;
  for (const SourceInfluence& k : kept) {
    sum += k.weight;
    EXPECT_NE(k.joint, 4);
    EXPECT_NE(k.joint, 1) << "the smallest";
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

// The arm of the golden file: scaled by 2, turned a quarter about z and moved by (0, 0, 1) above the shoulder, so a
// bind vertex (x, y, z) rests at (-2 y, 2 x, 2 z + 1), whatever its node's own transform.
TEST(Reference, RestPoseOfTheGoldenFileByHand) {
  const Reference reference(in_golden("tiny.gltf"));
  const ReferencePose rest = reference.rest();
  ASSERT_EQ(rest.positions.size(), 29u);
  const auto expect = [](const Vec3& got, const Vec3& want) { EXPECT_LT(length(minus(got, want)), 1e-6) << got[0]; };
  expect(rest.positions[0], {0, 0.5, 1});    // ring 0, (0.25, 0, 0)
  expect(rest.positions[21], {-5, 0, 1.5});  // ring 5, (0, 2.5, 0.25)
  expect(rest.normals[0], {0, 1, 0});
  expect(rest.normals[1], {0, 0, 1});
  expect(rest.tangents[0], {-1, 0, 0});
  // The hat hangs half a metre beyond the wrist at y = 2, mirrored in z: (-.5, 0, -.5) → (-.5, 2.5, .5) → scene.
  expect(rest.positions[24], {-5, -1, 2});
  expect(rest.positions[28], {-6.5, 0, 1});
}

// Vertex 3 of two bones, one metre apart, is at (3, 9, 0) and follows the upper one: two levels and three more, of one
// and a half roundings each. The longest way that it can have come is √3 times its way into the joint's space, which is
// √3 times √90 and one: as long as matrices of three unit rows may make it.
TEST(Reference, NoiseOfFloatsByHand) {
  cook::Builder document = cook::skinned();
  const Reference reference(read_source_text(document.text()));
  const ReferencePose rest = reference.rest();
  ASSERT_EQ(rest.float_noise.size(), 4u);
  const double longest = std::sqrt(3.0) * (std::sqrt(3.0) * std::sqrt(90.0) + 1);
  EXPECT_NEAR(rest.float_noise[3], 1.5 * 0x1p-24 * 5 * longest, 1e-12);
  // The origins of both bones: one level and three, and nothing is long; two and three, and √3 metres.
  const std::vector<double> origins = reference.node_noise_at(0, 0);
  ASSERT_EQ(origins.size(), 3u);
  EXPECT_EQ(origins[1], 0);
  EXPECT_NEAR(origins[2], 1.5 * 0x1p-24 * 5 * std::sqrt(3.0), 1e-12);
}

}  // namespace
}  // namespace marrow::test
