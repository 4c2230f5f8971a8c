#include "cook/clip/build_clips.h"

#include <algorithm>
#include <map>

#include "common/failure.h"
#include "common/parallel.h"
#include "cook/clip/additive_references.h"
#include "cook/clip/build_channels.h"
#include "cook/clip/build_tracks.h"
#include "cook/clip/compress/compress_clip.h"
#include "cook/clip/morph_errors.h"
#include "cook/clip/split_clips.h"
#include "cook/motion/root_track.h"
#include "text/nearest.h"
#include "text/pattern.h"

namespace marrow::cook {
namespace {

constexpr double kPerson = 2.0;  // metres

// The joints that meshes of a skeleton follow; without any all: what draws nothing does not measure a character.
std::vector<char> drawn_joints(std::uint32_t skeleton, std::size_t joints, const Carried& carried) {
  std::vector<char> out(joints, 0);
  for (const Mesh& mesh : carried.meshes)
    for (std::uint32_t j = 0; j < mesh.joint_count && mesh.skeleton == skeleton; ++j) out[mesh.joints[j]] = 1;
  if (std::ranges::count(out, 1) == 0) out.assign(joints, 1);
  return out;
}

// Of the box around some joints at rest, scene units.
double diagonal_of(const Rig& rig, const std::vector<char>& joints) {
  glm::dvec3 low(1e300), high(-1e300);
  for (std::size_t j = 0; j < rig.size(); ++j) {
    if (joints[j] == 0) continue;
    low = glm::min(low, rig.world[j].origin);
    high = glm::max(high, rig.world[j].origin);
  }
  return glm::length(high - low);
}

// By what lengths for a person of 2 m are multiplied where the unit is clearly not the metre: `largest` character of
// the file is over 20 or under 0.2 across.
double scale_of_person(double largest) {
  return largest < 0.2 || largest > 20 ? largest / kPerson : 1.0;
}

Promise make_promise(const BuiltSkeleton& skeleton, const Rig& rig, double diagonal, double largest,
                     const ClipOptions& options) {
  const double scale = scale_of_person(largest);
  const double size = diagonal > 0 ? diagonal : largest;  // one joint has no extent
  Promise promise;
  if (options.shell) promise.shell = *options.shell;
  promise.shell *= scale;  // where the error is looked at, not how large it may be
  promise.of_vertices = !options.shell;
  promise.error.resize(rig.size());
  promise.points.resize(rig.size());
  promise.reach.assign(rig.size(), promise.shell);
  for (const ClipErrorRule& rule : options.error)
    for (std::size_t j = 0; j < rig.size(); ++j)
      if (rule.joints.empty() || tools::fits(rule.joints, skeleton.joint_names[j]))
        promise.error[j] = rule.error * (rule.is_share ? size : rule.is_for_a_person ? scale : 1);
  return promise;
}

std::vector<std::string> joint_names(const std::vector<BuiltSkeleton>& skeletons) {
  std::vector<std::string> out;
  for (const BuiltSkeleton& skeleton : skeletons)
    out.insert(out.end(), skeleton.joint_names.begin(), skeleton.joint_names.end());
  return out;
}

void check_clip_error_rules(const std::vector<BuiltSkeleton>& skeletons, const ClipOptions& options, Notes& notes) {
  for (const ClipErrorRule& rule : options.error) {
    const auto fits = [&](const std::string& joint) { return tools::fits(rule.joints, joint); };
    const bool found = rule.joints.empty() || std::ranges::any_of(skeletons, [&](const BuiltSkeleton& skeleton) {
                         return std::ranges::any_of(skeleton.joint_names, fits);
                       });
    if (!found && !rule.origin.must_fit)
      notes.warnings.push_back(
          {"/nodes", "rule-fits-nothing", "clip-error: no joint is called \"" + rule.joints + "\""});
    if (!found && rule.origin.must_fit)
      throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                           "no joint is called \"" + rule.joints + "\"",
                           tools::suggestion(rule.joints, joint_names(skeletons)));
  }
}

// Everything that the clips of one skeleton are compressed for.
struct Rigged {
  Rig rig;
  double diagonal_m = 0;
  Promise promise;
  Hung hung;
};

void hang_all(std::uint32_t skeleton, const Carried& carried, Rigged& to) {
  std::vector<Mesh> meshes;
  for (const Mesh& mesh : carried.meshes)
    if (mesh.skeleton == skeleton) meshes.push_back(mesh);
  Promise watched = to.promise;
  std::vector<MorphedMesh> morphed;
  for (const MorphedMesh& one : carried.morphed)
    if (one.mesh.skeleton == skeleton) morphed.push_back(one);
  to.hung = hang(meshes, morphed, to.rig, watched);
  for (const BuiltNode& node : carried.nodes)
    if (node.skeleton == skeleton && node.joint != kNoJoint) {
      const auto& rows = node.joint_from_node.rows;
      hang(node.joint, {rows[0][3], rows[1][3], rows[2][3]}, to.rig, watched);
    }
  if (to.promise.of_vertices) to.promise = std::move(watched);
}

// channels: a clip's, as they are.
std::vector<BuiltClip> compressed(std::vector<BuiltClip> clips, const std::vector<BuiltClip>& channels,
                                  const std::vector<BuiltSkeleton>& skeletons, const Carried& carried,
                                  const ClipOptions& options, const deform::Progress& progress) {
  std::map<std::uint32_t, Rigged> rigged;
  for (const BuiltClip& clip : clips)
    rigged.try_emplace(clip.skeleton, Rigged{Rig(skeletons[clip.skeleton]), 0, {}, {}});
  double largest = 0;
  for (auto& [skeleton, of] : rigged) {
    of.diagonal_m = diagonal_of(of.rig, drawn_joints(skeleton, of.rig.size(), carried));
    largest = std::max(largest, of.diagonal_m);
  }
  if (!(largest > 0)) largest = kPerson;
  for (auto& [skeleton, of] : rigged) {
    of.promise = make_promise(skeletons[skeleton], of.rig, of.diagonal_m, largest, options);
    hang_all(skeleton, carried, of);
  }
  deform::Steps steps(progress, clips.size());
  tools::for_each_in_parallel(clips.size(), [&](std::size_t i) {
    const Rigged& of = rigged.at(clips[i].skeleton);
    compress_clip(clips[i], skeletons[clips[i].skeleton], of.rig, of.promise, of.hung, options.effort, channels[i]);
    steps.one_more();
  });
  return clips;
}

}  // namespace

