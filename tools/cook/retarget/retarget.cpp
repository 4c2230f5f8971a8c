#include "cook/retarget/retarget.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

#include "common/failure.h"
#include "cook/retarget/play_take.h"
#include "cook/roles/build_roles.h"
#include "cook/skeleton/build_skeletons.h"
#include "marrow/roles.h"
#include "text/nearest.h"

namespace marrow::cook {
namespace {

constexpr std::uint64_t kFewPoses = 1u << 22;
constexpr std::size_t kMostCompared = 16;  // skeletons of either file

std::string place_of_joints(const RawScene& source) {
  return source.is_capture ? "HIERARCHY" : "/nodes";
}

// The source's skeletons, with roles.
std::vector<BuiltSkeleton> skeletons_of(const RawScene& source) {
  BuiltScene built = build_skeletons(source);
  Notes unused;
  find_roles(source, {}, {}, built, unused);
  return std::move(built.skeletons);
}

[[noreturn]] void fail_unpaired(const Character& character, const RawScene& source,
                                const std::vector<BuiltSkeleton>& rigs) {
  std::vector<std::string> names;
  for (const BuiltSkeleton& rig : rigs) names.insert(names.end(), rig.joint_names.begin(), rig.joint_names.end());
  throw tools::Failure(tools::Exit::invalid, source.source, place_of_joints(source),
                       "no joint is called as in " + character.file,
                       "rename joints: here are " + tools::listed(names) + "; there are " +
                           tools::listed(character.skeletons.at(0).joint_names));
}

std::ptrdiff_t count_of(const std::vector<Counterpart>& pairs) {
  return std::ranges::count_if(pairs, &Counterpart::is_there);
}

// Of a file of very many skeletons those with the most joints.
std::vector<std::size_t> largest(const std::vector<BuiltSkeleton>& skeletons) {
  std::vector<std::size_t> out(skeletons.size());
  std::iota(out.begin(), out.end(), std::size_t{0});
  std::ranges::stable_sort(out, std::greater{}, [&](std::size_t s) { return skeletons[s].joint_names.size(); });
  out.resize(std::min(out.size(), kMostCompared));
  std::ranges::sort(out);
  return out;
}

// The one that has most of the names.
std::size_t with_most(const std::vector<BuiltSkeleton>& skeletons, const std::set<std::string>& names) {
  std::size_t best = 0;
  std::ptrdiff_t most = -1;
  for (std::size_t s = 0; s < skeletons.size(); ++s) {
    const auto is_named = [&](const std::string& name) { return names.contains(name); };
    const std::ptrdiff_t count = std::ranges::count_if(skeletons[s].joint_names, is_named);
    if (count <= most) continue;
    most = count;
    best = s;
  }
  return best;
}

RigPairing pair_by_map(const Character& character, const RawScene& source, const std::vector<BuiltSkeleton>& rigs,
                       const RetargetMap& map) {
  std::set<std::string> own, others;
  for (const MappedJoint& line : map.joints) {
    own.insert(line.joint);
    others.insert(line.source);
  }
  const std::size_t s = with_most(character.skeletons, own), r = with_most(rigs, others);
  return {s, r, map_rigs(character.skeletons[s], rigs[r], map, character.file, source.source), {}};
}

// The two skeletons that have most in common.
RigPairing pair_best(const Character& character, const RawScene& source, const std::vector<BuiltSkeleton>& rigs) {
  RigPairing out;
  for (const std::size_t s : largest(character.skeletons))
    for (const std::size_t r : largest(rigs)) {
      std::vector<Counterpart> pairs = pair_rigs(character.skeletons[s], rigs[r]);
      if (count_of(pairs) > count_of(out.pairs)) out = {s, r, std::move(pairs), {}};
    }
  if (count_of(out.pairs) == 0) fail_unpaired(character, source, rigs);
  return out;
}

// Of the source's joints, in the order of its nodes.
void warn_of_strangers(const Character& character, const RawScene& source, const BuiltSkeleton& rig,
                       const std::vector<Counterpart>& pairs, Notes& notes) {
  std::set<int> used, strangers;
  for (const Counterpart& at : pairs)
    for (const int joint : {at.node, at.other})
      if (joint != kNone) used.insert(joint);
  for (std::size_t j = 0; j < rig.joint_names.size(); ++j)
    if (!used.contains(static_cast<int>(j))) strangers.insert(rig.node_of_joint[j]);
  std::vector<std::string> names;
  for (const int node : strangers) names.push_back(source.nodes[to_index(node)].name);
  if (!names.empty())
    notes.warnings.push_back({place_of_joints(source), "no-such-joint",
                              std::to_string(names.size()) + " of " + std::to_string(rig.joint_names.size()) +
                                  " joints have no counterpart in " + character.file +
                                  " and are left out: " + tools::listed(names)});
}

// Four legs on two feet, or two on four.
void warn_of_other_plan(const BuiltSkeleton& own, const BuiltSkeleton& rig, const RawScene& source, Notes& notes) {
  const auto on_hands = [](const BuiltSkeleton& of) {
    return std::ranges::find(of.roles.soles, joint_with(of, Role::left_hand), &JointSole::joint) !=
           of.roles.soles.end();
  };
  const bool has_hands = joint_with(own, Role::left_hand) != kNone && joint_with(rig, Role::left_hand) != kNone;
  if (has_hands && on_hands(own) != on_hands(rig))
    notes.warnings.push_back({place_of_joints(source), "other-body",
                              "one of the two stands on four feet, and the other on two; clips will hardly fit"});
}

// A file of two megabytes can have 32767 joints and a million frames of one channel.
void check_size(const Take& take, std::size_t joints) {
  const RawScene& source = take.scene();
  const std::uint64_t frames = take.times_s().size();
  if ((source.nodes.size() + joints) * frames > std::max(8 * source.source_bytes, kFewPoses))
    throw tools::Failure(tools::Exit::unsupported, source.source, source.is_capture ? "MOTION" : "/animations",
                         "too many frames for so few channels", "split the take, or leave out joints without channels");
}

RawClip clip_of(const RetargetPlan& plan, const RawClip& source, const Take& take, TakenKeys keys) {
  RawClip out;
  out.name = source.name;
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    const auto add = [&](RawPath path, std::vector<glm::vec4>& values) {
      if (!values.empty())
        out.channels.push_back(
            {static_cast<int>(j), path, RawInterpolation::linear, take.times_s(), std::move(values)});
    };
    add(RawPath::translation, keys.places[j]);
    add(RawPath::rotation, keys.turns[j]);
  }
  return out;
}

}  // namespace

