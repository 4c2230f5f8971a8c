#include "bench/models.h"

#include <cstdlib>
#include <filesystem>

#include "common/failure.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "sample/embedded.h"

namespace marrow::tools {
namespace {

cook::RawScene read_model(const ModelSource& model, const std::string& folder) {
  return model.embedded ? cook::read_gltf(model.file, sample_glb())
                        : cook::read_gltf((std::filesystem::path(folder) / model.file).string());
}

// What a clip moves stays a joint, so the skeleton is the same whichever clips are wanted.
void keep_first_keys(cook::RawClip& clip) {
  for (cook::RawChannel& channel : clip.channels) {
    channel.times_s.resize(1);
    channel.values.resize(channel.interpolation == cook::RawInterpolation::cubic_spline ? 3 : 1);
  }
}

}  // namespace

Models::Models() {
  const char* const given = std::getenv("MARROW_ASSETS");
  folder_ = std::filesystem::path(given != nullptr ? given : MARROW_DEFAULT_ASSETS).lexically_normal().string();
}

bool Models::has(const ModelSource& model) const {
  std::error_code unreadable;
  return model.embedded || std::filesystem::exists(std::filesystem::path(folder_) / model.file, unreadable);
}

const File& Models::get(const ModelSource& model) {
  const auto [at, is_new] = cooked_.try_emplace(&model);
  LoadedFile& loaded = at->second;
  if (!is_new) return loaded.file;
  cook::RawScene scene = read_model(model, folder_);
  for (cook::RawClip& clip : scene.clips)
    if (!wanted_[&model].contains(clip.name)) keep_first_keys(clip);
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  loaded.bytes = AlignedBytes(std::span<const std::byte>(cook::cook_scene(std::move(scene), options).file));
  if (load({loaded.bytes.data(), loaded.bytes.size()}, loaded.file) != Status::ok)
    throw Failure(Exit::internal, model.file, "", "cannot be loaded once cooked", "please report this");
  return loaded.file;
}

const std::vector<std::byte>& Models::packed(const ModelSource& model, const std::string& codec) {
  const auto [at, is_new] = packed_.try_emplace({&model, codec});
  if (!is_new) return at->second;
  cook::CookOptions options;
  options.mesh.codec = codec == "draco" ? cook::MeshCodec::draco : cook::MeshCodec::meshopt;
  at->second = cook::cook_scene(read_model(model, folder_), options).file;
  return at->second;
}

ClipOfModel find_clip(const ModelSource& model, const File& file, const std::string& name) {
  const std::uint32_t index = file.find_clip(name.c_str());
  if (index == file.clip_count())
    throw Failure(Exit::invalid, model.file, "", "no clip \"" + name + "\"", "use the model that the row is meant for");
  const Clip clip = file.clip(index);
  return {file.skeleton(clip.skeleton), clip};
}

}  // namespace marrow::tools
