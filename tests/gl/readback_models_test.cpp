// Every model, every clip, every deformer: what the vertex shader computes against what the CPU computes.
#include <cstdio>

#include <gtest/gtest.h>

#include "gl/support/feedback.h"
#include "gl/support/models.h"
#include "gl/support/worst.h"
#include "pose/evaluate.h"
#include "render/performance.h"
#include "support/millipede.h"

namespace marrow::test {
namespace {

// What is promised; measured values are printed.
constexpr double kMostPosition = 2e-4;
constexpr double kMostNormalDeg = 1;
// Below this a fold is so flat that one step of a weight turns its normal.
constexpr double kLeastConditioning = 0.02;
constexpr double kLeastSurfaceConditioning = 0.01;
#ifdef __SANITIZE_ADDRESS__
constexpr int kWayMoments = 1;  // what it looks for is the same at every moment
#else
constexpr int kWayMoments = 8;  // of the first clip, in every way
#endif
constexpr int kMoments = 4;  // of every clip, by the uniform block

struct Tally {
  Worst rigid, ssd, as, surface;
  Worst ways[std::size(kWays)];
  std::size_t poses = 0, meshes = 0;
};

Worst compare_mesh(const Mesh& mesh, const tools::Character& character, std::uint32_t index, Feedback& feedback,
                   tools::Deformer deformer, double diagonal, Way way = Way::block) {
  tools::PosedMesh posed;
  character.skin(index, deformer, posed);
  const gles3::Deformer on_gpu = deformer == tools::Deformer::rigid ? gles3::Deformer::rigid
                                 : deformer == tools::Deformer::ssd ? gles3::Deformer::ssd
                                                                    : gles3::Deformer::as;
  const Skinned got = feedback.skin(on_gpu, character.model_from_joint(mesh.skeleton),
                                    {character.weights(index).data(), mesh.targets.size}, way);
  const std::vector<double> well =
      deformer == tools::Deformer::rigid
          ? std::vector<double>(mesh.geometry.slot_count, 1.0)
          : conditioning(mesh.geometry, character.palette(index), deformer == tools::Deformer::as);
  return compare(mesh.geometry, got, {posed.positions, posed.normals, posed.tangents}, diagonal, well,
                 kLeastConditioning);
}

// Animation space with its surface's own normals.
Worst compare_surface(const Mesh& mesh, const tools::Character& character, std::uint32_t index,
                      Span<const float> tangents, Feedback& feedback, double diagonal, Way way = Way::block) {
  tools::PosedMesh posed;
  character.skin(index, tools::Deformer::as, posed);
  const Skinned got = feedback.skin(gles3::Deformer::as, character.model_from_joint(mesh.skeleton), {}, way);
  const std::vector<double> well = surface_conditioning(mesh.geometry, tangents, character.palette(index));
  return compare(mesh.geometry, got, {posed.positions, posed.normals, posed.tangents}, diagonal, well,
                 kLeastSurfaceConditioning);
}

// One mesh of a model, on the GPU with normals by the blend and by the surface.
struct Subject {
  Subject(const File& file, std::uint32_t m, Span<const float> of_surface)
      : mesh(file.mesh(m)), index(m), tangents(of_surface), blended(mesh), surface(mesh, of_surface) {}
  bool has_surface() const { return (surface.gpu().features & gles3::kSurfaceNormals) != 0; }

