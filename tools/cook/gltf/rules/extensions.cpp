// Decides whether a document's version and extensions can be cooked at all.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "cook/gltf/rules/schema.h"

namespace marrow::cook::gltf {
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
void check_extension_objects(const Json& value, const std::string& where, const Json& root, Report& report) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (value[i].is_structured()) check_extension_objects(value[i], under(where, i), root, report);
    }
    return;
  }
  for (const auto& [key, member] : value.items()) {
    if (!member.is_structured() && key != "extensions") continue;
    if (key == "extras") continue;
    const std::string here = under(where, key);
    if (key == "extensions") {
      if (!member.is_object()) report.invalid(here, "wrong type", "it must be an object");
      for (const auto& [name, extension] : member.items()) {
        if (!extension.is_object()) report.invalid(under(here, name), "wrong type", "it must be an object");
        if (lists(root, "extensionsUsed", name)) continue;
        report.mend(under(here, name), "undeclared-extension", name + " is not listed in extensionsUsed");
      }
    }
    check_extension_objects(member, here, root, report);
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
  check_extension_objects(root, "", root, report);
}

}  // namespace marrow::cook::gltf