std::vector<BuiltClip> build_clips(const RawScene& scene, const BuiltScene& built, const Carried& carried,
                                   const ClipOptions& options, Notes& notes) {
  std::vector<ClipPart> parts = split_clips(scene, built);
  std::vector<BuiltClip> clips;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ClipPart& part = parts[i];
    const BuiltClip* const raw = built.clips.empty() ? nullptr : &built.clips[i];
    if (raw != nullptr && !raw->motion.root_in_pose.empty())
      take_out_root(raw->motion.root_in_pose, *raw, built.skeletons[part.skeleton], part.clip);
    clips.push_back(build_tracks(part.clip, built.joint_of_node));
    clips.back().source = part.source;
    clips.back().skeleton = part.skeleton;
    clips.back().duration_s = part.duration_s;
  }
  const std::vector<AdditiveReference> references =
      additive_references(built.skeletons, clips, options.additive, notes);
  for (std::size_t i = 0; i < clips.size(); ++i) {
    clips[i].additive = references[i].name.empty() && parts[i].clip.additive ? "rest" : references[i].name;
    clips[i].reference = references[i].pose;
  }
  std::vector<BuiltClip> channels(clips.size());
  for (std::size_t i = 0; i < clips.size(); ++i) {
    channels[i].duration_s = clips[i].duration_s;
    add_channels(parts[i].clip, true, channels[i]);
  }
  if (options.raw)
    for (BuiltClip& clip : clips) clip.raw_because = "--clip-codec raw";
  if (!options.raw) {
    check_clip_error_rules(built.skeletons, options, notes);
    clips = compressed(std::move(clips), channels, built.skeletons, carried, options, notes.progress_of(Stage::clip));
  }
  for (std::size_t i = 0; i < clips.size(); ++i) {
    add_channels(parts[i].clip, options.raw, clips[i]);
    if (!built.clips.empty()) clips[i].motion = built.clips[i].motion;
    clips[i].error.vertex_error_m +=
        morph_error_m(channels[i], clips[i], built.skeletons[clips[i].skeleton], carried.morphed);
  }
  return clips;
}

std::vector<BuiltClip> build_raw_clips(const RawScene& scene, const BuiltScene& built,
                                       const std::vector<AdditiveRule>& additive) {
  ClipOptions raw;
  raw.raw = true;
  raw.additive = additive;
  Notes of_the_others;
  return build_clips(scene, built, {}, raw, of_the_others);
}

}  // namespace marrow::cook
