// Textures in pictures: the right texel in the right corner, holes, and pictures that nobody can decode.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include "support/places.h"
#include "unit/cook/gltf_document.h"

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

// Where a hue is in a picture: pixels, and their middle.
struct Patch {
  std::size_t count = 0;
  double x = 0, y = 0;
};

class TexturedQuad : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("marrow_texture_" + std::to_string(::getpid()));
    fs::create_directories(folder_ / "elsewhere");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  static int run(const std::string& arguments) {
    const int status = std::system((test::program() + " " + arguments + " >/dev/null 2>&1").c_str());
    return status < 0 ? -1 : status / 256;
  }

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
  void cook(Builder b, const std::string& options) const {
    write("quad.gltf", b.text());
    ASSERT_EQ(run("cook " + path("quad.gltf") + " -o " + path("quad.mrw") + " " + options), 0);
  }
  int render(const std::string& options = "") const {
    fs::remove(path("quad.png"));
    return run("render " + path("quad.mrw") + " --size 240x200 " + options + " -o " + path("quad.png"));
  }

  // Pixels in which the channels of `high` are at least twice as bright as the others.
  Patch patch(const std::array<bool, 3>& high) const {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path("quad.png").c_str()), 0);
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> rgb(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0);
    Patch out;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
      int low_most = 0, high_least = 255;
      for (std::size_t c = 0; c < 3; ++c) {
        if (high[c]) high_least = std::min(high_least, int{rgb[i + c]});
        if (!high[c]) low_most = std::max(low_most, int{rgb[i + c]});
      }
      if (high_least < 60 || high_least < 2 * low_most) continue;
      ++out.count;
      out.x += static_cast<double>(i / 3 % image.width);
      out.y += static_cast<double>(i / 3 / image.width);
    }
    if (out.count > 0) {
      out.x /= static_cast<double>(out.count);
      out.y /= static_cast<double>(out.count);
    }
    return out;
  }
  Patch red() const { return patch({true, false, false}); }
  Patch green() const { return patch({false, true, false}); }
  Patch blue() const { return patch({false, false, true}); }
  Patch yellow() const { return patch({true, true, false}); }

  void expect_corners() const {
    const Patch r = red(), g = green(), b = blue(), y = yellow();
    for (const Patch& p : {r, g, b, y}) EXPECT_GT(p.count, 1000u);
    EXPECT_LT(r.x + 20, g.x) << "red is left of green";
    EXPECT_LT(b.x + 20, y.x) << "blue is left of yellow";
    EXPECT_LT(r.y + 20, b.y) << "red is above blue";
    EXPECT_LT(g.y + 20, y.y) << "green is above yellow";
  }

 private:
  fs::path folder_;
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
  fs::rename(path("a b.png"), path("elsewhere/a b.png"));
  ASSERT_EQ(render(), 0) << "what is not there is not drawn";
  EXPECT_EQ(red().count + green().count + blue().count, 0u);
  ASSERT_EQ(render("--images-from " + path("elsewhere")), 0);
  expect_corners();
  EXPECT_EQ(render("--images-from " + path("nowhere")), 1);
}

TEST_F(TexturedQuad, LinksOutOfTheFolderAreRefused) {
  write("elsewhere/a.png", encode(2, 2, corners()));
  fs::create_directory(path("here"));
  fs::create_symlink(path("elsewhere/a.png"), path("here/a.png"));
  cook(quad("a.png"), "");
  EXPECT_EQ(render("--images-from " + path("here")), 3);
  EXPECT_FALSE(fs::exists(path("quad.png")));
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
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path("quad.png").c_str()), 0);
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> rgb(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0);
    const std::size_t middle = 3 * (std::size_t{100} * 240 + 120);
    return int{rgb[middle]} - int{rgb[middle + 2]};
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
    EXPECT_FALSE(fs::exists(path("quad.png")));
    ++refused;
  }
  EXPECT_EQ(refused, 3u);
}

}  // namespace
}  // namespace marrow::cook
