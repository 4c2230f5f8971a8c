// Principal displacements as morph targets, against the truth's own places in double precision.
#include "cook/learn/eigen_targets.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/failure.h"
#include "cook/options/options.h"
#include "cook/scene/node_motion.h"
#include "deform/deformers.h"
#include "disk/cook_on_disk.h"
#include "marrow/morph.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

constexpr int kRings = 9, kSides = 8;

// A tube of radius ½ along x, 0 … 4, whose second joint at x = 2 twists by up to 120° about it and back; the clip goes
// on for 2 s. Weights go over from one joint to the other between x = 1 and 3.
RawScene tube(bool is_rigid = false) {
  RawScene out;
  out.source = "tube";
  out.nodes.resize(3);
  const char* const names[] = {"near", "far", "body"};
  for (std::size_t i = 0; i < 3; ++i) out.nodes[i].name = names[i];
  out.nodes[1].parent = 0;
  out.nodes[1].translation = {2, 0, 0};
  RawSkin skin;
  skin.joints = {0, 1};
  skin.inverse_bind = {glm::dmat4(1), glm::dmat4(1)};
  skin.inverse_bind[1][3] = {-2, 0, 0, 1};
  out.skins.push_back(skin);
  RawPrimitive p;
  p.pointer = "/meshes/0/primitives/0";
  for (int ring = 0; ring < kRings; ++ring)
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2 * M_PI * side / kSides, x = 0.5 * ring;
      p.positions.emplace_back(x, 0.5 * std::cos(angle), 0.5 * std::sin(angle));
      const auto far = static_cast<float>(is_rigid ? std::round(x / 4) : std::clamp((x - 1) / 2, 0.0, 1.0));
      p.influences.push_back({{0, 1 - far}, {1, far}});
    }
  for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring)
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t a = ring * kSides + side, b = ring * kSides + (side + 1) % kSides;
      for (const std::uint32_t corner : {a, a + kSides, b, b, a + kSides, b + kSides}) p.indices.push_back(corner);
    }
  out.meshes.push_back({"tube", {}, {p}});
  out.instances.push_back({2, 0, 0, {}, kNone});
  const float s = std::sqrt(0.75F);
  out.clips.push_back(
      {"twist",
       {{1, RawPath::rotation, RawInterpolation::linear, {0, 1, 2}, {{0, 0, 0, 1}, {s, 0, 0, 0.5F}, {0, 0, 0, 1}}}},
       {},
       false});
  return out;
}

deform::SkinnedMesh mesh_of(const RawScene& scene) {
  deform::SkinnedMesh out;
  out.joint_count = 2;
  const RawPrimitive& p = scene.meshes[0].primitives[0];
  out.indices = p.indices;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    out.positions.emplace_back(p.positions[v]);
    std::vector<deform::Influence>& to = out.influences.emplace_back();
    for (const RawInfluence& i : p.influences[v])
      if (i.weight > 0) to.push_back({i.joint, static_cast<double>(i.weight)});
  }
  return out;
}

deform::Pose pose_at(const RawScene& scene, float time_s) {
  deform::Pose out;
  for (std::size_t j = 0; j < 2; ++j)
    out.emplace_back(NodeMotion(scene, scene.clips[0], {scene.skins[0].joints[j]}).at(time_s)[0] *
                     scene.skins[0].inverse_bind[j]);
  return out;
}

