// What `marrow view` opens: a cooked file, or a glTF file that is cooked in memory first.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "behave/open_character.h"
#include "render/images.h"

namespace marrow::tools {

// Names of joints, by the names of the meshes that have them in their skins.
using SkinJoints = std::map<std::string, std::set<std::string>>;

struct Source : OpenedCharacter {
  std::string path;
  ImagePlaces images;
  SkinJoints skins;  // of what was cooked here
};

// How a model is opened.
struct SourceOptions {
  std::string images_from = {};  // as places_of_cooked() takes it
  bool takes_roots = false;      // as CookHere has it
};
// As open_character().
Source open_source(const std::string& path, const SourceOptions& options = {});

}  // namespace marrow::tools
