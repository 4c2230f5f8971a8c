// Walks a document along the schema tables and refuses the first property that is not what glTF 2.0 says; decides
// whether its version and extensions can be cooked at all.
#include "cook/gltf/rules/schema.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

namespace marrow::cook::gltf {
namespace {

// More elements than this in one collection is an attack or a mistake, and would cost gigabytes before it is found out.
constexpr std::size_t kLongestCollection = 200'000;

// Where the walk is; turned into text only when there is something to say.
struct Path {
  const Path* up = nullptr;
  std::string_view key = {};
  std::size_t index = 0;
  bool is_index = false;

  Path step(std::string_view name) const { return {this, name, 0, false}; }
  Path step(std::size_t number) const { return {this, {}, number, true}; }

  std::string text() const {
    if (up == nullptr) return {};
    return is_index ? under(up->text(), index) : under(up->text(), key);
  }
};

std::string shown(double number) {
  std::string text = Json(number).dump();
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

class Walker {
 public:
  Walker(Json& root, Report& report) : root_(root), report_(report) {}

  void check_object(Json& value, const Schema& schema, const Path& path) {
    if (!value.is_object()) wrong_kind(path, "an object");
    for (auto member = value.begin(); member != value.end();) {
      if (is_idle(*member, member.key(), schema)) {
        report_.mend(path.step(member.key()).text(), "empty-array",
                     "left out; a list such as /nodes has elements or is not there");
        member = value.erase(member);
        continue;
      }
      check_member(member.key(), *member, schema, path);
      ++member;
    }
    for (const Property& property : schema.properties) {
      if (property.required && !value.contains(property.name)) {
        report_.invalid(path.step(property.name).text(), "missing", "glTF 2.0 demands this property");
      }
    }
  }

 private:
  // An empty list that says as little as none would: exporters write them, though glTF 2.0 has none.
  static bool is_idle(const Json& value, const std::string& name, const Schema& schema) {
    const auto known = std::ranges::find(schema.properties, name, &Property::name);
    return value.is_array() && value.empty() && known != schema.properties.end() && is_list(known->kind) &&
           known->shortest == 1 && !known->required;
  }

  static bool is_list(Kind kind) {
    return kind == Kind::texts || kind == Kind::numbers || kind == Kind::indices || kind == Kind::index_maps ||
           kind == Kind::objects;
  }

  void check_member(const std::string& name, Json& value, const Schema& schema, const Path& path) {
    const auto known = std::ranges::find(schema.properties, name, &Property::name);
    if (known != schema.properties.end()) {
      check_property(value, *known, path.step(name));
    } else if (name == "name") {
      if (!value.is_string()) wrong_kind(path.step(name), "a string");
    } else if (name != "extras" && name != "extensions" && !schema.open) {
      report_.warn(path.step(name).text(), "unknown-property", "not a property of glTF 2.0; ignored");
    }
  }

  void check_property(Json& value, const Property& property, const Path& path) {
    switch (property.kind) {
      case Kind::boolean:
        if (!value.is_boolean()) wrong_kind(path, "true or false");
        break;
      case Kind::text:
        check_text(value, property, path);
        break;
      case Kind::texts:
        check_texts(value, property, path);
        break;
      case Kind::integer:
        check_integer(value, property.min, property.max, path);
        break;
      case Kind::number:
        check_number(value, property, path);
        break;
      case Kind::index:
        check_index(value, property, path);
        break;
      case Kind::index_map:
        check_index_map(value, property, path);
        break;
      case Kind::object:
        check_object(value, *property.schema, path);
        break;
      case Kind::object_map:
        if (!value.is_object()) wrong_kind(path, "an object");
        for (const auto& member : value.items())
          check_object(member.value(), *property.schema, path.step(member.key()));
        break;
      case Kind::indices:
        check_indices(value, property, path);
        break;
      case Kind::numbers:
      case Kind::index_maps:
      case Kind::objects:
        check_items(value, property, path);
        break;
    }
  }

  void check_items(Json& value, const Property& property, const Path& path) {
    check_length(value, property, path);
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (property.kind == Kind::numbers) check_number(value[i], property, path.step(i));
      if (property.kind == Kind::index_maps) check_target(value[i], property, path.step(i));
      if (property.kind == Kind::objects) check_object(value[i], *property.schema, path.step(i));
    }
  }

  void check_length(const Json& value, const Property& property, const Path& path) {
    if (!value.is_array()) wrong_kind(path, "an array, as /nodes is");
    // An animation that moves nothing, a mesh that draws nothing.
    if (value.empty() && property.kind == Kind::objects && property.shortest == 1) {
      report_.mend(path.text(), "empty-array", "glTF 2.0 demands an element");
      return;
    }
    if (value.size() < property.shortest || value.size() > property.longest) {
      report_.invalid(path.text(), "wrong number of items",
                      "it has " + std::to_string(value.size()) + "; export again");
    }
    if (value.size() > kLongestCollection) {
      report_.unsupported(path.text(), "too many items",
                          "at most " + std::to_string(kLongestCollection) + " are read; split the scene");
    }
  }

  void check_text(const Json& value, const Property& property, const Path& path) {
    if (!value.is_string()) wrong_kind(path, "a string");
    if (property.of.empty()) return;
    const auto& text = value.get_ref<const std::string&>();
    const std::string words = ' ' + std::string(property.of) + ' ';
    if (text.empty() || words.find(' ' + text + ' ') == std::string::npos) {
      report_.invalid(path.text(), "unknown value", "use one of: " + std::string(property.of));
    }
  }

  void check_texts(const Json& value, const Property& property, const Path& path) {
    check_length(value, property, path);
    std::unordered_set<std::string> seen;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!value[i].is_string()) wrong_kind(path.step(i), "a string");
      if (!seen.insert(value[i].get<std::string>()).second) {
        report_.mend(path.step(i).text(), "duplicate-entry", "listed twice; the second is ignored");
      }
    }
  }

