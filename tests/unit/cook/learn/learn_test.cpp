// Animation space that is learnt, from the artist's file to what the runtime's kernels make of the cooked one.
#include "cook/learn/learn.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "cook/gltf/read.h"
#include "cook/learn/trainees.h"
#include "cook/learn/truths.h"
#include "cook/skin/deform_source.h"
#include "deform/animation_space.h"
#include "deform/motion/motion_errors.h"
#include "marrow/marrow.h"
#include "support/places.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

const std::string kNewt = test::newt_glb();
constexpr Truth kTruths[] = {Truth::dual_quaternions, Truth::centres_of_rotation, Truth::delta_mush,
                             Truth::delta_mush_over_dqs, Truth::elastic};

CookOptions fitted_to_dual_quaternions(const std::string& codec) {
  return options_of("--keep-vertex-order --clip-codec raw --as fit --truth dqs --helpers auto --mesh-codec " + codec);
}

// A fit of the newt takes seconds, and minutes under sanitizers: each once.
const Result& fitted(const std::string& codec) {
  static std::map<std::string, Result> made;
  const auto at = made.find(codec);
  return at != made.end() ? at->second
                          : made.emplace(codec, cook_file(kNewt, fitted_to_dual_quaternions(codec))).first->second;
}

// Squared errors against dual quaternions, over all skinned vertices and a few moments of a clip.
struct Errors {
  double ssd = 0, as = 0;
  std::size_t vertices = 0;
};

Errors errors_against_dual_quaternions(const File& file, std::uint32_t clip) {
  const RawScene raw = read_gltf(kNewt);
  CookOptions plain;
  plain.clips.raw = true;
  Notes notes;
  const BuiltScene built = build_scene(raw, plain, notes);
  Errors out;
  std::uint32_t number = 0;
  for (const RawInstance& instance : raw.instances) {
    const RawMesh& mesh = raw.meshes[static_cast<std::size_t>(instance.mesh)];
    if (instance.skin == kNone) {
      number += static_cast<std::uint32_t>(mesh.primitives.size());
      continue;
    }
    const RawSkin& skin = raw.skins[static_cast<std::size_t>(instance.skin)];
    const DeformSource source = deform_source(mesh, skin, bind_to_skin(mesh, notes), built);
    const deform::Deformer truth = deform::dual_quaternions(source.mesh);
    for (const float part : {0.2f, 0.45f, 0.7f}) {
      const float time_s = part * file.clip(clip).duration_s;
      const Skeleton skeleton = file.skeleton(source.skeleton);
      std::vector<SoaTransform> local(skeleton.soa_size());
      EXPECT_EQ(sample(skeleton, file.clip(clip), time_s, local), Status::ok);
      deform::Positions want;
      truth(deform_pose(source, built.skeletons[source.skeleton], local), want);
      for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
        const Mesh cooked = file.mesh(number + static_cast<std::uint32_t>(p));
        const Skins skins = skins_at(file, clip, time_s, cooked);
        for (std::size_t v = 0; v < source.vertex_of[p].size(); ++v) {
          const std::uint32_t slot = cooked.geometry.source_slots[v];
          if (slot == kNoSlot) continue;
          const glm::dvec3& at = want[source.vertex_of[p][v]];
          const glm::dvec3 ssd = glm::dvec3(skins.ssd[slot]) - at, as = glm::dvec3(skins.as[slot]) - at;
          out.ssd += glm::dot(ssd, ssd);
          out.as += glm::dot(as, as);
          ++out.vertices;
        }
      }
    }
    number += static_cast<std::uint32_t>(mesh.primitives.size());
  }
  return out;
}

