// Multi-weights and pose space that are learnt, from a scene to what the runtime's kernels make of the cooked file.
#include "cook/learn/learn_deformers.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "cook/clip/build_clips.h"
#include "cook/learn/learn.h"
#include "cook/skeleton/build_skeletons.h"
#include "cook/skin/primitive_palette.h"
#include "deform/cylinder.h"
#include "deform/fit/multi_weight.h"
#include "deform/fit/pose_space.h"
#include "marrow/marrow.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

// The cylinder in two primitives. The second is its far end, which follows joint 1 alone: root and parent are not among
// the joints of its vertices.
RawScene cylinder_scene(const std::vector<glm::dquat>& keys) {
  RawScene scene;
  scene.source = "cylinder";
  scene.nodes.resize(3);
  scene.nodes[1].parent = 0;
  RawSkin skin;
  skin.joints = {0, 1};
  skin.inverse_bind.assign(2, glm::dmat4(1.0));
  scene.skins = {skin};
  const deform::SkinnedMesh mesh = deform::cylinder();
  scene.meshes = {{"cylinder", {}, std::vector<RawPrimitive>(2)}};
  std::map<std::uint32_t, std::uint32_t> number_of[2];
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    bool far = true;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& influences = mesh.influences[mesh.indices[t + c]];
      far = far && influences.size() == 1 && influences[0].joint == 1;
    }
    RawPrimitive& p = scene.meshes[0].primitives[far ? 1 : 0];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.indices[t + c];
      const auto [at, is_new] = number_of[far ? 1 : 0].try_emplace(v, static_cast<std::uint32_t>(p.positions.size()));
      p.indices.push_back(at->second);
      if (!is_new) continue;
      p.positions.emplace_back(mesh.positions[v]);
      p.influences.emplace_back();
      for (const deform::Influence& i : mesh.influences[v])
        p.influences.back().push_back({i.joint, static_cast<float>(i.weight)});
    }
  }
  scene.meshes[0].primitives[0].pointer = "/meshes/0/primitives/0";
  scene.meshes[0].primitives[1].pointer = "/meshes/0/primitives/1";
  scene.instances = {{2, 0, 0, {}}};
  RawChannel channel;
  channel.node = 1;
  channel.path = RawPath::rotation;
  for (const glm::dquat& q : keys) {
    channel.times_s.push_back(static_cast<float>(channel.times_s.size()) / 30);
    channel.values.emplace_back(glm::dvec4(q.x, q.y, q.z, q.w));
  }
  scene.clips = {{"clip", {channel}, {}}};
  return scene;
}

RawScene moving_cylinder() {
  std::vector<glm::dquat> keys;
  for (int i = 0; i < 24; ++i)
    keys.push_back(glm::angleAxis(0.08 * i, glm::dvec3(0, 0, 1)) *
                   glm::angleAxis(0.1 * (i * 5 % 24), glm::dvec3(1, 0, 0)));
  return cylinder_scene(keys);
}

CookOptions options_for(const std::string& codec, const std::string& learn = "--mwe --psd 6") {
  return options_of("--keep-vertex-order --clip-codec raw --mesh-codec " + codec + " --truth dqs " + learn);
}

// The same fits without a file between.
struct Offline {
  explicit Offline(const RawScene& scene) {
    const CookOptions options = options_for("none");
    Notes notes;
    BuiltScene built = build_skeletons(scene);
    built.clips = build_raw_clips(scene, built, {});
    source = deform_source(scene.meshes[0], scene.skins[0], bind_to_skin(scene.meshes[0], notes), built);
    truth = make_truth(source, options.learn);
    const std::vector<deform::TrainingPose> trained =
        trainees(source, built, clip_poses(built, source.skeleton, kTrainedRate_hz, kMostTrained)).poses;
    weights = deform::fit_multi_weights(source.mesh, 0, trained, truth).weights;
    deform::PoseSpaceOptions six;
    six.most_examples = 6;
    space = deform::fit_pose_space(source.mesh, source.parents, trained, truth, six).space;
    for (const deform::TrainingPose& p : trained)
      if (p.shipped) poses.push_back(p.pose);
  }
  DeformSource source;
  deform::Deformer truth;
  deform::MultiWeights weights;
  deform::PoseSpace space;
  std::vector<deform::Pose> poses;  // of the clip
};

