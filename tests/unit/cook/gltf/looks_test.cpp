// Materials, textures, samplers and images from glTF to the cooked file.
#include <string>
#include <vector>

#include "unit/cook/cook_text.h"

namespace marrow::cook {
namespace {

std::string in_base64(const std::string& bytes) {
  return base64(std::as_bytes(std::span(bytes.data(), bytes.size())));
}
const std::string kPng("\x89PNG\r\n\x1a\nrest of a picture", 26), kJpeg("\xFF\xD8\xFF\xE0rest of a photograph", 24);

std::string data_uri(const std::string& mime, const std::string& bytes) {
  return "\"data:" + mime + ";base64," + in_base64(bytes) + "\"";
}

// A triangle with coordinates (0, 0), (1, 0), (0, 1), in the first set halved;
// its material's base colour is textures/0, which is images/0.
Builder painted() {
  return document_of(
      R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"material": 0, "attributes":
      {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0", "TEXCOORD_0": "=f32x2 0 0 .5 0 0 .5", "TEXCOORD_1": "=f32x2 0 0 1 0 0 1"}}]}],
    "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "paint%20can.png"}], "extensionsUsed": ["KHR_texture_transform"])");
}

const std::string kBase = "\"/materials/0/pbrMetallicRoughness/baseColorTexture";
const std::string kTransform = kBase + "/extensions/KHR_texture_transform";

// Enumerations: alpha opaque, mask, blend; wrap repeat, clamp, mirror; filters
// any, nearest, linear, and by mipmap nearest/nearest, linear/nearest,
// nearest/linear, linear/linear; roles base colour, metallic-roughness, normal,
// occlusion, emissive, specular-glossiness.
constexpr int kMask = static_cast<int>(AlphaMode::mask);
static_assert(kMask == 1 && static_cast<int>(Wrap::mirrored_repeat) == 2 && static_cast<int>(MagFilter::linear) == 2);
static_assert(static_cast<int>(MinFilter::nearest_mipmap_nearest) == 3 &&
              static_cast<int>(MinFilter::linear_mipmap_nearest) == 4 &&
              static_cast<int>(MinFilter::nearest_mipmap_linear) == 5 &&
              static_cast<int>(MinFilter::linear_mipmap_linear) == 6);
static_assert(static_cast<int>(TextureRole::metallic_roughness) == 1 && static_cast<int>(TextureRole::normal) == 2 &&
              static_cast<int>(TextureRole::occlusion) == 3 && static_cast<int>(TextureRole::emissive) == 4 &&
              static_cast<int>(TextureRole::specular_glossiness) == 5);

TEST(GltfLooks, MaterialsTexturesAndSamplers) {
  expect_rows(
      painted(),
      {{"as they stand",
        R"("/materials/0/alphaMode": "MASK", "/materials/0/alphaCutoff": 0.75, "/materials/0/normalTexture": {"index": 1},
           "/materials/0/emissiveTexture": {"index": 2},
           "/textures": [{"source": 0, "sampler": 0}, {"source": 0, "sampler": 1}, {"source": 0}],
           "/samplers": [{"magFilter": 9728, "minFilter": 9985, "wrapS": 33071, "wrapT": 33648},
                         {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497}])",
        R"("materials/#": 1, "materials/0": {"name": "paint", "alpha": 1, "alpha_cutoff": 0.75},
           "materials/0/textures": [{"role": 0, "wrap": [1, 2], "mag": 1, "min": 4}, {"role": 2, "wrap": [0, 0], "min": 6},
                                    {"role": 4, "mag": 0}],
           "warns only": ["extra-uvs-dropped"])"},
       {"what is wrong is mended",
        R"("/materials/0/alphaMode": "DITHER", "/materials/0/alphaCutoff": -1, "/textures": [{"source": 0, "sampler": 0}],
           "/samplers": [{"wrapS": 7, "minFilter": 9986}])",
        R"("materials/0/alpha": 0, "materials/0/textures/0": {"wrap": [0, 0], "min": 5},
           "warns": ["alpha-mode-unknown /materials/0/alphaMode", "alpha-cutoff-negative /materials/0/alphaCutoff",
                     "sampler-unknown /samplers/0/wrapS"])"},
       {"a texture without an image is none", R"("/textures": [{"extensions": {"EXT_texture_avif": {"source": 0}}}])",
        R"("materials/0/textures": [],
           "warns": ["texture-without-image /materials/0/pbrMetallicRoughness/baseColorTexture"])"},
       {"no such texture", kBase + R"(/index": 1)",
        "invalid /materials/0/pbrMetallicRoughness/baseColorTexture/index: "},
       {"no such image", R"("/textures/0/source": 1)", "invalid /textures/0/source: "},
       {"no such sampler", R"("/textures/0/sampler": 0)", "invalid /textures/0/sampler: "},
       {"half an offset", kTransform + R"(": {"offset": [1]})",
        "invalid "
        "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/"
        "KHR_texture_transform/offset: "}});
}

