// The models that the whole road is tried on.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/places.h"

namespace marrow::test {

inline std::filesystem::path assets() {
  return assets_folder();
}

// The manifest's models that take part, then the sample and the golden sources.
inline std::vector<std::string> models() {
  std::vector<std::string> out;
  std::ifstream manifest(assets() / "manifest.json");
  if (manifest) {
    const nlohmann::json json = nlohmann::json::parse(manifest);
    for (const auto& asset : json.at("assets")) {
      const std::string model = (assets() / asset.at("file").get<std::string>()).string();
      if (takes_part(model)) out.push_back(model);
    }
  }
  out.push_back(newt_glb());
  for (const char* name : {"tiny.gltf", "dance.gltf", "face.gltf"}) out.push_back(in_golden(name));
  return out;
}

}  // namespace marrow::test