// The root of the mean square of how far SSD of the morphed mesh is from the truth of the plain one, at the weights'
// keys.
double rms(const RawScene& plain, const RawScene& morphed) {
  const deform::SkinnedMesh mesh = mesh_of(plain);
  const deform::Deformer truth = deform::centres_of_rotation(mesh);
  double sum = 0, count = 0;
  for (int k = 0; k <= 60; ++k) {
    const float time_s = static_cast<float>(2.0 * k / 60);
    deform::SkinnedMesh moved = mesh;
    const std::vector<RawTarget>& targets = morphed.meshes[0].primitives[0].targets;
    for (std::size_t n = 0; n < targets.size(); ++n) {
      const double weight = static_cast<double>(value_at(morphed.clips[0].scalars.at(n), time_s));
      for (std::size_t v = 0; v < moved.positions.size(); ++v)
        moved.positions[v] += weight * glm::dvec3(targets[n].positions[v]);
    }
    deform::Positions wanted, got;
    truth(pose_at(plain, time_s), wanted);
    deform::ssd(moved)(pose_at(plain, time_s), got);
    for (std::size_t v = 0; v < got.size(); ++v) {
      sum += glm::dot(got[v] - wanted[v], got[v] - wanted[v]);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

RawScene with_fields(int most, Notes& notes, const RawScene& scene = tube()) {
  LearnOptions options;
  options.eigen_targets = most;
  return add_eigen_targets(scene, options, notes);
}

TEST(EigenTargets, LeaveLessWithEachField) {
  const RawScene plain = tube();
  double last = rms(plain, plain);
  EXPECT_GT(last, 0.02) << "a twist by 120° narrows the tube";
  for (const int most : {1, 2, 3}) {
    Notes notes;
    const RawScene scene = with_fields(most, notes);
    ASSERT_EQ(scene.meshes[0].primitives[0].targets.size(), static_cast<std::size_t>(most));
    const double now = rms(plain, scene);
    EXPECT_LT(now, 0.7 * last) << most;
    last = now;
    // What the note says is what was measured.
    ASSERT_EQ(notes.warnings.size(), 1U);
    EXPECT_NE(notes.warnings[0].text.find("from "), std::string::npos);
    const double said = std::stod(notes.warnings[0].text.substr(notes.warnings[0].text.find(" to ") + 4));
    EXPECT_NEAR(said, now, 0.01 * now + 1e-6);
  }
}

TEST(EigenTargets, AreExactAtTheirKeysWithAsManyAsThereIsToSay) {
  Notes notes;
  EXPECT_LT(rms(tube(), with_fields(kMostEigenTargets, notes)), 1e-6);
}

TEST(EigenTargets, HaveNamesAndWeightsWithinOne) {
  Notes notes;
  const RawScene scene = with_fields(3, notes);
  ASSERT_EQ(scene.clips[0].scalars.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) {
    const RawScalar& scalar = scene.clips[0].scalars[n];
    EXPECT_EQ(scalar.name, "body.eigenskin[" + std::to_string(n) + "]");
    EXPECT_EQ(scene.instances[0].weights[n].channel, scalar.name);
    EXPECT_EQ(scalar.node, 2);
    EXPECT_EQ(scalar.times_s.size(), 61U);
    float most = 0;
    for (const float value : scalar.values) most = std::max(most, std::abs(value));
    EXPECT_NEAR(most, 1, 1e-6);
    EXPECT_NEAR(scalar.values.front(), 0, 1e-6) << "nothing is missing at rest";
  }
}

TEST(EigenTargets, NoneWhereNothingIsMissingOrMoves) {
  Notes notes;
  RawScene scene = with_fields(4, notes, tube(true));
  EXPECT_TRUE(scene.meshes[0].primitives[0].targets.empty()) << "one joint a vertex";
  RawScene still = tube();
  still.clips.clear();
  EXPECT_TRUE(with_fields(4, notes, still).meshes[0].primitives[0].targets.empty());
  RawScene hung = tube();
  hung.instances[0].skin = kNone;
  EXPECT_TRUE(with_fields(4, notes, hung).meshes[0].primitives[0].targets.empty());
  ASSERT_EQ(notes.warnings.size(), 3U);
  for (const RawWarning& warning : notes.warnings) EXPECT_EQ(warning.rule, "eigenskin-idle");
}

TEST(EigenTargets, AMeshDrawnTwiceIsCopied) {
  RawScene twice = tube();
  twice.nodes.push_back(twice.nodes[2]);
  twice.nodes[3].name = "twin";
  twice.instances.push_back({3, 0, 0, {}, kNone});
  Notes notes;
  const RawScene scene = with_fields(2, notes, twice);
  ASSERT_EQ(scene.meshes.size(), 2U);
  EXPECT_EQ(scene.clips[0].scalars.size(), 4U);
  for (const RawMesh& mesh : scene.meshes) EXPECT_EQ(mesh.primitives[0].targets.size(), 2U);
  EXPECT_EQ(scene.clips[0].scalars[2].name, "twin.eigenskin[0]");
  // Of one name, each has channels of its own, as morph targets of the source have.
  twice.nodes[3].name = "body";
  const RawScene namesakes = with_fields(2, notes, twice);
  EXPECT_EQ(namesakes.clips[0].scalars[0].name, "body.eigenskin[0]");
  EXPECT_EQ(namesakes.clips[0].scalars[2].name, "nodes[3].eigenskin[0]");
}

// Cooked and packed, sampled, morphed and skinned by the runtime.
TEST(EigenTargets, CookedAndPosed) {
  const LoadedCook cooked(cook_scene(tube(), options_of("--eigenskin 8")));
  Mesh mesh = cooked.file.mesh(0);
  const Clip clip = cooked.file.clip(0);
  std::vector<float> values(clip.channels.size), weights(mesh.targets.size);
  std::vector<std::uint32_t> channels(mesh.targets.size);
  ASSERT_EQ(mesh.targets.size, 4U) << "a twist has no more to say";
  ASSERT_EQ(find_weight_channels(cooked.file, mesh, cooked.file, clip, channels), Status::ok);
  const deform::SkinnedMesh source = mesh_of(tube());
  tools::AlignedBytes memory(morphed_bytes(mesh.geometry));
  MorphedGeometry morphed;
  ASSERT_EQ(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed), Status::ok);
  for (const float time_s : {0.0F, 0.6F, 1.0F}) {
    ASSERT_EQ(sample_channels(clip, time_s, values), Status::ok);
    ASSERT_EQ(morph_weights(mesh, channels, values, weights), Status::ok);
    ASSERT_EQ(morph(weights, morphed), Status::ok);
    mesh.geometry = morphed.geometry;
    const Skins skins = skins_at(cooked.file, 0, time_s, mesh);
    deform::Positions wanted;
    deform::centres_of_rotation(source)(pose_at(tube(), time_s), wanted);
    double worst = 0;
    for (const glm::dvec3& v : wanted) {
      double nearest = 1e9;
      for (const glm::vec3& at : skins.ssd) nearest = std::min(nearest, glm::length(glm::dvec3(at) - v));
      worst = std::max(worst, nearest);
    }
    EXPECT_LT(worst, 2e-3) << time_s << " s";  // half a thousandth of the tube's length
  }
}

TEST(EigenTargets, AsAnOption) {
  EXPECT_EQ(options_of("--eigenskin 8").learn.eigen_targets, 8);
  EXPECT_EQ(options_of("--eigenskin 8 --truth dqs").learn.truth, Truth::dual_quaternions);
  for (const std::string bad : {"--eigenskin 8 --clips-only", "--weights-over-time a=b,c --clips-only",
                                "--eigenskin -1", "--eigenskin 33", "--eigenskin x", "--eigenskin "})
    EXPECT_THROW(options_of(bad), tools::Failure) << bad;
  for (const std::string other : {"--as fit", "--as smooth", "--helpers 8", "--mwe", "--psd 8"})
    EXPECT_THROW(options_of("--eigenskin 8 --truth cor " + other), tools::Failure) << other;
}

}  // namespace
}  // namespace marrow::cook
