// Multi-weight enveloping and pose-space deformation against their definitions in double precision.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "math/elementary.h"
#include "support/family.h"
#include "support/rig.h"
#include "support/skinned.h"

namespace marrow {
namespace {

using test::Map;
using test::Quat;
using test::Skinned;
using test::TestMesh;
using test::Vec3;

std::vector<Affine> random_palette(std::uint64_t seed, std::size_t count, const Vec3& scale) {
  test::Random random(seed);
  std::vector<Affine> out;
  for (std::size_t i = 0; i < count; ++i) {
    const Quat rotation = random.rotation();
    const Vec3 translation{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    out.push_back(test::to_affine(test::from_trs(translation, rotation, scale)));
  }
  return out;
}

// The rotation next to the first two columns: Gram and Schmidt.
Map rotation_of(const Map& m) {
  const auto column = [&](int c) { return Vec3{m.rows[0][c], m.rows[1][c], m.rows[2][c]}; };
  const Vec3 x = test::normalised(column(0)), b = column(1);
  const double along = test::dot(x, b);
  const Vec3 y = test::normalised(Vec3{b[0] - along * x[0], b[1] - along * x[1], b[2] - along * x[2]});
  const Vec3 z = test::cross(x, y);
  Map out;
  for (std::size_t r = 0; r < 3; ++r) {
    out.rows[r][0] = x[r];
    out.rows[r][1] = y[r];
    out.rows[r][2] = z[r];
  }
  return out;
}

Map transposed(const Map& m) {
  Map out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out.rows[r][c] = m.rows[c][r];
  return out;
}

// Calls f(run, vertex, slot, block, lane, influence blocks before that block).
template <class F>
void for_each_vertex(const TestMesh& mesh, const F& f) {
  std::size_t before = 0;
  for (std::size_t r = 0; r < mesh.source.size(); ++r) {
    const std::size_t k = mesh.source[r].set.size(), count = mesh.source[r].vertices.size();
    for (std::size_t i = 0; i < count; ++i)
      f(mesh.source[r], mesh.source[r].vertices[i], mesh.slot(r, i), mesh.slot(r, i) / 4, i % 4, before + i / 4 * k);
    before += (count + 3) / 4 * k;
  }
}

void expect_directions(const Map& blend, const test::TestVertex& v, const Skinned& got, std::size_t slot) {
  if (test::invertibility(blend) < 1e-2) return;
  const Vec3 normal = Skinned::three(got.normals, slot), tangent = Skinned::three(got.tangents, slot, 4);
  EXPECT_LT(test::angle_deg(normal, test::normal(blend, v.normal)), 0.02) << "slot " << slot;
  EXPECT_LT(test::angle_deg(tangent, test::direction(blend, v.tangent)), 0.02) << "slot " << slot;
}

// R Σ_j (Ω_j ∘ R⁻¹ M_j), of one vertex.
Map multi_weight_blend(const test::TestRun& run, const test::TestVertex& v, const std::vector<Affine>& palette,
                       const test::TestMultiWeights& weights, std::size_t influence_block, std::size_t lane) {
  const Map root = test::to_map(palette[weights.root]);
  Map back = transposed(rotation_of(root)), frame = rotation_of(root), sum;
  for (int r = 0; r < 3; ++r) frame.rows[r][3] = root.rows[r][3];
  const Vec3 origin = test::direction(back, {root.rows[0][3], root.rows[1][3], root.rows[2][3]});
  for (std::size_t r = 0; r < 3; ++r) back.rows[r][3] = -origin[r];
  for (auto& row : sum.rows)
    for (double& x : row) x = 0;
  for (std::size_t k = 0; k < run.set.size(); ++k) {
    const Map inside = back * test::to_map(palette[run.set[k]]);
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 4; ++c) {
        const double residual =
            static_cast<double>(weights.residual[(influence_block + k) * 48 + (4 * r + c) * 4 + lane]);
        sum.rows[r][c] += (v.weights[k] + residual) * inside.rows[r][c];
      }
  }
  return frame * sum;
}

TEST(SkinMwe, IsItsDefinition) {
  const Vec3 scales[] = {{1, 1, 1}, {0.5, 1, 2}, {1, -1, 1}};
  std::size_t compared = 0;
  for (const Vec3& scale : scales) {
    const test::TestCharacter c = test::make_character(31, 40, 9, false);
    ASSERT_EQ(c.mesh.source.size(), 8u) << "a run for each number of influences";
    Mesh mesh = c.mesh.view();
    const test::TestMultiWeights weights(32, mesh, 7);
    weights.put(mesh.geometry);
    const std::vector<Affine> palette = random_palette(33, 40, scale);
    Skinned got(mesh.geometry.slot_count), blended(mesh.geometry.slot_count);
    ASSERT_EQ(skin_mwe(mesh, palette, got.output()), Status::ok);
    ASSERT_EQ(skin_mwe(mesh, palette, blended.output(NormalTransform::blended_matrix)), Status::ok);
    EXPECT_EQ(got.positions, blended.positions);
    for_each_vertex(c.mesh, [&](const test::TestRun& run, const test::TestVertex& v, std::size_t slot, std::size_t,
                                std::size_t lane, std::size_t influence_block) {
      const Map blend = multi_weight_blend(run, v, palette, weights, influence_block, lane);
      EXPECT_LT(test::length(test::minus(Skinned::three(got.positions, slot), test::point(blend, v.position))), 1e-5);
      expect_directions(blend, v, got, slot);
      EXPECT_LT(test::length(test::minus(Skinned::three(blended.normals, slot), test::direction(blend, v.normal))),
                4e-6);
      if (test::invertibility(blend) > 1e-2) {
        EXPECT_EQ(got.tangents[slot * 4 + 3], blended.tangents[slot * 4 + 3]) << "handedness";
      }
      ++compared;
    });
  }
  EXPECT_GT(compared, 200u);
}

TEST(SkinMwe, WithoutResidualIsSsdAndMovesWithTheRoot) {
  const test::TestCharacter c = test::make_character(34, 40, 9, false);
  Mesh mesh = c.mesh.view();
  test::TestMultiWeights weights(35, mesh, 3);
  weights.put(mesh.geometry);
  const std::vector<Affine> palette = random_palette(36, 40, {1, 1, 1});
  const Map motion = test::from_trs({0.5, -0.25, 1}, test::normalised(Quat{1, 2, -3, 4}), {1, 1, 1});
  std::vector<Affine> moved;
  for (const Affine& m : palette) moved.push_back(test::to_affine(motion * test::to_map(m)));
  Skinned here(mesh.geometry.slot_count), there(mesh.geometry.slot_count), ssd(mesh.geometry.slot_count);
  ASSERT_EQ(skin_mwe(mesh, palette, here.output()), Status::ok);
  ASSERT_EQ(skin_mwe(mesh, moved, there.output()), Status::ok);
  for (std::size_t slot = 0; slot < mesh.geometry.slot_count; ++slot) {
    const Vec3 want = test::point(motion, Skinned::three(here.positions, slot));
    EXPECT_LT(test::length(test::minus(Skinned::three(there.positions, slot), want)), 1e-5);
  }
  std::fill(weights.residual.begin(), weights.residual.end(), 0.0f);
  ASSERT_EQ(skin_mwe(mesh, palette, here.output()), Status::ok);
  ASSERT_EQ(skin_ssd(mesh, palette, ssd.output()), Status::ok);
  for (std::size_t i = 0; i < here.positions.size(); ++i) EXPECT_NEAR(here.positions[i], ssd.positions[i], 5e-6f);
  for (std::size_t slot = 0; slot < mesh.geometry.slot_count; ++slot)
    EXPECT_EQ(here.tangents[slot * 4 + 3], ssd.tangents[slot * 4 + 3]);
}

// sin² of half the angle of the rotation from one to the other.
double distance(const Map& a, const Map& b) {
  const Map m = transposed(a) * b;
  const Vec3 axis{m.rows[2][1] - m.rows[1][2], m.rows[0][2] - m.rows[2][0], m.rows[1][0] - m.rows[0][1]};
  const double angle = std::atan2(test::length(axis), m.rows[0][0] + m.rows[1][1] + m.rows[2][2] - 1);
  return std::pow(std::sin(angle / 2), 2);
}

// The distances of a pose in double precision.
struct Distances {
  std::vector<double> to_bind;
  std::vector<std::vector<double>> to;  // an example, palette entry

