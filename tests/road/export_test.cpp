// A cooked file exported to glTF is the source again: every vertex of every model by the reference evaluator, which
// reads both files itself; and coded clips between their frames, against the runtime's decoder.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "disk/cook_on_disk.h"
#include "export/export.h"
#include "marrow/local_to_model.h"
#include "marrow/sample.h"
#include "road/models.h"
#include "road/reference.h"
#include "support/aligned.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

// What cooking promises of positions, as a share of the diagonal; exporting adds float rounding.
constexpr double kMostPosition = 1e-4;
// Between frames: times are floats, and a millionth of a second late is 5e-5 of the way between two frames.
constexpr double kMostJoint = 5e-5;
constexpr int kMoments = 16;

struct ExportedModel {
  ExportedModel(const std::string& source, bool raw) {
    cook::CookOptions options;
    options.mesh.keep_vertex_order = true;
    options.mesh.codec = cook::MeshCodec::none;
    options.clips.raw = raw;
    const cook::Result cooked = cook::cook_file(source, options);
    block = std::make_unique<AlignedBlock>(cooked.file.data(), cooked.file.size());
    if (load(*block, file) != Status::ok) throw std::runtime_error("cooked, but not loaded");
    std::string name = (fs::temp_directory_path() / "marrow_export_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    folder = name;
    path = (folder / "export.glb").string();
    const tools::Exported exported = tools::export_file(file, source);
    warnings = exported.warnings;
    std::ofstream(path, std::ios::binary) << exported.glb;
  }
  ~ExportedModel() { fs::remove_all(folder); }

  std::unique_ptr<AlignedBlock> block;
  File file;
  fs::path folder;
  std::string path;
  std::vector<tools::Warning> warnings;
};

class Export : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__)
    if (fs::file_size(GetParam()) > 1'000'000) GTEST_SKIP() << "thinned under sanitizers";
#endif
  }
};

// Of the source's vertices in their order: whether a triangle uses them, for others are not cooked.
std::vector<bool> used_vertices(const File& file) {
  std::vector<bool> used;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const auto slots = file.mesh(m).geometry.source_slots;
    const std::size_t first = used.size() - (file.mesh(m).is_next_part ? slots.size : 0);
    used.resize(first + slots.size, false);
    for (std::size_t v = 0; v < slots.size; ++v)
      if (slots[v] != kNoSlot) used[first + v] = true;
  }
  return used;
}

double worst_distance(const Reference& source, const std::vector<bool>& used, const ReferencePose& p,
                      const ReferencePose& q) {
  double worst = 0;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    if (!source.comparable(v) || !used[v]) continue;
    const double distance = length(minus(p.positions[v], q.positions[v]));
    worst = std::max(worst, distance < 1e300 ? distance : 1e300);
  }
  return worst / source.diagonal();
}

TEST_P(Export, PosesAsItsSource) {
  const ExportedModel exported(GetParam(), true);
  for (const tools::Warning& warning : exported.warnings)
    EXPECT_NE(warning.text.find("--images embed"), std::string::npos);
  const Reference source(GetParam()), back(exported.path);
  ASSERT_EQ(source.rest().positions.size(), back.rest().positions.size());
  const std::vector<bool> used = used_vertices(exported.file);
  ASSERT_EQ(used.size(), source.rest().positions.size());
  double worst = worst_distance(source, used, source.rest(), back.rest());
  std::size_t clip = 0, poses = 1;
  for (std::size_t a = 0; a < source.source().animations.size(); ++a) {
    const SourceAnimation& animation = source.source().animations[a];
    if (animation.channels.empty() && animation.weights.empty()) continue;
    ASSERT_LT(clip, back.source().animations.size());
    EXPECT_EQ(back.source().animations[clip].name, animation.name);
    for (int i = 0; i < kMoments && !animation.channels.empty(); ++i, ++poses) {
      const double time_s = source.duration_s(a) * i / (kMoments - 1);
      worst = std::max(worst, worst_distance(source, used, source.at(a, time_s), back.at(clip, time_s)));
    }
    ++clip;
  }
  EXPECT_EQ(clip, back.source().animations.size());
  EXPECT_LE(worst, kMostPosition);
  std::printf("%-28s %zu poses, position %8.2e\n", fs::path(GetParam()).stem().c_str(), poses, worst);
}

// glTF interpolates between keys as the decoder does between frames: on the sphere.
TEST_P(Export, CodedClipsAgreeBetweenFrames) {
  const ExportedModel exported(GetParam(), false);
  const Reference back(exported.path);
  double worst = 0;
  std::size_t compared = 0, coded = 0;
  for (std::uint32_t c = 0; c < exported.file.clip_count(); ++c) {
    const Clip clip = exported.file.clip(c);
    if (clip.coded.frame_count == 0 || clip.skeleton != 0) continue;
    ++coded;
    const Skeleton skeleton = exported.file.skeleton(0);
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::vector<Affine> scene(skeleton.joint_count);
    const std::uint32_t quarters = 4 * (clip.coded.frame_count - 1), step = std::max(1u, quarters / 64) | 1u;
    for (std::uint32_t q = 0; q <= quarters; q += step) {
      const float frame_s = clip.coded.time_of(q / 4), next_s = clip.coded.time_of(std::min(q / 4 + 1, quarters / 4));
      const float time_s = frame_s + (next_s - frame_s) * static_cast<float>(q % 4) / 4;
      ASSERT_EQ(sample(skeleton, clip, time_s, local), Status::ok);
      ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
      const std::vector<Map> nodes = back.nodes_at(c, static_cast<double>(time_s));
      for (std::size_t j = 0; j < scene.size(); ++j, ++compared)
        for (std::size_t r = 0; r < 3; ++r)
          worst = std::max(worst, std::fabs(nodes[j].rows[r][3] - static_cast<double>(scene[j].rows[r][3])));
    }
  }
  EXPECT_EQ(compared > 0, coded > 0);
  EXPECT_LE(worst, kMostJoint * back.diagonal());
  std::printf("%-28s %zu clips, %zu joints, %8.2e of the diagonal\n", fs::path(GetParam()).stem().c_str(), coded,
              compared, worst / back.diagonal());
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).stem().string() + "_" + std::to_string(info.index);
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Models, Export, ::testing::ValuesIn(models()), test_name);

}  // namespace
}  // namespace marrow::test
