// Every model, every clip, every deformer: what the vertex shader computes against what the CPU computes.
#include <cstdio>

#include <gtest/gtest.h>

#include "gl/feedback.h"
#include "gl/models.h"
#include "gl/worst.h"
#include "pose/evaluate.h"
#include "render/performance.h"

namespace marrow::test {
namespace {

// What is promised, see the issue; measured values are printed.
constexpr double kMostPosition = 2e-4;
constexpr double kMostNormalDeg = 1;
// Below this a fold is so flat that one step of a weight turns its normal.
constexpr double kLeastConditioning = 0.02;
constexpr double kLeastSurfaceConditioning = 0.01;
constexpr int kMoments = 4;

struct Tally {
  Worst rigid, ssd, as, surface;
  std::size_t poses = 0, meshes = 0, refused = 0;
};

Worst compare_mesh(const Mesh& mesh, const tools::Character& character, std::uint32_t index, Feedback& feedback,
                   tools::Deformer deformer, double diagonal) {
  tools::PosedMesh posed;
  character.skin(index, deformer, posed);
  const gles3::Deformer on_gpu = deformer == tools::Deformer::rigid ? gles3::Deformer::rigid
                                 : deformer == tools::Deformer::ssd ? gles3::Deformer::ssd
                                                                    : gles3::Deformer::as;
  const Skinned got = feedback.skin(on_gpu, character.scene_from_joint(mesh.skeleton),
                                    {character.weights(index).data(), mesh.targets.size});
  const std::vector<double> well =
      deformer == tools::Deformer::rigid
          ? std::vector<double>(mesh.geometry.slot_count, 1.0)
          : conditioning(mesh.geometry, character.palette(index), deformer == tools::Deformer::as);
  return compare(mesh.geometry, got, {posed.positions, posed.normals, posed.tangents}, diagonal, well,
                 kLeastConditioning);
}

// Animation space with its surface's own normals.
Worst compare_surface(const Mesh& mesh, const tools::Character& character, std::uint32_t index,
                      Span<const float> tangents, Feedback& feedback, double diagonal) {
  tools::PosedMesh posed;
  character.skin(index, tools::Deformer::as, posed);
  const Skinned got = feedback.skin(gles3::Deformer::as, character.scene_from_joint(mesh.skeleton));
  const std::vector<double> well = surface_conditioning(mesh.geometry, tangents, character.palette(index));
  return compare(mesh.geometry, got, {posed.positions, posed.normals, posed.tangents}, diagonal, well,
                 kLeastSurfaceConditioning);
}

Tally read_back(const Model& model) {
  const File& file = model.file;
  Tally tally;
  tools::Character character(file), with_surface(file, tools::AsNormals::tangents);
  const std::vector<std::vector<float>> tangents = tools::tangents_of(file);
  const double diagonal =
      2 * static_cast<double>(tools::box_of(tools::skin_all(file, character, tools::Deformer::ssd)).radius());
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    Feedback feedback(mesh);
    if (mesh.joint_count > gles3::kPaletteJoints) {
      EXPECT_EQ(feedback.prepared(), Status::unsupported) << model.name;
      ++tally.refused;
      continue;
    }
    EXPECT_EQ(feedback.prepared(), Status::ok) << model.name;
    if (!feedback.ok()) continue;
    ++tally.meshes;
    Feedback surface(mesh, tangents[m]);
    const bool has_surface = (surface.gpu().features & gles3::kSurfaceNormals) != 0;
    // clip_count() stands for the rest pose.
    for (std::uint32_t clip = 0; clip <= file.clip_count(); ++clip) {
      const bool rest = clip == file.clip_count();
      for (int moment = 0; moment < (rest ? 1 : kMoments); ++moment) {
        const tools::Play play = rest ? tools::Play{} : tools::play_together(file, clip);
        character.pose(play, play.duration_s * static_cast<float>(moment) / (kMoments - 1));
        tally.rigid.add(compare_mesh(mesh, character, m, feedback, tools::Deformer::rigid, diagonal));
        tally.ssd.add(compare_mesh(mesh, character, m, feedback, tools::Deformer::ssd, diagonal));
        tally.as.add(compare_mesh(mesh, character, m, feedback, tools::Deformer::as, diagonal));
        if (has_surface) {
          with_surface.pose(play, play.duration_s * static_cast<float>(moment) / (kMoments - 1));
          tally.surface.add(compare_surface(mesh, with_surface, m, tangents[m], surface, diagonal));
        }
        ++tally.poses;
      }
    }
  }
  return tally;
}

void expect_promises(const std::string& name, const Tally& tally) {
  for (const Worst* worst : {&tally.rigid, &tally.ssd, &tally.as, &tally.surface}) {
    EXPECT_LE(worst->position, kMostPosition) << name;
    EXPECT_LE(worst->normal_deg, kMostNormalDeg) << name;
    EXPECT_LE(worst->tangent_deg, kMostNormalDeg) << name;
    EXPECT_EQ(worst->wrong_signs, 0u) << name;
  }
  std::printf("%-32s %4zu poses  position %.1e %.1e %.1e  normal %.3f %.3f %.3f %.3f deg\n", name.c_str(), tally.poses,
              tally.rigid.position, tally.ssd.position, tally.as.position, tally.rigid.normal_deg, tally.ssd.normal_deg,
              tally.as.normal_deg, tally.surface.normal_deg);
}

TEST(Readback, TheEmbeddedSample) {
  const std::optional<Model> model = cook_model(model_paths().front());
  ASSERT_TRUE(model.has_value());
  const Tally tally = read_back(*model);
  expect_promises(model->name, tally);
  EXPECT_GE(tally.meshes, 1u);
  EXPECT_GE(tally.poses, tally.meshes * (3 * kMoments + 1));  // three clips at least, and the rest pose
  EXPECT_GE(tally.as.vertices, 3000u * tally.poses / tally.meshes);
  EXPECT_GT(tally.as.normals, tally.as.vertices / 2);
  EXPECT_GT(tally.surface.normals, tally.surface.vertices / 2);
}

TEST(Readback, EveryModel) {
  if (!have_assets()) {
    std::fprintf(stderr, "SKIPPED: no models; name their folder in MARROW_ASSETS\n");
    GTEST_SKIP() << "no models; name their folder in MARROW_ASSETS";
  }
  Tally all;
  std::size_t models = 0;
  for (const std::string& path : model_paths()) {
    const std::optional<Model> model = cook_model(path);
    EXPECT_TRUE(model.has_value()) << path;
    if (!model) continue;
    const Tally tally = read_back(*model);
    expect_promises(model->name, tally);
    all.rigid.add(tally.rigid);
    all.ssd.add(tally.ssd);
    all.as.add(tally.as);
    all.surface.add(tally.surface);
    all.poses += tally.poses;
    all.meshes += tally.meshes;
    all.refused += tally.refused;
    ++models;
  }
  std::printf("%s\n", gl().driver().c_str());
  expect_promises("worst of all (rigid, SSD, AS, its surface's)", all);
  std::printf(
      "%zu models, %zu meshes, %zu refused for their joints, %zu vertices compared, %zu normals, %zu tangents\n",
      models, all.meshes, all.refused, all.as.vertices, all.as.normals, all.as.tangents);
  EXPECT_EQ(models, model_paths().size());
  EXPECT_GE(all.meshes, models - 1);
  EXPECT_GE(all.poses, all.meshes);
  EXPECT_GT(all.as.normals, all.as.vertices / 2);
  std::printf("%zu of %zu normals of surfaces\n", all.surface.normals, all.surface.vertices);
  EXPECT_GT(all.surface.normals, all.as.normals / 4);
}

}  // namespace
}  // namespace marrow::test