TEST(GltfLooks, TextureCoordinates) {
  const std::string second = kBase + R"(/texCoord": 1, )", first_uvs = R"("P/uvs": [[0, 0], [0.5, 0], [0, 0.5]], )";
  const std::string dropped = R"("warns": ["extra-uvs-dropped /P/attributes/TEXCOORD_)";
  expect_rows(
      painted(),
      {{"the extension's own example: the lower left quadrant, turned "
        "clockwise",
        second + kTransform + R"(": {"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]})",
        R"("P/uvs ~1e-6": [[0, 1], [0, 0.5], [0.5, 1]])"},
       {"and V turned over", second + kTransform + R"(": {"offset": [0, 1], "scale": [1, -1]})",
        R"("P/uvs": [[0, 1], [1, 1], [0, 0]])"},
       {"the set that the material uses is carried", "", first_uvs + dropped + R"(1"])"},
       {"the second", kBase + R"(/texCoord": 1)", R"("P/uvs": [[0, 0], [1, 0], [0, 1]], )" + dropped + R"(0"])"},
       {"the transform overrides", second + kTransform + R"(": {"texCoord": 0})", first_uvs + R"("warns": [])"},
       {"there is no third set: the first, as it is", second + kTransform + R"(": {"texCoord": 2, "scale": [9, 9]})",
        first_uvs + R"("warns": ["texture-coordinates-missing"])"},
       {"textures agree", R"("/materials/0/normalTexture": {"index": 0})", R"("warns not": ["texture-uvs-differ"])"},
       {"textures disagree", R"("/materials/0/normalTexture": {"index": 0, "texCoord": 1})",
        R"("warns": ["texture-uvs-differ /materials/0"])"},
       {"without a base colour the normal map's coordinates are the material's",
        R"("/materials/0": {"normalTexture": {"index": 0, "texCoord": 1}})",
        R"("warns not": ["texture-uvs-differ"], "P/uvs/1": [1, 0])"}});
}

// Images of these members, each of a texture of its own, which the material has
// as base colour, normal and so on.
std::string images(const std::vector<std::string>& all) {
  const char* const roles[] = {"", ", \"/materials/0/normalTexture\"", ", \"/materials/0/emissiveTexture\"",
                               ", \"/materials/0/occlusionTexture\""};
  std::string list, textures, used;
  for (std::size_t i = 0; i < all.size(); ++i) {
    list += (i > 0 ? ", {" : "{") + all[i] + "}";
    textures += (i > 0 ? ", {\"source\": " : "{\"source\": ") + std::to_string(i) + "}";
    if (i > 0) used += roles[i] + (": {\"index\": " + std::to_string(i)) + "}";
  }
  return "\"/images\": [" + list + "], \"/textures\": [" + textures + "]" + used;
}
// A view of those bytes.
std::string view(const std::string& bytes) {
  std::string out = R"("bufferView": "=u8)";
  for (const char c : bytes) out += " " + std::to_string(static_cast<unsigned char>(c));
  return out + "\", \"mimeType\": \"image/" + (bytes == kPng ? "png\"" : "jpeg\"");
}

