// What `marrow view` opens: a cooked file, or a glTF file that is cooked in memory first.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "render/images.h"

namespace marrow::tools {

// Names of joints, by the names of the meshes that have them in their skins.
using SkinJoints = std::map<std::string, std::set<std::string>>;

struct Source {
  std::string path;
  LoadedFile loaded;
  ImagePlaces images;
  std::vector<std::string> reads;  // what it was made from, itself first
  bool cooked_here = false;
  std::string settings;      // the marrow.toml that it was cooked by; empty: none
  std::size_t warnings = 0;  // of cooking
  SkinJoints skins;          // of what was cooked here
};

// A glTF file is cooked as `marrow cook PATH` would: with the settings of the nearest marrow.toml, else with the
// defaults. images_from: as places_of_cooked() takes it. Throws Failure: what loading and cooking throw; usage if the
// settings make it a clip pack. Cost: of cooking, seconds for a large file.
Source open_source(const std::string& path, const std::string& images_from);

}  // namespace marrow::tools