TEST(Learn, WhatIsFittedIsWhatTheRuntimeDeforms) {
  std::vector<std::string> codecs = {"none"};
  if (test::in_long_form()) codecs.insert(codecs.end(), {"draco", "meshopt"});
  for (const std::string& codec : codecs) {
    const LoadedCook cooked(fitted(codec));
    ASSERT_GT(cooked.file.clip_count(), 0u);
    Errors all;
    for (std::uint32_t clip = 0; clip < cooked.file.clip_count(); ++clip) {
      const Errors e = errors_against_dual_quaternions(cooked.file, clip);
      all.ssd += e.ssd;
      all.as += e.as;
      all.vertices += e.vertices;
    }
    EXPECT_GT(all.vertices, 10000u);
    const double share = std::sqrt(all.as / all.ssd);
    std::printf("  codec %s: share of SSD's error %.3f\n", codec.c_str(), share);
    EXPECT_LT(share, 0.35);
    const auto& learnt = cooked.report["meshes"][0]["animation_space"];
    EXPECT_EQ(learnt["kind"], "fit");
    EXPECT_EQ(learnt["truth"], "dqs");
    EXPECT_GT(learnt["helpers"], 5);
    EXPECT_LT(learnt["held_out_share"], 0.6);
  }
}

// Where helpers are straight means of their joints, linear blend skinning is what the artist painted.
TEST(Learn, LeavesSsdAlone) {
  CookOptions lift = fitted_to_dual_quaternions("none");
  lift.learn = {};
  const LoadedCook learnt(fitted("none"));
  const LoadedCook plain(cook_file(kNewt, lift));
  ASSERT_EQ(learnt.file.mesh_count(), plain.file.mesh_count());
  std::size_t compared = 0;
  for (std::uint32_t m = 0; m < learnt.file.mesh_count(); ++m) {
    const Mesh a = learnt.file.mesh(m), b = plain.file.mesh(m);
    const Skins one = skins_at(learnt.file, 0, 0.5f, a, true), other = skins_at(plain.file, 0, 0.5f, b);
    ASSERT_EQ(a.geometry.source_slots.size, b.geometry.source_slots.size);
    for (std::size_t v = 0; v < a.geometry.source_slots.size; ++v) {
      if (a.geometry.source_slots[v] == kNoSlot) continue;
      EXPECT_LT(glm::length(one.ssd[a.geometry.source_slots[v]] - other.ssd[b.geometry.source_slots[v]]), 1e-6f);
      ++compared;
    }
  }
  EXPECT_GT(compared, 5000u);
}

TEST(Learn, IsTheSameBytesEveryTime) {
  const std::string source = test::in_long_form() ? kNewt : test::in_golden("elbow.gltf");
  const CookOptions options = fitted_to_dual_quaternions("meshopt");
  EXPECT_EQ(cook_file(source, options).file, cook_file(source, options).file);
}

// In the bind pose nothing moves, whatever was learnt: there residuals of a vertex sum to 0. Helpers bring that along.
TEST(Learn, CanKeepTheBindPose) {
  for (const bool keeps : {true, false}) {
    CookOptions options = fitted_to_dual_quaternions("none");
    options.learn.helpers = 0;
    options.learn.keep_bind_pose = keeps;
    const LoadedCook cooked(cook_file(test::in_golden("elbow.gltf"), options));
    const Geometry g = cooked.file.mesh(0).geometry;
    ASSERT_NE(g.as_residual, nullptr);
    const float* r = g.as_residual;
    float largest = 0, largest_sum = 0;
    for (const marrow::Run& run : g.runs) {
      for (std::uint32_t block = 0; block < (run.vertex_count + 3) / 4; ++block, r += 16 * run.influences) {
        for (std::uint32_t i = 0; i < 16; ++i) {
          float sum = 0;
          for (std::uint32_t j = 0; j < run.influences; ++j) {
            sum += r[16 * j + i];
            largest = std::max(largest, std::abs(r[16 * j + i]));
          }
          largest_sum = std::max(largest_sum, std::abs(sum));
        }
      }
    }
    EXPECT_GT(largest, 0.01f);
    EXPECT_EQ(largest_sum < 1e-6f, keeps) << largest_sum;
  }
}

