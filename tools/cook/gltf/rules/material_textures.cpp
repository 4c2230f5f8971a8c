#include "cook/gltf/rules/material_textures.h"

#include "common/elementary.h"

namespace marrow::cook::gltf {

glm::vec2 UvMapping::apply(glm::vec2 uv) const {
  const double u = scale[0] * static_cast<double>(uv.x), v = scale[1] * static_cast<double>(uv.y);
  const double c = tools::cosine(rotation), s = tools::sine(rotation);
  return {static_cast<float>(c * u + s * v + offset[0]), static_cast<float>(c * v - s * u + offset[1])};
}

const Json& below(const Json& object, const char* name) {
  static const Json kNothing = Json::object();
  const auto member = object.find(name);
  return member == object.end() ? kNothing : *member;
}

UvMapping read_uv_mapping(const Json& info) {
  UvMapping mapping;
  mapping.set = info.value("texCoord", std::size_t{0});
  const auto extensions = info.find("extensions");
  if (extensions == info.end()) return mapping;
  const auto transform = extensions->find("KHR_texture_transform");
  if (transform == extensions->end()) return mapping;
  mapping.set = transform->value("texCoord", mapping.set);
  mapping.rotation = transform->value("rotation", 0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    if (transform->contains("offset")) mapping.offset[i] = transform->at("offset")[i].get<double>();
    if (transform->contains("scale")) mapping.scale[i] = transform->at("scale")[i].get<double>();
  }
  return mapping;
}

}  // namespace marrow::cook::gltf
