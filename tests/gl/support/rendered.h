// glTF documents as `marrow render` draws them.
#pragma once

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include "support/places.h"
#include "unit/cook/gltf/document.h"

namespace marrow::cook {

// Where a hue is in a picture: pixels, and their middle.
struct Patch {
  std::size_t count = 0;
  double x = 0, y = 0;
};

struct Pixels {
  std::size_t width = 0, height = 0;
  std::vector<png_byte> rgb;

  const png_byte* at(std::size_t x, std::size_t y) const { return rgb.data() + 3 * (y * width + x); }
};

inline Pixels read_png(const std::string& path) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << path;
  image.format = PNG_FORMAT_RGB;
  Pixels out{image.width, image.height, std::vector<png_byte>(PNG_IMAGE_SIZE(image))};
  EXPECT_NE(png_image_finish_read(&image, nullptr, out.rgb.data(), 0, nullptr), 0) << path;
  return out;
}

// Whether the channels of `high` are at least twice as bright as the others.
inline bool has_hue(const png_byte* rgb, const std::array<bool, 3>& high) {
  int low_most = 0, high_least = 255;
  for (std::size_t c = 0; c < 3; ++c) {
    if (high[c]) high_least = std::min(high_least, int{rgb[c]});
    if (!high[c]) low_most = std::max(low_most, int{rgb[c]});
  }
  return high_least >= 60 && high_least >= 2 * low_most;
}

// Pixels of that hue.
inline Patch patch_of(const Pixels& picture, const std::array<bool, 3>& high) {
  Patch out;
  for (std::size_t y = 0; y < picture.height; ++y) {
    for (std::size_t x = 0; x < picture.width; ++x) {
      if (!has_hue(picture.at(x, y), high)) continue;
      ++out.count;
      out.x += static_cast<double>(x);
      out.y += static_cast<double>(y);
    }
  }
  if (out.count > 0) {
    out.x /= static_cast<double>(out.count);
    out.y /= static_cast<double>(out.count);
  }
  return out;
}

// A document in a folder of its own: written, cooked, drawn 240 pixels wide and 200 high.
class Rendered : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("marrow_rendered_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  // Exit code of the program.
  static int run(const std::string& arguments) {
    const int status = std::system((test::program() + " " + arguments + " >/dev/null 2>&1").c_str());
    return status < 0 ? -1 : status / 256;
  }
  void cook(Builder b, const std::string& options = "") const {
    write("document.gltf", b.text());
    ASSERT_EQ(run("cook " + path("document.gltf") + " -o " + path("document.mrw") + " " + options), 0);
  }
  int render(const std::string& options = "") const {
    std::filesystem::remove(path("document.png"));
    return run("render " + path("document.mrw") + " --size 240x200 " + options + " -o " + path("document.png"));
  }
  Pixels pixels() const { return read_png(path("document.png")); }

 private:
  std::filesystem::path folder_;
};

}  // namespace marrow::cook
