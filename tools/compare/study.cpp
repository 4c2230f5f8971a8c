#include "compare/study.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/failure.h"
#include "cook/build.h"
#include "cook/gltf/read.h"
#include "deform/cylinder.h"
#include "deform/surface.h"

namespace marrow::tools {
namespace {

using namespace marrow::cook;

constexpr double kRate_hz = 30;
constexpr std::size_t kMostPoses = 640;  // half of them are learnt from
constexpr std::size_t kMadeUp = 100;
constexpr std::size_t kMostRounds = 8;

std::size_t vertex_count(const RawMesh& mesh) {
  std::size_t out = 0;
  for (const RawPrimitive& p : mesh.primitives) out += p.influences.size();
  return out;
}

const RawInstance* largest_skinned(const RawScene& scene) {
  const RawInstance* best = nullptr;
  std::size_t most = 0;
  for (const RawInstance& instance : scene.instances) {
    const std::size_t count =
        instance.skin == kNone ? 0 : vertex_count(scene.meshes[static_cast<std::size_t>(instance.mesh)]);
    if (count <= most) continue;
    most = count;
    best = &instance;
  }
  return best;
}

struct Sampled {
  std::vector<SampledPose> poses;
  std::vector<std::uint32_t> clips;  // those that have poses
  std::uint32_t ordinal(const SampledPose& pose) const {
    return static_cast<std::uint32_t>(std::ranges::find(clips, pose.clip) - clips.begin());
  }
};

void add_made_up(const Study& study, const BuiltSkeleton& skeleton, const std::vector<SampledPose>& from,
                 std::uint32_t folds, Round& round) {
  std::uint32_t number = 0;
  for (const SampledPose& pose : resampled_poses(skeleton, from, kMadeUp))
    round.train.push_back({deform_pose(study.source, skeleton, pose.local), number++ % folds, false});
  round.train.push_back({deform::Pose(study.source.joints.size(), deform::Matrix(1.0)), 0, false});
}

void hold_frames(const Sampled& sampled, const BuiltScene& built, const BuiltSkeleton& skeleton, Study& study) {
  Round& round = study.rounds.emplace_back();
  std::vector<SampledPose> trained;
  std::uint32_t folds = 1;
  for (std::size_t i = 0; i < sampled.poses.size(); ++i) {
    const SampledPose& pose = sampled.poses[i];
    const deform::Pose matrices = deform_pose(study.source, skeleton, pose.local);
    if (i % 2 == 1) {
      round.held.push_back({matrices, built.clips[pose.clip].name, static_cast<double>(pose.time_s)});
      continue;
    }
    // With few clips a fold is a quarter of one.
    const double part =
        static_cast<double>(pose.time_s) / std::max(1e-6, static_cast<double>(built.clips[pose.clip].duration_s));
    const std::uint32_t ordinal = sampled.ordinal(pose);
    const std::uint32_t fold =
        sampled.clips.size() > 2 ? ordinal % 8 : 4 * ordinal + static_cast<std::uint32_t>(std::min(3.0, 4 * part));
    folds = std::max(folds, fold + 1);
    round.train.push_back({matrices, fold, true});
    trained.push_back(pose);
  }
  add_made_up(study, skeleton, trained, folds, round);
}

// What moves no clip: half of poses that are made up.
void hold_made_up(const BuiltSkeleton& skeleton, Study& study) {
  Round& round = study.rounds.emplace_back();
  std::uint32_t number = 0;
  for (const SampledPose& pose : resampled_poses(skeleton, {}, 2 * kMadeUp)) {
    const deform::Pose matrices = deform_pose(study.source, skeleton, pose.local);
    if (++number % 2 == 1) {
      round.train.push_back({matrices, number % 5, true});
    } else {
      round.held.push_back({matrices, "", 0});
    }
  }
  round.train.push_back({deform::Pose(study.source.joints.size(), deform::Matrix(1.0)), 0, false});
}

void hold_clips(const Sampled& sampled, const BuiltScene& built, const BuiltSkeleton& skeleton, Study& study) {
  const std::size_t rounds = std::min(sampled.clips.size(), kMostRounds);
  for (std::size_t r = 0; r < rounds; ++r) {
    Round& round = study.rounds.emplace_back();
    std::vector<SampledPose> trained;
    for (const SampledPose& pose : sampled.poses) {
      const std::uint32_t ordinal = sampled.ordinal(pose);
      const deform::Pose matrices = deform_pose(study.source, skeleton, pose.local);
      if (ordinal % rounds == r) {
        round.held.push_back({matrices, built.clips[pose.clip].name, static_cast<double>(pose.time_s)});
      } else {
        round.train.push_back({matrices, ordinal % 8, true});
        trained.push_back(pose);
      }
    }
    add_made_up(study, skeleton, trained, 8, round);
  }
}

}  // namespace

Study study_file(const std::string& path, Holdout holdout) {
  Study study;
  study.scene = read_gltf(path);
  RawScene scene = study.scene;
  BuiltScene built;
  build_skeletons(scene, built);
  CookOptions options;
  options.raw_clips = true;
  build_clips(scene, options, built);
  const RawInstance* const instance = largest_skinned(scene);
  if (instance == nullptr)
    throw Failure(Exit::invalid, path, "/skins", "not-skinned",
                  "no mesh is bound to a skin; there is nothing to compare");
  const RawMesh& mesh = scene.meshes[static_cast<std::size_t>(instance->mesh)];
  const RawSkin& skin = scene.skins[static_cast<std::size_t>(instance->skin)];
  study.scene.instances = {*instance};  // what is cooked and drawn is this mesh alone
  study.source = deform_source(mesh, skin, bind_to_skin(scene, mesh), built);
  study.name = mesh.name;
  const BuiltSkeleton& skeleton = built.skeletons[study.source.skeleton];
  study.rest = deform_pose(study.source, skeleton, skeleton.rest);
  Sampled sampled{clip_poses(built, study.source.skeleton, kRate_hz, kMostPoses), {}};
  for (const SampledPose& pose : sampled.poses)
    if (sampled.clips.empty() || sampled.clips.back() != pose.clip) sampled.clips.push_back(pose.clip);
  if (holdout == Holdout::clips && sampled.clips.size() < 2)
    throw Failure(Exit::usage, "--holdout", "", "fewer than two clips", "give --holdout frames");
  if (sampled.clips.empty()) {
    hold_made_up(skeleton, study);
  } else if (holdout == Holdout::frames) {
    hold_frames(sampled, built, skeleton, study);
  } else {
    hold_clips(sampled, built, skeleton, study);
  }
  return study;
}

namespace {

// The cylinder as an artist's file would have it, with the poses of a study as the keys of a clip.
RawScene cylinder_scene(const deform::SkinnedMesh& mesh) {
  RawScene scene;
  scene.source = "cylinder";
  scene.nodes.resize(3);
  scene.nodes[0].name = "root";
  scene.nodes[1].name = "bend";
  scene.nodes[1].parent = 0;
  scene.nodes[2].name = "cylinder";
  RawSkin skin;
  skin.joints = {0, 1};
  skin.inverse_bind.assign(2, glm::dmat4(1.0));
  scene.skins.push_back(skin);
  RawPrimitive p;
  p.pointer = "/meshes/0/primitives/0";
  p.indices = mesh.indices;
  const std::vector<glm::dvec3> normals = deform::vertex_normals(mesh.positions, mesh.indices);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    p.positions.emplace_back(mesh.positions[v]);
    p.normals.emplace_back(normals[v]);
    std::vector<RawInfluence>& influences = p.influences.emplace_back();
    for (const deform::Influence& i : mesh.influences[v]) influences.push_back({i.joint, static_cast<float>(i.weight)});
  }
  scene.meshes.push_back({"cylinder", {}, {p}});
  scene.instances.push_back({2, 0, 0, {}});
  return scene;
}

void add_clip(const std::vector<std::pair<double, double>>& angles, RawScene& scene) {
  RawChannel channel;
  channel.node = 1;
  channel.path = RawPath::rotation;
  for (const auto& [bend, twist] : angles) {
    const glm::dquat q = glm::angleAxis(bend, glm::dvec3(0, 0, 1)) * glm::angleAxis(twist, glm::dvec3(1, 0, 0));
    channel.times_s.push_back(static_cast<float>(channel.times_s.size()) / 30);
    channel.values.emplace_back(static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                                static_cast<float>(q.w));
  }
  scene.clips.push_back({"bends and twists", {channel}, {}});
}

}  // namespace

