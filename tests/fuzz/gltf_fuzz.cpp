// Fuzzes the glTF reader: any bytes must end in a scene or in a located failure.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/failure.h"
#include "cook/gltf/read.h"

namespace {

// What the build stage relies on; a breach here is a bug of the reader even if nothing crashes.
void require(bool holds) {
  if (!holds) std::abort();
}

void check_primitive(const marrow::cook::RawPrimitive& primitive) {
  const std::size_t vertices = primitive.positions.size();
  const auto fits = [vertices](std::size_t size) { return size == 0 || size == vertices; };
  require(fits(primitive.normals.size()) && fits(primitive.tangents.size()) && fits(primitive.uvs.size()));
  require(fits(primitive.colours.size()) && fits(primitive.influences.size()));
  require(primitive.indices.size() % 3 == 0);
  for (const std::uint32_t index : primitive.indices) require(index < vertices);
}

void check_scene(const marrow::cook::RawScene& scene) {
  const auto node_exists = [&](int node) { return node >= 0 && static_cast<std::size_t>(node) < scene.nodes.size(); };
  for (const auto& node : scene.nodes) require(node.parent == marrow::cook::kNone || node_exists(node.parent));
  for (const auto& mesh : scene.meshes) {
    for (const auto& primitive : mesh.primitives) check_primitive(primitive);
  }
  for (const auto& mesh : scene.meshes) {
    for (const auto& primitive : mesh.primitives) {
      const int material = primitive.material;
      require(material >= marrow::cook::kNone && (material < 0 || std::size_t(material) < scene.materials.size()));
    }
  }
  for (const auto& material : scene.materials) {
    for (const auto& texture : material.textures) require(!scene.images.at(texture.image).name.empty());
  }
  for (const auto& skin : scene.skins) {
    require(skin.joints.size() == skin.inverse_bind.size());
    for (const int joint : skin.joints) require(node_exists(joint));
  }
  for (const auto& instance : scene.instances) {
    require(node_exists(instance.node));
    if (instance.skin == marrow::cook::kNone) continue;
    const std::size_t joints = scene.skins.at(static_cast<std::size_t>(instance.skin)).joints.size();
    for (const auto& primitive : scene.meshes.at(static_cast<std::size_t>(instance.mesh)).primitives) {
      for (const auto& vertex : primitive.influences) {
        for (const auto& influence : vertex) require(influence.joint < joints && influence.weight > 0);
      }
    }
  }
  for (const auto& clip : scene.clips) {
    for (const auto& scalar : clip.scalars) {
      const std::size_t per_key = scalar.interpolation == marrow::cook::RawInterpolation::cubic_spline ? 3 : 1;
      require(!scalar.times_s.empty() && scalar.values.size() == scalar.times_s.size() * per_key);
      for (std::size_t i = 1; i < scalar.times_s.size(); ++i) require(scalar.times_s[i - 1] < scalar.times_s[i]);
    }
    for (const auto& channel : clip.channels) {
      const std::size_t per_key = channel.interpolation == marrow::cook::RawInterpolation::cubic_spline ? 3 : 1;
      require(node_exists(channel.node) && !channel.times_s.empty());
      require(channel.values.size() == channel.times_s.size() * per_key);
      for (std::size_t i = 1; i < channel.times_s.size(); ++i) require(channel.times_s[i - 1] < channel.times_s[i]);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check_scene(marrow::cook::read_gltf("fuzz", std::as_bytes(std::span(data, size)), {.image_bytes = size % 2 == 0}));
  } catch (const marrow::tools::Failure& failure) {
    require(!failure.where().empty() && !failure.rule().empty());
  }
  return 0;
}
