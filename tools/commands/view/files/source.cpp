#include "commands/view/files/source.h"

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::tools {
namespace {

// Named as cooked meshes are.
SkinJoints skin_joints(const cook::RawScene& scene) {
  SkinJoints out;
  for (const cook::RawInstance& instance : scene.instances) {
    if (instance.skin == cook::kNone) continue;
    const std::string& own = scene.meshes[cook::to_index(instance.mesh)].name;
    std::set<std::string>& names = out[own.empty() ? scene.nodes[cook::to_index(instance.node)].name : own];
    for (const int joint : scene.skins[cook::to_index(instance.skin)].joints)
      names.insert(scene.nodes[cook::to_index(joint)].name);
  }
  return out;
}

}  // namespace

Source open_source(const std::string& path, const SourceOptions& options) {
  Source source;
  source.path = path;
  CookHere how;
  how.takes_roots = options.takes_roots;
  // A skeleton that is made takes the place of skins.
  how.look = [&](const cook::RawScene& scene, const cook::CookOptions& by) {
    if (by.prepare.auto_skeleton.empty()) source.skins = skin_joints(scene);
  };
  static_cast<OpenedCharacter&>(source) = open_character(path, how);
  source.images = source.cooked_here && options.images_from.empty() ? places_beside(path)
                                                                    : places_of_cooked(path, options.images_from);
  return source;
}

}  // namespace marrow::tools
