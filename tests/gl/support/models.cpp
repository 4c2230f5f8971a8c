#include "gl/support/models.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "common/failure.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "support/places.h"

namespace marrow::test {
namespace fs = std::filesystem;

bool have_assets() {
  return fs::is_directory(assets_folder());
}

std::vector<std::string> model_paths() {
  std::vector<std::string> paths;
  if (have_assets()) {
    for (const fs::directory_entry& entry : fs::directory_iterator(assets_folder())) {
      const std::string extension = entry.path().extension().string();
      const bool is_model = extension == ".glb" || extension == ".gltf";
      if (is_model && takes_part(entry.path().string())) paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  paths.insert(paths.begin(), newt_glb());
  return paths;
}

std::optional<Model> cook_model(cook::RawScene scene, std::size_t palette) {
  const std::string path = scene.source;
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.clips.raw = true;  // poses are all that matters here, and compressing takes most of the time
  options.mesh.most_entries = palette;
  const cook::Result cooked = cook::cook_scene(std::move(scene), options);
  Model model{fs::path(path).filename().string(), tools::AlignedBytes(cooked.file), {}};
  DataError error;
  if (load({model.bytes.data(), model.bytes.size()}, model.file, &error) == Status::ok) return model;
  std::fprintf(stderr, "%s: @%u: %s\n", path.c_str(), error.offset, error.rule);
  return std::nullopt;
}

std::optional<Model> cook_model(const std::string& path) {
  try {
    return cook_model(cook::read_gltf(path));
  } catch (const tools::Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
  }
  return std::nullopt;
}

}  // namespace marrow::test
