// Materials with their textures, and nodes that were kept for the game.
#pragma once

#include "export/export_parts.h"

namespace marrow::tools {

// Adds what a mesh's material has beyond name, colour and sides: alpha and textures, whose images and samplers are
// added to the document once. A texture whose image is known by its name alone is left out, with a warning.
class Looks {
 public:
  explicit Looks(ExportScene& scene) : scene_(scene) {}
  void add_to(Json& material, const Mesh& mesh);

 private:
  std::size_t once(const char* list, const Json& element);
  bool add_texture(const Texture& texture, Json& out);
  // Its index in the document; none if it is known by its name alone.
  std::optional<std::size_t> add_image(std::uint32_t index);
  void add_light(Json& material, const Material& m);
  ExportScene& scene_;
  std::map<std::string, std::size_t> known_;
  std::map<std::uint32_t, std::size_t> images_;
  std::map<std::uint32_t, bool> warned_;
};

// Kept nodes below their joints; of one that is a joint itself the properties go to the joint's node.
void export_nodes(ExportScene& scene);

}  // namespace marrow::tools
