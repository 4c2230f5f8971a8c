// Textures in pictures: the right texel in the right corner, holes, and pictures that nobody can decode.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "gl/support/rendered.h"

namespace marrow::cook {
namespace {

namespace fs = std::filesystem;

std::string encode(unsigned width, unsigned height, const std::vector<std::uint8_t>& rgba) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = PNG_FORMAT_RGBA;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, rgba.data(), 0, nullptr), 0);
  bytes.resize(size);
  return bytes;
}

// Top row red, green; bottom row blue, yellow.
std::vector<std::uint8_t> corners(std::uint8_t left_alpha = 255) {
  return {255, 0, 0, left_alpha, 0, 255, 0, 255, 0, 0, 255, left_alpha, 255, 255, 0, 255};
}

class TexturedQuad : public Rendered {
 protected:
  // Faces the camera, from (-1, -1) to (1, 1). The corner at the upper left has (0, 0), as in the image.
  Builder quad(const std::string& uri, const std::string& alpha = "OPAQUE") const {
    Builder b;
    const int positions = b.positions({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    const int uvs = b.numbers<float>(kF32, "VEC2", 2, {0, 1, 1, 1, 1, 0, 0, 0});
    Json& primitive = b.primitive({{"POSITION", positions}, {"TEXCOORD_0", uvs}});
    primitive["indices"] = b.numbers<std::uint16_t>(kU16, "SCALAR", 1, {0, 1, 2, 0, 2, 3});
    primitive["material"] = 0;
    b.root["materials"] = {{{"alphaMode", alpha}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    b.root["textures"] = {{{"source", 0}, {"sampler", 0}}};
    b.root["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33071}}};
    b.root["images"] = {{{"uri", uri}}};
    return b;
  }
  static std::string data_uri(const std::string& bytes) {
    return "data:image/png;base64," + base64(std::as_bytes(std::span(bytes.data(), bytes.size())));
  }
  // What drawing says, with success.
  std::string rendered_words(const std::string& options) const {
    const std::string command = test::program() + " render " + path("document.mrw") + " --size 240x200 " + options +
                                " -o " + path("document.png") + " 2> " + path("words");
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream stream(path("words"));
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  Patch red() const { return patch_of(pixels(), {true, false, false}); }
  Patch green() const { return patch_of(pixels(), {false, true, false}); }
  Patch blue() const { return patch_of(pixels(), {false, false, true}); }
  Patch yellow() const { return patch_of(pixels(), {true, true, false}); }

  void expect_corners() const {
    const Patch r = red(), g = green(), b = blue(), y = yellow();
    for (const Patch& p : {r, g, b, y}) EXPECT_GT(p.count, 1000u);
    EXPECT_LT(r.x + 20, g.x) << "red is left of green";
    EXPECT_LT(b.x + 20, y.x) << "blue is left of yellow";
    EXPECT_LT(r.y + 20, b.y) << "red is above blue";
    EXPECT_LT(g.y + 20, y.y) << "green is above yellow";
  }
};

TEST_F(TexturedQuad, ShowsEachTexelInItsCorner) {
  cook(quad(data_uri(encode(2, 2, corners()))), "--images embed");
  for (const char* options : {"--path ubo", "--path cpu", "--path ubo --deformer as"}) {
    SCOPED_TRACE(options);
    ASSERT_EQ(render(options), 0);
    expect_corners();
  }
}

TEST_F(TexturedQuad, FindsPicturesByReference) {
  write("a b.png", encode(2, 2, corners()));
  cook(quad("a%20b.png"), "");
  ASSERT_EQ(render(), 0);
  expect_corners();
  fs::create_directory(path("elsewhere"));
  fs::rename(path("a b.png"), path("elsewhere/a b.png"));
  ASSERT_EQ(render(), 0) << "what is not there is not drawn";
  EXPECT_EQ(red().count + green().count + blue().count, 0u);
  ASSERT_EQ(render("--images-from " + path("elsewhere")), 0);
  expect_corners();
  EXPECT_EQ(render("--images-from " + path("nowhere")), 1);
}

// By default a cooked file knows it by name alone.
TEST_F(TexturedQuad, FindsPicturesInTheSource) {
  Builder b = quad("");
  const std::string red_png = encode(1, 1, {255, 0, 0, 255}), png = encode(2, 2, corners());
  b.root["images"] = {{{"name", "face"}, {"uri", data_uri(png)}}, {{"name", "face"}, {"uri", data_uri(red_png)}}};
  cook(b, "");
  ASSERT_EQ(render(), 0) << "the source is beside the cooked file";
  expect_corners();
  fs::create_directory(path("elsewhere"));
  fs::rename(path("document.gltf"), path("elsewhere/art.gltf"));
  EXPECT_NE(rendered_words("").find("image 0 \"face\": drawn without: it lies inside the source"), std::string::npos);
  EXPECT_EQ(red().count, 0u);
  ASSERT_EQ(render("--images-from " + path("elsewhere/art.gltf")), 0);
  expect_corners();
}

// Black surfaces: what is seen is their own light.
TEST_F(TexturedQuad, WhatEmitsIsSeenWhereItsTextureSays) {
  const auto black = [&](const std::string& png) {
    Builder b = quad(data_uri(png));
    b.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}}}};
    return b;
  };
  const std::string png = encode(2, 2, corners());
  Builder textured = black(png);
  textured.root["materials"][0]["emissiveFactor"] = {1, 1, 1};
  textured.root["materials"][0]["emissiveTexture"] = {{"index", 0}};
  cook(textured, "--images embed");
  ASSERT_EQ(render("--path ubo"), 0);
  expect_corners();
  textured.root["materials"][0]["emissiveFactor"] = {1, 0, 0};
  cook(textured, "--images embed");
  ASSERT_EQ(render("--path cpu"), 0);
  EXPECT_GT(red().count, 2000u) << "red and yellow";
  EXPECT_EQ(green().count + yellow().count + blue().count, 0u);
  Builder plain = black(png);
  plain.root["materials"][0]["emissiveFactor"] = {0, 1, 0};
  cook(plain, "");
  ASSERT_EQ(render(), 0);
  EXPECT_GT(green().count, 4000u);
  // As KHR_materials_unlit has it, its base colour is all that is seen.
  plain.root["materials"][0]["extensions"] = {{"KHR_materials_unlit", nlohmann::json::object()}};
  plain.root["extensionsUsed"] = {"KHR_materials_unlit"};
  cook(plain, "");
  ASSERT_EQ(render(), 0);
  EXPECT_EQ(green().count, 0u);
  // Where it emits is not known.
  textured.root["images"][0]["uri"] = data_uri(png.substr(0, 40));
  cook(textured, "--images embed");
  ASSERT_EQ(render(), 0);
  EXPECT_EQ(red().count, 0u);
}

TEST_F(TexturedQuad, TheDemoShowsTheSourcesPictures) {
  write("face.gltf", quad(data_uri(encode(2, 2, corners()))).text());
  ASSERT_EQ(run("demo " + path("face.gltf") + " -o " + path("out")), 0);
  const Pixels sheet = read_png(path("out/face.png"));
  EXPECT_GT(patch_of(sheet, {true, false, false}).count, 20000u);
  EXPECT_GT(patch_of(sheet, {true, true, false}).count, 20000u);
}

TEST_F(TexturedQuad, PicturesOfOneNameAreNotMistakenForEachOther) {
  Builder b = quad("");
  b.root["images"] = {{{"name", "face"}, {"uri", data_uri(encode(2, 2, corners()))}},
                      {{"name", "face"}, {"uri", data_uri(encode(1, 1, {255, 0, 0, 255}))}}};
  b.root["textures"].push_back({{"source", 1}});
  b.root["materials"][0]["emissiveTexture"] = {{"index", 1}};
  cook(b, "");
  ASSERT_EQ(render(), 0);
  expect_corners();
}

TEST_F(TexturedQuad, LinksOutOfTheFolderAreNotFollowed) {
  fs::create_directory(path("elsewhere"));
  write("elsewhere/a.png", encode(2, 2, corners()));
  fs::create_directory(path("here"));
  fs::create_symlink(path("elsewhere/a.png"), path("here/a.png"));
  cook(quad("a.png"), "");
  const std::string said = rendered_words("--images-from " + path("here"));
  EXPECT_NE(said.find("drawn without: URI not allowed"), std::string::npos) << said;
  EXPECT_EQ(red().count, 0u);
}

TEST_F(TexturedQuad, MaskAndBlend) {
  const std::string holes = data_uri(encode(2, 2, corners(0)));
  cook(quad(holes, "OPAQUE"), "--images embed");
  ASSERT_EQ(render(), 0);
  expect_corners();  // alpha has no say
  const std::size_t greens = green().count;
  for (const char* mode : {"MASK", "BLEND"}) {
    SCOPED_TRACE(mode);
    cook(quad(holes, mode), "--images embed");
    ASSERT_EQ(render(), 0);
    EXPECT_EQ(red().count + blue().count, 0u);
    EXPECT_GT(green().count, greens * 9 / 10);
  }
}

// Half of the light behind shows through: the backdrop there is bluish grey, so red is less of what is seen.
TEST_F(TexturedQuad, BlendIsBetween) {
  const auto redness = [&](const char* mode, std::uint8_t alpha) {
    cook(quad(data_uri(encode(1, 1, {255, 0, 0, alpha})), mode), "--images embed");
    EXPECT_EQ(render(), 0);
    const Pixels picture = pixels();
    const png_byte* const middle = picture.at(120, 100);
    return int{middle[0]} - int{middle[2]};
  };
  const int opaque = redness("OPAQUE", 128), half = redness("BLEND", 128), none = redness("BLEND", 0);
  EXPECT_GT(opaque, half + 10);
  EXPECT_GT(half, none + 10);
}

TEST_F(TexturedQuad, OfDamagedPicturesTheMaterialsColourIsDrawn) {
  const std::string good = encode(2, 2, corners());
  std::string huge = good;  // 65538 pixels wide; stb_image reads no checksums
  huge[17] = 1;
  std::size_t named = 0;
  for (const std::string& bytes : {good.substr(0, 40), huge, good.substr(0, 8) + std::string(64, 'x')}) {
    Builder b = quad(data_uri(bytes));
    b.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0, 1, 0, 1};
    b.root["images"][0]["name"] = "face";
    cook(b, "--images embed");
    const std::string said = rendered_words("");
    named += said.find("image 0 \"face\": drawn without: no PNG or JPEG that can be decoded") != std::string::npos;
    EXPECT_GT(green().count, 4000u);
    EXPECT_EQ(red().count, 0u);
  }
  EXPECT_EQ(named, 3u);
}

}  // namespace
}  // namespace marrow::cook
