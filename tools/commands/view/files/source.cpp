#include "commands/view/files/source.h"

#include <algorithm>
#include <filesystem>

#include "common/failure.h"
#include "common/formats.h"
#include "cook/cook.h"
#include "cook/read_source.h"
#include "options/settings.h"

namespace marrow::tools {
namespace {

cook::CookOptions options_for(Source& source) {
  const std::string folder = std::filesystem::path(source.path).parent_path().string();
  source.settings = cook::find_settings(source.path, folder.empty() ? "." : folder).value_or("");
  if (source.settings.empty()) return {};
  std::vector<bool> used;
  const cook::CookOptions options =
      cook::to_options(cook::settings_for(cook::read_settings(source.settings), source.path, used));
  if (options.clips_only)
    throw Failure(Exit::usage, source.settings, "", "it makes a clip pack of " + source.path,
                  "cook the character that the pack is for, and name the pack with --clips");
  return options;
}

// Named as cooked meshes are.
SkinJoints skin_joints(const cook::RawScene& scene) {
  SkinJoints out;
  for (const cook::RawInstance& instance : scene.instances) {
    if (instance.skin == cook::kNone) continue;
    const std::string& own = scene.meshes[cook::to_index(instance.mesh)].name;
    std::set<std::string>& names = out[own.empty() ? scene.nodes[cook::to_index(instance.node)].name : own];
    for (const int joint : scene.skins[cook::to_index(instance.skin)].joints)
      names.insert(scene.nodes[cook::to_index(joint)].name);
  }
  return out;
}

void cook_in_memory(Source& source) {
  const cook::CookOptions options = options_for(source);
  cook::RawScene scene = cook::read_source(source.path, options);
  // A skeleton that is made takes the place of skins.
  if (options.auto_skeleton.empty()) source.skins = skin_joints(scene);
  cook::CookResult cooked = cook::cook_scene(std::move(scene), options);
  AlignedBytes bytes(cooked.file.size());
  std::ranges::copy(cooked.file, bytes.data());
  source.loaded = load_mrw(source.path, std::move(bytes));
  source.cooked_here = true;
  source.warnings = cooked.report["warnings"].size();
  for (const cook::RawRead& read : cooked.reads)
    if (read.path != source.path) source.reads.push_back(read.path);
  if (!source.settings.empty()) source.reads.push_back(source.settings);
}

}  // namespace

Source open_source(const std::string& path, const std::string& images_from) {
  Source source;
  source.path = path;
  source.reads = {path};
  if (is_named_source(path)) {
    cook_in_memory(source);
    source.images = images_from.empty() ? places_beside(path) : places_of_cooked(path, images_from);
  } else {
    source.loaded = load_mrw(path);
    source.images = places_of_cooked(path, images_from);
  }
  return source;
}

}  // namespace marrow::tools
