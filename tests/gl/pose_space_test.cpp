// Pose spaces: what each way of the GPU makes of them against the CPU, of a mesh that learnt one and of noise.
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "gl/support/feedback.h"
#include "gl/support/models.h"
#include "gl/support/worst.h"
#include "gles3/mesh/pose_examples.h"
#include "gles3/mesh/prepare.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "pose/evaluate.h"
#include "render/performance.h"
#include "support/aligned.h"
#include "support/family.h"
#include "support/morphs.h"
#include "support/places.h"

namespace marrow::test {
namespace {

constexpr double kMostPosition = 2e-4;  // of the diagonal
constexpr double kMostNormalDeg = 1;

void expect_promises(const char* what, const Worst& worst) {
  std::printf("%s: position %.1e of the diagonal, normal %.3f deg, %zu vertices\n", what, worst.position,
              worst.normal_deg, worst.vertices);
  EXPECT_LE(worst.position, kMostPosition) << what;
  EXPECT_LE(worst.normal_deg, kMostNormalDeg) << what;
  EXPECT_LE(worst.tangent_deg, kMostNormalDeg) << what;
  EXPECT_EQ(worst.wrong_signs, 0u) << what;
}

double farthest(const std::vector<float>& a, const std::vector<float>& b) {
  double out = 0;
  for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, std::fabs(double{a[i]} - double{b[i]}));
  return out;
}

// The sample, taught by dual quaternions what one clip does.
TEST(PoseSpace, OfTheSampleIsTheCpusInEveryWay) {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.clips.raw = true;
  options.learn.truth = cook::Truth::dual_quaternions;
  options.learn.pose_examples = 8;
  cook::RawScene scene = cook::read_gltf(newt_glb());
  std::erase_if(scene.clips, [](const auto& clip) { return clip.name != "twist"; });
  ASSERT_EQ(scene.clips.size(), 1u);
  const cook::Result cooked = cook::cook_scene(std::move(scene), options);
  const tools::AlignedBytes bytes(cooked.file);
  File file;
  ASSERT_EQ(load({bytes.data(), bytes.size()}, file), Status::ok);
  const Mesh mesh = file.mesh(0);
  ASSERT_GT(mesh.geometry.pose_space.examples.size, 3u);
  std::printf("%zu examples, sigma %g\n", mesh.geometry.pose_space.examples.size,
              static_cast<double>(mesh.geometry.pose_space.sigma));
  tools::Character character(file);
  const double diagonal =
      2 * static_cast<double>(tools::box_of(tools::skin_all(file, character, tools::Deformer::ssd)).radius());
  Feedback feedback(mesh);
  ASSERT_EQ(feedback.prepared(), Status::ok);
  Worst worst;
  double moved = 0;
  for (std::uint32_t clip = 0; clip < file.clip_count(); ++clip) {
    const tools::Play play = tools::play_together(file, clip);
    for (int moment = 0; moment < 12; ++moment) {
      character.pose(play, play.duration_s * static_cast<float>(moment + 1) / 13);
      tools::PosedMesh ssd, psd;
      character.skin(0, tools::Deformer::ssd, ssd);
      character.skin(0, tools::Deformer::psd, psd);
      moved = std::max(moved, farthest(ssd.positions, psd.positions) / diagonal);
      const std::vector<double> well = conditioning(mesh.geometry, character.palette(0), false);
      for (const Way way : kWays) {
        if (!can(way)) continue;
        const Skinned got = feedback.skin(gles3::Deformer::psd, character.model_from_joint(mesh.skeleton), {}, way);
        worst.add(compare(mesh.geometry, got, {psd.positions, psd.normals, psd.tangents}, diagonal, well, 0.02));
      }
    }
  }
  EXPECT_GT(moved, 20 * kMostPosition) << "a test that could not fail";
  expect_promises("newt", worst);
}

// Up to eight influences, joint numbers of one and two bytes, more examples than fit into a texel, morph targets too.
Worst run_character(std::uint64_t seed, std::size_t joints, std::size_t examples, std::size_t targets) {
  const TestCharacter character = make_character(seed, joints, 13, false);
  const Skeleton skeleton = character.skeleton.view();
  const Clip clip = character.clip.view();
  Mesh mesh = with_box(character.mesh);
  TestMorphs morphs(seed, mesh.geometry.slot_count, targets);
  morphs.put(mesh.geometry);
  const TestPoseSpace space(seed + 1, mesh, examples, mesh.geometry.index_bytes == 4);
  space.put(mesh.geometry);
  AlignedBlock memory(morphed_bytes(mesh.geometry));
  MorphedGeometry morphed;
  EXPECT_EQ(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed), Status::ok);
  EXPECT_EQ(morph(morphs.weights, morphed), Status::ok);
  Feedback feedback(mesh);
  EXPECT_EQ(feedback.prepared(), Status::ok);
  mesh.geometry = morphed.geometry;
  Worst worst;
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> scene(skeleton.joint_count), palette(mesh.palette_size());
  std::vector<float> distances(psd_distance_count(mesh.geometry));
  const std::size_t slots = mesh.geometry.slot_count;
  std::vector<float> positions(3 * slots), normals(3 * slots), tangents(4 * slots);
  for (int moment = 0; moment < 3; ++moment) {
    EXPECT_EQ(sample(skeleton, clip, clip.duration_s * static_cast<float>(moment) / 2, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, scene), Status::ok);
    EXPECT_EQ(build_palette(mesh, scene, palette), Status::ok);
    EXPECT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
    const SkinOutput want{positions, normals, tangents};
    EXPECT_EQ(skin_psd(mesh, distances, palette, want), Status::ok);
    const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
    const std::vector<double> well = conditioning(mesh.geometry, palette, false);
    for (const Way way : kWays) {
      if (!can(way) || (way != Way::texture && palette.size() > gles3::kPaletteJoints)) continue;
      worst.add(compare(mesh.geometry, feedback.skin(gles3::Deformer::psd, scene, morphs.weights, way), want,
                        double{*high} - double{*low}, well, 0.05));
    }
  }
  return worst;
}

