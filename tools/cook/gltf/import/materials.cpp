// Imports materials, their textures and samplers.
#include "cook/gltf/import/materials.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cook/gltf/import/import.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::size_t kMostImages = 0xFFFF;  // Texture::image has 16 bits
constexpr double kBrightest = 1e9;           // emitted light

// glTF 2.0, section 5.26: what a sampler's numbers mean.
std::optional<Wrap> wrap_of(std::int64_t code) {
  switch (code) {
    case 10497:
      return Wrap::repeat;
    case 33071:
      return Wrap::clamp_to_edge;
    case 33648:
      return Wrap::mirrored_repeat;
    default:
      return std::nullopt;
  }
}

std::optional<MagFilter> mag_of(std::int64_t code) {
  if (code == 9728) return MagFilter::nearest;
  if (code == 9729) return MagFilter::linear;
  return std::nullopt;
}

std::optional<MinFilter> min_of(std::int64_t code) {
  if (code == 9728) return MinFilter::nearest;
  if (code == 9729) return MinFilter::linear;
  if (code < 9984 || code > 9987) return std::nullopt;
  constexpr auto kFirst = static_cast<std::int64_t>(MinFilter::nearest_mipmap_nearest);
  return static_cast<MinFilter>(kFirst + code - 9984);
}

class Importer {
 public:
  Importer(const Json& looks, Report& report) : looks_(looks), report_(report) {}

  void import(const Json& material, std::size_t index) {
    const std::string where = pointer("materials", index);
    RawMaterial& raw = result.raw.emplace_back();
    const auto name = material.find("name");
    if (name != material.end()) raw.name = clean_name(name->get<std::string>(), where, report_);
    raw.double_sided = material.value("doubleSided", false);
    import_colour(material, where, raw);
    import_alpha(material, where, raw);
    import_emission(material, where, raw);
    raw.unlit = below(material, "extensions").contains("KHR_materials_unlit");
    std::optional<UvMapping> uvs;
    bool differ = false;
    for_each_texture(material, [&](TextureRole role, const Json& info, const std::string& below) {
      const UvMapping mapping = read_uv_mapping(info);
      if (!uvs) uvs = mapping;
      differ = differ || !(mapping == *uvs);
      import_texture(role, info, where + below, raw);
    });
    if (differ)
      report_.warn(where, "texture-uvs-differ",
                   "its textures are mapped in different ways; the mesh carries the base colour's coordinates");
    result.uvs.push_back(uvs.value_or(UvMapping{}));
  }

  Materials result;

 private:
  void import_colour(const Json& material, const std::string& where, RawMaterial& raw) {
    const Json& metallic = below(material, "pbrMetallicRoughness");
    const Json& specular = below(below(material, "extensions"), "KHR_materials_pbrSpecularGlossiness");
    // Of a material with both models the first says; defaults are white.
    const bool in_metallic = metallic.contains("baseColorFactor") || metallic.contains("baseColorTexture");
    const Json& factor = in_metallic ? below(metallic, "baseColorFactor") : below(specular, "diffuseFactor");
    const std::string place = in_metallic
                                  ? under(where, "pbrMetallicRoughness", "baseColorFactor")
                                  : under(where, "extensions", "KHR_materials_pbrSpecularGlossiness", "diffuseFactor");
    for (int c = 0; c < 4 && factor.is_array(); ++c) {
      const double value = factor[static_cast<std::size_t>(c)].get<double>();
      raw.base_colour[c] = static_cast<float>(std::clamp(value, 0.0, 1.0));
      if (value < 0 || value > 1) {
        report_.mend(under(place, c), "colours-clamped", "outside of 0 to 1");
      }
    }
  }

