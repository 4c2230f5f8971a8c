// Characters that are hard on a path, on those that readback_models_test.cpp leaves out: crowds, the CPU's, and
// palettes of any size in a texture; with no more than GLES 3.0 promises.
#include <cstdio>

#include <gtest/gtest.h>

#include "gl/support/crowd_worst.h"
#include "gl/support/models.h"
#include "marrow/gles3_skinner.h"
#include "marrow/marrow.h"
#include "pose/evaluate.h"
#include "support/millipede.h"
#include "support/places.h"

namespace marrow::test {
namespace {

constexpr double kMostPosition = 2e-4;  // of the diagonal
constexpr double kMostNormalDeg = 1;
constexpr double kLeastConditioning = 0.05;
constexpr std::uint32_t kMillipedeJoints = 2000;

// Every mesh as a crowd. The number of meshes.
std::uint32_t read_back_crowds(const Model& model) {
  const File& file = model.file;
  Worst worst;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    std::vector<gles3::CrowdSource> clips = all_clips(file, mesh.skeleton);
    Clip still;
    still.duration_s = 1;
    if (clips.empty()) clips.push_back({still, true});
    const Reel reel(file.skeleton(mesh.skeleton), clips, 4);
    worst.add(compare_crowd(mesh, reel, {}, 0, 6));
  }
  expect_crowd_promises(model.name.c_str(), worst);
  return file.mesh_count();
}

// What path cpu has put into its buffer, against the CPU's: the very bits.
std::size_t read_back_cpu(const Model& model) {
  const File& file = model.file;
  tools::Character character(file);
  const tools::Play play = file.clip_count() == 0 ? tools::Play{} : tools::play_together(file, 0);
  character.pose(play, 0.4f * play.duration_s);
  std::size_t compared = 0;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    gles3::ProgramSet programs;
    programs.roles[0] = feedback_source();
    gles3::SkinnerOptions options;
    options.path = gles3::SkinningPath::cpu;
    std::vector<SoaTransform> memory;
    gles3::Skinner skinner;
    EXPECT_EQ(gles3::create_skinner(gl(), {}, mesh, options, programs,
                                    room_for(memory, gles3::skinner_bytes(mesh, options)), skinner),
              Status::ok);
    EXPECT_EQ(gles3::pose(skinner, 0, character.model_from_joint(mesh.skeleton), character.weights(m)), Status::ok);
    EXPECT_EQ(gles3::update(gl(), skinner, programs, 1), Status::ok);
    tools::PosedMesh want;
    character.skin(m, tools::Deformer::ssd, want);
    std::vector<float> all = want.positions;
    all.insert(all.end(), want.normals.begin(), want.normals.end());
    all.insert(all.end(), want.tangents.begin(), want.tangents.end());
    EXPECT_EQ(read_feedback(skinner.skinned[0].buffer, all.size()), all) << model.name << " " << m;
    compared += all.size();
    gles3::destroy(gl(), skinner);
    gles3::destroy(gl(), programs);
  }
  return compared;
}

TEST(ReadbackLarge, AMillipedeInPartsAsACrowdAndOnTheCpu) {
  const std::optional<Model> model = cook_model(Millipede(kMillipedeJoints / 5).scene);
  ASSERT_TRUE(model.has_value());
  ASSERT_EQ(model->file.skeleton(0).joint_count, kMillipedeJoints);
  EXPECT_GE(read_back_crowds(*model), 6u);
  EXPECT_GE(read_back_cpu(*model), std::size_t{6} * 14000);
}

// One mesh, one palette: of the vertex shader's paths a texture takes it, or a crowd.
TEST(ReadbackLarge, AMillipedeInOnePiece) {
  const std::optional<Model> model = cook_model(Millipede(kMillipedeJoints / 5).scene, kMillipedeJoints);
  ASSERT_TRUE(model.has_value());
  ASSERT_EQ(model->file.mesh_count(), 1u);
  const Mesh mesh = model->file.mesh(0);
  ASSERT_EQ(mesh.palette_size(), kMillipedeJoints);
  Feedback feedback(mesh);
  ASSERT_EQ(feedback.prepared(), Status::ok);
  tools::Character character(model->file);
  const tools::Play play = tools::play_together(model->file, 0);
  Worst worst;
  for (const float share : {0.0f, 0.3f, 1.0f}) {
    character.pose(play, share * play.duration_s);
    for (const tools::Deformer deformer : {tools::Deformer::rigid, tools::Deformer::ssd, tools::Deformer::as}) {
      tools::PosedMesh want;
      character.skin(0, deformer, want);
      const bool as = deformer == tools::Deformer::as;
      const gles3::Deformer on_gpu = as                                 ? gles3::Deformer::as
                                     : deformer == tools::Deformer::ssd ? gles3::Deformer::ssd
                                                                        : gles3::Deformer::rigid;
      const std::vector<double> well = deformer == tools::Deformer::rigid
                                           ? std::vector<double>(mesh.geometry.slot_count, 1.0)
                                           : conditioning(mesh.geometry, character.palette(0), as);
      worst.add(compare(mesh.geometry, feedback.skin(on_gpu, character.model_from_joint(0), {}, Way::texture),
                        {want.positions, want.normals, want.tangents}, 0.1 * kMillipedeJoints / 5, well,
                        kLeastConditioning));
    }
  }
  std::printf("in one piece: position %.1e of the diagonal, normal %.3f deg, %zu vertices\n", worst.position,
              worst.normal_deg, worst.vertices);
  EXPECT_LE(worst.position, kMostPosition);
  EXPECT_LE(worst.normal_deg, kMostNormalDeg);
  EXPECT_GE(worst.vertices, std::size_t{9} * 13000);
  EXPECT_EQ(read_back_crowds(*model), 1u);
  EXPECT_GE(read_back_cpu(*model), std::size_t{6} * 13000);
}

// More influences than a vertex takes, joints by the hundred, and a character of a film.
TEST(ReadbackLarge, ModelsAsCrowdsAndOnTheCpu) {
  if (!have_assets()) {
    std::fprintf(stderr, "SKIPPED: no models; name their folder in MARROW_ASSETS\n");
    GTEST_SKIP() << "no models; name their folder in MARROW_ASSETS";
  }
  int models = 0;
  for (const std::string& path : model_paths()) {
    const auto ends_with = [&](const char* name) { return path.ends_with(name); };
    if (!ends_with("assimp_quad_skin_10inf.glb") && !ends_with("ruby.glb") && !ends_with("pab.glb")) continue;
    const std::optional<Model> model = cook_model(path);
    ASSERT_TRUE(model.has_value()) << path;
    EXPECT_GE(read_back_crowds(*model), 1u);
    EXPECT_GE(read_back_cpu(*model), 24u) << "four vertices";
    ++models;
  }
  EXPECT_EQ(models, in_long_form() ? 3 : 1);
}

}  // namespace
}  // namespace marrow::test