  void check_number(const Json& value, const Property& property, const Path& path) {
    if (!value.is_number()) wrong_kind(path, "a number");
    check_range(value.get<double>(), property.min, property.max, path);
  }

  void check_range(double number, double min, double max, const Path& path) {
    if (number >= min && number <= max) return;
    report_.invalid(path.text(), "out of range",
                    shown(number) + " is not between " + shown(min) + " and " + shown(max));
  }

  void check_integer(Json& value, double min, double max, const Path& path) {
    if (!value.is_number()) wrong_kind(path, "an integer");
    const double number = value.get<double>();
    check_range(number, min, max, path);
    if (value.is_number_integer()) return;
    if (number != std::floor(number)) wrong_kind(path, "an integer");
    value = static_cast<std::int64_t>(number);  // 1.0 is a legal spelling of 1
  }

  void check_index(Json& value, const Property& property, const Path& path) {
    if (property.of.empty()) return check_integer(value, 0, std::numeric_limits<std::int32_t>::max(), path);
    check_integer(value, -kLargestInteger, kLargestInteger, path);
    const auto collection = root_.find(property.of);
    const std::size_t size = collection == root_.end() || !collection->is_array() ? 0 : collection->size();
    const double number = value.get<double>();
    if (number < 0 || number >= static_cast<double>(size)) {
      report_.invalid(path.text(), "reference to nothing",
                      "there is no /" + std::string(property.of) + '/' + shown(number) + "; export again");
    }
  }

