// The compact attributes themselves: sums that are exact, directions that survive.
#include "gles3/mesh/encode.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "gl/support/worst.h"
#include "gles3/mesh/gpu_mesh.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

TEST(Encode, WeightsSumExactly) {
  Random random(1);
  for (int round = 0; round < 20000; ++round) {
    const std::uint32_t count = 1 + random.below(8);
    float weights[8] = {};
    float left = 1;
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
      weights[i] = static_cast<float>(random.between(0, 1)) * left;
      left -= weights[i];
    }
    weights[count - 1] = left;
    for (const std::int32_t total : {65535, 32767, 16383}) {
      std::int32_t out[8] = {};
      gles3::quantise_sum(weights, count, total, out);
      ASSERT_EQ(std::accumulate(out, out + count, 0), total);
      for (std::uint32_t i = 0; i < count; ++i) {
        ASSERT_LT(std::fabs(static_cast<float>(out[i]) - weights[i] * static_cast<float>(total)), 1.01f);
      }
    }
  }
}

TEST(Encode, NegativeWeightsSumExactly) {
  const float weights[] = {1.75f, -0.5f, -0.25f};
  std::int32_t out[3] = {};
  gles3::quantise_sum(weights, 3, 16383, out);
  EXPECT_EQ(out[0] + out[1] + out[2], 16383);
  EXPECT_NEAR(out[1], -8191.5, 1);
}

TEST(Encode, WeightsThatDoNotSumToOneAreMadeTo) {
  const float weights[] = {0.5f, 0.25f};
  std::int32_t out[2] = {};
  gles3::quantise_sum(weights, 2, 1000, out);
  EXPECT_EQ(out[0] + out[1], 1000);
}

TEST(Encode, HugeWeightsOfADamagedFileSumExactlyToo) {
  const float weights[] = {3e38f, -3e38f, 1e30f};
  std::int32_t out[3] = {};
  gles3::quantise_sum(weights, 3, 32767, out);
  EXPECT_EQ(out[0] + out[1] + out[2], 32767);
}

// Sums of a damaged file's finite numbers may be infinite, or no numbers; those are held, or 0.
TEST(Encode, WeightsThatAreNotFiniteSumExactlyToo) {
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    const float weights[] = {0.5f, bad, 0.25f};
    std::int32_t out[3] = {};
    gles3::quantise_sum(weights, 3, 32767, out);
    EXPECT_EQ(out[0] + out[1] + out[2], 32767);
    EXPECT_NEAR(out[1], std::isnan(bad) ? 0 : bad > 0 ? 1e6 : -1e6, 1);
  }
}

// As large as a file may have them: coordinates overflow on the way, and become some 16-bit numbers.
TEST(Encode, AnyFiniteNumbersAreEncoded) {
  Random random(3);
  const float sizes[] = {0, 1e-45f, 1, -1, 1e19f, -1e30f, 3e38f, -3e38f};
  for (int round = 0; round < 200; ++round) {
    const auto any = [&] { return static_cast<double>(sizes[random.below(8)]); };
    TestRun run{{0, 1, 2}, {}};
    for (int v = 0; v < 4; ++v) {
      TestVertex vertex;
      vertex.position = {any(), any(), any()};
      vertex.weights = {any(), any(), any()};
      for (int j = 0; j < 3; ++j) vertex.residual.push_back({any(), any(), any(), any()});
      run.vertices.push_back(vertex);
    }
    const TestMesh source({run}, std::vector<Map>(3), true);
    const Mesh mesh = with_box(source);
    const gles3::VertexLayout layout = gles3::make_layout(mesh, false, false);
    const gles3::Quantisation q = gles3::make_quantisation(mesh.geometry);
    std::vector<std::byte> out(4 * std::max(layout.ssd_stride, layout.as_stride));
    gles3::encode_ssd(mesh.geometry, layout, q, out.data());
    for (const bool whole : {false, true}) gles3::encode_as(mesh.geometry, layout, q, nullptr, whole, out.data());
    EXPECT_GT(q.coordinate_one, 0);
  }
}

// The specification's decoding, written out again.
void from_octahedron(const float e[2], float out[3]) {
  out[0] = e[0];
  out[1] = e[1];
  out[2] = 1 - std::fabs(e[0]) - std::fabs(e[1]);
  if (out[2] >= 0) return;
  out[0] = (1 - std::fabs(e[1])) * (e[0] >= 0 ? 1.0f : -1.0f);
  out[1] = (1 - std::fabs(e[0])) * (e[1] >= 0 ? 1.0f : -1.0f);
}

TEST(Encode, NormalsSurviveSixteenBits) {
  Random random(2);
  double worst = 0;
  for (int round = 0; round < 100000; ++round) {
    const Quat q = random.rotation();
    const Vec3 n = normalised(Vec3{q[0], q[1], q[2] + 1e-6});
    const float unit[3] = {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])};
    float e[2], back[3];
    gles3::to_octahedron(unit, e);
    for (float& c : e) c = std::floor(c * 32767 + 0.5f) / 32767;
    from_octahedron(e, back);
    worst = std::max(worst, angle_deg(unit, back));
  }
  std::printf("octahedral snorm16x2: %.5f deg at most\n", worst);
  EXPECT_LT(worst, 0.005);
}

}  // namespace
}  // namespace marrow::test
