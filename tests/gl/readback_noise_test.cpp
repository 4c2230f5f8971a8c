// Meshes that no artist makes: every influence count, mirrored joints, residuals, many joints, one vertex, none.
#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gl/support/feedback.h"
#include "gl/support/models.h"
#include "gl/support/worst.h"
#include "gles3/mesh/morph.h"
#include "gles3/palettes.h"
#include "marrow/gles3_skinner.h"
#include "support/aligned.h"
#include "support/morphs.h"
#include "support/rig.h"
#include "support/surface.h"

namespace marrow::test {
namespace {

constexpr double kMostPosition = 2e-4;
constexpr double kMostNormalDeg = 1;
constexpr double kLeastConditioning = 0.05;

struct Buffers {
  std::vector<float> positions, normals, tangents;
  explicit Buffers(const Geometry& g)
      : positions(std::size_t{3} * g.slot_count), normals(positions.size()), tangents(std::size_t{4} * g.slot_count) {}
  SkinOutput output() { return {positions, normals, tangents}; }
};

double diagonal_of(const std::vector<float>& positions) {
  double squared = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    float low = 1e30f, high = -1e30f;
    for (std::size_t i = c; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    squared += static_cast<double>(high - low) * static_cast<double>(high - low);
  }
  return std::sqrt(squared);
}

// All deformers at a few moments. targets: morph targets, of which as many as a shader can add have a weight.
Worst run_character(std::uint64_t seed, std::size_t joints, bool residuals, std::size_t targets = 0) {
  const TestCharacter character = make_character(seed, joints, 13, residuals);
  const Skeleton skeleton = character.skeleton.view();
  const Clip clip = character.clip.view();
  Mesh mesh = with_box(character.mesh);
  TestMorphs morphs(seed, mesh.geometry.slot_count, targets);
  morphs.put(mesh.geometry);
  for (std::size_t t = gles3::kMorphTargets; t < targets; ++t) morphs.weights[t % 7 == 0 ? t : t - 64] = 0;
  AlignedBlock memory(morphed_bytes(mesh.geometry));
  MorphedGeometry morphed;
  EXPECT_EQ(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed), Status::ok);
  Feedback feedback(mesh);
  EXPECT_EQ(feedback.prepared(), Status::ok);
  Worst worst;
  if (!feedback.ok()) return worst;
  EXPECT_EQ(feedback.gpu().influences, 8);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> scene(skeleton.joint_count), palette(mesh.palette_size());
  for (int moment = 0; moment < 3; ++moment) {
    for (float& w : morphs.weights) w *= -0.75f;
    EXPECT_EQ(morph(morphs.weights, morphed), Status::ok);
    EXPECT_EQ(morph_coordinates(morphed, coordinates), Status::ok);
    mesh.geometry = morphed.geometry;
    EXPECT_EQ(sample(skeleton, clip, clip.duration_s * static_cast<float>(moment) / 2, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, scene), Status::ok);
    EXPECT_EQ(build_palette(mesh, scene, palette), Status::ok);
    const std::vector<double> ones(mesh.geometry.slot_count, 1.0);
    const std::vector<double> ssd_well = conditioning(mesh.geometry, palette, false);
    const std::vector<double> as_well = conditioning(mesh.geometry, palette, true);
    Buffers rigid(mesh.geometry), ssd(mesh.geometry), as(mesh.geometry);
    EXPECT_EQ(skin_rigid(mesh, palette, rigid.output()), Status::ok);
    EXPECT_EQ(skin_ssd(mesh, palette, ssd.output()), Status::ok);
    EXPECT_EQ(skin_as(mesh, coordinates, palette, as.output()), Status::ok);
    const double diagonal = diagonal_of(ssd.positions);
    const auto add = [&](gles3::Deformer deformer, Buffers& want, const std::vector<double>& well) {
      worst.add(compare(mesh.geometry, feedback.skin(deformer, scene, morphs.weights), want.output(), diagonal, well,
                        kLeastConditioning));
    };
    add(gles3::Deformer::rigid, rigid, ones);
    add(gles3::Deformer::ssd, ssd, ssd_well);
    add(gles3::Deformer::as, as, as_well);
  }
  return worst;
}

void expect_promises(const std::string& what, const Worst& worst) {
  std::printf("%s: position %.1e of the diagonal, normal %.3f deg, tangent %.3f deg, %zu vertices\n", what.c_str(),
              worst.position, worst.normal_deg, worst.tangent_deg, worst.vertices);
  EXPECT_LE(worst.position, kMostPosition) << what;
  EXPECT_LE(worst.normal_deg, kMostNormalDeg) << what;
  EXPECT_LE(worst.tangent_deg, kMostNormalDeg) << what;
  EXPECT_EQ(worst.wrong_signs, 0u) << what;
  EXPECT_GE(worst.vertices, 500u) << what;
  EXPECT_GE(worst.normals, worst.vertices / 2) << what;
  EXPECT_EQ(worst.tangents, worst.normals) << what;
}

TEST(Noise, EveryInfluenceCountAndMirroredJoints) {
  expect_promises("lift", run_character(11, 40, false));
}
TEST(Noise, Residuals) {
  expect_promises("residuals", run_character(12, 40, true));
}
TEST(Noise, JointNumbersOfTwoBytes) {
  expect_promises("300 joints", run_character(13, 300, false));
}
TEST(Noise, AsManyJointsAsABlockHolds) {
  expect_promises("341 joints", run_character(14, gles3::kPaletteJoints, false));
}

TEST(Noise, Morphs) {
  expect_promises("9 targets", run_character(16, 40, false, 9));
  expect_promises("9 targets and residuals", run_character(17, 40, true, 9));
}
TEST(Noise, MoreMorphsThanAShaderAdds) {
  expect_promises("80 targets", run_character(18, 40, false, 80));
}

void put_box_of_sheet(Mesh& mesh) {
  for (std::size_t c = 0; c < 3; ++c) {
    mesh.geometry.box_min[c] = c < 2 ? -1.0f : -0.125f;
    mesh.geometry.box_max[c] = -mesh.geometry.box_min[c];
  }
}

std::vector<Affine> pose_sheet(Random& random, bool mirrored) {
  std::vector<Affine> palette;
  for (int j = 0; j < 9; ++j) {
    const Vec3 t{random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.1, 0.1)};
    const Vec3 axis{random.between(-1, 1), random.between(-1, 1), random.between(0.5, 1)};
    palette.push_back(to_affine(from_trs(t, axis_angle(axis, 0.75), {1, mirrored ? -1.0 : 1.0, 1})));
  }
  return palette;
}