  void check_indices(Json& value, const Property& property, const Path& path) {
    check_length(value, property, path);
    std::unordered_set<std::int64_t> seen;
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_index(value[i], property, path.step(i));
      if (!seen.insert(value[i].get<std::int64_t>()).second) {
        report_.invalid(path.step(i).text(), "listed twice", "the elements must be distinct; export again");
      }
    }
  }

  void check_target(Json& value, const Property& property, const Path& path) {
    if (value.is_object() && value.empty())
      report_.mend(path.text(), "empty-target", "the morph target moves nothing; kept, so that its weight has a place");
    else
      check_index_map(value, property, path);
  }

  void check_index_map(Json& value, const Property& property, const Path& path) {
    if (!value.is_object()) wrong_kind(path, "an object");
    if (value.empty()) report_.invalid(path.text(), "empty object", "it needs a member; export again");
    for (auto member = value.begin(); member != value.end(); ++member) {
      check_index(*member, property, path.step(member.key()));
    }
  }

  [[noreturn]] void wrong_kind(const Path& path, const std::string& expected) {
    report_.invalid(path.up == nullptr ? "@0" : path.text(), "wrong type", "it must be " + expected);
  }

  Json& root_;
  Report& report_;
};

}  // namespace

void check_schema(Json& root, Report& report) {
  if (!root.contains("scenes")) report.mend_nothing("as the file has no scene; give it one or export again");
  Walker(root, report).check_object(root, kRootSchema, Path{});
}

namespace {

// Read in full.
constexpr std::array<std::string_view, 18> kRead = {"KHR_mesh_quantization",
                                                    "KHR_draco_mesh_compression",
                                                    "EXT_meshopt_compression",
                                                    "KHR_meshopt_compression",
                                                    "KHR_texture_transform",
                                                    "KHR_animation_pointer",  // what it leaves out it says
                                                    "KHR_texture_basisu",
                                                    "EXT_texture_webp",
                                                    "MSFT_texture_dds",
                                                    "KHR_materials_unlit",
                                                    "KHR_materials_emissive_strength",
                                                    "KHR_materials_pbrSpecularGlossiness",
                                                    "VRM",
                                                    "VRMC_vrm",
                                                    "VRMC_springBone",
                                                    "VRMC_node_constraint",  // says that it is left out
                                                    "KHR_node_visibility",
                                                    "MSFT_lod"};  // says which levels are left out

// Change looks, lights or names but no vertex and no joint, so a file that demands them is still worth cooking.
constexpr std::array<std::string_view, 22> kHarmless = {"KHR_materials_anisotropy",
                                                        "KHR_materials_clearcoat",
                                                        "KHR_materials_diffuse_transmission",
                                                        "KHR_materials_dispersion",
                                                        "KHR_materials_ior",
                                                        "KHR_materials_iridescence",
                                                        "KHR_materials_sheen",
                                                        "KHR_materials_specular",
                                                        "KHR_materials_transmission",
                                                        "KHR_materials_variants",
                                                        "KHR_materials_volume",
                                                        "KHR_lights_punctual",
                                                        "KHR_xmp_json_ld",
                                                        "KHR_xmp",
                                                        "KHR_node_hoverability",
                                                        "KHR_node_selectability",
                                                        "EXT_lights_image_based",
                                                        "FB_ngon_encoding",
                                                        "EXT_texture_avif",
                                                        "VRMC_materials_mtoon",
                                                        "VRMC_materials_hdr_emissiveMultiplier",
                                                        "VRMC_springBone_extended_collider"};

struct Version {
  int major = 0;
  int minor = 0;
};

std::optional<Version> parse_version(const std::string& text) {
  Version version;
  const char* end = text.data() + text.size();
  const auto [dot, major_error] = std::from_chars(text.data(), end, version.major);
  if (major_error != std::errc() || dot == end || *dot != '.' || version.major < 0) return std::nullopt;
  const auto [rest, minor_error] = std::from_chars(dot + 1, end, version.minor);
  if (minor_error != std::errc() || rest != end || version.minor < 0) return std::nullopt;
  return version;
}

Version checked_version(const Json& asset, const char* name, Report& report) {
  const std::string where = pointer("asset", name);
  const auto version = parse_version(asset.at(name).get_ref<const std::string&>());
  if (!version) report.invalid(where, "not a version", "it must be like \"2.0\"");
  return *version;
}

void check_version(const Json& asset, Report& report) {
  const Version version = checked_version(asset, "version", report);
  if (version.minor != 0) {
    report.warn("/asset/version", "newer-minor-version", "read as glTF 2.0, which later 2.x versions extend");
  }
  if (!asset.contains("minVersion")) return;
  const Version least = checked_version(asset, "minVersion", report);
  if (least.major != 2 || least.minor > version.minor) {
    report.invalid("/asset/minVersion", "greater than version", "export as glTF 2.0");
  }
}

bool lists(const Json& root, const char* list, std::string_view extension) {
  const auto found = root.find(list);
  return found != root.end() && std::find(found->begin(), found->end(), extension) != found->end();
}

void check_required(const Json& root, Report& report) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) return;
  for (std::size_t i = 0; i < required->size(); ++i) {
    const std::string& name = (*required)[i].get_ref<const std::string&>();
    const std::string where = pointer("extensionsRequired", i);
    if (!lists(root, "extensionsUsed", name)) {
      report.mend(where, "extension-not-used", name + " is required but not listed in extensionsUsed");
    }
    if (std::ranges::find(kRead, name) != kRead.end()) continue;
    if (std::ranges::find(kHarmless, name) == kHarmless.end()) {
      report.unsupported(where, "needs the extension " + name, "export without it");
    }
    report.warn(where, "extension-ignored", name + " changes no geometry and is left out");
  }
}

