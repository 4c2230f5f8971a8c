#include "compare/study.h"

#include <algorithm>
#include <functional>
#include <numbers>
#include <random>

#include "common/failure.h"
#include "cook/clip/build_clips.h"
#include "cook/gltf/read.h"
#include "cook/learn/truths.h"
#include "cook/skeleton/build_details.h"
#include "cook/skeleton/build_skeletons.h"
#include "cook/skin/deform_source.h"
#include "deform/cylinder.h"
#include "deform/surface.h"

namespace marrow::tools {
namespace {

using namespace marrow::cook;

constexpr double kRate_hz = 30;
constexpr std::size_t kMostPoses = 640;  // half of them are learnt from
constexpr std::size_t kMostRounds = 8;
// Bytes: each row learns from the truth's poses, and is judged by them.
constexpr std::size_t kMostRemembered = 512'000'000;

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

// What is said of a clip without a name is its number.
std::string title_of_clip(const BuiltScene& built, std::uint32_t clip) {
  const std::string& name = built.clips[clip].name;
  return name.empty() ? "clip " + std::to_string(clip) : name;
}

// Which of a row's poses are held out.
using IsHeld = std::function<bool(std::size_t number, std::size_t clip)>;

void add_round(const std::vector<SampledPose>& poses, const std::vector<std::uint32_t>& clips, const BuiltScene& built,
               const IsHeld& is_held, Study& study) {
  Round& round = study.rounds.emplace_back();
  std::vector<SampledPose> trained;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto ordinal = static_cast<std::size_t>(std::ranges::find(clips, poses[i].clip) - clips.begin());
    if (is_held(i, ordinal)) {
      round.held.push_back({deform_pose(study.source, built.skeletons[study.source.skeleton], poses[i].local),
                            title_of_clip(built, poses[i].clip), static_cast<double>(poses[i].time_s), poses[i].clip});
    } else {
      trained.push_back(poses[i]);
    }
  }
  round.train = trainees(study.source, built, trained, study.wide_poses).poses;
}

void add_round(const std::vector<ShownPose>& poses, const std::vector<std::uint32_t>& clips, const BuiltScene&,
               const IsHeld& is_held, Study& study) {
  Round& round = study.rounds.emplace_back();
  std::vector<ShownPose> trained;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto ordinal = static_cast<std::size_t>(std::ranges::find(clips, poses[i].clip) - clips.begin());
    if (is_held(i, ordinal)) {
      round.held.push_back({poses[i].pose, poses[i].clip_name, poses[i].time_s, {}});
    } else {
      trained.push_back(poses[i]);
    }
  }
  round.train = trainees(study.source, trained).poses;
}

template <class PoseOfClip>
void hold_out(const std::vector<PoseOfClip>& poses, Holdout holdout, const BuiltScene& built, Study& study) {
  std::vector<std::uint32_t> clips;  // those that have poses
  for (const PoseOfClip& pose : poses)
    if (clips.empty() || clips.back() != pose.clip) clips.push_back(pose.clip);
  if (holdout == Holdout::frames) {
    add_round(
        poses, clips, built, [](std::size_t number, std::size_t) { return number % 2 == 1; }, study);
    return;
  }
  if (clips.size() < 2) throw Failure(Exit::usage, "--holdout", "", "fewer than two clips", "give --holdout frames");
  const std::size_t rounds = std::min(clips.size(), kMostRounds);
  for (std::size_t r = 0; r < rounds; ++r)
    add_round(
        poses, clips, built, [&](std::size_t, std::size_t clip) { return clip % rounds == r; }, study);
}

// Where no clip moves it: poses that are made up behind those that are learnt from.
void hold_made_up(const BuiltScene& built, Study& study) {
  const BuiltSkeleton& skeleton = built.skeletons[study.source.skeleton];
  Round& round = study.rounds.emplace_back();
  round.train = trainees(study.source, built, {}, study.wide_poses).poses;
  const std::vector<SampledPose> poses = resampled_poses(skeleton, {}, 2 * kMadeUp);
  for (std::size_t i = kMadeUp; i < poses.size(); ++i)
    round.held.push_back({deform_pose(study.source, skeleton, poses[i].local), "", 0, {}});
}

void add_motion(const BuiltSkeleton& skeleton, Study& study) {
  for (const std::uint16_t joint : study.source.joints) study.joint_names.push_back(skeleton.joint_names[joint]);
  study.motion = range_of_motion(study.source, skeleton);
  study.source.motion = study.motion.poses;
  study.left_out_of_motion = left_out_of_motion(study.source, skeleton, study.motion.left_out);
}

}  // namespace

