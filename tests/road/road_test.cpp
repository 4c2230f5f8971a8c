// The whole road of data, source file to deformed vertices, against the reference evaluator: every model, every clip.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "road/cooked.h"
#include "road/models.h"
#include "road/reference.h"
#include "support/places.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

// What is promised, as fractions of the model's diagonal and in degrees.
constexpr double kMostPosition = 1e-4;
constexpr double kMostLift = 1e-5;
constexpr double kMostNormalDeg = 0.5;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kMoments = 4;  // thinned: the numbers are the same as without a sanitizer, and this is for memory errors
#else
constexpr int kMoments = 16;
#endif

struct Worst {
  double position = 0, rigid = 0, lift = 0;  // fractions of the diagonal
  double normal_deg = 0, tangent_deg = 0;
  std::size_t poses = 0, vertices = 0, normals = 0, tangents = 0, wrong_signs = 0;
};

void compare_directions(const ReferencePose& want, const CookedPose& got, std::size_t v, Worst& worst) {
  if (length(want.normals[v]) > 0) {
    worst.normal_deg = std::max(worst.normal_deg, angle_deg(want.normals[v], got.normals[v]));
    ++worst.normals;
  }
  if (length(want.tangents[v]) > 0) {
    worst.tangent_deg = std::max(worst.tangent_deg, angle_deg(want.tangents[v], got.tangents[v]));
    if (want.tangent_signs[v] != got.tangent_signs[v]) ++worst.wrong_signs;
    ++worst.tangents;
  }
}

void compare(const Reference& reference, const ReferencePose& want, const Cooked& cooked, std::uint32_t clip,
             float time_s, Worst& worst, const std::vector<float>& cycle = {}) {
  const CookedPose ssd = cooked.pose(clip, time_s, Deformer::ssd, cycle);
  const CookedPose as = cooked.pose(clip, time_s, Deformer::as, cycle);
  const CookedPose rigid = cooked.pose(clip, time_s, Deformer::rigid, cycle);
  ASSERT_EQ(ssd.positions.size(), want.positions.size()) << "every vertex of the source, no more";
  const double scale = 1 / reference.diagonal();
  // NaN compares false with everything: turned into a huge error here, so that it cannot slip through std::max.
  const auto error = [&](const Vec3& a, const Vec3& b) {
    const double e = length(minus(a, b)) * scale;
    return e < 1e300 ? e : 1e300;
  };
  for (std::size_t v = 0; v < want.positions.size(); ++v) {
    if (!reference.comparable(v) || !ssd.used[v]) continue;
    worst.position = std::max(worst.position, error(want.positions[v], ssd.positions[v]));
    worst.lift = std::max(worst.lift, error(as.positions[v], ssd.positions[v]));
    if (want.rigid_unique[v]) worst.rigid = std::max(worst.rigid, error(want.rigid[v], rigid.positions[v]));
    compare_directions(want, ssd, v, worst);
    compare_directions(want, as, v, worst);
    ++worst.vertices;
  }
  ++worst.poses;
}

// From before the first key to the last, one moment on a key's own time, where STEP jumps.
float moment_s(const Reference& reference, std::size_t animation, int i) {
  const double duration_s = reference.duration_s(animation);
  if (i == kMoments / 2) {
    const SourceAnimation& a = reference.source().animations[animation];
    const auto& times =
        a.channels.empty() ? a.weights.front().channel.times_s : a.channels[a.channels.size() / 2].times_s;
    return static_cast<float>(times[times.size() / 2]);
  }
  return static_cast<float>(duration_s * i / (kMoments - 1));
}

class Road : public ::testing::TestWithParam<std::string> {};

