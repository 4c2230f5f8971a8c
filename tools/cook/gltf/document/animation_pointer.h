// What animations drive: transforms and weights of nodes, and by KHR_animation_pointer numbers in `extras`.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"

namespace marrow::cook::gltf {

// Rewrites channels that point at /nodes/3/translation, rotation, scale or weights as channels of that node, as
// glTF 2.0 has them. `root` has been through check_schema().
void aim_at_nodes(Json& root);

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

// Channels that drive neither of these get an empty path, with a warning. Needs both steps above.
void drop_idle_channels(Json& root, const UserNumbers& user_numbers, Report& report);

}  // namespace marrow::cook::gltf