TEST(PoseSpace, OfNoiseIsTheCpusInEveryWay) {
  expect_promises("1 example", run_character(51, 40, 1, 0));
  expect_promises("3 examples", run_character(52, 40, 3, 0));
  expect_promises("32 examples, 300 joints", run_character(53, 300, kMaxPoseExamples, 0));
  expect_promises("9 examples, 5 morph targets", run_character(54, 40, 9, 5));
  expect_promises("7 examples, 700 joints", run_character(55, 700, 7, 0));
}

// Changes that are all zero, and examples that move nothing.
TEST(PoseSpace, MayMoveNothing) {
  const TestCharacter character = make_character(56, 40, 5, false);
  Mesh mesh = with_box(character.mesh);
  TestPoseSpace space(57, mesh, 2);
  std::fill(space.records.begin(), space.records.end(), std::int16_t{0});
  space.put(mesh.geometry);
  Feedback feedback(mesh);
  ASSERT_EQ(feedback.prepared(), Status::ok);
  const std::vector<Affine> scene(character.skeleton.view().joint_count,
                                  Affine{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  EXPECT_EQ(feedback.skin(gles3::Deformer::psd, scene).positions, feedback.skin(gles3::Deformer::ssd, scene).positions);
}

TEST(PoseSpace, IsRefusedWhereThereIsNone) {
  const TestCharacter character = make_character(58, 40, 5, false);
  const Mesh mesh = with_box(character.mesh);
  Feedback feedback(mesh);
  ASSERT_EQ(feedback.prepared(), Status::ok);
  EXPECT_EQ(feedback.gpu().layout.ssd_stride, 28u);
  const gles3::Program program;
  EXPECT_EQ(gles3::draw(gl(), feedback.gpu(), gles3::Deformer::psd, program), Status::bad_argument);
  EXPECT_EQ(gles3::bind_examples(gl(), feedback.gpu(), {}, 0, 0, program), Status::bad_argument);
  EXPECT_EQ(gles3::distance_matrices(mesh.geometry), 0u);
  EXPECT_EQ(gles3::pack_distances(mesh.geometry, {}, {}), Status::bad_argument);
  gles3::Program none;
  EXPECT_EQ(
      gles3::create_program(gl(), {gles3::Deformer::psd, 4, 0, gles3::Palettes::crowd}, feedback_source(), 0, none),
      Status::bad_argument);
}

}  // namespace
}  // namespace marrow::test
