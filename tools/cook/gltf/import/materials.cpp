// Imports materials, their textures and samplers, and the pictures that they use, without looking into these.
#include "cook/gltf/import/materials.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "common/elementary.h"
#include "cook/gltf/document/scene_files.h"
#include "cook/gltf/import/import.h"
#include "text/nearest.h"

namespace marrow::cook::gltf {

glm::vec2 UvMapping::apply(glm::vec2 uv) const {
  const double u = scale[0] * static_cast<double>(uv.x), v = scale[1] * static_cast<double>(uv.y);
  const double c = tools::cosine(rotation), s = tools::sine(rotation);
  return {static_cast<float>(c * u + s * v + offset[0]), static_cast<float>(c * v - s * u + offset[1])};
}

const Json& below(const Json& object, const char* name) {
  static const Json kNothing = Json::object();
  const auto member = object.find(name);
  return member == object.end() ? kNothing : *member;
}

UvMapping read_uv_mapping(const Json& info) {
  UvMapping mapping;
  mapping.set = info.value("texCoord", std::size_t{0});
  const auto extensions = info.find("extensions");
  if (extensions == info.end()) return mapping;
  const auto transform = extensions->find("KHR_texture_transform");
  if (transform == extensions->end()) return mapping;
  mapping.set = transform->value("texCoord", mapping.set);
  mapping.rotation = transform->value("rotation", 0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    if (transform->contains("offset")) mapping.offset[i] = transform->at("offset")[i].get<double>();
    if (transform->contains("scale")) mapping.scale[i] = transform->at("scale")[i].get<double>();
  }
  return mapping;
}

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

std::int64_t highest_texture_coordinate(const Json& material) {
  std::int64_t highest = -1;
  for_each_texture(material, [&](TextureRole, const Json& info, const std::string&) {
    highest = std::max(highest, static_cast<std::int64_t>(read_uv_mapping(info).set));
  });
  return highest;
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
      const double value = factor[to_index(c)].get<double>();
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
      const double value = factor[to_index(c)].get<double>();
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
      if (best == kNone) result.alternatives[to_index(other)] = {format, own};
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

void check_texture_coordinates(const Json& root, Report& report) {
  if (!root.contains("meshes") || !root.contains("materials")) return;
  const Json& materials = root.at("materials");
  for (std::size_t m = 0; m < root.at("meshes").size(); ++m) {
    const Json& primitives = root.at("meshes")[m].at("primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const auto material = primitives[p].find("material");
      if (material == primitives[p].end()) continue;
      const std::int64_t needed = highest_texture_coordinate(materials[material->get<std::size_t>()]);
      if (needed < 0 || primitives[p].at("attributes").contains("TEXCOORD_" + std::to_string(needed))) continue;
      report.mend(pointer("meshes", m, "primitives", p, "material"), "texture-coordinates-missing",
                  "the material needs TEXCOORD_" + std::to_string(needed) + ", which the primitive lacks");
    }
  }
}

namespace {

constexpr std::uint64_t kMostImageBytes = kMostBytes;  // of all that are read from files

struct FormatName {
  ImageFormat format;
  std::string_view mime_type, extension;
};
constexpr FormatName kFormats[] = {
    {ImageFormat::png, "image/png", ".png"},    {ImageFormat::jpeg, "image/jpeg", ".jpg"},
    {ImageFormat::jpeg, "image/jpeg", ".jpeg"}, {ImageFormat::webp, "image/webp", ".webp"},
    {ImageFormat::ktx2, "image/ktx2", ".ktx2"}, {ImageFormat::dds, "image/vnd-ms.dds", ".dds"}};

ImageFormat format_of_bytes(std::span<const std::byte> bytes) {
  const auto has = [&](std::initializer_list<int> signature, std::size_t at = 0) {
    return bytes.size() >= at + signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](int s, std::byte b) { return s == std::to_integer<int>(b); });
  };
  if (has({0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'})) return ImageFormat::png;
  if (has({0xFF, 0xD8, 0xFF})) return ImageFormat::jpeg;
  if (has({'R', 'I', 'F', 'F'}) && has({'W', 'E', 'B', 'P'}, 8)) return ImageFormat::webp;
  if (has({0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'})) return ImageFormat::ktx2;
  if (has({'D', 'D', 'S', ' '})) return ImageFormat::dds;
  return ImageFormat::unknown;
}

ImageFormat format_of_mime_type(std::string_view mime) {
  for (const FormatName& known : kFormats)
    if (mime == known.mime_type) return known.format;
  return ImageFormat::unknown;
}

ImageFormat format_of_uri(std::string_view uri) {
  std::string extension;
  if (const std::size_t dot = uri.rfind('.'); dot != std::string_view::npos)
    for (const char c : uri.substr(dot)) extension += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const FormatName& known : kFormats)
    if (extension == known.extension) return known.format;
  return ImageFormat::unknown;
}

class ImageImporter {
 public:
  ImageImporter(const Document& document, Files* files, Budget& budget, std::uint64_t& external_bytes, Report& report)
      : document_(document), files_(files), budget_(budget), external_bytes_(external_bytes), report_(report) {}

  RawImage import(std::size_t index, bool with_bytes) {
    const Json& image = document_.looks.at("images")[index];
    const std::string where = pointer("images", index);
    RawImage raw;
    raw.name = clean_name(image.value("name", std::string()), where, report_);
    if (raw.name.empty()) raw.name = "images[" + std::to_string(index) + ']';
    const auto uri = image.find("uri");
    const bool is_file = uri != image.end() && !is_data_uri(uri->get_ref<const std::string&>());
    if (is_file) raw.uri = uri->get<std::string>();
    raw.format = format_of_mime_type(image.value("mimeType", std::string()));
    if (raw.format == ImageFormat::unknown) raw.format = format_of_uri(raw.uri);
    if (!is_file) raw.inside_bytes = inside_bytes(image);
    if (!with_bytes) return raw;
    if (is_file) {
      raw.bytes = file_bytes(raw.uri, under(where, "uri"));
    } else if (uri != image.end()) {
      raw.bytes = decode_data_uri(uri->get_ref<const std::string&>(), under(where, "uri"), report_).bytes;
    } else if (image.contains("bufferView")) {
      raw.bytes = view_bytes(image.at("bufferView").get<std::size_t>(), under(where, "bufferView"));
    } else {
      report_.mend(where, "image-without-data", "it has neither uri nor bufferView");
    }
    check_bytes(image, where, raw);
    return raw;
  }

 private:
  // Without decoding: base64 has four characters for three bytes.
  std::uint64_t inside_bytes(const Json& image) const {
    if (image.contains("bufferView")) return document_.buffers.views[image.at("bufferView").get<std::size_t>()].length;
    const std::string uri = image.value("uri", std::string());
    const std::size_t characters = uri.size() - std::min(uri.size(), uri.find(',') + 1);
    const std::size_t bytes = characters / 4 * 3, padding = uri.ends_with("==") ? 2 : uri.ends_with('=') ? 1 : 0;
    return bytes - std::min(bytes, padding);
  }

  std::vector<std::byte> view_bytes(std::size_t index, const std::string& where) {
    const View& view = document_.buffers.views[index];
    if (!view.present) {
      report_.warn(where, "image-without-data", "the buffer has no bytes");
      return {};
    }
    budget_.take(view.bytes.size(), where, report_);  // many images may share a view
    return {view.bytes.begin(), view.bytes.end()};
  }

  // A file named twice is read and counted twice: it is the sum of what is held.
  std::vector<std::byte> file_bytes(const std::string& uri, const std::string& where) {
    const std::string path = name_beside(files_, report_.file(), uri, "image", where, report_);
    std::vector<std::byte> bytes = read_scene_file(*files_, path, kMostBytes + 1, where, report_);
    image_bytes_ += bytes.size();
    if (image_bytes_ > kMostImageBytes) report_.unsupported(where, "images too large", "2 GiB is the limit");
    external_bytes_ += bytes.size();
    return bytes;
  }

  void check_bytes(const Json& image, const std::string& where, RawImage& raw) {
    if (raw.bytes.empty()) return;
    const ImageFormat format = format_of_bytes(raw.bytes);
    if (format == ImageFormat::unknown) {
      report_.mend(where, "image-format",
                   "no PNG, JPEG, WebP, KTX2 or DDS, so it cannot be embedded; referred to by name");
      raw.bytes.clear();
      return;
    }
    if (image.contains("mimeType") && format != format_of_mime_type(image.at("mimeType").get<std::string>()))
      report_.mend(under(where, "mimeType"), "image-mime-type", "the bytes say otherwise, and are believed");
    raw.format = format;
  }

  const Document& document_;
  Files* files_;
  Budget& budget_;
  std::uint64_t& external_bytes_;
  Report& report_;
  std::uint64_t image_bytes_ = 0;
};

// By its name alone an image inside the source is found again, so no two have the same. Files are found by their URIs.
void number_equal_names(std::vector<RawImage>& images, Report& report) {
  std::set<std::string> all;
  std::map<std::string, std::size_t> last;  // the number of each name's last bearer
  for (const RawImage& image : images) all.insert(image.name);
  std::vector<std::string> renamed;
  for (RawImage& image : images) {
    if (image.name.empty() || !image.uri.empty()) continue;
    const auto [at, is_first] = last.try_emplace(image.name, 1);
    if (is_first) continue;
    while (!all.insert(image.name).second) image.name = at->first + '.' + std::to_string(++at->second);
    renamed.push_back('"' + image.name + '"');
  }
  if (!renamed.empty())
    report.warn("/images", "images-numbered",
                std::to_string(renamed.size()) + " images are called as others are; now " + tools::listed(renamed));
}

}  // namespace

void check_image_uris(const Json& root, Report& report) {
  const auto images = root.find("images");
  if (images == root.end()) return;
  for (std::size_t i = 0; i < images->size(); ++i) {
    const auto uri = (*images)[i].find("uri");
    if (uri == (*images)[i].end()) continue;
    const auto& text = uri->get_ref<const std::string&>();
    if (!is_data_uri(text)) decode_relative_uri(text, pointer("images", i, "uri"), report);
  }
}

std::vector<RawImage> import_images(const Document& document, const Materials& materials, Files* files, bool with_bytes,
                                    Budget& budget, std::uint64_t& external_bytes, Report& report) {
  const auto list = document.looks.find("images");
  std::vector<RawImage> images(list == document.looks.end() ? 0 : list->size());
  std::vector<bool> known(images.size(), false);
  ImageImporter importer(document, files, budget, external_bytes, report);
  const auto import = [&](std::size_t index) {
    if (!known[index]) images[index] = importer.import(index, with_bytes);
    known[index] = true;
  };
  for (const RawMaterial& material : materials.raw)
    for (const Texture& texture : material.textures) import(texture.image);
  for (const auto& [index, alternative] : materials.alternatives) {
    RawImage& image = images[index];
    if (image.format == ImageFormat::unknown) image.format = image.bytes.empty() ? alternative.format : image.format;
    if (alternative.fallback == kNone || image.format <= ImageFormat::jpeg) continue;
    const auto fallback = to_index(alternative.fallback);
    import(fallback);
    // Every decoder must know it; so a fallback has none itself.
    if (images[fallback].format <= ImageFormat::jpeg)
      image.fallback = alternative.fallback;
    else
      report.warn(pointer("images", index), "image-fallback",
                  "what should stand in for it is no PNG or JPEG; left out");
  }
  number_equal_names(images, report);
  return images;
}

}  // namespace marrow::cook::gltf