// A sheet with up to `most` influences in three poses, with mirrored joints in one, all with their tangents as vectors.
Worst run_sheet(std::uint64_t seed, std::size_t most, bool residuals, std::uint8_t& features) {
  const Sheet sheet = make_sheet(seed, 16, 9, most, residuals);
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(9), residuals);
  Mesh mesh = surface.view();
  put_box_of_sheet(mesh);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), tangents(as_tangent_count(mesh.geometry));
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  const AsPart part{&mesh, coordinates, tangents};
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / 4);
  EXPECT_EQ(as_tangents({&part, 1}, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}), Status::ok);
  Feedback feedback(mesh, tangents);
  EXPECT_EQ(feedback.prepared(), Status::ok);
  Worst worst;
  if (!feedback.ok()) return worst;
  features = feedback.gpu().features;
  const bool surface_normals = (features & gles3::kSurfaceNormals) != 0;
  Random random(seed);
  for (int moment = 0; moment < 3; ++moment) {
    const std::vector<Affine> palette = pose_sheet(random, moment == 1);
    Buffers want(mesh.geometry);
    EXPECT_EQ(skin_as(mesh, coordinates, palette, want.output(), surface_normals ? tangents : Span<const float>()),
              Status::ok);
    const std::vector<double> well = surface_normals ? surface_conditioning(mesh.geometry, tangents, palette)
                                                     : conditioning(mesh.geometry, palette, true);
    worst.add(compare(mesh.geometry, feedback.skin(gles3::Deformer::as, palette), want.output(),
                      diagonal_of(want.positions), well, surface_normals ? 0.01 : kLeastConditioning));
  }
  return worst;
}

