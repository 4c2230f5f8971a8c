// Textures in pictures: the right texel in the right corner, holes, and pictures that nobody can decode.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "gl/rendered.h"

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

TEST_F(TexturedQuad, LinksOutOfTheFolderAreRefused) {
  fs::create_directory(path("elsewhere"));
  write("elsewhere/a.png", encode(2, 2, corners()));
  fs::create_directory(path("here"));
  fs::create_symlink(path("elsewhere/a.png"), path("here/a.png"));
  cook(quad("a.png"), "");
  EXPECT_EQ(render("--images-from " + path("here")), 3);
  EXPECT_FALSE(fs::exists(path("document.png")));
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

TEST_F(TexturedQuad, DamagedPicturesAreRefused) {
  const std::string good = encode(2, 2, corners());
  std::string huge = good;  // 65538 pixels wide; stb_image reads no checksums
  huge[17] = 1;
  std::size_t refused = 0;
  for (const std::string& bytes : {good.substr(0, 40), huge, good.substr(0, 8) + std::string(64, 'x')}) {
    cook(quad(data_uri(bytes)), "--images embed");
    EXPECT_EQ(render(), 3);
    EXPECT_FALSE(fs::exists(path("document.png")));
    ++refused;
  }
  EXPECT_EQ(refused, 3u);
}

}  // namespace
}  // namespace marrow::cook
