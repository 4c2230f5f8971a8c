#include "cook/retarget/add_clips.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "common/failure.h"
#include "cook/mesh/build_meshes.h"
#include "cook/prepare/prepare_scene.h"
#include "cook/retarget/make_pose_map.h"
#include "cook/retarget/mirror_clips.h"
#include "cook/retarget/retarget.h"
#include "cook/roles/build_roles.h"
#include "cook/skeleton/build_skeletons.h"
#include "text/safe_name.h"

namespace marrow::cook {
namespace {

struct Named {
  std::string file;
  RetargetedClips clips;
};

// What is said of another file.
void add_warnings_of(const std::string& file, Notes said, Notes& notes) {
  for (RawWarning& warning : said.warnings) {
    warning.pointer = file + " " + warning.pointer;
    notes.warnings.push_back(std::move(warning));
  }
}

std::vector<Named> retarget_all(const Character& character, const std::vector<RetargetRule>& rules, Notes& notes) {
  std::vector<Named> out;
  for (const RetargetRule& rule : rules) {
    Notes own;
    out.push_back({rule.file, retarget_clips(character, *rule.rig, rule.pairs.get(), own)});
    add_warnings_of(rule.file, std::move(own), notes);
    if (out.back().clips.clips.empty())
      notes.warnings.push_back({rule.file, "no-clips", "it has no clip that moves a node; nothing is added"});
  }
  return out;
}

// Unlike all there are, and one of them from now on.
std::string free_name(const std::string& name, const std::string& file, std::set<std::string>& taken) {
  const std::string stem = tools::safe_name(std::filesystem::path(file).stem().string());
  std::string out = name.empty() ? stem : name;
  if (taken.contains(out)) out = stem + "." + name;
  const std::string base = out;
  for (int i = 2; !taken.insert(out).second; ++i) out = base + "." + std::to_string(i);
  return out;
}

}  // namespace

Character character_of(const RawScene& scene, const std::vector<RoleRule>& rules) {
  Character out;
  out.file = scene.source;
  BuiltScene built = build_skeletons(scene);
  MeshOptions plain;
  plain.codec = MeshCodec::none;
  Notes unused;
  const auto meshes = std::make_shared<BuiltMeshes>(build_meshes(scene, built, plain, {}, unused));
  out.meshes = full_meshes(*meshes);
  find_roles(scene, out.meshes, rules, built, unused);
  out.skeletons = std::move(built.skeletons);
  out.holds = meshes;
  return out;
}

RawScene with_added_clips(RawScene scene, const RetargetOptions& options, const std::vector<RoleRule>& roles,
                          Notes& notes) {
  if (options.clips.empty() && options.mirror.empty()) return scene;
  const Character character = character_of(scene, roles);
  std::set<std::string> taken;
  for (const RawClip& clip : scene.clips) taken.insert(clip.name);
  for (Named& named : retarget_all(character, options.clips, notes))
    for (RawClip& clip : named.clips.clips) {
      clip.name = free_name(clip.name, named.file, taken);
      for (RawChannel& channel : clip.channels)
        channel.node = character.skeletons[named.clips.skeleton].node_of_joint[to_index(channel.node)];
      scene.clips.push_back(std::move(clip));
    }
  if (options.mirror.empty()) return scene;
  BuiltScene built = build_skeletons(scene);
  for (std::size_t s = 0; s < built.skeletons.size(); ++s) built.skeletons[s].roles = character.skeletons[s].roles;
  return with_mirrored_clips(std::move(scene), built, options.mirror);
}

Matched only_added_clips(const Character& onto, RawScene scene, const RetargetOptions& options, Notes& notes) {
  expect_skeletons(onto);
  std::vector<RetargetedClips> all;
  std::set<std::string> taken;
  for (Named& named : retarget_all(onto, options.clips, notes)) {
    for (RawClip& clip : named.clips.clips) clip.name = free_name(clip.name, named.file, taken);
    all.push_back(std::move(named.clips));
  }
  Matched out = scene_of(onto, std::move(all), std::move(scene));
  out.scene = with_mirrored_clips(std::move(out.scene), out.built, options.mirror);
  return out;
}

std::vector<BuiltPoseMap> make_pose_maps(const Character& character, const std::vector<RetargetRule>& rules,
                                         Notes& notes) {
  std::vector<BuiltPoseMap> out;
  for (const RetargetRule& rule : rules) {
    const std::string name = tools::safe_name(std::filesystem::path(rule.file).stem().string());
    if (std::ranges::find(out, name, &BuiltPoseMap::name) != out.end())
      throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                           "a second rig called \"" + name + "\"", "name one of the files otherwise");
    Notes own, unused;
    RawScene rig = *rule.rig;
    if (!rule.file.ends_with(".mrw")) rig = prepare_scene(std::move(rig), {}, unused);  // as it is cooked
    out.push_back(make_pose_map(character, rig, rule.pairs.get(), own));
    out.back().name = name;
    add_warnings_of(rule.file, std::move(own), notes);
  }
  return out;
}

std::string map_of(const Character& character, const RawScene& rig) {
  return retarget_map_text(character, rig, pair_with(character, rig, nullptr));
}

}  // namespace marrow::cook
