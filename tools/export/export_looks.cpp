#include "export/export_looks.h"

#include <algorithm>
#include <cstring>

#include "export/affine_parts.h"

namespace marrow::tools {
namespace {

constexpr const char* kAlphaModes[] = {"OPAQUE", "MASK", "BLEND"};
// By ImageFormat. A texture of what glTF 2.0 does not know itself names it in an extension.
constexpr const char* kMimeTypes[] = {"", "image/png", "image/jpeg", "image/webp", "image/ktx2", "image/vnd-ms.dds"};
constexpr const char* kImageExtensions[] = {"", "", "", "EXT_texture_webp", "KHR_texture_basisu", "MSFT_texture_dds"};
constexpr int kWraps[] = {10497, 33071, 33648};
constexpr int kMagFilters[] = {0, 9728, 9729};
constexpr int kMinFilters[] = {0, 9728, 9729, 9984, 9985, 9986, 9987};

Json sampler_of(const Texture& t) {
  Json sampler = Json::object();
  if (t.mag != MagFilter::any) sampler["magFilter"] = kMagFilters[static_cast<std::size_t>(t.mag)];
  if (t.min != MinFilter::any) sampler["minFilter"] = kMinFilters[static_cast<std::size_t>(t.min)];
  if (t.wrap_u != Wrap::repeat) sampler["wrapS"] = kWraps[static_cast<std::size_t>(t.wrap_u)];
  if (t.wrap_v != Wrap::repeat) sampler["wrapT"] = kWraps[static_cast<std::size_t>(t.wrap_v)];
  return sampler;
}

// A path as in "door/hinges/0" to members within members; "~1" and "~0" stand for "/" and "~".
Json& member(Json& object, const std::string& path) {
  Json* at = &object;
  for (std::size_t first = 0; first <= path.size();) {
    const std::size_t end = std::min(path.find('/', first), path.size());
    std::string key;
    for (std::size_t i = first; i < end; ++i) {
      const bool escaped = path[i] == '~' && i + 1 < end && (path[i + 1] == '0' || path[i + 1] == '1');
      key += escaped ? (path[++i] == '0' ? '~' : '/') : path[i];
    }
    if (!at->is_object()) *at = Json::object();
    at = &(*at)[key];
    first = end + 1;
  }
  return *at;
}

Json extras_of(const File& file, const Node& node) {
  Json extras = Json::object();
  for (const Property& p : node.properties) {
    Json& to = member(extras, file.text(p.name));
    if (p.type == PropertyType::number) to = p.number;
    if (p.type == PropertyType::boolean) to = p.number != 0;
    if (p.type == PropertyType::text) to = file.text(p.text);
  }
  return extras;
}

bool is_identity(const Affine& a) {
  constexpr Affine kIdentity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  return std::memcmp(&a, &kIdentity, sizeof a) == 0;
}

}  // namespace

std::size_t Looks::once(const char* list, const Json& element) {
  const auto [at, is_new] =
      known_.try_emplace(std::string(list) + element.dump(-1, ' ', false, Json::error_handler_t::replace), 0u);
  if (is_new) at->second = scene_.glb.add(list, element);
  return at->second;
}

std::optional<std::size_t> Looks::add_image(std::uint32_t index) {
  const Image image = scene_.file.image(index);
  if (image.bytes.empty() && *image.uri == '\0') {
    if (!warned_[index])
      scene_.warnings.push_back({"image " + std::to_string(index) + " \"" + image.name + "\"", "",
                                 "known by name alone and left out; cook with --images embed"});
    warned_[index] = true;
    return std::nullopt;
  }
  const auto found = images_.find(index);
  if (found != images_.end()) return found->second;
  Json json = Json::object();
  if (*image.name != '\0') json["name"] = image.name;
  if (image.bytes.empty()) {
    json["uri"] = image.uri;
  } else {
    json["bufferView"] = scene_.glb.add_view(image.bytes.data, image.bytes.size, Target::none);
    json["mimeType"] = kMimeTypes[static_cast<std::size_t>(image.format)];
  }
  return images_.emplace(index, scene_.glb.add("images", json)).first->second;
}

bool Looks::add_texture(const Texture& texture, Json& out) {
  const Image image = scene_.file.image(texture.image);
  const std::optional<std::size_t> source = add_image(texture.image);
  if (!source) return false;
  Json json = Json::object();
  if (const char* const extension = kImageExtensions[static_cast<std::size_t>(image.format)]; *extension != '\0') {
    scene_.glb.use_extension(extension);
    json["extensions"][extension] = {{"source", *source}};
    if (image.fallback != kNoImage)
      if (const std::optional<std::size_t> fallback = add_image(image.fallback)) json["source"] = *fallback;
  } else {
    json["source"] = *source;
  }
  const Json sampler = sampler_of(texture);
  if (!sampler.empty()) json["sampler"] = once("samplers", sampler);
  out = {{"index", once("textures", json)}};
  return true;
}

void Looks::add_to(Json& material, const Mesh& mesh) {
  if (mesh.material_index == kNoMaterial) return;
  const Material m = scene_.file.material(mesh.material_index);
  if (m.alpha != AlphaMode::opaque) material["alphaMode"] = kAlphaModes[static_cast<std::size_t>(m.alpha)];
  if (m.alpha == AlphaMode::mask) material["alphaCutoff"] = number(m.alpha_cutoff);
  add_light(material, m);
  for (const Texture& texture : m.textures) {
    Json reference;
    if (mesh.geometry.uvs == nullptr || !add_texture(texture, reference)) continue;
    Json& pbr = material["pbrMetallicRoughness"];
    if (texture.role == TextureRole::base_colour) pbr["baseColorTexture"] = reference;
    if (texture.role == TextureRole::metallic_roughness) {
      pbr["metallicRoughnessTexture"] = reference;
      pbr.erase("metallicFactor");  // the texture says
    }
    if (texture.role == TextureRole::normal) material["normalTexture"] = reference;
    if (texture.role == TextureRole::occlusion) material["occlusionTexture"] = reference;
    if (texture.role == TextureRole::emissive) {
      material["emissiveTexture"] = reference;
    }
    if (texture.role == TextureRole::specular_glossiness) {
      scene_.glb.use_extension("KHR_materials_pbrSpecularGlossiness");
      Json& specular = material["extensions"]["KHR_materials_pbrSpecularGlossiness"];
      specular["specularGlossinessTexture"] = reference;
      if (pbr.contains("baseColorTexture")) specular["diffuseTexture"] = pbr["baseColorTexture"];
      if (pbr.contains("baseColorFactor")) specular["diffuseFactor"] = pbr["baseColorFactor"];
    }
  }
}

// A factor is at most 1; a strength makes up for it.
void Looks::add_light(Json& material, const Material& m) {
  if (m.unlit) {
    scene_.glb.use_extension("KHR_materials_unlit");
    material["extensions"]["KHR_materials_unlit"] = Json::object();
  }
  const float brightest = std::max({m.emissive[0], m.emissive[1], m.emissive[2]});
  if (!(brightest > 0)) return;
  const float strength = std::max(brightest, 1.0f);
  for (const float c : m.emissive) material["emissiveFactor"].push_back(number(c / strength));
  if (strength <= 1) return;
  scene_.glb.use_extension("KHR_materials_emissive_strength");
  material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", number(strength)}};
}

void export_nodes(ExportScene& scene) {
  for (std::uint32_t i = 0; i < scene.file.node_count(); ++i) {
    const Node kept = scene.file.node(i);
    const bool on_joint = kept.joint != kNoJoint;
    std::size_t parent = on_joint ? scene.joint_nodes[kept.skeleton][kept.joint] : ExportScene::kScene;
    const Json extras = extras_of(scene.file, kept);
    if (on_joint && is_identity(*kept.joint_from_node) &&
        scene.glb.json["nodes"][parent].value("name", std::string()) == kept.name) {
      if (!extras.empty()) scene.glb.json["nodes"][parent]["extras"].merge_patch(extras);  // limits may be there
      continue;
    }
    Json node = Json::object();
    if (*kept.name != '\0') node["name"] = kept.name;
    if (!extras.empty()) node["extras"] = extras;
    const std::vector<Parts> between = parts_of(*kept.joint_from_node);
    for (std::size_t p = 0; p + 1 < between.size(); ++p) {
      Json outer = Json::object();
      set_parts(outer, between[p]);
      parent = scene.add_node(std::move(outer), parent);
    }
    if (!between.empty()) set_parts(node, between.back());
    scene.add_node(std::move(node), parent);
  }
}

}  // namespace marrow::tools