// The scene of one triangle on two joints, which says nothing of how it moves.
RawScene two_joint_scene() {
  RawScene scene;
  scene.source = "made.gltf";
  scene.nodes.resize(3);
  for (std::size_t n = 0; n < 3; ++n) scene.nodes[n].name = "n" + std::to_string(n);
  scene.nodes[1].parent = 0;
  scene.nodes[1].translation = {1, 0, 0};
  RawSkin skin;
  skin.joints = {0, 1};
  skin.inverse_bind = {glm::dmat4(1.0), glm::dmat4(1.0)};
  skin.inverse_bind[1][3] = {-1, 0, 0, 1};
  scene.skins.push_back(skin);
  RawPrimitive p;
  p.pointer = "/meshes/0/primitives/0";
  p.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, 0}};
  p.indices = {0, 1, 2, 0, 1, 3, 2, 2, 3};
  p.influences = {{{0, 1.0f}}, {{1, 1.0f}}, {{0, 0.5f}, {1, 0.5f}}, {{0, 0.5f}, {1, 0.5f}}};
  scene.meshes.push_back({"made", {}, {p}});
  scene.instances.push_back({2, 0, 0, {}});
  return scene;
}

TEST(Learn, MakesPosesUpWithoutClips) {
  for (const Truth truth : kTruths) {
    CookOptions options = fitted_to_dual_quaternions("none");
    options.learn.truth = truth;
    const LoadedCook cooked(cook_scene(two_joint_scene(), options));
    const auto& learnt = cooked.report["meshes"][0]["animation_space"];
    EXPECT_EQ(learnt["made_up_poses"], 100);
    const Geometry g = cooked.file.mesh(0).geometry;
    if (truth == Truth::dual_quaternions) {
      EXPECT_EQ(learnt["kind"], "fit");
      EXPECT_LT(learnt["held_out_share"], 0.5);
      ASSERT_NE(g.as_residual, nullptr);
    }
  }
}

RawChannel turning(int node) {
  RawChannel out;
  out.node = node;
  out.path = RawPath::rotation;
  out.times_s = {0, 1};
  out.values = {{0, 0, 0, 1}, {0, 0, 0.7071068f, 0.7071068f}};
  return out;
}

// What cross-validation leaves out together: clips, or where there are hardly any, quarters of them.
TEST(Learn, ClipsAreFolds) {
  for (std::uint32_t clips = 1; clips <= 10; ++clips) {
    RawScene raw = two_joint_scene();
    for (std::uint32_t c = 0; c < clips; ++c) raw.clips.push_back({"clip" + std::to_string(c), {turning(1)}, {}});
    CookOptions plain;
    plain.clips.raw = true;
    Notes notes;
    const BuiltScene built = build_scene(raw, plain, notes);
    const DeformSource source = deform_source(raw.meshes[0], raw.skins[0], bind_to_skin(raw.meshes[0], notes), built);
    const std::vector<SampledPose> shipped = clip_poses(built, source.skeleton, 8, 1000);
    ASSERT_EQ(shipped.size(), 9 * clips);
    const Trainees got = trainees(source, built, shipped);
    ASSERT_GT(got.poses.size(), shipped.size());
    for (std::size_t i = 0; i < shipped.size(); ++i) {
      const std::uint32_t c = shipped[i].clip, quarter = std::min(3u, static_cast<std::uint32_t>(i % 9) / 2);
      EXPECT_EQ(got.poses[i].fold, clips > 2 ? c % 8 : 4 * c + quarter) << clips << " clips, pose " << i;
    }
  }
}

std::vector<std::string> warnings_of(const Result& result, const std::string& rule) {
  std::vector<std::string> out;
  for (const auto& w : result.report["warnings"])
    if (w["rule"] == rule) out.push_back(w["text"]);
  return out;
}