RigPairing pair_with(const Character& character, const RawScene& source, const RetargetMap* map) {
  expect_skeletons(character);
  const std::vector<BuiltSkeleton> rigs = skeletons_of(source);
  if (rigs.empty()) fail_unpaired(character, source, rigs);
  RigPairing out = map == nullptr ? pair_best(character, source, rigs) : pair_by_map(character, source, rigs, *map);
  out.rig_skeleton = rigs[out.rig];
  return out;
}

RigPairing pair_with(const Character& character, const RawScene& source, const RetargetMap* map, Notes& notes) {
  RigPairing out = pair_with(character, source, map);
  warn_of_strangers(character, source, out.rig_skeleton, out.pairs, notes);
  warn_of_other_plan(character.skeletons[out.skeleton], out.rig_skeleton, source, notes);
  return out;
}

std::vector<Counterpart> nodes_of_pairs(const RigPairing& pairing) {
  std::vector<Counterpart> out = pairing.pairs;
  for (Counterpart& at : out)
    for (int* const joint : {&at.node, &at.other})
      if (*joint != kNone) *joint = pairing.rig_skeleton.node_of_joint[to_index(*joint)];
  return out;
}

void warn_of_facing(const Character& character, const RawScene& source, int facing_deg, Notes& notes) {
  if (facing_deg != 0)
    notes.warnings.push_back({place_of_joints(source), "turned",
                              character.file + " faces another way at rest; the clip is turned about y by " +
                                  std::to_string(facing_deg) + " degrees"});
}

RetargetedClips retarget_clips(const Character& character, const RawScene& source, const RetargetMap* map,
                               Notes& notes) {
  const RigPairing pairing = pair_with(character, source, map, notes);
  const std::vector<Counterpart> pairs = nodes_of_pairs(pairing);
  const std::vector<Mesh> meshes = meshes_of(character.meshes, pairing.skeleton);
  const BuiltSkeleton& skeleton = character.skeletons[pairing.skeleton];
  RetargetedClips out{pairing.skeleton, {}};
  const BuiltSkeleton& rig = pairing.rig_skeleton;
  Take take(source);
  int facing_deg = 0;
  for (const RawClip& clip : source.clips) {
    if (clip.channels.empty()) continue;
    take.open(clip, skeleton.joint_names.size() + source.nodes.size());
    check_size(take, skeleton.joint_names.size());
    RetargetPlan plan = plan_retarget(skeleton, rig, pairs, take);
    TakenKeys keys = play_take(skeleton, plan, take, taken_contacts(rig, clip), meshes, character.file);
    out.clips.push_back(clip_of(plan, clip, take, std::move(keys)));
    facing_deg = plan.facing_deg;
  }
  warn_of_facing(character, source, facing_deg, notes);
  return out;
}

Matched scene_of(const Character& character, std::vector<RetargetedClips> all, RawScene scene) {
  Matched out;
  out.built.skeletons = character.skeletons;
  scene.nodes.clear();
  scene.skins.clear();
  scene.clips.clear();
  std::vector<int> first;  // node of a skeleton
  for (std::size_t s = 0; s < character.skeletons.size(); ++s) {
    BuiltSkeleton& skeleton = out.built.skeletons[s];
    skeleton.node_of_joint.clear();
    first.push_back(static_cast<int>(scene.nodes.size()));
    for (std::size_t j = 0; j < skeleton.joint_names.size(); ++j) {
      skeleton.node_of_joint.push_back(static_cast<int>(scene.nodes.size()));
      RawNode& node = scene.nodes.emplace_back();
      node.name = skeleton.joint_names[j];
      node.parent = skeleton.parents[j] == kNoJoint ? kNone : first[s] + skeleton.parents[j];
      out.built.joint_of_node.push_back(static_cast<int>(j));
      out.built.nearest.push_back({static_cast<int>(s), static_cast<int>(j), glm::dmat4(1.0)});
    }
  }
  for (RetargetedClips& clips : all)
    for (RawClip& clip : clips.clips) {
      for (RawChannel& channel : clip.channels) channel.node += first[clips.skeleton];
      scene.clips.push_back(std::move(clip));
    }
  out.scene = std::move(scene);
  return out;
}

Matched retarget(const Character& character, RawScene capture, Notes& notes) {
  std::vector<RetargetedClips> all;
  all.push_back(retarget_clips(character, capture, nullptr, notes));
  return scene_of(character, std::move(all), std::move(capture));
}

}  // namespace marrow::cook