Study study_scene(RawScene of, Holdout holdout, const LearnOptions& learn) {
  Study study;
  study.scene = std::move(of);
  const RawScene scene = study.scene;
  BuiltScene built = build_skeletons(scene);
  Notes notes;  // that only cooking says
  const std::vector<std::vector<JointLimit>> limits = build_limits(scene, built, notes);
  for (std::size_t s = 0; s < limits.size(); ++s) built.skeletons[s].limits = limits[s];
  built.clips = build_raw_clips(scene, built, {});
  const RawInstance* const instance = largest_skinned(scene);
  if (instance == nullptr)
    throw Failure(Exit::invalid, scene.source, "/skins", "not-skinned",
                  "no mesh is bound to a skin; there is nothing to compare");
  const RawMesh& mesh = scene.meshes[static_cast<std::size_t>(instance->mesh)];
  const RawSkin& skin = scene.skins[static_cast<std::size_t>(instance->skin)];
  study.scene.instances = {*instance};  // what is cooked and drawn is this mesh alone
  study.source = deform_source(mesh, skin, bind_to_skin(mesh, notes), built);
  study.built = built;
  study.name = mesh.name;
  study.wide_poses = learn.wide_poses;
  const BuiltSkeleton& skeleton = built.skeletons[study.source.skeleton];
  study.rest = deform_pose(study.source, skeleton, skeleton.rest);
  add_motion(skeleton, study);
  if (learn.truth == Truth::elastic) study.source.frames = frames_in_a_row(study.source, built, kFramesInARow);
  if (learn.truth == Truth::examples) {
    study.source.shown = read_examples(*learn.examples, {scene, mesh, skin, built, study.source});
    hold_out(study.source.shown, holdout, built, study);
    return study;
  }
  const std::vector<SampledPose> poses = clip_poses(built, study.source.skeleton, kRate_hz, kMostPoses);
  if (poses.empty() && holdout == Holdout::frames) {
    hold_made_up(built, study);
  } else {
    hold_out(poses, holdout, built, study);
  }
  return study;
}

void drop_unusable_poses(const LearnOptions& options, Study& study, Notes& notes) {
  const RawSkin& skin = study.scene.skins[static_cast<std::size_t>(study.scene.instances.front().skin)];
  const UsablePoses usable(study.source.mesh, options.truth);
  remember_truth(options, study.scene, skin,
                 study.scene.meshes[static_cast<std::size_t>(study.scene.instances.front().mesh)], study.source, notes,
                 kMostRemembered);
  const deform::Deformer truth = make_truth(study.source, options);
  const auto is_infinite = [&](const auto& p) {
    deform::Positions positions;
    truth(p.pose, positions);
    return !deform::is_finite(positions);
  };
  for (Round& round : study.rounds) {
    drop_spoilt_poses(study.scene, skin, study.source.mesh, options.truth, "/meshes", round.train, notes);
    std::erase_if(round.held, [&](const HeldPose& p) { return usable.spoiling_joint(p.pose).has_value(); });
    std::erase_if(round.train, is_infinite);
    std::erase_if(round.held, is_infinite);
  }
  std::erase_if(study.rounds, [](const Round& round) { return round.held.empty(); });
  if (study.rounds.empty())
    throw Failure(Exit::invalid, study.scene.source, "/animations", "no-truth",
                  "the truth is finite in no pose that is held out");
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

glm::dquat bent(double bend, double twist) {
  return glm::angleAxis(bend, glm::dvec3(0, 0, 1)) * glm::angleAxis(twist, glm::dvec3(1, 0, 0));
}

void add_clip(const std::vector<std::pair<double, double>>& angles, RawScene& scene) {
  RawChannel channel;
  channel.node = 1;
  channel.path = RawPath::rotation;
  for (const auto& [bend, twist] : angles) {
    const glm::dquat q = bent(bend, twist);
    channel.times_s.push_back(static_cast<float>(channel.times_s.size()) / 30);
    channel.values.emplace_back(static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                                static_cast<float>(q.w));
  }
  scene.clips.push_back({"bends and twists", {channel}, {}});
}

}  // namespace

Study study_cylinder() {
  constexpr int kSeeds = 5, kHeld = 200;
  constexpr std::uint32_t kTrained = 30;
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
  study.joint_names = {"root", "bend"};
  study.motion = deform::range_of_motion(mesh, study.source.parents, study.source.centres);
  study.source.motion = study.motion.poses;
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
    // As for a character, poses between those are made up.
    for (std::uint32_t i = 0; i < kMadeUp; ++i) {
      const auto& from = angles[random() % kTrained];
      const auto& to = angles[random() % kTrained];
      const glm::dquat turn = glm::slerp(bent(from.first, from.second), bent(to.first, to.second), up_to(1));
      round.train.push_back({{study.rest[0], deform::Matrix(glm::mat3_cast(turn))}, i % 5, false});
    }
    for (int i = 0; i < kHeld; ++i) {
      const double bend = up_to(kMostBend), twist = up_to(kMostTwist);
      round.held.push_back({deform::cylinder_pose(bend, twist), "", 0, {}});
    }
    if (seed == 1) add_clip(angles, study.scene);
  }
  return study;
}

}  // namespace marrow::tools