std::vector<Affine> palette_of(const Mesh& mesh, const DeformSource& source, const deform::Pose& pose) {
  std::vector<Affine> model(pose.size()), out(mesh.palette_size());
  for (std::size_t j = 0; j < pose.size(); ++j)  // inverse binds are identities
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) model[source.joints[j]].rows[r][c] = static_cast<float>(pose[j][c][r]);
  EXPECT_EQ(build_palette(mesh, model, out), Status::ok);
  return out;
}

std::vector<float> skinned(const Mesh& mesh, const std::vector<Affine>& palette, bool multi_weight) {
  std::vector<float> out(std::size_t{3} * mesh.geometry.slot_count), distances(psd_distance_count(mesh.geometry));
  SkinOutput to;
  to.positions = out;
  if (multi_weight) {
    EXPECT_EQ(skin_mwe(mesh, palette, to), Status::ok);
  } else {
    EXPECT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
    EXPECT_EQ(skin_psd(mesh, distances, palette, to), Status::ok);
  }
  return out;
}

// How far the runtime is from the offline deformer at most, and its RMS error over SSD's.
struct Distance {
  double from_offline = 0, share = 0;
  std::size_t vertices = 0;
};

Distance distance(const File& file, const Offline& offline, bool multi_weight) {
  const deform::Deformer expected = multi_weight ? deform::multi_weight(offline.source.mesh, offline.weights, 0)
                                                 : deform::pose_space(offline.source.mesh, offline.space);
  Distance out;
  double squares = 0, ssd_squares = 0;
  for (const deform::Pose& pose : offline.poses) {
    deform::Positions want, truth, ssd;
    expected(pose, want);
    offline.truth(pose, truth);
    deform::ssd(offline.source.mesh)(pose, ssd);
    for (std::uint32_t p = 0; p < 2; ++p) {
      const Mesh mesh = file.mesh(p);
      const std::vector<float> got = skinned(mesh, palette_of(mesh, offline.source, pose), multi_weight);
      for (std::size_t v = 0; v < offline.source.vertex_of[p].size(); ++v) {
        const std::uint32_t welded = offline.source.vertex_of[p][v], slot = mesh.geometry.source_slots[v];
        if (slot == kNoSlot) continue;
        const glm::dvec3 at(glm::vec3(got[3 * slot], got[3 * slot + 1], got[3 * slot + 2]));
        out.from_offline = std::max(out.from_offline, glm::length(at - want[welded]));
        squares += glm::dot(at - truth[welded], at - truth[welded]);
        ssd_squares += glm::dot(ssd[welded] - truth[welded], ssd[welded] - truth[welded]);
        ++out.vertices;
      }
    }
  }
  out.share = std::sqrt(squares / ssd_squares);
  return out;
}

TEST(LearnDeformers, TheRuntimeMakesOfTheFileWhatTheFitMeant) {
  const Offline offline(moving_cylinder());
  for (const std::string codec : {"none", "draco", "meshopt"}) {
    const LoadedCook cooked(cook_scene(moving_cylinder(), options_for(codec)));
    ASSERT_EQ(cooked.file.mesh_count(), 2u);
    EXPECT_EQ(cooked.file.mesh(1).palette_size(), 2u) << "the root, and the parent of what turns";
    const Distance mwe = distance(cooked.file, offline, true), psd = distance(cooked.file, offline, false);
    EXPECT_GT(mwe.vertices, 30000u);
    std::printf("  codec %s: %.2g and %.2g from the fit, share of SSD's error %.3f and %.3f\n", codec.c_str(),
                mwe.from_offline, psd.from_offline, mwe.share, psd.share);
    // Rounded weights are other weights to fit to: not the same result to the last digit, and for pose space another
    // pose may be the next example.
    EXPECT_LT(mwe.from_offline, codec == "none" ? 1e-4 : 0.002);
    if (codec == "none") {
      EXPECT_LT(psd.from_offline, 1e-4);
    }
    EXPECT_LT(mwe.share, 0.35);
    EXPECT_LT(psd.share, 0.30);
  }
}

TEST(LearnDeformers, GoTogetherWithMorphTargets) {
  RawScene scene = moving_cylinder();
  scene.meshes[0].weights = scene.instances[0].weights = {{"bulge", "cylinder.bulge", 0}};
  for (RawPrimitive& p : scene.meshes[0].primitives)
    p.targets.push_back({std::vector<glm::vec3>(p.positions.size(), glm::vec3(0, 0, 0.1f)), {}, {}});
  for (const std::string codec : {"none", "draco", "meshopt"}) {
    const LoadedCook cooked(cook_scene(scene, options_for(codec)));
    ASSERT_EQ(cooked.file.mesh_count(), 2u);
    const Geometry g = cooked.file.mesh(0).geometry;
    EXPECT_EQ(g.targets.size, 1u);
    EXPECT_NE(g.mwe_residual, nullptr);
  }
}