void warn_of_unknown(const Json& root, Report& report) {
  const auto used = root.find("extensionsUsed");
  if (used == root.end()) return;
  for (std::size_t i = 0; i < used->size(); ++i) {
    const std::string& name = (*used)[i].get_ref<const std::string&>();
    if (std::ranges::find(kRead, name) != kRead.end() || lists(root, "extensionsRequired", name)) continue;
    report.warn(pointer("extensionsUsed", i), "extension-ignored", name + " is optional and left out");
  }
}

// Everywhere but in `extras`, whose content is the application's own.
void check_extension_objects(const Json& value, const Path& path, const Json& root, Report& report) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (value[i].is_structured()) check_extension_objects(value[i], path.step(i), root, report);
    }
    return;
  }
  for (auto member = value.begin(); member != value.end(); ++member) {
    const bool is_extensions = member.key() == "extensions";
    if (member.key() == "extras" || (!member->is_structured() && !is_extensions)) continue;
    const Path here = path.step(member.key());
    if (is_extensions) {
      if (!member->is_object()) report.invalid(here.text(), "wrong type", "it must be an object");
      for (const auto& [name, extension] : member->items()) {
        if (!extension.is_object()) report.invalid(here.step(name).text(), "wrong type", "it must be an object");
        if (lists(root, "extensionsUsed", name)) continue;
        report.mend(here.step(name).text(), "undeclared-extension", name + " is not listed in extensionsUsed");
      }
    }
    check_extension_objects(*member, here, root, report);
  }
}

// glTF 1.0 need not say its version, and keeps meshes and nodes by name.
bool looks_like_1(const Json& root) {
  return std::ranges::any_of(std::array{"meshes", "nodes"}, [&](const char* name) {
    const auto found = root.find(name);
    return found != root.end() && found->is_object();
  });
}

}  // namespace

void check_generation(const Json& root, const Report& report) {
  const auto asset = root.find("asset");
  const bool has_asset = asset != root.end() && asset->is_object();
  const auto text = has_asset ? asset->find("version") : asset;
  const bool says = has_asset && text != asset->end();
  const auto version = says && text->is_string() ? parse_version(text->get_ref<const std::string&>()) : std::nullopt;
  if (version && version->major != 2)
    report.unsupported("/asset/version", "glTF " + text->get<std::string>(), "export as glTF 2.0");
  if (!says && looks_like_1(root)) report.unsupported("/asset/version", "glTF 1.0", "export as glTF 2.0");
}

void check_asset_and_extensions(const Json& root, Report& report) {
  check_version(root.at("asset"), report);
  check_required(root, report);
  warn_of_unknown(root, report);
  check_extension_objects(root, Path{}, root, report);
}

}  // namespace marrow::cook::gltf
