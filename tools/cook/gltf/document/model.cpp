// Says what animations drive, and hands a checked document to tinygltf, which turns it into typed structures.
#include "cook/gltf/document/model.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace marrow::cook::gltf {
namespace {

// The steps of a JSON pointer, unescaped as RFC 6901 says; nullopt if it is none.
std::optional<std::vector<std::string>> split_pointer(std::string_view pointer) {
  if (pointer.empty() || pointer.front() != '/') return std::nullopt;
  std::vector<std::string> steps;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      steps.emplace_back();
    } else if (pointer[i] != '~') {
      steps.back() += pointer[i];
    } else if (++i < pointer.size() && (pointer[i] == '0' || pointer[i] == '1')) {
      steps.back() += pointer[i] == '0' ? '~' : '/';
    } else {
      return std::nullopt;
    }
  }
  return steps;
}

// The member or element of `value`; null if there is none.
const Json* step_into(const Json& value, const std::string& step) {
  if (value.is_object()) {
    const auto member = value.find(step);
    return member == value.end() ? nullptr : &*member;
  }
  std::size_t index = 0;
  const char* const end = step.data() + step.size();
  const auto [stop, error] = std::from_chars(step.data(), end, index);
  const bool plain = error == std::errc() && stop == end && (step.size() == 1 || step.front() != '0');
  return value.is_array() && plain && index < value.size() ? &value[index] : nullptr;
}

// How many steps lead to the owner of the extras; nullopt if they lead elsewhere.
std::optional<std::size_t> owner_steps(const Json& root, const std::vector<std::string>& steps) {
  if (steps.size() > 1 && steps[0] == "extras") return 0;
  if (steps.size() > 2 && steps[0] == "asset" && steps[1] == "extras") return 1;
  if (steps.size() <= 3 || steps[2] != "extras") return std::nullopt;
  const Json* const collection = step_into(root, steps[0]);
  if (collection == nullptr || !collection->is_array()) return std::nullopt;
  return 2;
}

bool is_animated_property(std::string_view name) {
  return name == "translation" || name == "rotation" || name == "scale" || name == "weights";
}

std::string owner_name(const Json& owner, const std::vector<std::string>& steps, std::size_t count) {
  if (count < 2) return {};
  const auto name = owner.is_object() ? owner.find("name") : owner.end();
  const bool named = name != owner.end() && name->is_string() && !name->get_ref<const std::string&>().empty();
  return named ? name->get<std::string>() : steps[0] + '[' + steps[1] + ']';
}

std::optional<UserNumber> resolve(const Json& root, const std::string& pointer) {
  const auto steps = split_pointer(pointer);
  const auto owner = steps ? owner_steps(root, *steps) : std::nullopt;
  if (!owner) return std::nullopt;
  UserNumber out;
  out.pointer = pointer;
  const Json* at = &root;
  for (std::size_t i = 0; i < steps->size(); ++i) {
    if (i == *owner) out.name = owner_name(*at, *steps, i);
    const bool in_list = at->is_array();
    at = step_into(*at, (*steps)[i]);
    if (at == nullptr) return std::nullopt;
    if (i <= *owner) continue;
    out.name += in_list ? '[' + (*steps)[i] + ']' : (out.name.empty() ? "" : ".") + (*steps)[i];
  }
  if (!at->is_number()) return std::nullopt;
  out.rest = static_cast<float>(at->get<double>());
  return std::isfinite(out.rest) ? std::optional(out) : std::nullopt;
}

// Where a channel points to; null if it does not.
const std::string* pointer_of(const Json& channel) {
  const Json& target = channel.at("target");
  if (target.at("path") != "pointer") return nullptr;
  const auto extensions = target.find("extensions");
  if (extensions == target.end()) return nullptr;
  const auto extension = extensions->find("KHR_animation_pointer");
  return extension == extensions->end() ? nullptr : &extension->at("pointer").get_ref<const std::string&>();
}

bool is_animated(const Json& channel, const std::string& where, Report& report) {
  const Json& target = channel.at("target");
  const auto& path = target.at("path").get_ref<const std::string&>();
  const auto leave_out = [&](const std::string& at, const char* rule, const std::string& why) {
    report.warn(at, rule, why);
    return false;
  };
  if (path == "pointer") {
    const std::string* const to = pointer_of(channel);
    if (to != nullptr && to->ends_with("/extensions/KHR_node_visibility/visible"))
      return leave_out(under(where, "target", "path"), "visibility-not-animated",
                       *to + ": a node stays as it rests, shown or hidden; left out");
    return leave_out(under(where, "target", "path"), "channel-dropped",
                     (to == nullptr ? "it points nowhere" : "it points at " + *to) +
                         ": neither a node's transform or weights, nor a number in extras; left out");
  }
  if (!is_animated_property(path))
    return leave_out(under(where, "target", "path"), "channel-dropped", "nothing that Marrow animates; left out");
  if (!target.contains("node"))
    return leave_out(under(where, "target"), "channel-dropped", "it names no node; left out");
  return true;
}

// Whether a channel pointed at a property of a node; it has that for its target now.
bool aim_at_node(const Json& root, const std::string& to, Json& channel) {
  const auto steps = split_pointer(to);
  if (!steps || steps->size() != 3 || (*steps)[0] != "nodes" || !is_animated_property((*steps)[2])) return false;
  const Json* const nodes = step_into(root, "nodes");
  const Json* const node = nodes == nullptr ? nullptr : step_into(*nodes, (*steps)[1]);
  if (node == nullptr) return false;
  channel["target"] = {{"node", node - &nodes->front()}, {"path", (*steps)[2]}};
  return true;
}

}  // namespace

UserNumbers aim_channels(Json& root, Report& report) {
  UserNumbers out;
  const auto animations = root.find("animations");
  if (animations == root.end()) return out;
  for (std::size_t a = 0; a < animations->size(); ++a) {
    Json& channels = (*animations)[a].at("channels");
    for (std::size_t c = 0; c < channels.size(); ++c) {
      Json& channel = channels[c];
      const std::string* const to = pointer_of(channel);
      if (to != nullptr && aim_at_node(root, *to, channel)) continue;
      std::optional<UserNumber> number = to == nullptr ? std::nullopt : resolve(root, *to);
      if (number)
        out.emplace(std::pair(a, c), std::move(*number));
      else if (!is_animated(channel, pointer("animations", a, "channels", c), report))
        channel.at("target").at("path") = "";
    }
  }
  return out;
}

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
  std::string text = root.dump();  // all that tinygltf takes
  root = nullptr;                  // the tree is several times the text's size
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