// The scene with a clip in which its second joint scales.
RawScene scaling(const glm::dvec4& from, const glm::dvec4& to) {
  RawScene scene = two_joint_scene();
  RawChannel channel;
  channel.node = 1;
  channel.path = RawPath::scale;
  channel.times_s = {0, 1};
  channel.values = {from, to};
  scene.clips.push_back({"scale", {channel}, {}});
  return scene;
}

// A joint scaled to nothing has no rotation to learn from; nor has one that is flat, as half way to a mirror. Two of
// the poses that are made up are between the first moment and itself.
TEST(Learn, LeavesOutWhereAJointHasNoRotationAndNamesIt) {
  const std::pair<RawScene, std::string> scenes[] = {{scaling({0, 0, 0, 0}, {1, 1, 1, 0}), "3 of 132"},
                                                     {scaling({1, 1, 1, 0}, {-1, 1, 1, 0}), "1 of 132"}};
  for (const auto& [scene, count] : scenes) {
    for (const Truth truth : kTruths) {
      CookOptions options = fitted_to_dual_quaternions("none");
      options.learn.truth = truth;
      options.learn.multi_weights = true;  // says it no second time
      const Result result = cook_scene(scene, options);
      LoadedCook of_finite_numbers(result);  // load() refuses what is not finite
      const std::vector<std::string> said = warnings_of(result, "joint-without-rotation");
      ASSERT_EQ(said.size(), truth == Truth::delta_mush ? 0u : 1u);
      if (truth == Truth::delta_mush) continue;
      EXPECT_NE(said[0].find("\"n1\" has no rotation in " + count + " poses"), std::string::npos) << said[0];
    }
  }
}

TEST(Learn, TakesPosesThatAJointAloneSpoils) {
  RawScene scene = scaling({0, 0, 0, 0}, {1, 1, 1, 0});
  for (std::vector<RawInfluence>& influences : scene.meshes[0].primitives[0].influences) influences.resize(1);
  EXPECT_TRUE(warnings_of(cook_scene(scene, fitted_to_dual_quaternions("none")), "joint-without-rotation").empty());
}

TEST(Learn, FindsTheJointThatSpoilsAPose) {
  deform::SkinnedMesh mesh;
  mesh.joint_count = 4;
  mesh.positions.resize(3);
  mesh.influences = {{{0, 1.0}}, {{1, 0.5}, {2, 0.5}}, {{0, 1.0}}};
  const UsablePoses rotating(mesh, Truth::centres_of_rotation), smoothing(mesh, Truth::delta_mush);
  deform::Pose pose(4, deform::Matrix(1.0));
  const deform::Matrix nothing(0.0);
  deform::Matrix infinite(1.0);
  infinite[3][1] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(rotating.spoiling_joint(pose));
  pose[3] = infinite;  // which nobody follows
  pose[0] = nothing;   // which is followed alone
  EXPECT_FALSE(rotating.spoiling_joint(pose));
  pose[2] = nothing;
  EXPECT_EQ(rotating.spoiling_joint(pose), 2u);
  EXPECT_FALSE(smoothing.spoiling_joint(pose));
  pose[0] = infinite;
  EXPECT_EQ(rotating.spoiling_joint(pose), 0u);
  EXPECT_EQ(smoothing.spoiling_joint(pose), 0u);
}

TEST(Learn, TakesJointsInOnePlace) {
  RawScene scene = two_joint_scene();
  scene.nodes[1].translation = {0, 0, 0};
  scene.skins[0].inverse_bind[1] = glm::dmat4(1.0);
  for (const bool moves : {false, true}) {
    if (moves) scene.clips.push_back({"turn", {turning(1)}, {}});
    for (const Truth truth : kTruths) {
      CookOptions options = fitted_to_dual_quaternions("none");
      options.learn.truth = truth;
      options.learn.wide_poses = true;
      EXPECT_NO_THROW(LoadedCook(cook_scene(scene, options)));
    }
  }
}

