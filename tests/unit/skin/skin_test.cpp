// The deformers against their definitions in double precision, and against arithmetic done by hand.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/rig.h"
#include "support/skinned.h"

namespace marrow {
namespace {

using test::Map;
using test::Skinned;
using test::TestMesh;
using test::TestRun;
using test::TestVertex;
using test::Vec3;

enum class Kind { rigid, ssd, as };

Skinned skin(const TestMesh& mesh, const std::vector<Map>& palette, Kind kind,
             NormalTransform transform = NormalTransform::inverse_transpose) {
  const Mesh view = mesh.view();
  std::vector<Affine> entries;
  for (const Map& m : palette) entries.push_back(test::to_affine(m));
  Skinned out(mesh.slot_count);
  std::vector<float> coordinates(as_coordinate_count(view.geometry));
  EXPECT_EQ(as_coordinates(view.geometry, coordinates), Status::ok);
  const SkinOutput output = out.output(transform);
  const Status status = kind == Kind::rigid ? skin_rigid(view, entries, output)
                        : kind == Kind::ssd ? skin_ssd(view, entries, output)
                                            : skin_as(view, coordinates, entries, output);
  EXPECT_EQ(status, Status::ok);
  return out;
}

// What a deformer makes of one vertex: Σ M_j q_j and the blend whose 3×3 part normals go through.
struct Expected {
  Vec3 position{0, 0, 0};
  Map blend{{{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}};
};

Expected expect(const TestRun& run, const TestVertex& v, const std::vector<Map>& palette, Kind kind) {
  std::size_t largest = 0;
  for (std::size_t k = 1; k < run.set.size(); ++k)
    if (v.weights[k] > v.weights[largest]) largest = k;
  Expected e;
  for (std::size_t k = 0; k < run.set.size(); ++k) {
    const double w = kind == Kind::rigid ? (k == largest ? 1.0 : 0.0) : v.weights[k];
    std::array<double, 4> q = {w * v.position[0], w * v.position[1], w * v.position[2], w};
    for (std::size_t i = 0; kind == Kind::as && !v.residual.empty() && i < 4; ++i) q[i] += v.residual[k][i];
    const Map& m = palette[run.set[k]];
    for (std::size_t r = 0; r < 3; ++r) {
      e.position[r] += m.rows[r][0] * q[0] + m.rows[r][1] * q[1] + m.rows[r][2] * q[2] + m.rows[r][3] * q[3];
      for (int c = 0; c < 4; ++c) e.blend.rows[r][c] += q[3] * m.rows[r][c];
    }
  }
  return e;
}

// Every vertex of every run; returns how many normals could be compared.
int compare(const TestMesh& mesh, const std::vector<Map>& palette, Kind kind) {
  const Skinned got = skin(mesh, palette, kind);
  int directions = 0;
  for (std::size_t r = 0; r < mesh.source.size(); ++r) {
    for (std::size_t i = 0; i < mesh.source[r].vertices.size(); ++i) {
      const TestVertex& v = mesh.source[r].vertices[i];
      const Expected want = expect(mesh.source[r], v, palette, kind);
      const std::size_t slot = mesh.slot(r, i);
      EXPECT_LT(test::length(test::minus(Skinned::three(got.positions, slot), want.position)), 5e-6) << "slot " << slot;
      if (test::invertibility(want.blend) < 1e-2) continue;
      ++directions;
      const Vec3 normal = Skinned::three(got.normals, slot), tangent = Skinned::three(got.tangents, slot, 4);
      EXPECT_LT(test::angle_deg(normal, test::normal(want.blend, v.normal)), 0.02) << "slot " << slot;
      EXPECT_LT(test::angle_deg(tangent, test::direction(want.blend, v.tangent)), 0.02) << "slot " << slot;
      EXPECT_NEAR(test::length(normal), 1, 1e-6);
      EXPECT_NEAR(test::length(tangent), 1, 1e-6);
      EXPECT_EQ(std::fabs(got.tangents[slot * 4 + 3]), 1.0f);
    }
  }
  return directions;
}

// The same with NormalTransform::blended_matrix; returns how many vertices were compared.
std::size_t compare_blended(const TestMesh& mesh, const std::vector<Map>& palette, Kind kind) {
  const Skinned got = skin(mesh, palette, kind, NormalTransform::blended_matrix);
  const Skinned exact = skin(mesh, palette, kind);
  EXPECT_EQ(got.positions, exact.positions) << "positions know nothing of normals";
  std::size_t compared = 0;
  for (std::size_t r = 0; r < mesh.source.size(); ++r) {
    const Map& last = palette[mesh.source[r].set.back()];
    for (std::size_t i = 0; i < mesh.source[r].vertices.size(); ++i, ++compared) {
      const TestVertex& v = mesh.source[r].vertices[i];
      const Expected want = expect(mesh.source[r], v, palette, kind);
      const std::size_t slot = mesh.slot(r, i);
      const Vec3 normal = Skinned::three(got.normals, slot), tangent = Skinned::three(got.tangents, slot, 4);
      EXPECT_LT(test::length(test::minus(normal, test::direction(want.blend, v.normal))), 2e-6) << "slot " << slot;
      EXPECT_LT(test::length(test::minus(tangent, test::direction(want.blend, v.tangent))), 2e-6) << "slot " << slot;
      const bool mirrors = test::determinant(kind == Kind::rigid ? want.blend : last) < 0;
      EXPECT_EQ(got.tangents[slot * 4 + 3], static_cast<float>(mirrors ? -v.sign : v.sign)) << "slot " << slot;
    }
  }
  return compared;
}

std::vector<Map> random_palette(std::uint64_t seed, std::size_t count, const Vec3& scale) {
  test::Random random(seed);
  std::vector<Map> out;
  for (std::size_t i = 0; i < count; ++i) {
    const test::Quat rotation = random.rotation();
    const Vec3 translation{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    // As floats, so that the expected values see the numbers that the deformer sees.
    out.push_back(test::to_map(test::to_affine(test::from_trs(translation, rotation, scale))));
  }
  return out;
}

class SkinEveryWay : public ::testing::TestWithParam<Kind> {};

TEST_P(SkinEveryWay, OneToEightInfluences) {
  const test::TestCharacter c = test::make_character(11, 40, 9, false);
  ASSERT_EQ(c.mesh.source.size(), 8u);
  EXPECT_GT(compare(c.mesh, random_palette(1, 40, {1, 1, 1}), GetParam()), 40);
}

TEST_P(SkinEveryWay, UnevenScale) {
  const test::TestCharacter c = test::make_character(12, 40, 5, false);
  EXPECT_GT(compare(c.mesh, random_palette(2, 40, {0.5, 1, 2}), GetParam()), 20);
}

TEST_P(SkinEveryWay, Mirrored) {
  const test::TestCharacter c = test::make_character(13, 40, 5, false);
  EXPECT_GT(compare(c.mesh, random_palette(3, 40, {1, -1, 1}), GetParam()), 20);
}

TEST_P(SkinEveryWay, Residuals) {
  const test::TestCharacter c = test::make_character(14, 40, 6, true);
  EXPECT_GT(compare(c.mesh, random_palette(4, 40, {1, 1, 1}), GetParam()), 20);
}

TEST_P(SkinEveryWay, BlendedMatrix) {
  const Vec3 scales[] = {{1, 1, 1}, {0.5, 1, 2}, {1, -1, 1}};
  int cases = 0;
  for (const bool residuals : {false, true}) {
    const test::TestCharacter c = test::make_character(17, 40, 9, residuals);
    ASSERT_EQ(c.mesh.source.size(), 8u) << "a run for each number of influences";
    for (const Vec3& scale : scales) {
      EXPECT_EQ(compare_blended(c.mesh, random_palette(7, 40, scale), GetParam()), c.mesh.vertex_count);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 6);
}

INSTANTIATE_TEST_SUITE_P(Deformers, SkinEveryWay, ::testing::Values(Kind::rigid, Kind::ssd, Kind::as));

TEST(Skin, HalfAndHalfByHand) {
  // One joint stays, the other moves by (2, 0, 0) and turns half a turn about z: the blend maps (1, 1, 1) to
  // ½ (1, 1, 1) + ½ (2 - 1, -1, 1).
  const TestMesh mesh({{{0, 1}, {{{1, 1, 1}, {0, 0, 1}, {1, 0, 0}, 1, {0.5, 0.5}, {}}}}}, {{}, {}});
  const std::vector<Map> palette = {{}, {{{-1, 0, 0, 2}, {0, -1, 0, 0}, {0, 0, 1, 0}}}};
  const Skinned ssd = skin(mesh, palette, Kind::ssd);
  for (std::size_t slot = 0; slot < 4; ++slot) {  // the vertex and its padding
    EXPECT_EQ(ssd.positions[slot * 3], 1.0f);
    EXPECT_EQ(ssd.positions[slot * 3 + 1], 0.0f);
    EXPECT_EQ(ssd.positions[slot * 3 + 2], 1.0f);
  }
  // The blend squashes x and y to nothing: the normal along z survives in the limit, and must not be NaN here.
  for (const float n : ssd.normals) EXPECT_EQ(n, n);
  for (const float t : ssd.tangents) EXPECT_EQ(t, t);
}

TEST(Skin, RigidTakesTheLargestWeightWhereverItStands) {
  int cases = 0;
  for (std::size_t k = 1; k <= kMaxInfluences; ++k) {
    for (std::size_t largest = 0; largest < k; ++largest, ++cases) {
      TestVertex v;
      v.weights.assign(k, 1.0 / static_cast<double>(2 * k));
      v.weights[largest] += 0.5;
      TestRun run;
      std::vector<Map> palette(k);
      for (std::size_t j = 0; j < k; ++j) {
        run.set.push_back(static_cast<std::uint16_t>(j));
        palette[j].rows[0][3] = static_cast<double>(j);
      }
      run.vertices.push_back(v);
      const Skinned got = skin(TestMesh({run}, palette), palette, Kind::rigid);
      EXPECT_EQ(got.positions[0], static_cast<float>(largest)) << "of " << k;
    }
  }
  EXPECT_EQ(cases, 36);
}

TEST(Skin, NormalsOfAnUnevenScaleByHand) {
  // Twice as wide in x: a slanted normal leans away from x by the inverse, (1, 1, 0) → (½, 1, 0); a tangent leans to
  // it.
  const double h = 0.7071067811865476;
  const TestMesh mesh({{{0}, {{{0, 0, 0}, {h, h, 0}, {h, -h, 0}, -1, {1}, {}}}}}, {{}});
  const std::vector<Map> palette = {{{{2, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  for (const Kind kind : {Kind::rigid, Kind::ssd, Kind::as}) {
    const Skinned got = skin(mesh, palette, kind);
    EXPECT_NEAR(got.normals[0], 0.4472136f, 1e-6f);
    EXPECT_NEAR(got.normals[1], 0.8944272f, 1e-6f);
    EXPECT_NEAR(got.tangents[0], 0.8944272f, 1e-6f);
    EXPECT_NEAR(got.tangents[1], -0.4472136f, 1e-6f);
    EXPECT_EQ(got.tangents[3], -1.0f);
  }
}

// What an inverse transpose would not do: the normal is stretched as the surface is, and nothing is normalised.
TEST(Skin, BlendedMatrixByHand) {
  const TestMesh mesh({{{0}, {{{0, 0, 0}, {0.5, 0.5, 0}, {0.5, -0.5, 0}, -1, {1}, {}}}}}, {{}});
  const std::vector<Map> palette = {{{{-2, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  for (const Kind kind : {Kind::rigid, Kind::ssd, Kind::as}) {
    const Skinned got = skin(mesh, palette, kind, NormalTransform::blended_matrix);
    EXPECT_EQ(got.normals[0], -1.0f);
    EXPECT_EQ(got.normals[1], 0.5f);
    EXPECT_EQ(got.tangents[0], -1.0f);
    EXPECT_EQ(got.tangents[1], -0.5f);
    EXPECT_EQ(got.tangents[3], 1.0f) << "the joint mirrors";
  }
}

// Under a mirror the bitangent is w cross(n, t) with the other w: the triad's handedness changes with the surface.
TEST(Skin, MirrorByHand) {
  const TestMesh mesh({{{0}, {{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, 1, {1}, {}}}}}, {{}});
  const std::vector<Map> palette = {{{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  for (const Kind kind : {Kind::rigid, Kind::ssd, Kind::as}) {
    const Skinned got = skin(mesh, palette, kind);
    EXPECT_EQ(got.positions[0], -1.0f);
    EXPECT_EQ(got.normals[0], -1.0f) << "a normal that points out still does";
    EXPECT_EQ(got.tangents[1], 1.0f);
    EXPECT_EQ(got.tangents[3], -1.0f) << "the bitangent (0, 0, 1) stays where it is";
  }
}

TEST(Skin, PositionsAloneAreTheSameBits) {
  const test::TestCharacter c = test::make_character(15, 40, 7, true);
  const Mesh mesh = c.mesh.view();
  std::vector<Affine> palette;
  for (const Map& m : random_palette(5, 40, {1, 1, 1})) palette.push_back(test::to_affine(m));
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
  ASSERT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  for (const Kind kind : {Kind::rigid, Kind::ssd, Kind::as}) {
    const auto run = [&](const SkinOutput& out) {
      return kind == Kind::rigid ? skin_rigid(mesh, palette, out)
             : kind == Kind::ssd ? skin_ssd(mesh, palette, out)
                                 : skin_as(mesh, coordinates, palette, out);
    };
    Skinned all(mesh.geometry.slot_count), alone(mesh.geometry.slot_count), two(mesh.geometry.slot_count);
    ASSERT_EQ(run(all.output()), Status::ok);
    ASSERT_EQ(run({alone.positions, {}, {}}), Status::ok);
    ASSERT_EQ(run({two.positions, two.normals, {}}), Status::ok);
    EXPECT_EQ(all.positions, alone.positions);
    EXPECT_EQ(all.positions, two.positions);
    EXPECT_EQ(all.normals, two.normals);
    const NormalTransform blended = NormalTransform::blended_matrix;
    ASSERT_EQ(run(all.output(blended)), Status::ok);
    ASSERT_EQ(run({two.positions, two.normals, {}, blended}), Status::ok);
    EXPECT_EQ(all.positions, two.positions);
    EXPECT_EQ(all.positions, alone.positions);
    EXPECT_EQ(all.normals, two.normals);
  }
}

TEST(Skin, AnimationSpaceCoordinatesAreLiftAndResidual) {
  const TestMesh mesh(
      {{{0, 1}, {{{2, 4, 8}, {0, 0, 1}, {1, 0, 0}, 1, {0.25, 0.75}, {{0.5, 0, 0, 0.25}, {0, 0, -0.5, -0.25}}}}}},
      {{}, {}}, true);
  const Geometry g = mesh.view().geometry;
  ASSERT_EQ(as_coordinate_count(g), 28u);
  std::vector<float> q(29, 99.0f);
  ASSERT_EQ(as_coordinates(g, q), Status::ok);
  const float want[7] = {2 + 0.5f, 4, 8 - 0.5f, 0.25f * 2 + 0.5f, 1, 2, 0.5f};  // the sum, then q_0
  for (std::size_t i = 0; i < 7; ++i)
    for (std::size_t lane = 0; lane < 4; ++lane) EXPECT_EQ(q[i * 4 + lane], want[i]) << i;
  EXPECT_EQ(q[28], 99.0f) << "no more than the count is written";
}

TEST(Skin, TheLiftIsSsd) {
  const test::TestCharacter c = test::make_character(16, 40, 12, false);
  const std::vector<Map> palette = random_palette(6, 40, {1, 1, 1});
  const Skinned as = skin(c.mesh, palette, Kind::as), ssd = skin(c.mesh, palette, Kind::ssd);
  for (std::size_t i = 0; i < as.positions.size(); ++i) EXPECT_NEAR(as.positions[i], ssd.positions[i], 5e-6f);
}

}  // namespace
}  // namespace marrow
