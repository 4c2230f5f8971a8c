#include "cook/add_clips.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "cook/cook.h"
#include "cook/mesh/build_meshes.h"
#include "cook/prepare/mirrors.h"
#include "cook/read_source.h"
#include "cook/retarget/cooked_motion.h"
#include "cook/retarget/mirror_clips.h"
#include "cook/retarget/retarget.h"
#include "cook/retarget/retarget_map.h"
#include "cook/roles/build_roles.h"
#include "cook/skeleton/build_skeletons.h"
#include "text/safe_name.h"

namespace marrow::cook {
namespace {

struct Named {
  std::string file;
  RetargetedClips clips;
};

std::vector<Named> retarget_all(const Character& character, const CookOptions& options, Notes& notes) {
  std::vector<Named> out;
  for (const RetargetRule& rule : options.retarget) {
    const RawScene source = read_rig(rule.file);
    notes.reads.insert(notes.reads.end(), source.reads.begin(), source.reads.end());
    RetargetMap map;
    if (!rule.map.empty()) map = read_retarget_map(rule.map, notes.reads);
    Notes own;
    out.push_back({rule.file, retarget_clips(character, source, rule.map.empty() ? nullptr : &map, own)});
    for (RawWarning& warning : own.warnings) {
      warning.pointer = rule.file + " " + warning.pointer;
      notes.warnings.push_back(std::move(warning));
    }
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

RawScene read_rig(const std::string& file) {
  return with_one_form_of_mirrors(file.ends_with(".mrw") ? read_cooked_motion(file) : read_source(file, {}));
}

Character character_of(const RawScene& scene, const std::vector<RoleRule>& rules) {
  Character out;
  out.file = scene.source;
  BuiltScene built = build_skeletons(scene);
  CookOptions plain;
  plain.mesh_codec = MeshCodec::none;
  Notes unused;
  const auto meshes = std::make_shared<BuiltMeshes>(build_meshes(scene, built, plain, unused));
  out.meshes = full_meshes(*meshes);
  std::vector<BuiltRoles> roles = build_roles(scene, built, out.meshes, rules, unused);
  for (std::size_t s = 0; s < roles.size(); ++s) built.skeletons[s].roles = std::move(roles[s]);
  out.skeletons = std::move(built.skeletons);
  out.holds = meshes;
  return out;
}

RawScene with_added_clips(RawScene scene, const CookOptions& options, Notes& notes) {
  if (options.retarget.empty() && options.mirror.empty()) return scene;
  const Character character = character_of(scene, options.roles);
  std::set<std::string> taken;
  for (const RawClip& clip : scene.clips) taken.insert(clip.name);
  for (Named& named : retarget_all(character, options, notes))
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

Matched only_added_clips(const Character& onto, RawScene scene, const CookOptions& options, Notes& notes) {
  expect_skeletons(onto);
  std::vector<RetargetedClips> all;
  std::set<std::string> taken;
  for (Named& named : retarget_all(onto, options, notes)) {
    for (RawClip& clip : named.clips.clips) clip.name = free_name(clip.name, named.file, taken);
    all.push_back(std::move(named.clips));
  }
  Matched out = scene_of(onto, std::move(all), std::move(scene));
  out.scene = with_mirrored_clips(std::move(out.scene), out.built, options.mirror);
  return out;
}

std::string map_of(const std::string& character, const std::string& source) {
  const Character own = read_character(character);
  const RawScene scene = read_rig(source);
  return retarget_map_text(own, scene, pair_with(own, scene, nullptr));
}

}  // namespace marrow::cook
