// Compressed clips keep their promise at what hangs on joints: by each deformer, at each level of detail, with morph
// targets. The same scene is cooked with its clips as they are, which road_test.cpp holds against the specification.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/aligned_bytes.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "marrow/character.h"
#include "marrow/skin.h"
#include "support/places.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

constexpr double kError = 1e-4;

enum class By { ssd, as };

// A cooked scene as a character of one mesh, posed by its first clip.
class CookedScene {
 public:
  CookedScene(RawScene scene, CookOptions options, bool raw_clips, std::uint32_t level) {
    options.mesh.codec = MeshCodec::none;
    options.clips.raw = raw_clips;
    Result result = cook_scene(std::move(scene), options);
    report = std::move(result.report);
    file_bytes_ = tools::AlignedBytes(result.file);
    EXPECT_EQ(load({file_bytes_.data(), file_bytes_.size()}, file), Status::ok);
    CharacterOptions as;
    as.level = level;
    as.animation_space = true;
    own_ = tools::AlignedBytes(character_bytes(file, as));
    shared_ = tools::AlignedBytes(animations_bytes(file, file));
    EXPECT_EQ(make_character(file, as, {own_.data(), own_.size()}, character), Status::ok);
    EXPECT_EQ(make_animations(file, file, {shared_.data(), shared_.size()}, animations_), Status::ok);
  }
  float duration_s() const { return animations_.all[0].duration_s; }
  // target: which morph target has weight 1, if there is any.
  std::vector<float> at(float time_s, By by, std::size_t target) {
    const AnimationLayer layer{&animations_.all[0], time_s, 1};
    EXPECT_EQ(pose_character(character, {&layer, 1}), Status::ok);
    CharacterMesh& m = character.meshes[0];
    for (std::size_t t = 0; t < m.weights.size; ++t) m.weights[t] = t == target ? 1.0f : 0.0f;
    EXPECT_EQ(finish_character(character), Status::ok);
    std::vector<float> out(std::size_t{3} * m.mesh.geometry.slot_count);
    EXPECT_EQ(by == By::ssd ? skin_ssd(m.mesh, m.palette, {out}) : skin_as(m.mesh, m.coordinates, m.palette, {out}),
              Status::ok);
    return out;
  }

  nlohmann::ordered_json report;
  File file;
  marrow::Character character;

 private:
  tools::AlignedBytes file_bytes_, own_, shared_;
  Animations animations_;
};

double farthest(const std::vector<float>& a, const std::vector<float>& b) {
  double squared = 0;
  for (std::size_t v = 0; v < a.size(); v += 3) {
    double sum = 0;
    for (std::size_t c = v; c < v + 3; ++c) sum += std::pow(static_cast<double>(a[c]) - static_cast<double>(b[c]), 2);
    squared = std::max(squared, sum);
  }
  return std::sqrt(squared);
}

// The largest distance at random times, between the clip as it is and compressed.
double worst_of(const RawScene& scene, const CookOptions& options, std::uint32_t level, By by, std::size_t targets) {
  CookedScene source(scene, options, true, level), coded(scene, options, false, level);
  EXPECT_EQ(coded.report["clips"][0]["codec"], "segments") << coded.report["clips"][0]["raw_because"];
  EXPECT_LE(coded.report["clips"][0]["max_vertex_error_m"].get<double>(), kError);
  std::mt19937 random(5);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const float time_s = source.duration_s() * static_cast<float>(random() % 10007) / 10007;
    for (std::size_t target = 0; target <= targets; ++target)
      worst = std::max(worst, farthest(source.at(time_s, by, target), coded.at(time_s, by, target)));
  }
  return worst;
}

