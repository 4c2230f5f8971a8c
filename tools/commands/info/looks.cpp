// What `marrow info` says of materials, images and kept nodes.
#include "commands/info/looks.h"

#include <fmt/format.h>

#include "text/quantity.h"
#include "text/words.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

// As JSON has it, so that whatever a file says, it stays on its line.
std::string quoted(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json value_of(const File& file, const Property& p) {
  if (p.type == PropertyType::text) return file.text(p.text);
  if (p.type == PropertyType::boolean) return p.number != 0;
  return p.number;
}

bool emits(const Material& m) {
  return m.emissive[0] > 0 || m.emissive[1] > 0 || m.emissive[2] > 0;
}

}  // namespace

void describe_looks(const File& file, ordered_json& r) {
  r["materials"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.material_count(); ++i) {
    const Material m = file.material(i);
    ordered_json textures = ordered_json::array();
    for (const Texture& t : m.textures) textures.push_back({{"role", word(t.role)}, {"image", t.image}});
    r["materials"].push_back({{"name", m.name}, {"alpha", word(m.alpha)}, {"textures", textures}});
    if (m.alpha == AlphaMode::mask) r["materials"].back()["alpha_cutoff"] = m.alpha_cutoff;
    if (m.unlit) r["materials"].back()["unlit"] = true;
    if (emits(m)) r["materials"].back()["emissive"] = m.emissive;
  }
  r["images"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.image_count(); ++i) {
    const Image image = file.image(i);
    r["images"].push_back({{"name", image.name},
                           {"uri", image.uri},
                           {"format", word(image.format)},
                           {"embedded_bytes", image.bytes.size}});
    if (image.fallback != kNoImage) r["images"].back()["fallback"] = image.fallback;
  }
}

void describe_nodes(const File& file, ordered_json& r) {
  r["nodes"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.node_count(); ++i) {
    const Node n = file.node(i);
    ordered_json properties = ordered_json::array();
    for (const Property& p : n.properties)
      properties.push_back({{"name", file.text(p.name)}, {"value", value_of(file, p)}});
    const bool has_joint = n.joint != kNoJoint;
    r["nodes"].push_back({{"name", n.name},
                          {"skeleton", n.skeleton},
                          {"joint", has_joint ? ordered_json(n.joint) : ordered_json()},
                          {"joint_name", has_joint ? file.text(file.skeleton(n.skeleton).names[n.joint]) : ""},
                          {"properties", properties}});
  }
}

void print_looks(const ordered_json& r) {
  for (std::size_t i = 0; i < r["materials"].size(); ++i) {
    const auto& m = r["materials"][i];
    fmt::print("material {} {}: {}", i, quoted(m["name"]), m["alpha"].get<std::string>());
    for (const auto& t : m["textures"])
      fmt::print(", {} image {}", t["role"].get<std::string>(), t["image"].get<int>());
    if (m.contains("unlit")) fmt::print(", unlit");
    if (m.contains("emissive"))
      fmt::print(", emits {} {} {}", plain_number(m["emissive"][0]), plain_number(m["emissive"][1]),
                 plain_number(m["emissive"][2]));
    fmt::print("\n");
  }
  for (std::size_t i = 0; i < r["images"].size(); ++i) {
    const auto& image = r["images"][i];
    const auto bytes = image["embedded_bytes"].get<std::size_t>();
    fmt::print("image {} {}: {}, {}", i, quoted(image["name"]), image["format"].get<std::string>(),
               bytes > 0 ? std::to_string(bytes) + " bytes" : "by reference, " + quoted(image["uri"]));
    if (image.contains("fallback")) fmt::print(", fallback image {}", image["fallback"].get<int>());
    fmt::print("\n");
  }
}

void print_nodes(const ordered_json& r) {
  for (std::size_t i = 0; i < r["nodes"].size(); ++i) {
    const auto& n = r["nodes"][i];
    fmt::print("node {} {}: {}\n", i, quoted(n["name"]),
               n["joint"].is_null() ? "fixed in the scene" : "on joint " + quoted(n["joint_name"]));
    for (const auto& p : n["properties"]) fmt::print("  {} = {}\n", quoted(p["name"]), quoted(p["value"]));
  }
}

}  // namespace marrow::tools
