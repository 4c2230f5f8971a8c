// The models that the whole road is tried on.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace marrow::test {

inline std::filesystem::path assets() {
  const char* const given = std::getenv("MARROW_ASSETS");
  return given != nullptr ? std::filesystem::path(given) : std::filesystem::path(MARROW_DEFAULT_ASSETS);
}

// The manifest's models, then the embedded sample; only what exists, so that its absence is one test's failure or skip.
inline std::vector<std::string> models() {
  std::vector<std::string> out;
  std::ifstream manifest(assets() / "manifest.json");
  if (manifest) {
    const nlohmann::json json = nlohmann::json::parse(manifest);
    for (const auto& asset : json.at("assets"))
      out.push_back((assets() / asset.at("file").get<std::string>()).string());
  }
  const std::filesystem::path sample = std::filesystem::path(MARROW_SOURCE_DIR) / "tools/sample/newt.glb";
  if (std::filesystem::exists(sample)) out.push_back(sample.string());
  for (const char* name : {"tiny.gltf", "dance.gltf", "face.gltf"})
    out.push_back((std::filesystem::path(MARROW_SOURCE_DIR) / "tests/golden" / name).string());
  return out;
}

}  // namespace marrow::test
