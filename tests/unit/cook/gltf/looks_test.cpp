// Materials, textures, samplers and images from glTF to the cooked file.
#include <cstring>

#include "common/aligned_bytes.h"
#include "common/unpack_mrw.h"
#include "disk/cook_on_disk.h"
#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

const std::string kPng("\x89PNG\r\n\x1a\nrest of a picture", 26), kJpeg("\xFF\xD8\xFF\xE0rest of a photograph", 24);

std::string data_uri(const std::string& mime, const std::string& bytes) {
  return "data:" + mime + ";base64," + base64(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

// A triangle with coordinates (0, 0), (1, 0), (0, 1), in the first set halved; its material's base colour is
// textures/0, which is images/0.
Builder painted() {
  Builder b;
  const int first = b.numbers<float>(kF32, "VEC2", 2, {0, 0, .5F, 0, 0, .5F});
  const int second = b.numbers<float>(kF32, "VEC2", 2, {0, 0, 1, 0, 0, 1});
  b.primitive({{"POSITION", b.curve(3)}, {"TEXCOORD_0", first}, {"TEXCOORD_1", second}})["material"] = 0;
  b.root["materials"] = {{{"name", "paint"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  b.root["textures"] = {{{"source", 0}}};
  b.root["images"] = {{{"uri", "paint%20can.png"}}};
  b.root["extensionsUsed"] = {"KHR_texture_transform"};
  return b;
}

Json& base_texture(Builder& b) {
  return b.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
}

RawScene read_embedded(Builder& b) {
  const std::string text = b.text();
  return read_gltf("test.gltf", std::as_bytes(std::span(text.data(), text.size())), {.image_bytes = true});
}

// A cooked file and the view of it.
struct Cooked {
  Result result;
  tools::AlignedBytes block;
  File file;

  explicit Cooked(RawScene scene, const CookOptions& options = {})
      : result(cook_scene(std::move(scene), options)), block(tools::unpacked(result.file, "test")) {
    EXPECT_EQ(load({block.data(), block.size()}, file), Status::ok);
  }
  bool warns(const std::string& rule) const {
    for (const auto& w : result.report["warnings"])
      if (w["rule"] == rule) return true;
    return false;
  }
};

CookOptions with(Images images) {
  CookOptions options;
  options.source.images = images;
  return options;
}

std::string text_of(Span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data), bytes.size};
}

TEST(GltfLooks, MaterialsAndSamplers) {
  Builder b = painted();
  b.root["materials"][0].update({{"alphaMode", "MASK"}, {"alphaCutoff", .75}, {"normalTexture", {{"index", 1}}}});
  b.root["materials"][0]["emissiveTexture"] = {{"index", 2}};
  b.root["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 0}, {"sampler", 1}}, {{"source", 0}}};
  b.root["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9985}, {"wrapS", 33071}, {"wrapT", 33648}},
                        {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}}};
  const RawScene scene = read(b);
  ASSERT_EQ(scene.materials.size(), 1U);
  const RawMaterial& material = scene.materials[0];
  EXPECT_EQ(material.name, "paint");
  EXPECT_EQ(material.alpha, AlphaMode::mask);
  EXPECT_EQ(material.alpha_cutoff, .75F);
  ASSERT_EQ(material.textures.size(), 3U);
  const Texture &base = material.textures[0], &normal = material.textures[1], &emissive = material.textures[2];
  EXPECT_EQ(base.role, TextureRole::base_colour);
  EXPECT_EQ(base.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(base.wrap_v, Wrap::mirrored_repeat);
  EXPECT_EQ(base.mag, MagFilter::nearest);
  EXPECT_EQ(base.min, MinFilter::linear_mipmap_nearest);
  EXPECT_EQ(normal.role, TextureRole::normal);
  EXPECT_EQ(normal.wrap_u, Wrap::repeat);
  EXPECT_EQ(normal.min, MinFilter::linear_mipmap_linear);
  EXPECT_EQ(emissive.role, TextureRole::emissive);
  EXPECT_EQ(emissive.mag, MagFilter::any);
  EXPECT_TRUE(scene.warnings.size() == 1 && warns(scene, "extra-uvs-dropped")) << scene.warnings.size();
}

TEST(GltfLooks, WhatIsWrongIsMended) {
  Builder b = painted();
  b.root["materials"][0].update({{"alphaMode", "DITHER"}, {"alphaCutoff", -1}});
  b.root["textures"] = {{{"source", 0}, {"sampler", 0}}};
  b.root["samplers"] = {{{"wrapS", 7}, {"minFilter", 9986}}};
  const RawScene scene = read(b);
  EXPECT_EQ(scene.materials[0].alpha, AlphaMode::opaque);
  EXPECT_TRUE(warns(scene, "alpha-mode-unknown", "/materials/0/alphaMode"));
  EXPECT_TRUE(warns(scene, "alpha-cutoff-negative", "/materials/0/alphaCutoff"));
  EXPECT_TRUE(warns(scene, "sampler-unknown", "/samplers/0/wrapS"));
  EXPECT_EQ(scene.materials[0].textures[0].wrap_u, Wrap::repeat);
  EXPECT_EQ(scene.materials[0].textures[0].min, MinFilter::nearest_mipmap_linear);

  b = painted();
  b.root["textures"] = {{{"extensions", {{"EXT_texture_avif", {{"source", 0}}}}}}};
  const RawScene avif = read(b);
  EXPECT_TRUE(warns(avif, "texture-without-image", "/materials/0/pbrMetallicRoughness/baseColorTexture"));
  EXPECT_TRUE(avif.materials[0].textures.empty());
}

TEST(GltfLooks, BrokenReferencesAreRefused) {
  Builder b = painted();
  base_texture(b)["index"] = 1;
  expect_refused(b.text(), Exit::invalid, "/materials/0/pbrMetallicRoughness/baseColorTexture/index", "");
  b = painted();
  b.root["textures"][0]["source"] = 1;
  expect_refused(b.text(), Exit::invalid, "/textures/0/source", "");
  b = painted();
  b.root["textures"][0]["sampler"] = 0;
  expect_refused(b.text(), Exit::invalid, "/textures/0/sampler", "");
  b = painted();
  base_texture(b)["extensions"]["KHR_texture_transform"]["offset"] = {1};
  expect_refused(b.text(), Exit::invalid,
                 "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset", "");
}

// The extension's own examples: the lower left quadrant, turned clockwise; and V turned over.
TEST(GltfLooks, TextureTransform) {
  Builder b = painted();
  base_texture(b)["texCoord"] = 1;
  Json& transform = base_texture(b)["extensions"]["KHR_texture_transform"];
  transform = {{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {.5, .5}}};
  const std::vector<glm::vec2> turned = read(b).meshes[0].primitives[0].uvs;
  const glm::vec2 expected[] = {{0, 1}, {0, .5F}, {.5F, 1}};
  ASSERT_EQ(turned.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(turned[i].x, expected[i].x, 1e-6) << i;
    EXPECT_NEAR(turned[i].y, expected[i].y, 1e-6) << i;
  }
  base_texture(b)["extensions"]["KHR_texture_transform"] = {{"offset", {0, 1}}, {"scale", {1, -1}}};
  EXPECT_EQ(read(b).meshes[0].primitives[0].uvs, (std::vector<glm::vec2>{{0, 1}, {1, 1}, {0, 0}}));
}

TEST(GltfLooks, TheSetThatTheMaterialUsesIsCarried) {
  const std::vector<glm::vec2> first = {{0, 0}, {.5F, 0}, {0, .5F}}, second = {{0, 0}, {1, 0}, {0, 1}};
  Builder b = painted();
  EXPECT_EQ(read(b).meshes[0].primitives[0].uvs, first);
  EXPECT_TRUE(warns(read(b), "extra-uvs-dropped", "/meshes/0/primitives/0/attributes/TEXCOORD_1"));
  base_texture(b)["texCoord"] = 1;
  EXPECT_EQ(read(b).meshes[0].primitives[0].uvs, second);
  EXPECT_TRUE(warns(read(b), "extra-uvs-dropped", "/meshes/0/primitives/0/attributes/TEXCOORD_0"));
  base_texture(b)["extensions"]["KHR_texture_transform"]["texCoord"] = 0;  // overrides
  EXPECT_EQ(read(b).meshes[0].primitives[0].uvs, first);
  base_texture(b)["extensions"]["KHR_texture_transform"] = {{"texCoord", 2}, {"scale", {9, 9}}};
  EXPECT_EQ(read(b).meshes[0].primitives[0].uvs, first) << "there is no third set: the first, as it is";
  EXPECT_TRUE(warns(read(b), "texture-coordinates-missing"));
}

TEST(GltfLooks, TexturesThatDisagreeAreNamed) {
  Builder b = painted();
  b.root["materials"][0]["normalTexture"] = {{"index", 0}};
  EXPECT_FALSE(warns(read(b), "texture-uvs-differ"));
  b.root["materials"][0]["normalTexture"]["texCoord"] = 1;
  EXPECT_TRUE(warns(read(b), "texture-uvs-differ", "/materials/0"));
  b.root["materials"][0].erase("pbrMetallicRoughness");  // then the normal map's coordinates are the material's
  EXPECT_FALSE(warns(read(b), "texture-uvs-differ"));
  EXPECT_EQ(read(b).meshes[0].primitives[0].uvs[1], glm::vec2(1, 0));
}

TEST(GltfLooks, ByReferenceTheUriIsKept) {
  Builder b = painted();
  const Cooked cooked(read(b));
  ASSERT_EQ(cooked.file.image_count(), 1U);
  const Image image = cooked.file.image(0);
  EXPECT_STREQ(image.uri, "paint%20can.png");
  EXPECT_EQ(image.format, ImageFormat::png);
  EXPECT_TRUE(image.bytes.empty());
  EXPECT_FALSE(cooked.warns("images-by-name"));
  const Mesh mesh = cooked.file.mesh(0);
  EXPECT_EQ(cooked.file.material(mesh.material_index).textures[0].image, 0U);
  EXPECT_EQ(cooked.result.report["images"][0]["uri"], "paint%20can.png");
  EXPECT_EQ(cooked.result.report["materials"][0]["textures"][0]["role"], "base colour");
}

TEST(GltfLooks, ImagesInsideTheSourceHaveANameOnly) {
  Builder b = painted();
  b.root["images"] = {{{"bufferView", b.view(std::vector<char>(kPng.begin(), kPng.end()))}, {"mimeType", "image/png"}}};
  const Cooked unnamed(read(b));
  EXPECT_STREQ(unnamed.file.image(0).name, "images[0]");
  EXPECT_TRUE(unnamed.warns("images-by-name"));
  b.root["images"][0]["name"] = "paint";
  const Cooked named(read(b));
  EXPECT_STREQ(named.file.image(0).name, "paint");
  EXPECT_STREQ(named.file.image(0).uri, "");
  EXPECT_EQ(named.file.image(0).format, ImageFormat::png);
}

// Inside the source the name is all that finds an image again.
TEST(GltfLooks, ImagesOfEqualNamesGetNumbers) {
  Builder b = painted();
  const int png = b.view(std::vector<char>(kPng.begin(), kPng.end())),
            jpeg = b.view(std::vector<char>(kJpeg.begin(), kJpeg.end()));
  b.root["images"] = {{{"name", "face"}, {"bufferView", png}, {"mimeType", "image/png"}},
                      {{"name", "face"}, {"bufferView", jpeg}, {"mimeType", "image/jpeg"}},
                      {{"name", "face.2"}, {"bufferView", png}, {"mimeType", "image/png"}},
                      {{"name", "face"}, {"uri", "face.png"}}};
  b.root["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}, {{"source", 3}}};
  b.root["materials"][0].update(
      {{"normalTexture", {{"index", 1}}}, {"emissiveTexture", {{"index", 2}}}, {"occlusionTexture", {{"index", 3}}}});
  const Cooked cooked(read(b));
  EXPECT_TRUE(cooked.warns("images-numbered"));
  ASSERT_EQ(cooked.file.image_count(), 4U);
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < 4; ++i) names.emplace_back(cooked.file.image(i).name);
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"face", "face", "face.2", "face.3"})) << "one is a file of its own";
  b.root["images"][0]["name"] = "a";
  EXPECT_FALSE(Cooked(read(b)).warns("images-numbered"));
}

TEST(GltfLooks, EmbeddedBytesAreTheSourcesOwnAndOnce) {
  Builder b = painted();
  const int view = b.view(std::vector<char>(kPng.begin(), kPng.end()));
  b.root["images"] = {{{"name", "a"}, {"bufferView", view}, {"mimeType", "image/png"}},
                      {{"name", "b"}, {"uri", data_uri("image/png", kPng)}},
                      {{"name", "c"}, {"uri", data_uri("image/jpeg", kJpeg)}},
                      {{"name", "unused"}, {"uri", "not-there.png"}}};
  b.root["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}, {{"source", 3}}};
  b.root["materials"][0].update({{"normalTexture", {{"index", 1}}}, {"emissiveTexture", {{"index", 2}}}});
  const Cooked cooked(read_embedded(b), with(Images::embed));
  ASSERT_EQ(cooked.file.image_count(), 2U);
  EXPECT_EQ(text_of(cooked.file.image(0).bytes), kPng);
  EXPECT_EQ(cooked.file.image(0).format, ImageFormat::png);
  EXPECT_EQ(text_of(cooked.file.image(1).bytes), kJpeg);
  EXPECT_EQ(cooked.file.image(1).format, ImageFormat::jpeg);
  const Material material = cooked.file.material(0);
  ASSERT_EQ(material.textures.size, 3U);
  EXPECT_EQ(material.textures[0].image, 0U);
  EXPECT_EQ(material.textures[1].image, 0U) << "the same bytes";
  EXPECT_EQ(material.textures[2].image, 1U);
  EXPECT_FALSE(cooked.warns("images-by-name"));
}

TEST(GltfLooks, WhatIsNoPictureIsNotEmbedded) {
  Builder b = painted();
  b.root["images"] = {{{"uri", data_uri("image/gif", "GIF89a......")}, {"name", "w"}}};
  const Cooked gif(read_embedded(b), with(Images::embed));
  EXPECT_TRUE(gif.warns("image-format"));
  EXPECT_TRUE(gif.file.image(0).bytes.empty());
  b.root["images"] = {{{"uri", data_uri("image/png", kJpeg)}, {"mimeType", "image/png"}}};
  const Cooked liar(read_embedded(b), with(Images::embed));
  EXPECT_TRUE(liar.warns("image-mime-type"));
  EXPECT_EQ(liar.file.image(0).format, ImageFormat::jpeg);
}

const std::string kWebp("RIFF\x08\0\0\0WEBPVP8 ", 16), kKtx("\xABKTX 20\xBB\r\n\x1A\nrest", 16), kDds("DDS rest", 8);

// The base colour is a picture of one extension, with a PNG for those that do not know it.
Builder with_alternative(const char* extension, const std::string& mime, const std::string& bytes) {
  Builder b = painted();
  b.root["images"] = {{{"name", "small"}, {"uri", data_uri(mime, bytes)}},
                      {{"name", "plain"}, {"uri", data_uri("image/png", kPng)}}};
  b.root["textures"] = {{{"source", 1}, {"extensions", {{extension, {{"source", 0}}}}}}};
  b.root["extensionsUsed"] = {extension};
  return b;
}

TEST(GltfLooks, PicturesForGpusKeepTheirBytesAndAFallback) {
  const struct {
    const char *extension, *mime;
    std::string bytes;
    ImageFormat format;
  } kinds[] = {{"EXT_texture_webp", "image/webp", kWebp, ImageFormat::webp},
               {"KHR_texture_basisu", "image/ktx2", kKtx, ImageFormat::ktx2},
               {"MSFT_texture_dds", "image/vnd-ms.dds", kDds, ImageFormat::dds}};
  for (const auto& kind : kinds) {
    Builder b = with_alternative(kind.extension, kind.mime, kind.bytes);
    const Cooked cooked(read_embedded(b), with(Images::embed));
    EXPECT_EQ(cooked.result.report["warnings"].size(), 1U) << cooked.result.report["warnings"].dump();  // extra UVs
    ASSERT_EQ(cooked.file.image_count(), 2U) << kind.extension;
    const Image image = cooked.file.image(cooked.file.material(0).textures[0].image);
    EXPECT_EQ(image.format, kind.format);
    EXPECT_EQ(text_of(image.bytes), kind.bytes);
    ASSERT_NE(image.fallback, kNoImage);
    const Image plain = cooked.file.image(image.fallback);
    EXPECT_EQ(plain.format, ImageFormat::png);
    EXPECT_EQ(text_of(plain.bytes), kPng);
    EXPECT_EQ(plain.fallback, kNoImage);

    // A file that demands it, without another picture, and by reference.
    b.root["textures"][0].erase("source");
    b.root["extensionsRequired"] = {kind.extension};
    const Cooked alone(read(b));
    ASSERT_EQ(alone.file.image_count(), 1U);
    EXPECT_EQ(alone.file.image(0).format, kind.format) << "known by the extension";
    EXPECT_EQ(alone.file.image(0).fallback, kNoImage);
    EXPECT_TRUE(alone.file.image(0).bytes.empty());
  }
}

TEST(GltfLooks, OfSeveralPicturesTheBestForAGpuIsCarried) {
  Builder b = with_alternative("EXT_texture_webp", "image/webp", kWebp);
  b.root["images"].push_back({{"name", "gpu"}, {"uri", data_uri("image/ktx2", kKtx)}});
  b.root["textures"][0]["extensions"]["KHR_texture_basisu"] = {{"source", 2}};
  b.root["extensionsUsed"].push_back("KHR_texture_basisu");
  const Cooked cooked(read_embedded(b), with(Images::embed));
  EXPECT_TRUE(cooked.warns("texture-alternative"));
  EXPECT_EQ(cooked.file.image_count(), 2U);
  EXPECT_EQ(cooked.file.image(cooked.file.material(0).textures[0].image).format, ImageFormat::ktx2);
}

// Two pictures that stand in for each other, and one for itself.
TEST(GltfLooks, FallbacksThatAreNoneAreLeftOut) {
  Builder b = with_alternative("EXT_texture_webp", "image/webp", kWebp);
  b.root["images"][1] = {{"name", "plain"}, {"uri", data_uri("image/webp", kWebp + "2")}};
  b.root["textures"].push_back({{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}});
  b.root["materials"][0]["normalTexture"] = {{"index", 1}};
  const Cooked crossed(read_embedded(b), with(Images::embed));
  EXPECT_TRUE(crossed.warns("image-fallback"));
  for (std::uint32_t i = 0; i < crossed.file.image_count(); ++i)
    EXPECT_EQ(crossed.file.image(i).fallback, kNoImage) << i;
  b = with_alternative("EXT_texture_webp", "image/webp", kWebp);
  b.root["textures"][0]["source"] = 0;
  EXPECT_EQ(Cooked(read_embedded(b), with(Images::embed)).file.image(0).fallback, kNoImage);
}

TEST(GltfLooks, BrokenAlternativesAreRefused) {
  const std::string where = "/textures/0/extensions/KHR_texture_basisu";
  for (const Json& source : {Json(2), Json(-1), Json("0"), Json(1e300)}) {
    Builder b = with_alternative("KHR_texture_basisu", "image/ktx2", kKtx);
    b.root["textures"][0]["extensions"]["KHR_texture_basisu"]["source"] = source;
    expect_refused(b.text(), Exit::invalid, where + "/source", "");
  }
  Builder b = with_alternative("KHR_texture_basisu", "image/ktx2", kKtx);
  b.root["textures"][0]["extensions"]["KHR_texture_basisu"] = Json::array();
  expect_refused(b.text(), Exit::invalid, where, "");
}

TEST(GltfLooks, SpecularGlossinessGivesColourAndTextures) {
  Builder b = painted();
  b.root["textures"].push_back({{"source", 1}});
  b.root["images"].push_back({{"uri", "shine.png"}});
  const Json specular = {{"diffuseFactor", {.25, .5, .75, 1}},
                         {"diffuseTexture", {{"index", 0}}},
                         {"specularGlossinessTexture", {{"index", 1}}},
                         {"glossinessFactor", .5}};
  b.root["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
  b.root["materials"][0] = {{"extensions", {{"KHR_materials_pbrSpecularGlossiness", specular}}}};
  const RawScene scene = read(b);
  const RawMaterial& material = scene.materials[0];
  EXPECT_EQ(material.base_colour, glm::vec4(.25F, .5F, .75F, 1));
  ASSERT_EQ(material.textures.size(), 2U);
  EXPECT_EQ(material.textures[0].role, TextureRole::base_colour);
  EXPECT_EQ(material.textures[1].role, TextureRole::specular_glossiness);
  EXPECT_EQ(material.textures[1].image, 1);
  EXPECT_FALSE(warns(scene, "extension-ignored"));
  // What the metallic-roughness model says comes first.
  b.root["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 0, 0, 1}},
                                                    {"metallicRoughnessTexture", {{"index", 1}}}};
  const RawMaterial both = read(b).materials[0];
  EXPECT_EQ(both.base_colour, glm::vec4(1, 0, 0, 1));
  ASSERT_EQ(both.textures.size(), 2U);
  EXPECT_EQ(both.textures[0].role, TextureRole::base_colour);
  EXPECT_EQ(both.textures[1].role, TextureRole::metallic_roughness);
  b.root["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"]["diffuseFactor"] = {1, 2};
  expect_refused(b.text(), Exit::invalid, "/materials/0/extensions/KHR_materials_pbrSpecularGlossiness/diffuseFactor",
                 "");
}

TEST(GltfLooks, LightAndNoLight) {
  Builder b = painted();
  b.root["materials"][0] = {
      {"emissiveFactor", {1, .5, 0}},
      {"extensions",
       {{"KHR_materials_unlit", Json::object()}, {"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}};
  b.root["extensionsUsed"] = {"KHR_materials_unlit", "KHR_materials_emissive_strength"};
  const Cooked cooked(read(b));
  EXPECT_FALSE(cooked.warns("extension-ignored"));
  ASSERT_EQ(cooked.file.material_count(), 1U);
  const Material material = cooked.file.material(0);
  EXPECT_TRUE(material.unlit);
  EXPECT_EQ(material.emissive[0], 8);
  EXPECT_EQ(material.emissive[1], 4);
  EXPECT_EQ(material.emissive[2], 0);
  EXPECT_EQ(cooked.result.report["materials"][0]["emissive"].get<std::vector<int>>(), (std::vector<int>{8, 4, 0}));
  b.root["materials"][0]["emissiveFactor"] = {-1, 0, 0};
  const Cooked dark(read(b));
  EXPECT_TRUE(dark.warns("emission-negative"));
  EXPECT_EQ(dark.file.material(0).emissive[0], 0);
}

TEST(GltfLooks, NoneLeavesTheRestOfAMaterial) {
  Builder b = painted();
  b.root["materials"][0]["alphaMode"] = "BLEND";
  const Cooked cooked(read(b), with(Images::none));
  EXPECT_EQ(cooked.file.image_count(), 0U);
  ASSERT_EQ(cooked.file.material_count(), 1U);
  EXPECT_EQ(cooked.file.material(0).alpha, AlphaMode::blend);
  EXPECT_TRUE(cooked.file.material(0).textures.empty());
  b.root["materials"][0].erase("alphaMode");
  EXPECT_EQ(Cooked(read(b), with(Images::none)).file.material_count(), 0U) << "nothing is left to say";
}

TEST(GltfLooks, MeshesShareARecord) {
  Builder b = painted();
  b.root["materials"].push_back(b.root["materials"][0]);  // the same once more
  b.root["materials"].push_back({{"name", "plain"}, {"doubleSided", true}});
  for (int i = 0; i < 5; ++i) {
    b.root["meshes"][0]["primitives"].push_back(b.root["meshes"][0]["primitives"][0]);
    b.root["meshes"][0]["primitives"].back()["material"] = i % 3;
  }
  const Cooked cooked(read(b));
  ASSERT_EQ(cooked.file.mesh_count(), 6U);
  EXPECT_EQ(cooked.file.material_count(), 1U);
  EXPECT_EQ(cooked.file.image_count(), 1U);
  std::size_t plain = 0;
  for (std::uint32_t m = 0; m < 6; ++m) {
    const Mesh mesh = cooked.file.mesh(m);
    plain += mesh.material_index == kNoMaterial && mesh.double_sided && std::strcmp(mesh.material, "plain") == 0;
  }
  EXPECT_EQ(plain, 1U);
}

// The table's 16 bytes, a record of 12 and 8 a texture; 16 and 16 an image; padding; names.
TEST(GltfLooks, AMaterialTakesFewBytes) {
  Builder b = painted();
  const std::size_t full = Cooked(read(b)).result.file.size();
  b.root["materials"][0].erase("pbrMetallicRoughness");
  const std::size_t bare = Cooked(read(b)).result.file.size();
  EXPECT_GT(full, bare);
  EXPECT_LE(full, bare + 16 + 32 + 16 + 16 + 16 + sizeof "paint%20can.png" + sizeof "images[0]");
}

TEST(GltfLooks, HostileUrisAreRefusedWhoeverReads) {
  std::size_t refused = 0;
  for (const char* uri :
       {"../up.png", "a/../../b.png", "%2e%2e/up.png", "a%2f..%2f..%2fup.png", "/etc/passwd", "~/x.png",
        "http://example.org/x.png", "file:///etc/passwd", "C:/x.png", "a\\b.png", "a%00.png", "", "x%zz"}) {
    SCOPED_TRACE(uri);
    Builder b = painted();
    b.root["images"][0]["uri"] = uri;
    expect_refused(b.text(), Exit::invalid, "/images/0/uri", "");
    expect_failure([&] { read_embedded(b); }, Exit::invalid, "/images/0/uri", "");
    ++refused;
  }
  EXPECT_EQ(refused, 13U);
}

TEST(GltfLooks, HostileBytesAreRefused) {
  Builder b = painted();
  b.root["images"][0]["uri"] = "data:image/png;base64,iVBORw0K*";
  expect_failure([&] { read_embedded(b); }, Exit::invalid, "/images/0/uri", "malformed base64");
  b.root["images"][0]["uri"] = "data:image/png;base64";
  expect_failure([&] { read_embedded(b); }, Exit::invalid, "/images/0/uri", "malformed data URI");
  b = painted();
  expect_failure([&] { read_embedded(b); }, Exit::io, "/images/0/uri", "cannot read");  // memory has no folder
  b.root["images"] = {{{"bufferView", 99}, {"mimeType", "image/png"}}};
  expect_refused(b.text(), Exit::invalid, "/images/0/bufferView", "");
  b.root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 100000}});
  b.root["images"][0]["bufferView"] = b.root["bufferViews"].size() - 1;
  expect_failure([&] { read_embedded(b); }, Exit::invalid,
                 "/bufferViews/" + std::to_string(b.root["bufferViews"].size() - 1) + "/byteLength", "beyond");
}

// One view named by hundreds of images must not be copied so often.
TEST(GltfLooks, ImagesThatUnfoldAreRefused) {
  Builder b = painted();
  std::vector<char> large(1 << 20, 'x');
  std::copy(kPng.begin(), kPng.end(), large.begin());
  const int view = b.view(large);
  b.root["images"] = Json::array();
  b.root["textures"] = Json::array();
  b.root["materials"] = Json::array();
  for (int i = 0; i < 400; ++i) {
    b.root["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    b.root["textures"].push_back({{"source", i}});
    b.root["materials"].push_back({{"normalTexture", {{"index", i}}}});
  }
  try {
    read_embedded(b);
    ADD_FAILURE() << "400 MB from 1.4";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::unsupported) << failure.what();
    EXPECT_NE(failure.rule().find("unfolds"), std::string::npos) << failure.what();
  }
}

}  // namespace
}  // namespace marrow::cook
