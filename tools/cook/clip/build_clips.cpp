#include "cook/clip/build_clips.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string>

#include "common/check_status.h"
#include "common/failure.h"
#include "common/parallel.h"
#include "cook/clip/build_tracks.h"
#include "cook/clip/compress/compress_clip.h"
#include "cook/clip/measure/clip_measure.h"
#include "cook/clip/measure/rig.h"
#include "cook/motion/build_motions.h"
#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_skeletons.h"
#include "marrow/local_to_model.h"
#include "marrow/sample.h"
#include "text/nearest.h"
#include "text/pattern.h"

namespace marrow::cook {
namespace {

// What a clip of the source moves in one skeleton.
struct ClipPart {
  std::uint32_t skeleton;
  std::size_t source;  // which clip of the scene
  RawClip clip;
  float duration_s;  // of the whole clip, so that its parts stay in step
};

// At least one part a clip, in the order of clips, in each of skeletons. built: its skeletons.
std::vector<ClipPart> split_clips(const RawScene& scene, const BuiltScene& built) {
  const auto skeleton_of = [&](int node) { return built.nearest[to_index(node)].skeleton; };
  std::vector<ClipPart> out;
  for (const RawClip& clip : scene.clips) {
    std::map<int, RawClip> parts;
    float duration_s = 0;
    for (const RawChannel& channel : clip.channels) {
      // Outside the scene, as the reader has said.
      if (built.joint_of_node[to_index(channel.node)] == kNone) continue;
      parts[skeleton_of(channel.node)].channels.push_back(channel);
      duration_s = std::max(duration_s, channel.times_s.back());
    }
    const auto skeleton_of_weights = [&](const RawScalar& scalar) {
      return scalar.node == kNone ? kNone : skeleton_of(node_of_weights(scene, scalar.node));
    };
    for (const RawScalar& scalar : clip.scalars)
      if (const int skeleton = skeleton_of_weights(scalar); skeleton != kNone) parts[skeleton];
    if (parts.empty()) parts[0];
    for (const RawScalar& scalar : clip.scalars) {
      const int skeleton = skeleton_of_weights(scalar);
      parts[skeleton != kNone ? skeleton : parts.begin()->first].scalars.push_back(scalar);
      duration_s = std::max(duration_s, scalar.times_s.back());
    }
    for (auto& [skeleton, part] : parts) {
      part.name = clip.name;
      part.additive = clip.additive;
      out.push_back({static_cast<std::uint32_t>(skeleton), static_cast<std::size_t>(&clip - scene.clips.data()),
                     std::move(part), duration_s});
    }
  }
  return out;
}

struct AdditiveReference {
  std::string name;                // as AdditiveRule's; empty: an ordinary clip
  std::vector<SoaTransform> pose;  // empty: the rest pose
};

[[noreturn]] void no_such_clip(const std::string& name, const std::vector<BuiltClip>& clips, const RuleOrigin& origin) {
  std::vector<std::string> names;
  for (const BuiltClip& clip : clips) names.push_back(clip.name);
  throw tools::Failure(tools::Exit::usage, origin.file, origin.where, "no clip is called \"" + name + "\"",
                       names.empty() ? "there are no clips" : tools::suggestion(name, names));
}

std::vector<SoaTransform> first_frame(const BuiltSkeleton& of, const BuiltClip& clip) {
  const Skeleton skeleton = view(of);
  std::vector<SoaTransform> pose(skeleton.soa_size());
  if (sample(skeleton, view(clip, skeleton), 0.0f, pose) != Status::ok)
    throw tools::Failure(tools::Exit::internal, "--additive", "", "no pose of \"" + clip.name + "\"",
                         "please report this");
  return pose;
}

// skeleton: the clip's.
std::vector<SoaTransform> reference_pose(const BuiltSkeleton& skeleton, const std::vector<BuiltClip>& clips,
                                         const BuiltClip& clip, const AdditiveRule& rule) {
  const std::string& reference = rule.reference;
  if (reference == "rest") return {};
  if (reference != "first" && std::ranges::find(clips, reference, &BuiltClip::name) == clips.end())
    no_such_clip(reference, clips, rule.origin);
  const auto other = std::ranges::find_if(
      clips, [&](const BuiltClip& c) { return c.name == reference && c.skeleton == clip.skeleton; });
  if (reference != "first" && other == clips.end()) return {};  // it leaves this skeleton at rest
  std::vector<SoaTransform> pose = first_frame(skeleton, reference == "first" ? clip : *other);
  if (std::memcmp(pose.data(), skeleton.rest.data(), pose.size() * sizeof(SoaTransform)) == 0) pose.clear();
  return pose;
}

// Scale is changed by a factor, and what has none cannot get one by it. As the runtime divides: see pose/additive.cpp.
void check_scales(const BuiltSkeleton& skeleton, const BuiltClip& clip, const std::vector<SoaTransform>& reference,
                  const AdditiveRule& rule) {
  const auto is_none = [](float scale) { return std::fabs(scale) <= 1e-20f; };
  for (const Track& track : clip.tracks) {
    if (track.path != TrackPath::scale) continue;
    const SoaTransform& four = (reference.empty() ? skeleton.rest : reference)[track.joint / 4];
    const std::uint32_t numbers = track.key_count * format::floats_per_key(track.path, track.interpolation);
    for (std::uint32_t i = 0; i < numbers; ++i) {
      if (!is_none(four.scale[i % 3][track.joint % 4]) || is_none(clip.values[track.first_value + i])) continue;
      throw tools::Failure(
          tools::Exit::usage, rule.origin.file, rule.origin.where,
          "clip \"" + clip.name + "\" scales joint \"" + skeleton.joint_names[track.joint] +
              "\", which has no scale in the reference \"" + rule.reference + "\"",
          "additive clips multiply scales, and nothing times 0 is more than 0; take another reference, "
          "such as \"rest\"");
    }
  }
}

// For each clip its reference, or none; of clips not yet compressed. Throws tools::Failure (usage) if a rule's
// reference is no clip or has no scale where the clip has some, or if it fits no clip and must; a warning if it need
// not.
std::vector<AdditiveReference> additive_references(const std::vector<BuiltSkeleton>& skeletons,
                                                   const std::vector<BuiltClip>& clips,
                                                   const std::vector<AdditiveRule>& rules, Notes& notes) {
  std::vector<AdditiveReference> out(clips.size());
  for (const AdditiveRule& rule : rules) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < clips.size(); ++i) {
      if (rule.clips != clips[i].name && !tools::fits(rule.clips, clips[i].name)) continue;
      const BuiltSkeleton& skeleton = skeletons[clips[i].skeleton];
      out[i] = {rule.reference, reference_pose(skeleton, clips, clips[i], rule)};
      check_scales(skeleton, clips[i], out[i].pose, rule);
      ++found;
    }
    if (found == 0 && rule.origin.must_fit) no_such_clip(rule.clips, clips, rule.origin);
    if (found == 0)
      notes.warnings.push_back(
          {"/animations", "rule-fits-nothing", "additive: no clip is called \"" + rule.clips + "\""});
  }
  return out;
}