// The far end's palette has the root for multi-weights, the parent for pose space.
TEST(LearnDeformers, EachAloneBringsTheJointsThatItNeeds) {
  const Offline offline(moving_cylinder());
  for (const bool multi_weight : {true, false}) {
    const CookOptions options = options_for("none", multi_weight ? "--mwe" : "--psd 6");
    const LoadedCook cooked(cook_scene(moving_cylinder(), options));
    EXPECT_EQ(cooked.file.mesh(1).palette_size(), 2u);
    EXPECT_EQ(cooked.file.mesh(1).geometry.mwe_residual != nullptr, multi_weight);
    EXPECT_EQ(cooked.file.mesh(1).geometry.pose_space.examples.empty(), multi_weight);
    EXPECT_LT(distance(cooked.file, offline, multi_weight).from_offline, 1e-4);
  }
  EXPECT_EQ(LoadedCook(cook_scene(moving_cylinder(), {})).file.mesh(1).palette_size(), 1u);
}

TEST(LearnDeformers, TheReportSaysHowGoodTheyAre) {
  const auto report = cook_scene(moving_cylinder(), options_for("draco")).report;
  for (const char* const name : {"multi_weights", "pose_space"}) {
    const auto& learnt = report["meshes"][1][name];
    EXPECT_EQ(learnt["shipped"], true);
    EXPECT_EQ(learnt["truth"], "dqs");
    EXPECT_EQ(learnt["poses"], 125) << "24 of the clip, 100 made up, the bind pose";
    EXPECT_EQ(learnt["made_up_poses"], 100);
    EXPECT_GT(learnt["held_out_share"], 0.0);
    EXPECT_LT(learnt["held_out_share"], 0.8);
  }
  EXPECT_EQ(report["meshes"][0]["pose_space"]["examples"], 6);
  EXPECT_EQ(report["meshes"][0]["animation_space"]["kind"], "lift");
  EXPECT_FALSE(cook_scene(moving_cylinder(), {}).report["meshes"][0].contains("multi_weights"));
}

// Multi-weights may follow the helpers that animation space does; pose space goes its own way.
TEST(LearnDeformers, StandBesideAnimationSpace) {
  const Offline offline(moving_cylinder());
  for (const std::string codec : {"none", "draco"}) {
    const CookOptions options = options_for(codec, "--mwe --psd 6 --as fit --helpers 1");
    const LoadedCook cooked(cook_scene(moving_cylinder(), options));
    EXPECT_EQ(cooked.file.mesh(0).palette_size(), 3u);
    EXPECT_NE(cooked.file.mesh(0).geometry.as_residual, nullptr);
    const double mwe = distance(cooked.file, offline, true).share, psd = distance(cooked.file, offline, false).share;
    std::printf("  codec %s: share of SSD's error %.3f and %.3f\n", codec.c_str(), mwe, psd);
    EXPECT_LT(mwe, 0.1);
    EXPECT_LT(psd, 0.35);
  }
}

// In a clip that keeps still SSD is right: there is nothing to learn, and the file has nothing of it.
TEST(LearnDeformers, WhatIsNoBetterIsNotShipped) {
  const RawScene still = cylinder_scene({glm::dquat(1, 0, 0, 0), glm::dquat(1, 0, 0, 0)});
  CookOptions options = options_for("draco");
  const Result learnt = cook_scene(still, options);
  options.learn = {};
  EXPECT_EQ(learnt.file, cook_scene(still, options).file);
  int warnings = 0;
  for (const auto& w : learnt.report["warnings"])
    warnings += w["rule"] == "fit-not-better" && w["pointer"] == "/meshes/0/primitives/0";
  EXPECT_EQ(warnings, 2);
  for (const char* const name : {"multi_weights", "pose_space"})
    EXPECT_EQ(learnt.report["meshes"][0][name]["shipped"], false);
}

TEST(LearnDeformers, TheRootIsTheHighestJointThatIsFollowed) {
  DeformSource source;
  source.joints = {4, 1, 2, 0};  // of the skeleton
  source.mesh.influences = {{{0, 0.5}, {2, 0.5}}, {{0, 0.25}, {1, 0.75}}, {{2, 0.5}, {4, 0.5}}};
  EXPECT_EQ(multi_weight_root(source), 1u) << "joint 3 is higher, but no vertex follows it; 4 is a helper";
}

}  // namespace
}  // namespace marrow::cook
