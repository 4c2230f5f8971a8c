// Hands a checked document to tinygltf, which turns it into typed structures.
#include "cook/gltf/document/model.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <set>
#include <string_view>

namespace marrow::cook::gltf {
namespace {

// Moves the named members of `from` into a new object.
Json keep(Json& from, std::initializer_list<const char*> names) {
  Json kept = Json::object();
  for (const char* name : names) {
    if (const auto member = from.find(name); member != from.end()) kept[name] = std::move(*member);
  }
  return kept;
}

template <class Transform>
Json map_items(Json& root, const char* collection, Transform transform) {
  Json items = Json::array();
  const auto list = root.find(collection);
  if (list == root.end()) return items;
  for (std::size_t i = 0; i < list->size(); ++i) items.push_back(transform((*list)[i], i));
  return items;
}

Json keep_primitive(Json& primitive) {
  Json extensions = Json::object();
  if (const auto all = primitive.find("extensions"); all != primitive.end()) {
    extensions = keep(*all, {"KHR_draco_mesh_compression"});
    for (Json& extension : extensions) extension = keep(extension, {"bufferView", "attributes"});
  }
  Json kept = keep(primitive, {"attributes", "indices", "material", "mode", "targets"});
  kept["extensions"] = std::move(extensions);
  return kept;
}

Json keep_mesh(Json& mesh, std::size_t) {
  Json kept = keep(mesh, {"name", "weights", "primitives"});
  for (Json& primitive : kept.at("primitives")) primitive = keep_primitive(primitive);
  return kept;
}

bool is_animated(const Json& channel, const std::string& where, Report& report) {
  static const std::set<std::string, std::less<>> kPaths = {"translation", "rotation", "scale", "weights"};
  const Json& target = channel.at("target");
  const auto& path = target.at("path").get_ref<const std::string&>();
  if (path == "pointer") {
    const std::string* const to = pointer_of(channel);
    if (to != nullptr && to->ends_with("/extensions/KHR_node_visibility/visible")) {
      report.warn(under(where, "target", "path"), "visibility-not-animated",
                  *to + ": a node stays as it rests, shown or hidden; left out");
      return false;
    }
    report.warn(under(where, "target", "path"), "channel-dropped",
                (to == nullptr ? "it points nowhere" : "it points at " + *to) +
                    ": neither a node's transform or weights, nor a number in extras; left out");
    return false;
  }
  if (!kPaths.contains(path)) {
    report.warn(under(where, "target", "path"), "channel-dropped", "nothing that Marrow animates; left out");
    return false;
  }
  if (!target.contains("node")) {
    report.warn(under(where, "target"), "channel-dropped", "it names no node; left out");
    return false;
  }
  return true;
}

Json keep_animation(Json& animation, std::size_t index, const UserNumbers& user_numbers, Report& report) {
  Json kept = keep(animation, {"name"});
  Json channels = Json::array();
  for (std::size_t i = 0; i < animation.at("channels").size(); ++i) {
    Json& channel = animation.at("channels")[i];
    if (user_numbers.contains({index, i})) {
      channels.push_back({{"sampler", channel.at("sampler")}, {"target", {{"node", 0}, {"path", "pointer"}}}});
      continue;
    }
    if (!is_animated(channel, pointer("animations", index, "channels", i), report)) {
      channels.push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", ""}}}});  // keeps the numbering
      continue;
    }
    Json slim = keep(channel, {"sampler"});
    slim["target"] = keep(channel.at("target"), {"node", "path"});
    channels.push_back(std::move(slim));
  }
  kept["channels"] = std::move(channels);
  kept["samplers"] = Json::array();
  for (Json& sampler : animation.at("samplers")) {
    kept["samplers"].push_back(keep(sampler, {"input", "output", "interpolation"}));
  }
  return kept;
}

// tinygltf insists that a primitive's indices exist and have a bufferView, which glTF does not. Layouts live in our own
// table, so the accessors that it looks at become stand-ins of the right number that satisfy it.
Json accessor_stand_ins(const Json& meshes) {
  std::size_t count = 0;
  for (const Json& mesh : meshes) {
    for (const Json& primitive : mesh.at("primitives")) {
      const auto indices = primitive.find("indices");
      if (indices != primitive.end()) count = std::max(count, indices->get<std::size_t>() + 1);
    }
  }
  return Json::array_t(count, {{"bufferView", 0}, {"componentType", 5121}, {"count", 1}, {"type", "SCALAR"}});
}

Json slim_document(Json& root, const UserNumbers& user_numbers, Report& report) {
  Json slim = Json::object();
  slim["asset"] = {{"version", "2.0"}};
  slim["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", 1}}});
  slim["meshes"] = map_items(root, "meshes", keep_mesh);
  slim["accessors"] = accessor_stand_ins(slim["meshes"]);
  slim["nodes"] = map_items(root, "nodes", [&](Json& node, std::size_t index) {
    // Looked at here because tinygltf keeps only the matrix.
    const bool has_trs = node.contains("translation") || node.contains("rotation") || node.contains("scale");
    if (has_trs && node.contains("matrix")) {
      report.invalid(pointer("nodes", index, "matrix"), "both matrix and TRS", "give one of them; export again");
    }
    return keep(node, {"name", "children", "mesh", "skin", "matrix", "translation", "rotation", "scale", "weights"});
  });
  slim["skins"] = map_items(root, "skins", [](Json& skin, std::size_t) {
    return keep(skin, {"name", "joints", "skeleton", "inverseBindMatrices"});
  });
  slim["scenes"] = map_items(root, "scenes", [](Json& scene, std::size_t) { return keep(scene, {"name", "nodes"}); });
  slim["animations"] = map_items(root, "animations", [&](Json& animation, std::size_t index) {
    return keep_animation(animation, index, user_numbers, report);
  });
  if (root.contains("scene")) slim["scene"] = std::move(root.at("scene"));
  return slim;
}

}  // namespace

std::size_t target_count(const tinygltf::Mesh& mesh) {
  return mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
}

tinygltf::Model parse_model(Json root, const UserNumbers& user_numbers, Report& report) {
  std::string text = slim_document(root, user_numbers, report).dump();
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
  return model;
}

}  // namespace marrow::cook::gltf
