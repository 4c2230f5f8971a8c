// Hands a checked document to tinygltf, which turns it into typed structures.
#include "cook/gltf/document/model.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace marrow::cook::gltf {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";

template <class Edit>
void edit_each(Json& owner, const char* list, Edit edit) {
  if (const auto items = owner.find(list); items != owner.end())
    for (Json& item : *items) edit(item);
}

void drop_extensions_and_extras(Json& object) {
  object.erase("extensions");
  object.erase("extras");
}

// Draco's alone is read of the model, and of it these two.
void keep_draco(Json& primitive) {
  Json kept = Json::object();
  const auto all = primitive.find("extensions");
  if (all == primitive.end()) return;
  if (const auto draco = all->find(kDraco); draco != all->end())
    kept[kDraco] = {{"bufferView", draco->at("bufferView")}, {"attributes", std::move(draco->at("attributes"))}};
  *all = std::move(kept);
}

// What tinygltf, of version 2.7, would do wrongly with a document that is right, and what keeps it from that. Gives the
// indices of all primitives in the document's order; kNone without.
std::vector<int> mend_for_tinygltf(Json& root) {
  // It reads buffers and images itself, wherever a URI leads; it refuses some legal accessors, and cameras that nobody
  // looks at. It would keep materials twice. Document has all of these that are carried.
  for (const char* name :
       {"accessors", "buffers", "bufferViews", "cameras", "images", "materials", "samplers", "textures"})
    root.erase(name);
  // It keeps every number of an extension or of extras in 152 bytes, and an animation's once more with each sampler.
  drop_extensions_and_extras(root);
  drop_extensions_and_extras(root.at("asset"));
  for (const char* list : {"animations", "meshes", "nodes", "scenes", "skins"})
    edit_each(root, list, drop_extensions_and_extras);
  std::vector<int> indices;
  edit_each(root, "meshes", [&](Json& mesh) {
    edit_each(mesh, "primitives", [&](Json& primitive) {
      primitive.erase("extras");
      keep_draco(primitive);
      // It refuses indices whose accessor has no bufferView, as those of Draco data have none.
      indices.push_back(primitive.value("indices", kNone));
      primitive.erase("indices");
    });
  });
  edit_each(root, "animations", [](Json& animation) {
    edit_each(animation, "samplers", drop_extensions_and_extras);
    edit_each(animation, "channels", [](Json& channel) {
      drop_extensions_and_extras(channel);
      drop_extensions_and_extras(channel.at("target"));
      // It leaves out a channel that names no node, and all behind it would get other numbers.
      channel.at("target").emplace("node", kNone);
      // It cuts numbers to 32 bits, which would make a sampler of 2^32 the first.
      Json& sampler = channel.at("sampler");
      sampler = std::min(sampler.get<std::int64_t>(), std::int64_t{std::numeric_limits<int>::max()});
    });
  });
  return indices;
}

}  // namespace

std::size_t target_count(const tinygltf::Mesh& mesh) {
  return mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
}

tinygltf::Model parse_model(Json root, Report& report) {
  const std::vector<int> indices = mend_for_tinygltf(root);
  std::string text = root.dump();
  root = nullptr;  // the tree is several times the text's size
  if (text.size() > std::numeric_limits<unsigned>::max()) {
    report.unsupported("@0", "JSON too large", "split the scene; 4 GiB is the limit");
  }
  tinygltf::Model model;
  tinygltf::TinyGLTF parser;
  std::string error;
  std::string warning;
  const auto length = static_cast<unsigned>(text.size());
  if (!parser.LoadASCIIFromString(&model, &error, &warning, text.c_str(), length, std::string())) {
    report.invalid("@0", "not understood", "tinygltf says: " + error);
  }
  auto next = indices.begin();
  for (tinygltf::Mesh& mesh : model.meshes)
    for (tinygltf::Primitive& primitive : mesh.primitives) primitive.indices = *next++;
  return model;
}

}  // namespace marrow::cook::gltf