Study study_cylinder() {
  constexpr int kSeeds = 5, kTrained = 30, kHeld = 200;
  constexpr double kMostBend = 120 * std::numbers::pi / 180, kMostTwist = 150 * std::numbers::pi / 180;
  const deform::SkinnedMesh mesh = deform::cylinder();
  Study study;
  study.name = "cylinder";
  study.scene = cylinder_scene(mesh);
  study.source.mesh = mesh;
  study.source.vertex_of.resize(1);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) study.source.vertex_of[0].push_back(v);
  study.source.parents = {kNone, 0};
  study.source.centres.assign(2, glm::dvec3(0));
  study.source.joints = {0, 1};
  study.rest = deform::cylinder_pose(0, 0);
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    std::mt19937 random(seed);
    const auto up_to = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
    Round& round = study.rounds.emplace_back();
    std::vector<std::pair<double, double>> angles;
    // Spread evenly: Roberts' R2 sequence, begun anywhere.
    double u = up_to(1), v = up_to(1);
    for (std::uint32_t i = 0; i < kTrained; ++i) {
      u += 0.7548776662466927;
      v += 0.5698402909980532;
      const double bend = (u - std::floor(u)) * kMostBend, twist = (v - std::floor(v)) * kMostTwist;
      angles.emplace_back(bend, twist);
      round.train.push_back({deform::cylinder_pose(bend, twist), i % 5, true});
    }
    round.train.push_back({study.rest, 0, false});
    for (int i = 0; i < kHeld; ++i) {
      const double bend = up_to(kMostBend), twist = up_to(kMostTwist);
      round.held.push_back({deform::cylinder_pose(bend, twist), "", 0});
    }
    if (seed == 1) add_clip(angles, study.scene);
  }
  return study;
}

}  // namespace marrow::tools
