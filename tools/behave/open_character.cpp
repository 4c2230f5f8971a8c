#include "behave/open_character.h"

#include <filesystem>

#include "common/failure.h"
#include "common/formats.h"
#include "disk/cook_on_disk.h"
#include "disk/settings.h"

namespace marrow::tools {
namespace {

cook::CookOptions options_for(const std::string& path, std::string& settings) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  settings = cook::find_settings(path, folder.empty() ? "." : folder).value_or("");
  if (settings.empty()) return {};
  std::vector<bool> used;
  cook::CookOptions options = cook::to_options(cook::settings_for(cook::read_settings(settings), path, used));
  if (options.clips_only)
    throw Failure(Exit::usage, settings, "", "it makes a clip pack of " + path,
                  "cook the character that the pack is for, and name the pack with --clips");
  return options;
}

OpenedCharacter cook_in_memory(const std::string& path, const CookHere& how) {
  OpenedCharacter out;
  cook::CookOptions options = options_for(path, out.settings);
  if (how.takes_roots) {
    cook::RootRule all;
    all.clips = "*";
    all.root = cook::RootMotion::ground;
    all.origin.must_fit = false;                                     // a model without clips is none the worse
    options.motion.roots.insert(options.motion.roots.begin(), all);  // of rules the last one counts
  }
  cook::RawScene scene = cook::read_source(path, options);
  if (how.look) how.look(scene, options);
  const cook::Result cooked = cook::cook_scene(std::move(scene), options);
  out.loaded = load_mrw(path, AlignedBytes(std::span<const std::byte>(cooked.file)));
  out.reads = {path};
  out.cooked_here = true;
  out.warnings = cooked.report["warnings"].size();
  for (const cook::Read& read : cooked.reads)
    if (read.name != path) out.reads.push_back(read.name);
  if (!out.settings.empty()) out.reads.push_back(out.settings);
  return out;
}

}  // namespace

OpenedCharacter open_character(const std::string& path, const CookHere& how) {
  if (is_named_source(path)) return cook_in_memory(path, how);
  OpenedCharacter out;
  out.loaded = load_mrw(path);
  out.reads = {path};
  return out;
}

}  // namespace marrow::tools