TEST(Hung, EveryDeformerAndLevelKeepsThePromise) {
  const CookOptions options = options_of("--as fit --truth dqs --helpers auto --lod 0.5");
  const RawScene elbow = read_gltf(test::in_golden("elbow.gltf"));
  const CookedScene cooked(elbow, options, true, 0);
  ASSERT_FALSE(cooked.file.mesh(0).helpers.empty());
  ASSERT_NE(cooked.file.mesh(0).geometry.as_residual, nullptr);
  ASSERT_LT(cooked.file.mesh(0, 1).geometry.index_count, cooked.file.mesh(0).geometry.index_count);
  for (const std::uint32_t level : {0u, 1u})
    for (const By by : {By::ssd, By::as}) {
      const double worst = worst_of(elbow, options, level, by, 0);
      EXPECT_LE(worst, 1.1 * kError) << level << ' ' << static_cast<int>(by);
      EXPECT_GT(worst, 0.01 * kError) << "something was lost, or there is nothing to see";
    }
}

// A flag that is rolled up against its pole, and 4 m long with its morph target.
RawScene flag() {
  RawScene scene;
  scene.source = "flag";
  for (const char* name : {"pole", "flag"}) scene.nodes.emplace_back().name = name;
  RawPrimitive p;
  p.positions = {{0, 0, 0}, {0.01F, 0, 0}, {0, 0.01F, 0}};
  p.indices = {0, 1, 2};
  p.influences.assign(3, {{0, 1.0F}});
  p.pointer = "/meshes/0/primitives/0";
  p.targets.emplace_back().positions = {{0, 0, 0}, {4, 0, 0}, {4, 0, 0}};
  scene.meshes.push_back({"flag", {}, {p}});
  scene.skins.push_back({"pole", {0}, {glm::dmat4(1.0)}});
  scene.instances.push_back({1, 0, 0, {{"unrolled", "flag.unrolled", 0}}, kNone});
  RawChannel turn{0, RawPath::rotation, RawInterpolation::linear, {}, {}};
  for (int k = 0; k < 40; ++k) {
    const double half = 0.4 * std::sin(0.3 * k);
    turn.times_s.push_back(static_cast<float>(k) / 30);
    turn.values.emplace_back(0, std::sin(half), 0, std::cos(half));
  }
  scene.clips.push_back({"wave", {turn}, {}});
  return scene;
}

TEST(Hung, MorphTargetsCountAtWeightOne) {
  EXPECT_LE(worst_of(flag(), {}, 0, By::ssd, 1), 1.1 * kError);
  const CookedScene shell(flag(), options_of("--clip-shell 3cm"), false, 0);
  EXPECT_GT(shell.report["clips"][0]["max_vertex_error_m"].get<double>(), 10 * kError) << "it does not keep itself";
}

// What a game hangs on a kept node.
TEST(Hung, KeptNodesCount) {
  RawScene scene = flag();
  scene.meshes[0].primitives[0].targets.clear();
  scene.instances[0].weights.clear();
  RawNode tip;
  tip.name = "tip";
  tip.parent = 0;
  tip.translation = {4, 0, 0};
  scene.nodes.push_back(tip);
  const auto error_at_the_tip = [&](const CookOptions& options) {
    CookedScene source(scene, options, true, 0), coded(scene, options, false, 0);
    double worst = 0;
    for (int i = 0; i < 60; ++i) {
      std::vector<float> places[2];
      for (CookedScene* cooked : {&source, &coded}) {
        (void)cooked->at(static_cast<float>(i) / 45, By::ssd, 0);
        const auto& rows = cooked->character.skeletons[0].pose.model_from_joint[0].rows;
        for (const auto& row : rows) places[cooked == &coded ? 1 : 0].push_back(4 * row[0] + row[3]);
      }
      worst = std::max(worst, farthest(places[0], places[1]));
    }
    return worst;
  };
  EXPECT_GT(error_at_the_tip({}), 2 * kError) << "nobody said that it counts";
  EXPECT_LE(error_at_the_tip(options_of("--keep tip")), 1.1 * kError);
}

}  // namespace
}  // namespace marrow::cook
