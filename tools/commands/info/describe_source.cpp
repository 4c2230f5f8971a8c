// What a source file spends its bytes on, from its accessors alone: nothing is decoded.
#include <cstring>
#include <set>
#include <string_view>

#include "commands/info/describe.h"
#include "common/failure.h"
#include "disk/files.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

struct SourceText {
  std::string json;
  std::size_t file_bytes = 0;
};

SourceText read_text(const std::string& path) {
  const AlignedBytes bytes = read_file(path);
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!all.starts_with("glTF")) return {std::string(all), all.size()};
  std::uint32_t length = 0;
  if (all.size() >= 20) std::memcpy(&length, all.data() + 12, 4);
  if (length > all.size() - std::min<std::size_t>(all.size(), 20))
    throw Failure(Exit::invalid, path, "@12", "the JSON chunk reaches past the end", "give a whole .glb file");
  return {std::string(all.substr(20, length)), all.size()};
}

// Sizes by what they are for; each accessor and view once, for whoever asks first.
class Counter {
 public:
  explicit Counter(const ordered_json& json) : json_(json) {}

  std::size_t accessor(const ordered_json& index) {
    const ordered_json* const a = element("accessors", index);
    if (a == nullptr || !seen_.insert({0, index.get<std::size_t>()}).second) return 0;
    const std::string type = a->value("type", "");
    const std::size_t parts = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    const int component = a->value("componentType", 0);
    const std::size_t size = component <= 5121 ? 1 : component <= 5123 ? 2 : 4;
    return a->contains("bufferView") ? a->value("count", std::size_t{0}) * parts * size : 0;
  }
  std::size_t view(const ordered_json& index) {
    const ordered_json* const v = element("bufferViews", index);
    return v != nullptr && seen_.insert({1, index.get<std::size_t>()}).second ? v->value("byteLength", std::size_t{0})
                                                                              : 0;
  }
  std::size_t primitive(const ordered_json& p) {
    const auto draco = ordered_json::json_pointer("/extensions/KHR_draco_mesh_compression/bufferView");
    if (p.contains(draco)) return view(p.at(draco));
    std::size_t sum = p.contains("indices") ? accessor(p.at("indices")) : 0;
    for (const auto& index : p.value("attributes", ordered_json::object())) sum += accessor(index);
    for (const auto& target : p.value("targets", ordered_json::array()))
      for (const auto& index : target) sum += accessor(index);
    return sum;
  }
  const ordered_json& list(const char* name) const {
    static const ordered_json none = ordered_json::array();
    const auto found = json_.find(name);
    return found != json_.end() && found->is_array() ? *found : none;
  }

 private:
  const ordered_json* element(const char* name, const ordered_json& index) const {
    const ordered_json& elements = list(name);
    if (!index.is_number_unsigned() || index.get<std::size_t>() >= elements.size()) return nullptr;
    return &elements[index.get<std::size_t>()];
  }
  const ordered_json& json_;
  std::set<std::pair<int, std::size_t>> seen_;
};

std::size_t add_bytes(ordered_json& by_name, const ordered_json& element, std::size_t bytes) {
  ordered_json& sum = by_name[element.value("name", "")];
  sum = (sum.is_null() ? 0 : sum.get<std::size_t>()) + bytes;
  return bytes;
}

ordered_json count(const ordered_json& json) {
  Counter counter(json);
  ordered_json meshes = ordered_json::object(), clips = ordered_json::object();
  std::size_t geometry = 0, skeletons = 0, animation = 0, images = 0;
  for (const auto& mesh : counter.list("meshes")) {
    std::size_t bytes = 0;
    for (const auto& p : mesh.at("primitives")) bytes += counter.primitive(p);
    geometry += add_bytes(meshes, mesh, bytes);
  }
  for (const auto& skin : counter.list("skins"))
    skeletons += counter.accessor(skin.value("inverseBindMatrices", ordered_json()));
  for (const auto& clip : counter.list("animations")) {
    std::size_t bytes = 0;
    for (const auto& s : clip.at("samplers"))
      bytes += counter.accessor(s.at("input")) + counter.accessor(s.at("output"));
    animation += add_bytes(clips, clip, bytes);
  }
  for (const auto& image : counter.list("images")) images += counter.view(image.value("bufferView", ordered_json()));
  return {{"geometry", geometry}, {"skeletons", skeletons}, {"clips", animation},
          {"images", images},     {"mesh_bytes", meshes},   {"clip_bytes", clips}};
}

}  // namespace

ordered_json describe_source(const std::string& path) {
  const SourceText text = read_text(path);
  try {
    const ordered_json json = ordered_json::parse(text.json);
    ordered_json out = count(json);
    out["names_and_structure"] = text.json.size();
    out["bytes"] = text.file_bytes;
    out["file"] = path;
    return out;
  } catch (const nlohmann::json::exception&) {
    throw Failure(Exit::invalid, path, "", "not a glTF file", "give the .gltf or .glb file that was cooked");
  }
}

}  // namespace marrow::tools