constexpr int kPoses = 64;  // that tell how large a clip makes a mesh

// Keys, what is just before them and the quarters between.
std::set<float> moments_of(const BuiltClip& source) {
  std::set<float> out = {0.0f};
  for (const Channel& channel : source.channels) {
    const float* const times = source.times_s.data() + channel.first_time;
    for (std::uint32_t k = 0; k < channel.key_count; ++k) {
      const float next = times[std::min(k + 1, channel.key_count - 1)];
      out.insert(just_before(times[k]));
      for (int quarter = 0; quarter < 4; ++quarter)
        out.insert(times[k] + (next - times[k]) * 0.25f * static_cast<float>(quarter));
    }
  }
  return out;
}

// Scene units a unit of the mesh, at most.
double largest_scale(const Mesh& mesh, const BuiltClip& clip, const Skeleton& skeleton) {
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count);
  double out = 0;
  for (int i = 0; i <= kPoses; ++i) {
    const float time_s = clip.duration_s * static_cast<float>(i) / kPoses;
    tools::check(sample(skeleton, view(clip, skeleton), time_s, local));
    tools::check(local_to_model(skeleton, local, model));
    for (std::uint32_t j = 0; j < mesh.joint_count; ++j)
      out = std::max(out,
                     largest_stretch(glm::dmat3(to_matrix(model[mesh.joints[j]]) * to_matrix(mesh.inverse_bind[j]))));
  }
  return out;
}

// The largest sum over targets, in the mesh's units.
double largest_sum(const MorphedMesh& mesh, const std::set<float>& moments, ChannelValues& source,
                   ChannelValues& cooked) {
  std::vector<std::pair<int, int>> channels;  // a target: of both
  for (const MorphedMesh::Target& target : mesh.targets)
    channels.emplace_back(source.find(target.channel), cooked.find(target.channel));
  double worst = 0;
  for (const float time_s : moments) {
    source.go_to(time_s);
    cooked.go_to(time_s);
    double sum = 0;
    for (std::size_t t = 0; t < mesh.targets.size(); ++t) {
      const MorphedMesh::Target& target = mesh.targets[t];
      const double wanted = source.value(channels[t].first, target.rest);
      sum += std::fabs(wanted - cooked.value(channels[t].second, target.rest)) * target.reach;
      sum += std::fabs(wanted) * target.error;
    }
    worst = std::max(worst, sum);
  }
  return worst;
}

// At worst, scene units, over the keys of `source`, which has the channels as they were, and the quarters between.
// clip: what became of it; meshes: of all skeletons.
double morph_error_m(const BuiltClip& source, const BuiltClip& clip, const BuiltSkeleton& skeleton,
                     const std::vector<MorphedMesh>& meshes) {
  if (std::ranges::none_of(meshes, [&](const MorphedMesh& m) { return m.mesh.skeleton == clip.skeleton; })) return 0;
  const Skeleton joints = view(skeleton);
  ChannelValues wanted(source), cooked(clip);
  const std::set<float> moments = moments_of(source);
  double worst = 0;
  for (const MorphedMesh& mesh : meshes) {
    if (mesh.mesh.skeleton != clip.skeleton) continue;
    const double sum = largest_sum(mesh, moments, wanted, cooked);
    if (sum > 0) worst = std::max(worst, sum * largest_scale(mesh.mesh, clip, joints));
  }
  return worst;
}

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
  Promise watched = to.promise;
  std::vector<MorphedMesh> morphed;
  for (const MorphedMesh& one : carried.morphed)
    if (one.mesh.skeleton == skeleton) morphed.push_back(one);
  to.hung = hang(meshes_of(carried.meshes, skeleton), morphed, to.rig, watched);
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