// Through the blend, with just so many influences as programs are compiled for. repeats: the fifth and further are of
// the joint that has the largest weight.
Worst run_blended_sheet(std::uint64_t seed, std::size_t most, bool repeats) {
  Sheet sheet = make_sheet(seed, 16, 9, most, true);
  for (SurfaceVertex& v : sheet.vertices) {
    const std::vector<double>& w = v.vertex.weights;
    const std::uint16_t largest = v.set[static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin())];
    for (std::size_t k = 4; repeats && k < v.set.size(); ++k) v.set[k] = largest;
  }
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(9), true);
  Mesh mesh = surface.view();
  put_box_of_sheet(mesh);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  Feedback feedback(mesh);
  EXPECT_EQ(feedback.prepared(), Status::ok);
  Worst worst;
  if (!feedback.ok()) return worst;
  EXPECT_EQ(feedback.gpu().influences, most);
  Random random(seed);
  const std::vector<Affine> palette = pose_sheet(random, false);
  Buffers ssd(mesh.geometry), as(mesh.geometry);
  EXPECT_EQ(skin_ssd(mesh, palette, ssd.output()), Status::ok);
  EXPECT_EQ(skin_as(mesh, coordinates, palette, as.output()), Status::ok);
  const auto add = [&](gles3::Deformer deformer, Buffers& want) {
    worst.add(compare(mesh.geometry, feedback.skin(deformer, palette), want.output(), diagonal_of(want.positions),
                      conditioning(mesh.geometry, palette, deformer == gles3::Deformer::as), kLeastConditioning));
  };
  add(gles3::Deformer::ssd, ssd);
  add(gles3::Deformer::as, as);
  return worst;
}

TEST(Noise, AsManyInfluencesAsAProgramHas) {
  for (std::size_t most = 4; most <= 8; ++most)
    expect_promises(fmt::format("{} influences, blended", most), run_blended_sheet(30 + most, most, false));
  expect_promises("a joint twice", run_blended_sheet(40, 7, true));
}

TEST(Noise, SurfaceNormals) {
  for (std::size_t most = 4; most <= 8; ++most) {
    for (const bool residuals : {false, true}) {
      std::uint8_t features = 0;
      expect_promises(fmt::format("{} influences{}", most, residuals ? ", residuals" : ""),
                      run_sheet(21, most, residuals, features));
      EXPECT_NE(features & gles3::kSurfaceNormals, 0);
    }
  }
}

TEST(Noise, OneJointMoreGoesIntoATextureAlone) {
  const TestCharacter character = make_character(15, gles3::kPaletteJoints + 1, 2, false);
  const Mesh mesh = with_box(character.mesh);
  gles3::PaletteRing ring;
  ASSERT_EQ(gles3::create_palette_ring(gl(), {}, 1000, 1, ring), Status::ok);
  const std::vector<Affine> palette(mesh.palette_size());
  std::uint32_t offset = 0;
  EXPECT_EQ(gles3::push_palette(gl(), ring, palette, offset), Status::bad_argument);
  gles3::destroy(gl(), ring);
  for (const gles3::SkinningPath path :
       {gles3::SkinningPath::ubo, gles3::SkinningPath::texture, gles3::SkinningPath::cpu}) {
    gles3::ProgramSet programs;
    programs.roles[0] = {"void main() { gl_Position = vec4(marrow_skin().position, 1.0); }",
                         "precision highp float; out vec4 colour; void main() { colour = vec4(1.0); }",
                         {}};
    gles3::SkinnerOptions options;
    options.path = path;
    std::vector<SoaTransform> memory(gles3::skinner_bytes(mesh, options) / sizeof(SoaTransform) + 1);
    gles3::Skinner skinner;
    EXPECT_EQ(gles3::create_skinner(gl(), {}, mesh, options, programs,
                                    {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(SoaTransform)},
                                    skinner),
              path == gles3::SkinningPath::ubo ? Status::unsupported : Status::ok)
        << gles3::to_string(path);
    gles3::destroy(gl(), skinner);
    gles3::destroy(gl(), programs);
  }
}

}  // namespace
}  // namespace marrow::test