TEST(GltfLooks, ImagesByReference) {
  expect_cooked(
      painted(),
      {{"the URI is kept", "", "",
        R"("images": [{"uri": "paint%20can.png", "format": 1, "bytes": ""}], "warns not": ["images-by-name"],
           "materials/0/textures/0/image": 0, "meshes/0/material": 0, "report/images/0/uri": "paint%20can.png",
           "report/materials/0/textures/0/role": "base colour")"},
       {"inside the source they have a number only", "", images({view(kPng)}),
        R"("images/0/name": "images[0]", "warns": ["images-by-name"])"},
       {"or a name", "", images({R"("name": "paint", )" + view(kPng)}),
        R"("images/0": {"name": "paint", "uri": "", "format": 1})"},
       {"inside the source the name is all that finds an image again: one is a "
        "file of its own",
        "",
        images({R"("name": "face", )" + view(kPng), R"("name": "face", )" + view(kJpeg),
                R"("name": "face.2", )" + view(kPng), R"("name": "face", "uri": "face.png")"}),
        R"("warns": ["images-numbered"], "images/#": 4, "image_names": ["face", "face", "face.2", "face.3"])"},
       {"names that differ", "",
        images({R"("name": "a", )" + view(kPng), R"("name": "face", )" + view(kJpeg),
                R"("name": "face.2", )" + view(kPng), R"("name": "face", "uri": "face.png")"}),
        R"("warns not": ["images-numbered"])"},
       {"none leaves the rest of a material", "--images none", R"("/materials/0/alphaMode": "BLEND")",
        R"("images": [], "materials": [{"alpha": 2, "textures": []}])"},
       {"or nothing, if nothing is left to say", "--images none", "", R"("materials": [])"}});
}

TEST(GltfLooks, EmbeddedImages) {
  const std::string png = in_base64(kPng), jpeg = in_base64(kJpeg);
  expect_cooked(painted(),
                {{"bytes are the source's own and once", "--images embed",
                  images({R"("name": "a", )" + view(kPng), R"("name": "b", "uri": )" + data_uri("image/png", kPng),
                          R"("name": "c", "uri": )" + data_uri("image/jpeg", kJpeg)}) +
                      R"(, "/images/3": {"name": "unused", "uri": "not-there.png"}, "/textures/3": {"source": 3})",
                  R"("images": [{"format": 1, "bytes": ")" + png + R"("}, {"format": 2, "bytes": ")" + jpeg + R"("}],
           "materials/0/textures": [{"image": 0}, {"role": 2, "image": 0}, {"role": 4, "image": 1}],
           "warns not": ["images-by-name"])"},
                 {"what is no picture is not", "--images embed",
                  images({R"("name": "w", "uri": )" + data_uri("image/gif", "GIF89a......")}),
                  R"("warns": ["image-format"], "images/0/bytes": "")"},
                 {"bytes count, not the type", "--images embed",
                  images({R"("mimeType": "image/png", "uri": )" + data_uri("image/png", kJpeg)}),
                  R"("warns": ["image-mime-type"], "images/0/format": 2)"},
                 {"malformed", "--images embed", R"("/images/0/uri": "data:image/png;base64,iVBORw0K*")",
                  "invalid /images/0/uri: malformed base64"},
                 {"without data", "--images embed", R"("/images/0/uri": "data:image/png;base64")",
                  "invalid /images/0/uri: malformed data URI"},
                 {"memory has no folder", "--images embed", "", "io /images/0/uri: cannot read"},
                 {"no such view", "", R"("/images": [{"bufferView": 99, "mimeType": "image/png"}])",
                  "invalid /images/0/bufferView: "},
                 {"a view beyond", "--images embed",
                  R"("/bufferViews/3": {"buffer": 0, "byteOffset": 0, "byteLength": 100000},
          "/images": [{"bufferView": 3, "mimeType": "image/png"}])",
                  "invalid /bufferViews/3/byteLength: beyond"}});
}

// One view named by hundreds of images must not be copied so often.
TEST(GltfLooks, ImagesThatUnfoldAreRefused) {
  Builder b = painted();
  std::vector<char> large(1 << 20, 'x');
  std::copy(kPng.begin(), kPng.end(), large.begin());
  const int view = b.view(large);
  for (const char* list : {"images", "textures", "materials"}) b.root[list] = Json::array();
  for (int i = 0; i < 400; ++i) {
    b.root["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    b.root["textures"].push_back({{"source", i}});
    b.root["materials"].push_back({{"normalTexture", {{"index", i}}}});
  }
  try {
    read(b, {.image_bytes = true});
    ADD_FAILURE() << "400 MB from 1.4";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::unsupported) << failure.what();
    EXPECT_NE(failure.rule().find("unfolds"), std::string::npos) << failure.what();
  }
}

