#include "commands/demo/prop.h"

#include <utility>

#include "common/check_status.h"
#include "disk/cook_on_disk.h"

namespace marrow::tools {
namespace {

cook::CookOptions raw() {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  return options;
}

}  // namespace

cook::RawScene prop_scene(cook::RawPrimitive primitive, const glm::vec3& colour, const glm::vec3& glow) {
  primitive.pointer = "/meshes/0/primitives/0";
  primitive.material = 0;
  cook::RawScene scene;
  scene.source = "prop";
  scene.nodes.emplace_back().name = "prop";
  cook::RawMaterial& material = scene.materials.emplace_back();
  material.base_colour = glm::vec4(colour, 1);
  material.emissive = glow;
  scene.meshes.push_back({"prop", {}, {std::move(primitive)}});
  cook::RawInstance& instance = scene.instances.emplace_back();
  instance.node = instance.mesh = 0;
  return scene;
}

Prop::Prop(const Gl& gl, gles3::ProgramSet& programs, const cook::RawScene& scene)
    : bytes_(cook::cook_scene(scene, raw()).file) {
  check(load({bytes_.data(), bytes_.size()}, file_));
  figure_ = std::make_unique<Figure>(gl, programs, file_);
  posed_ = skin_all(file_, Character(file_), Deformer::ssd);
}

std::vector<Drawable> Prop::drawables_at(const glm::vec3& place) {
  moved_ = posed_;
  for (PosedMesh& mesh : moved_)
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] += place[static_cast<int>(i % 3)];
  return figure_->from_cpu(moved_);
}

}  // namespace marrow::tools
