// What animations need of `extras`, which no other stage looks at.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cook/gltf/document/json.h"

namespace marrow::cook::gltf {

// Names of morph targets as exporters write them, mesh.extras.targetNames; one list a mesh, empty where there is none.
std::vector<std::vector<std::string>> read_target_names(const Json& root);

// A number in `extras` that an animation drives by KHR_animation_pointer.
struct UserNumber {
  std::string pointer;  // as in the file
  std::string name;     // "OWNER.property", "OWNER.list[2]"; without an owner where that is the asset or the document
  float rest = 0;
};

// By numbers of animation and channel. Taken are pointers to a number at any depth in the extras of the document, of
// the asset, or of an element of a root collection such as /nodes/3. `root` has been through check_schema().
using UserNumbers = std::map<std::pair<std::size_t, std::size_t>, UserNumber>;
UserNumbers find_user_numbers(const Json& root);

}  // namespace marrow::cook::gltf