const std::string kWebp("RIFF\x08\0\0\0WEBPVP8 ", 16), kKtx("\xABKTX 20\xBB\r\n\x1A\nrest", 16), kDds("DDS rest", 8);

// The base colour is a picture of one extension, with a PNG for those that do
// not know it.
Builder with_alternative(const std::string& extension, const std::string& mime, const std::string& bytes) {
  return changed(painted(), R"("/images": [{"name": "small", "uri": )" + data_uri(mime, bytes) +
                                R"(}, {"name": "plain", "uri": )" + data_uri("image/png", kPng) +
                                R"(}], "/extensionsUsed": [")" + extension +
                                R"("], "/textures": [{"source": 1, "extensions": {")" + extension +
                                R"(": {"source": 0}}}])");
}

TEST(GltfLooks, PicturesForGpusKeepTheirBytesAndAFallback) {
  const struct {
    std::string extension, mime, bytes, format;
  } kinds[] = {{"EXT_texture_webp", "image/webp", kWebp, "3"},
               {"KHR_texture_basisu", "image/ktx2", kKtx, "4"},
               {"MSFT_texture_dds", "image/vnd-ms.dds", kDds, "5"}};
  for (const auto& kind : kinds) {
    SCOPED_TRACE(kind.extension);
    expect_cooked(with_alternative(kind.extension, kind.mime, kind.bytes),
                  {{"beside a PNG", "--images embed", "",
                    R"("warns only": ["extra-uvs-dropped"], "images/#": 2, "materials/0/textures/0/name": "small",
                       "image/small": {"instead": "plain", "format": )" +
                        kind.format + R"(, "bytes": ")" + in_base64(kind.bytes) +
                        R"("}, "image/plain": {"instead": null, "format": 1, "bytes": ")" + in_base64(kPng) + "\"}"},
                   {"demanded, alone and by reference: known by the extension", "",
                    R"("/textures/0/source": null, "/extensionsRequired": [")" + kind.extension + "\"]",
                    R"("images": [{"format": )" + kind.format + R"(, "instead": null, "bytes": ""}])"}});
  }
}

TEST(GltfLooks, OfSeveralPicturesTheBestForAGpuIsCarried) {
  const Builder webp = with_alternative("EXT_texture_webp", "image/webp", kWebp);
  expect_cooked(
      webp,
      {{"of two", "--images embed",
        R"("/images/2": {"name": "gpu", "uri": )" + data_uri("image/ktx2", kKtx) +
            R"(}, "/textures/0/extensions/KHR_texture_basisu": {"source": 2}, "/extensionsUsed/1": "KHR_texture_basisu")",
        R"("warns": ["texture-alternative"], "images/#": 2, "materials/0/textures/0/name": "gpu", "image/gpu/format": 4)"},
       {"two that stand in for each other", "--images embed",
        R"("/images/1": {"name": "plain", "uri": )" + data_uri("image/webp", kWebp + "2") +
            R"(}, "/textures/1": {"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}},
                               "/materials/0/normalTexture": {"index": 1})",
        R"("warns": ["image-fallback"], "images": [{"instead": null}, {"instead": null}])"},
       {"one that stands in for itself", "--images embed", R"("/textures/0/source": 0)",
        R"("images/0/instead": null)"}});
  const std::string where = "/textures/0/extensions/KHR_texture_basisu";
  const Builder ktx = with_alternative("KHR_texture_basisu", "image/ktx2", kKtx);
  for (const std::string source : {"2", "-1", "\"0\"", "1e300"})
    expect_rows(ktx, {{source, "\"" + where + "/source\": " + source, "invalid " + where + "/source: "}});
  expect_rows(ktx, {{"a list", "\"" + where + "\": []", "invalid " + where + ": "}});
}