TEST_P(Road, AgreesWithTheReference) {
  const Reference reference(GetParam());
  const Cooked cooked(GetParam());
  ASSERT_GT(reference.diagonal(), 0);
  Worst worst;
  const std::uint32_t clips = cooked.file().clip_count();
  compare(reference, reference.rest(), cooked, clips, 0, worst);
  std::uint32_t clip = 0, posed = 0;
  for (std::size_t a = 0; a < reference.source().animations.size(); ++a) {
    const SourceAnimation& animation = reference.source().animations[a];
    if (animation.channels.empty() && animation.weights.empty()) continue;
    ASSERT_LT(clip, clips);
    EXPECT_EQ(cooked.file().clip(clip).name, animation.name);
    for (int i = 0; i < kMoments; ++i) {
      const float time_s = moment_s(reference, a, i);
      compare(reference, reference.at(a, static_cast<double>(time_s)), cooked, clip, time_s, worst);
    }
    clip = next_animation(cooked.file(), clip);
    ++posed;
  }
  EXPECT_EQ(clip, clips);
  EXPECT_EQ(worst.poses, 1 + static_cast<std::size_t>(posed) * kMoments);
  EXPECT_GT(worst.vertices, 0u);
  EXPECT_LE(worst.position, kMostPosition);
  EXPECT_LE(worst.rigid, kMostPosition);
  EXPECT_LE(worst.lift, kMostLift);
  EXPECT_LE(worst.normal_deg, kMostNormalDeg);
  EXPECT_LE(worst.tangent_deg, kMostNormalDeg);
  EXPECT_EQ(worst.wrong_signs, 0u);
  std::printf(
      "%-28s %9zu B %6zu poses %10zu vertices  position %8.2e  lift %8.2e  rigid %8.2e  normal %7.4f°  tangent %7.4f°"
      "  (%zu normals, %zu tangents)\n",
      fs::path(GetParam()).stem().c_str(), cooked.bytes(), worst.poses, worst.vertices, worst.position, worst.lift,
      worst.rigid, worst.normal_deg, worst.tangent_deg, worst.normals, worst.tangents);
}

bool has_targets(const Source& source) {
  for (const auto& mesh : source.meshes)
    for (const SourcePrimitive& p : mesh)
      if (!p.targets.empty()) return true;
  return false;
}

class Morphs : public ::testing::TestWithParam<std::string> {};

// Every target at once and apart, at weights of either sign and beyond 1.
TEST_P(Morphs, AgreeWithTheReference) {
  const Reference reference(GetParam());
  const Cooked cooked(GetParam());
  Worst worst;
  const std::vector<std::vector<float>> cycles = {{1}, {-0.5f, 0, 1.5f}, {0, 0.75f}, {0, 0, 0, 0, 1}, {0.25f, -0.125f}};
  for (const std::vector<float>& cycle : cycles)
    compare(reference, reference.rest(cycle), cooked, cooked.file().clip_count(), 0, worst, cycle);
  EXPECT_EQ(worst.poses, cycles.size());
  EXPECT_LE(worst.position, kMostPosition);
  EXPECT_LE(worst.lift, kMostLift);
  EXPECT_LE(worst.normal_deg, kMostNormalDeg);
  EXPECT_LE(worst.tangent_deg, kMostNormalDeg);
  EXPECT_EQ(worst.wrong_signs, 0u);
  std::printf("%-28s %zu weights  position %8.2e  lift %8.2e  normal %7.4f°  tangent %7.4f°  (%zu normals)\n",
              fs::path(GetParam()).stem().c_str(), cycles.size(), worst.position, worst.lift, worst.normal_deg,
              worst.tangent_deg, worst.normals);
}

std::vector<std::string> models_with_targets() {
  std::vector<std::string> out;
  for (const std::string& path : models())
    if (has_targets(read_source(path))) out.push_back(path);
  return out;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).stem().string() + "_" + std::to_string(info.index);
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Models, Morphs, ::testing::ValuesIn(models_with_targets()), test_name);
INSTANTIATE_TEST_SUITE_P(Models, Road, ::testing::ValuesIn(models()), test_name);

TEST(RoadModels, AreAllThere) {
  if (!fs::exists(assets() / "manifest.json")) {
    std::fprintf(stderr, "NO MODELS at %s: set MARROW_ASSETS. Only the project's own models are tested.\n",
                 assets().c_str());
    GTEST_SKIP();
  }
  std::ifstream manifest(assets() / "manifest.json");
  const std::size_t listed = nlohmann::json::parse(manifest).at("assets").size();
  std::size_t found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(assets()))
    found += entry.path().extension() == ".glb" || entry.path().extension() == ".gltf";
  EXPECT_GT(listed, 0u);
  EXPECT_EQ(found, listed);
  std::size_t tested = 0;
  for (const std::string& model : models()) tested += model.rfind(assets().string(), 0) == 0 && fs::exists(model);
  if (in_long_form())
    EXPECT_EQ(tested, listed);
  else
    EXPECT_GT(tested, listed / 2);
}

}  // namespace
}  // namespace marrow::test