  void import_alpha(const Json& material, const std::string& where, RawMaterial& raw) {
    const std::string mode = material.value("alphaMode", "OPAQUE");
    if (mode == "MASK") {
      raw.alpha = AlphaMode::mask;
    } else if (mode == "BLEND") {
      raw.alpha = AlphaMode::blend;
    } else if (mode != "OPAQUE") {
      report_.mend(under(where, "alphaMode"), "alpha-mode-unknown", "none of OPAQUE, MASK and BLEND; taken as OPAQUE");
    }
    const double cutoff = material.value("alphaCutoff", 0.5);
    if (cutoff < 0) report_.mend(under(where, "alphaCutoff"), "alpha-cutoff-negative", "taken as 0");
    if (raw.alpha == AlphaMode::mask) raw.alpha_cutoff = static_cast<float>(std::max(cutoff, 0.0));
  }

  void import_emission(const Json& material, const std::string& where, RawMaterial& raw) {
    const Json& factor = below(material, "emissiveFactor");
    const Json& strength = below(below(material, "extensions"), "KHR_materials_emissive_strength");
    for (int c = 0; c < 3 && factor.is_array(); ++c) {
      const double value = factor[static_cast<std::size_t>(c)].get<double>();
      if (value < 0) report_.mend(under(where, "emissiveFactor", c), "emission-negative", "taken as 0");
      const double light = std::max(value, 0.0) * strength.value("emissiveStrength", 1.0);
      raw.emissive[c] = static_cast<float>(std::min(light, kBrightest));
    }
  }

  // Which image a texture shows; kNone: none. What its extensions name is preferred to what itself does.
  int image_of(const Json& texture, const std::string& where) {
    static constexpr struct {
      const char* extension;
      ImageFormat format;
    } kAlternatives[] = {{"KHR_texture_basisu", ImageFormat::ktx2},
                         {"MSFT_texture_dds", ImageFormat::dds},
                         {"EXT_texture_webp", ImageFormat::webp}};
    const auto source_of = [](const Json& object) { return object.value("source", kNone); };
    const int own = source_of(texture);
    int best = kNone;
    for (const auto& [extension, format] : kAlternatives) {
      const int other = source_of(below(below(texture, "extensions"), extension));
      if (other == kNone) continue;
      if (best != kNone)
        report_.warn(where, "texture-alternative", std::string("its image by ") + extension + " is left out");
      if (best == kNone) result.alternatives[static_cast<std::size_t>(other)] = {format, own};
      if (best == kNone) best = other;
    }
    return best != kNone ? best : own;
  }

  void import_texture(TextureRole role, const Json& info, const std::string& where, RawMaterial& raw) {
    const auto index = info.at("index").get<std::size_t>();
    const Json& texture = looks_.at("textures")[index];
    const int image = image_of(texture, pointer("textures", index));
    if (image == kNone) {
      report_.warn(where, "texture-without-image", "it has no image that is known here; left out");
      return;
    }
    if (looks_.at("images").size() > kMostImages)
      report_.unsupported(where, "too many images", "split the scene; 65535 is the limit");
    Texture out{};
    out.image = static_cast<std::uint16_t>(image);
    out.role = role;
    if (const auto sampler = texture.find("sampler"); sampler != texture.end())
      import_sampler(sampler->get<std::size_t>(), out);
    raw.textures.push_back(out);
  }

  void import_sampler(std::size_t index, Texture& out) {
    const Json& sampler = looks_.at("samplers")[index];
    const auto read = [&](const char* name, auto of, auto& to) {
      const auto code = sampler.find(name);
      if (code == sampler.end()) return;
      const auto known = of(code->get<std::int64_t>());
      if (!known) report_.mend(pointer("samplers", index, name), "sampler-unknown", "no mode of glTF 2.0; ignored");
      if (known) to = *known;
    };
    read("wrapS", wrap_of, out.wrap_u);
    read("wrapT", wrap_of, out.wrap_v);
    read("magFilter", mag_of, out.mag);
    read("minFilter", min_of, out.min);
  }

  const Json& looks_;
  Report& report_;
};

}  // namespace

Materials import_materials(const Json& looks, Report& report) {
  Importer importer(looks, report);
  const auto materials = looks.find("materials");
  if (materials == looks.end()) return {};
  for (std::size_t i = 0; i < materials->size(); ++i) importer.import((*materials)[i], i);
  return std::move(importer.result);
}

}  // namespace marrow::cook::gltf