TEST(GltfLooks, SpecularGlossinessGivesColourAndTextures) {
  const std::string extension = "KHR_materials_pbrSpecularGlossiness";
  const std::string specular =
      R"("/textures/1": {"source": 1}, "/images/1": {"uri": "shine.png"}, "/extensionsUsed": [")" + extension +
      R"("], "/materials/0": {"extensions": {")" + extension +
      R"(": {"diffuseFactor": [0.25, 0.5, 0.75, 1],
      "diffuseTexture": {"index": 0}, "specularGlossinessTexture": {"index": 1}, "glossinessFactor": 0.5}}})";
  expect_rows(painted(),
              {{"alone", specular,
                R"("materials/0/base_colour": [0.25, 0.5, 0.75, 1], "warns not": ["extension-ignored"],
                                      "materials/0/textures": [{"role": 0}, {"role": 5, "image": 1}])"},
               {"what the metallic-roughness model says comes first",
                specular +
                    R"(, "/materials/0/pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1],
                                                                      "metallicRoughnessTexture": {"index": 1}})",
                R"("materials/0/base_colour": [1, 0, 0, 1], "materials/0/textures": [{"role": 0}, {"role": 1}])"},
               {"half a colour", specular + R"(, "/materials/0/extensions/)" + extension + R"(/diffuseFactor": [1, 2])",
                "invalid /materials/0/extensions/" + extension + "/diffuseFactor: "}});
}

TEST(GltfLooks, LightAndNoLight) {
  const std::string lit =
      R"("/extensionsUsed": ["KHR_materials_unlit", "KHR_materials_emissive_strength"], "/materials/0":
    {"emissiveFactor": [1, 0.5, 0], "extensions": {"KHR_materials_unlit": {},
                                                   "KHR_materials_emissive_strength": {"emissiveStrength": 8}}})";
  expect_cooked(painted(), {{"factor times strength", "", lit,
                             R"("warns not": ["extension-ignored"], "report/materials/0/emissive": [8, 4, 0],
                                "materials": [{"unlit": true, "emissive": [8, 4, 0]}])"},
                            {"less than none", "", lit + R"(, "/materials/0/emissiveFactor": [-1, 0, 0])",
                             R"("warns": ["emission-negative"], "materials/0/emissive/0": 0)"}});
}

TEST(GltfLooks, MeshesShareARecord) {
  Builder b =
      changed(painted(), R"("/materials/1": "@/materials/0", "/materials/2": {"name": "plain", "doubleSided": true})");
  for (int i = 0; i < 5; ++i) {
    b.root["meshes"][0]["primitives"].push_back(b.root["meshes"][0]["primitives"][0]);
    b.root["meshes"][0]["primitives"].back()["material"] = i % 3;
  }
  const Json cooked = facts_of(LoadedCook(cook_text(b)));
  expect_facts(cooked, R"("meshes/#": 6, "materials/#": 1, "images/#": 1)");
  EXPECT_EQ(std::ranges::count_if(cooked["meshes"],
                                  [](const Json& mesh) {
                                    return mesh["material"].is_null() && mesh["double_sided"] == true &&
                                           mesh["material_name"] == "plain";
                                  }),
            1);
}

// The table's 16 bytes, a record of 12 and 8 a texture; 16 and 16 an image;
// padding; names.
TEST(GltfLooks, AMaterialTakesFewBytes) {
  const std::size_t full = cook_text(painted()).file.size();
  const std::size_t bare = cook_text(changed(painted(), R"("/materials/0/pbrMetallicRoughness": null)")).file.size();
  EXPECT_GT(full, bare);
  EXPECT_LE(full, bare + 16 + 32 + 16 + 16 + 16 + sizeof "paint%20can.png" + sizeof "images[0]");
}

TEST(GltfLooks, HostileUrisAreRefusedWhoeverReads) {
  for (const std::string uri :
       {"../up.png", "a/../../b.png", "%2e%2e/up.png", "a%2f..%2f..%2fup.png", "/etc/passwd", "~/x.png",
        "http://example.org/x.png", "file:///etc/passwd", "C:/x.png", "a\\\\b.png", "a%00.png", "", "x%zz"})
    for (const bool image_bytes : {false, true})
      expect_rows(painted(), {{uri, R"("/images/0/uri": ")" + uri + "\"", "invalid /images/0/uri: "}},
                  {.image_bytes = image_bytes});
}

}  // namespace
}  // namespace marrow::cook