  Mesh mesh;
  std::uint32_t index;
  Span<const float> tangents;
  Feedback blended, surface;
};

void read_back_ways(const File& file, tools::Character& character, tools::Character& with_surface, Subject& subject,
                    double diagonal, Tally& tally) {
  const tools::Play play = file.clip_count() == 0 ? tools::Play{} : tools::play_together(file, 0);
  for (int moment = 0; moment < kWayMoments; ++moment) {
    const float time_s = play.duration_s * static_cast<float>(moment + 1) / kWayMoments;
    character.pose(play, time_s);
    if (subject.has_surface()) with_surface.pose(play, time_s);
    for (std::size_t w = 0; w < std::size(kWays); ++w) {
      if (!can(kWays[w])) continue;
      for (const tools::Deformer deformer : {tools::Deformer::rigid, tools::Deformer::ssd, tools::Deformer::as})
        tally.ways[w].add(
            compare_mesh(subject.mesh, character, subject.index, subject.blended, deformer, diagonal, kWays[w]));
      if (subject.has_surface())
        tally.ways[w].add(compare_surface(subject.mesh, with_surface, subject.index, subject.tangents, subject.surface,
                                          diagonal, kWays[w]));
    }
  }
}

Tally read_back(const Model& model) {
  const File& file = model.file;
  Tally tally;
  tools::Character character(file), with_surface(file, tools::AsNormals::tangents);
  const std::vector<std::vector<float>> tangents = tools::tangents_of(file);
  const double diagonal =
      2 * static_cast<double>(tools::box_of(tools::skin_all(file, character, tools::Deformer::ssd)).radius());
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    Subject subject(file, m, tangents[m]);
    EXPECT_EQ(subject.blended.prepared(), Status::ok) << model.name;
    if (!subject.blended.ok()) continue;
    ++tally.meshes;
    read_back_ways(file, character, with_surface, subject, diagonal, tally);
    const Mesh& mesh = subject.mesh;
    // clip_count() stands for the rest pose.
    for (std::uint32_t clip = 0; clip <= file.clip_count(); ++clip) {
      const bool rest = clip == file.clip_count();
      for (int moment = 0; moment < (rest ? 1 : kMoments); ++moment) {
        const tools::Play play = rest ? tools::Play{} : tools::play_together(file, clip);
        character.pose(play, play.duration_s * static_cast<float>(moment) / (kMoments - 1));
        tally.rigid.add(compare_mesh(mesh, character, m, subject.blended, tools::Deformer::rigid, diagonal));
        tally.ssd.add(compare_mesh(mesh, character, m, subject.blended, tools::Deformer::ssd, diagonal));
        tally.as.add(compare_mesh(mesh, character, m, subject.blended, tools::Deformer::as, diagonal));
        if (subject.has_surface()) {
          with_surface.pose(play, play.duration_s * static_cast<float>(moment) / (kMoments - 1));
          tally.surface.add(compare_surface(mesh, with_surface, m, tangents[m], subject.surface, diagonal));
        }
        ++tally.poses;
      }
    }
  }
  return tally;
}

void expect_promises(const std::string& name, const Tally& tally) {
  std::vector<Worst> all = {tally.rigid, tally.ssd, tally.as, tally.surface};
  all.insert(all.end(), std::begin(tally.ways), std::end(tally.ways));
  for (const Worst& worst : all) {
    EXPECT_LE(worst.position, kMostPosition) << name;
    EXPECT_LE(worst.normal_deg, kMostNormalDeg) << name;
    EXPECT_LE(worst.tangent_deg, kMostNormalDeg) << name;
    EXPECT_EQ(worst.wrong_signs, 0u) << name;
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
  for (std::size_t w = 0; w < std::size(kWays); ++w)
    EXPECT_GE(tally.ways[w].vertices, can(kWays[w]) ? 3000u * kWayMoments : 0u) << name_of(kWays[w]);
}

// More joints than a palette takes: in parts.
TEST(Readback, AMillipede) {
  const std::optional<Model> model = cook_model(Millipede(400).scene);
  ASSERT_TRUE(model.has_value());
  EXPECT_EQ(model->file.skeleton(0).joint_count, 2000u);
  const Tally tally = read_back(*model);
  expect_promises(model->name, tally);
  EXPECT_EQ(tally.meshes, model->file.mesh_count());
  EXPECT_GE(tally.meshes, 6u);
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
    for (std::size_t w = 0; w < std::size(kWays); ++w) all.ways[w].add(tally.ways[w]);
    all.poses += tally.poses;
    all.meshes += tally.meshes;
    ++models;
  }
  std::printf("%s\n", gl().driver().c_str());
  expect_promises("worst of all (rigid, SSD, AS, its surface's)", all);
  std::printf("%zu models, %zu meshes, %zu vertices compared, %zu normals, %zu tangents\n", models, all.meshes,
              all.as.vertices, all.as.normals, all.as.tangents);
  EXPECT_EQ(models, model_paths().size());
  EXPECT_GE(all.meshes, models);
  for (std::size_t w = 0; w < std::size(kWays); ++w) {
    std::printf("%-14s %10zu vertices  position %.1e  normal %.3f deg\n", name_of(kWays[w]), all.ways[w].vertices,
                all.ways[w].position, all.ways[w].normal_deg);
    EXPECT_GE(all.ways[w].vertices, can(kWays[w]) ? 1000 * models : 0) << name_of(kWays[w]);
  }
  EXPECT_GE(all.poses, all.meshes);
  EXPECT_GT(all.as.normals, all.as.vertices / 2);
  std::printf("%zu of %zu normals of surfaces\n", all.surface.normals, all.surface.vertices);
  EXPECT_GT(all.surface.normals, all.as.normals / 4);
}

}  // namespace
}  // namespace marrow::test