// The closed form about centres of rotation is worse than SSD in poses of this model, where it is not kept from that.
TEST(Learn, HelpersAreWorseThanSsdInNoPoseOfTheRangeOfMotion) {
  const std::string model = test::assets_folder() + "/m2m_shark.glb";
  if (!std::filesystem::exists(model)) {
    std::fprintf(stderr, "SKIPPED: %s is not there\n", model.c_str());
    GTEST_SKIP() << model;
  }
  const RawScene scene = read_gltf(model);
  CookOptions plain;
  plain.clips.raw = true;
  Notes notes;
  const BuiltScene built = build_scene(scene, plain, notes);
  std::size_t skinned = 0, poses = 0, helpers = 0;
  for (const RawInstance& instance : scene.instances) {
    if (instance.skin == kNone) continue;
    ++skinned;
    const RawMesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const RawSkin& skin = scene.skins[static_cast<std::size_t>(instance.skin)];
    DeformSource source = deform_source(mesh, skin, bind_to_skin(mesh, notes), built);
    source.motion = range_of_motion(source, built.skeletons[source.skeleton]).poses;
    LearnOptions options;
    options.helpers = kAutoHelpers;
    const Learnt learnt = learn(source, find_trainees(source, built, options).poses, options);
    const deform::Deformer with_helpers = [&](const deform::Pose& pose, deform::Positions& out) {
      deform::Pose extended = pose;
      deform::append_helpers(learnt.helpers, extended);
      deform::animation_space(learnt.coordinates)(extended, out);
    };
    EXPECT_TRUE(
        deform::worse_than_ssd(source.mesh, source.motion, deform::centres_of_rotation(source.mesh), with_helpers)
            .empty());
    poses += source.motion.size();
    helpers += learnt.helpers.size();
  }
  EXPECT_GT(skinned, 0u);
  EXPECT_GT(poses, 100u);
  EXPECT_GT(helpers, 10u);
}

// Angles between the two joints in the poses that are made up.
std::vector<double> made_up_turns(RawScene scene, bool wide) {
  CookOptions plain;
  plain.clips.raw = true;
  Notes notes;
  const BuiltScene built = build_scene(scene, plain, notes);
  const DeformSource source =
      deform_source(scene.meshes[0], scene.skins[0], bind_to_skin(scene.meshes[0], notes), built);
  const Trainees got = trainees(source, built, {}, wide);
  EXPECT_EQ(got.made_up, wide ? 200u : 100u);
  std::vector<double> out;
  for (std::size_t i = 0; i < got.made_up; ++i) {
    EXPECT_EQ(got.poses[i].shipped, i < 100);
    const glm::dmat3 turn =
        glm::transpose(deform::linear_of(got.poses[i].pose[0])) * deform::linear_of(got.poses[i].pose[1]);
    out.push_back(glm::degrees(std::acos(std::clamp((turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2, -1.0, 1.0))));
  }
  return out;
}

double most(const std::vector<double>& of) {
  return *std::ranges::max_element(of);
}

TEST(Learn, WidePosesTurnFarButWithinLimits) {
  const std::vector<double> narrow = made_up_turns(two_joint_scene(), false),
                            wide = made_up_turns(two_joint_scene(), true);
  EXPECT_EQ(std::vector<double>(wide.begin(), wide.begin() + 100), narrow);
  EXPECT_LT(most(narrow), 45.1);
  EXPECT_GT(most(wide), 140);
  EXPECT_LT(most(wide), 150.1);
  RawScene limited = two_joint_scene();
  RawLimit& limit = limited.nodes[1].limit.emplace();
  limit.description.kind = LimitKind::hinge;
  limit.description.least_rad[0] = -0.5f;
  limit.description.most_rad[0] = 0.5f;
  EXPECT_LT(most(made_up_turns(limited, true)), glm::degrees(0.5) + 0.1);
  limit.description.least_rad[0] = limit.description.most_rad[0] = 0;  // forbids every turn
  EXPECT_LT(most(made_up_turns(limited, true)), 0.1);
}

}  // namespace
}  // namespace marrow::cook