  Distances(const std::vector<Affine>& palette, const test::TestPoseSpace& space) {
    std::vector<Map> local;
    for (std::size_t j = 0; j < palette.size(); ++j) {
      const bool alone = space.parents[j] == kNoJoint;
      local.push_back(alone ? Map{}
                            : transposed(rotation_of(test::to_map(palette[space.parents[j]]))) *
                                  rotation_of(test::to_map(palette[j])));
      to_bind.push_back(distance(local[j], {}));
    }
    for (std::size_t k = 0; k < space.examples.size(); ++k) {
      to.emplace_back();
      for (std::size_t j = 0; j < palette.size(); ++j) {
        Quat q{};
        for (std::size_t c = 0; c < 4; ++c)
          q[c] = static_cast<double>(space.rotations[(k * palette.size() + j) * 4 + c]);
        const bool alone = space.parents[j] == kNoJoint;
        const Map example = alone ? Map{} : test::from_trs({0, 0, 0}, test::normalised(q), {1, 1, 1});
        to[k].push_back(distance(local[j], example));
      }
    }
  }
};

Vec3 with_deltas(const test::TestRun& run, const test::TestVertex& v, std::size_t block, std::size_t lane,
                 const test::TestPoseSpace& space, const Distances& d) {
  Vec3 out = v.position;
  for (std::size_t k = 0; k < space.examples.size(); ++k) {
    const MorphTarget& example = space.examples[k];
    for (std::size_t i = example.first_block; i < example.first_block + example.block_count; ++i) {
      if (space.narrow[i] != block) continue;
      double near = 0, around = 0;
      for (std::size_t j = 0; j < run.set.size(); ++j) {
        near += v.weights[j] * d.to[k][run.set[j]];
        around += v.weights[j] * d.to_bind[run.set[j]];
      }
      const double falloff = -1 / (2 * std::pow(static_cast<double>(space.sigma), 2));
      const double psi = std::exp(falloff * near) * (1 - std::exp(falloff * around));
      for (std::size_t c = 0; c < 3; ++c)
        out[c] += psi * static_cast<double>(example.position_step) * space.records[i * 12 + c * 4 + lane];
    }
  }
  return out;
}

TEST(SkinPsd, IsItsDefinition) {
  const Vec3 scales[] = {{1, 1, 1}, {0.5, 1, 2}, {1, -1, 1}};
  std::size_t compared = 0;
  for (const Vec3& scale : scales) {
    const test::TestCharacter c = test::make_character(41, 41, 9, false);
    Mesh mesh = c.mesh.view();
    const test::TestPoseSpace space(42, mesh, scale[0] < 1 ? kMaxPoseExamples : 6, scale[1] < 0);
    space.put(mesh.geometry);
    const std::vector<Affine> palette = random_palette(43, 41, scale);
    std::vector<float> distances(psd_distance_count(mesh.geometry));
    ASSERT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
    Skinned got(mesh.geometry.slot_count), ssd(mesh.geometry.slot_count);
    ASSERT_EQ(skin_psd(mesh, distances, palette, got.output()), Status::ok);
    ASSERT_EQ(skin_ssd(mesh, palette, ssd.output()), Status::ok);
    EXPECT_EQ(got.normals, ssd.normals);
    EXPECT_EQ(got.tangents, ssd.tangents);
    EXPECT_NE(got.positions, ssd.positions);
    const Distances expected(palette, space);
    for_each_vertex(c.mesh, [&](const test::TestRun& run, const test::TestVertex& v, std::size_t slot,
                                std::size_t block, std::size_t lane, std::size_t) {
      Vec3 want{0, 0, 0};
      const Vec3 bind = with_deltas(run, v, block, lane, space, expected);
      for (std::size_t j = 0; j < run.set.size(); ++j) {
        const Vec3 p = test::point(test::to_map(palette[run.set[j]]), bind);
        for (std::size_t i = 0; i < 3; ++i) want[i] += v.weights[j] * p[i];
      }
      EXPECT_LT(test::length(test::minus(Skinned::three(got.positions, slot), want)), 2e-5) << "slot " << slot;
      ++compared;
    });
  }
  EXPECT_GT(compared, 200u);
}

TEST(SkinPsd, LeavesTheBindPoseAndIsSsdWithoutExamples) {
  const test::TestCharacter c = test::make_character(44, 40, 9, false);
  Mesh mesh = c.mesh.view();
  const test::TestPoseSpace space(45, mesh, 5);
  space.put(mesh.geometry);
  const std::vector<Affine> bind(40, Affine{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  std::vector<float> distances(psd_distance_count(mesh.geometry));
  ASSERT_EQ(psd_distances(mesh.geometry, bind, distances), Status::ok);
  Skinned got(mesh.geometry.slot_count), ssd(mesh.geometry.slot_count);
  ASSERT_EQ(skin_psd(mesh, distances, bind, got.output()), Status::ok);
  ASSERT_EQ(skin_ssd(mesh, bind, ssd.output()), Status::ok);
  EXPECT_EQ(got.positions, ssd.positions);
  const std::vector<Affine> palette = random_palette(46, 40, {1, 1, 1});
  mesh.geometry.pose_space = {};
  EXPECT_EQ(psd_distance_count(mesh.geometry), 0u);
  ASSERT_EQ(psd_distances(mesh.geometry, palette, {}), Status::ok);
  ASSERT_EQ(skin_psd(mesh, {}, palette, got.output()), Status::ok);
  ASSERT_EQ(skin_ssd(mesh, palette, ssd.output()), Status::ok);
  EXPECT_EQ(got.positions, ssd.positions);
}

TEST(SkinFamily, PositionsAloneAreTheSameBits) {
  const test::TestCharacter c = test::make_character(47, 40, 7, false);
  Mesh mesh = c.mesh.view();
  const test::TestMultiWeights weights(48, mesh, 0);
  const test::TestPoseSpace space(49, mesh, 4);
  weights.put(mesh.geometry);
  space.put(mesh.geometry);
  const std::vector<Affine> palette = random_palette(50, 40, {1, 1, 1});
  std::vector<float> distances(psd_distance_count(mesh.geometry));
  ASSERT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
  for (const bool mwe : {false, true}) {
    const auto run = [&](const SkinOutput& out) {
      return mwe ? skin_mwe(mesh, palette, out) : skin_psd(mesh, distances, palette, out);
    };
    Skinned all(mesh.geometry.slot_count), alone(mesh.geometry.slot_count), two(mesh.geometry.slot_count);
    ASSERT_EQ(run(all.output()), Status::ok);
    ASSERT_EQ(run({alone.positions, {}, {}}), Status::ok);
    ASSERT_EQ(run({two.positions, two.normals, {}}), Status::ok);
    EXPECT_EQ(all.positions, alone.positions);
    EXPECT_EQ(all.positions, two.positions);
    EXPECT_EQ(all.normals, two.normals);
  }
}

TEST(SkinFamily, RefusesWhatIsTooShortOrAbsent) {
  const test::TestCharacter c = test::make_character(47, 40, 7, false);
  Mesh mesh = c.mesh.view();
  const test::TestMultiWeights weights(48, mesh, 0);
  const test::TestPoseSpace space(49, mesh, 4);
  std::vector<Affine> palette = random_palette(50, 40, {1, 1, 1});
  Skinned out(mesh.geometry.slot_count);
  EXPECT_EQ(skin_mwe(mesh, palette, out.output()), Status::bad_argument) << "no residual";
  weights.put(mesh.geometry);
  space.put(mesh.geometry);
  std::vector<float> distances(psd_distance_count(mesh.geometry));
  ASSERT_EQ(distances.size(), 5u * 40);
  EXPECT_EQ(psd_distances(mesh.geometry, {palette.data(), 39}, distances), Status::bad_argument);
  EXPECT_EQ(psd_distances(mesh.geometry, palette, {distances.data(), distances.size() - 1}), Status::bad_argument);
  EXPECT_EQ(skin_psd(mesh, {distances.data(), distances.size() - 1}, palette, out.output()), Status::bad_argument);
  EXPECT_EQ(skin_psd(mesh, distances, {palette.data(), 39}, out.output()), Status::bad_argument);
  EXPECT_EQ(skin_mwe(mesh, {palette.data(), 39}, out.output()), Status::bad_argument);
  EXPECT_EQ(skin_mwe(mesh, palette, {{out.positions.data(), 3}, {}, {}}), Status::bad_argument);
  mesh.geometry.mwe_residual += 1;
  EXPECT_EQ(skin_mwe(mesh, palette, out.output()), Status::bad_argument) << "not aligned";
  weights.put(mesh.geometry);
  mesh.geometry.mwe_root = 40;
  EXPECT_EQ(skin_mwe(mesh, palette, out.output()), Status::bad_argument);
  for (const float f : out.positions) EXPECT_EQ(f, 0.0f);
}

TEST(Exponential, IsWithinItsStatedError) {
  const auto value = [](float x) {
    float lanes[4];
    store(lanes, exp_negative(splat(x)));
    return lanes[0];
  };
  double worst = 0;
  for (int i = 0; i <= 870000; ++i) {
    const float x = -1e-4f * static_cast<float>(i);
    const double want = std::exp(static_cast<double>(x));
    worst = std::max(worst, std::fabs(static_cast<double>(value(x)) - want) / want);
  }
  EXPECT_LT(worst, 2e-7);
  EXPECT_EQ(value(0), 1.0f);
  EXPECT_EQ(value(-0.0f), 1.0f);
  EXPECT_LT(value(-1e30f), 2e-38f);
  EXPECT_LT(value(-INFINITY), 2e-38f);
  EXPECT_GT(value(-1e-44f), 0.999f);
  EXPECT_NE(value(NAN), value(NAN));
}

}  // namespace
}  // namespace marrow
