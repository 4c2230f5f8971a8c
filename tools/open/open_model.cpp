#include "open/open_model.h"

#include <algorithm>
#include <filesystem>

#include "common/failure.h"
#include "common/formats.h"
#include "disk/cook_on_disk.h"
#include "disk/settings.h"
#include "pose/worn.h"

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

void cook_in_memory(bool by_graph, const LookAtScene& look, OpenedModel& out) {
  cook::CookOptions options = options_for(out.path, out.settings);
  if (by_graph) {
    cook::RootRule all;
    all.clips = "*";
    all.root = cook::RootMotion::ground;
    all.origin.must_fit = false;                                     // a model without clips is none the worse
    options.motion.roots.insert(options.motion.roots.begin(), all);  // of rules the last one counts
  }
  cook::RawScene scene = cook::read_source(out.path, options);
  if (look) look(scene, options);
  const cook::Result cooked = cook::cook_scene(std::move(scene), options);
  out.loaded = load_mrw(out.path, AlignedBytes(std::span<const std::byte>(cooked.file)));
  out.cooked_here = true;
  out.warnings = cooked.report["warnings"].size();
  for (const cook::Read& read : cooked.reads)
    if (read.name != out.path) out.reads.push_back(read.name);
  if (!out.settings.empty()) out.reads.push_back(out.settings);
}

}  // namespace

OpenedModel open_model(const std::string& path, Opens opens, const LookAtScene& look) {
  OpenedModel out;
  out.path = path;
  out.reads = {path};
  if (opens != Opens::cooked_files && is_named_source(path)) {
    cook_in_memory(opens == Opens::models_by_graph, look, out);
  } else {
    out.loaded = load_mrw(path);
  }
  return out;
}

Model open_model(const ModelArguments& a, Opens opens) {
  Model out{open_model(a.file, opens), {}, {}};
  expect_level(a.file, out.file(), a.lod);
  out.chosen = choose(a.file, out.file(), a.choice, !a.outfits.empty());
  out.parameters = set_parameters(a.file, out.file(), a.choice);
  return out;
}

void prepare(const ModelArguments& a, const Model& model, Character& character, AsNormals normals) {
  character.set_parameters(model.parameters);
  put_on(a.outfits, a.file, model.file(), model.chosen.play, character, normals, a.lod);
}

void expect_level(const std::string& path, const File& file, std::uint32_t level) {
  std::size_t coarsest = 0;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) coarsest = std::max(coarsest, file.mesh(m).lods.size);
  if (level <= coarsest) return;
  throw Failure(Exit::usage, path, "", "no level of detail " + std::to_string(level),
                coarsest == 0
                    ? "there is 1 level, 0, in full; more are cooked by marrow cook --lod"
                    : "there are " + std::to_string(coarsest + 1) + " levels, 0 to " + std::to_string(coarsest));
}

}  // namespace marrow::tools
