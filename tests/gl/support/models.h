// Every model that the GL tests run over, cooked in memory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/aligned_bytes.h"
#include "cook/scene/raw.h"
#include "marrow/file.h"
#include "support/rig.h"

namespace marrow::test {

struct Model {
  std::string name;
  tools::AlignedBytes bytes;
  File file;
};

// The embedded sample first, then every .glb and .gltf in the folder of assets (environment MARROW_ASSETS; by default
// beside the sources), sorted by name.
std::vector<std::string> model_paths();
bool have_assets();

// Cooks and loads; nullopt if the cooker refuses, with why on stderr.
std::optional<Model> cook_model(const std::string& path);
// palette: entries of a mesh; primitives with more are split.
std::optional<Model> cook_model(cook::RawScene scene, std::size_t palette = 341);

}  // namespace marrow::test
