// `marrow view` in a window of a screen that nobody sees, with a hand at it, and what its pictures show.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {

inline constexpr int kWindowWidth = 480, kWindowHeight = 360;
inline constexpr int kPanelPixels = 316;

// Rows from the top, 3 bytes a pixel; empty unless of this size.
inline std::vector<png_byte> picture(const std::string& path, int width, int height) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
  EXPECT_EQ(image.width, static_cast<unsigned>(width));
  EXPECT_EQ(image.height, static_cast<unsigned>(height));
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> out(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, out.data(), 0, nullptr), 0) << image.message;
  return out;
}

// A screen that nobody sees, for all windows: one takes longer to start than a window does.
class Screen {
 public:
  Screen() : server_({"-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp", "-noreset"}, "Xvfb") {
    for (int tries = 0; tries < 3000 && server_.out().find('\n') == std::string::npos; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_NE(server_.out(), "") << server_.err();
  }
  // What tells a program of it.
  std::string variable() const { return "DISPLAY=:" + server_.out().substr(0, server_.out().find('\n')); }

 private:
  RunningMarrow server_;
};

class ViewTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (std::system("command -v Xvfb >/dev/null 2>&1") == 0) screen() = std::make_unique<Screen>();
  }
  static void TearDownTestSuite() { screen().reset(); }
  static std::unique_ptr<Screen>& screen() {
    static std::unique_ptr<Screen> it;
    return it;
  }
  void SetUp() override {
    if (!screen()) GTEST_SKIP() << "SKIPPED: there is no Xvfb (Debian: xvfb)";
    ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", mrw()}).code, 0);
  }
  std::string mrw() const { return folder_ / "t.mrw"; }
  // On the screen, with more settings of the environment.
  static Ran on_screen(const std::vector<std::string>& settings, const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"env", screen()->variable()};
    all.insert(all.end(), settings.begin(), settings.end());
    all.insert(all.end(), {program(), "view"});
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(all);
  }
  Ran view(std::vector<std::string> options, const std::vector<std::string>& settings = {}) const {
    options.insert(options.begin(), mrw());
    return on_screen(settings, options);
  }
  std::vector<png_byte> shot(std::vector<std::string> options) const {
    options.insert(options.end(), {"--size", "480x360", "--screenshot", folder_ / "w.png", "--frames", "3"});
    const Ran ran = view(options);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return picture(folder_ / "w.png", kWindowWidth, kWindowHeight);
  }

  // The same with a hand at the window, until some frames behind its last act. frames: so many in all. report: what it
  // says of its graph.
  std::vector<png_byte> by_hand(const std::string& acts, std::vector<std::string> options, int frames = 0,
                                std::string* report = nullptr) const {
    const std::size_t last = acts.rfind('|') + 1;  // 0 where there is none
    if (frames == 0) frames = 4 + std::atoi(acts.c_str() + last) + (acts.find("copy") != std::string::npos ? 5 : 0);
    options.insert(options.end(),
                   {"--size", "480x360", "--screenshot", folder_ / "h.png", "--frames", std::to_string(frames)});
    const Ran ran = on_screen({"LD_PRELOAD=" + hand_shim(), "MARROW_HAND=" + acts}, options);
    EXPECT_EQ(ran.code, 0) << ran.err;
    const std::size_t line = ran.err.find('\n') + 1;
    if (report != nullptr) *report = ran.err.substr(line, ran.err.find('\n', line) - line);
    return picture(folder_ / "h.png", kWindowWidth, kWindowHeight);
  }
  std::vector<png_byte> shot_of(const std::string& file, std::vector<std::string> options) const {
    options.insert(options.begin(), file);
    return by_hand("", options);
  }

  TemporaryFolder folder_;
};

// The middle of the pixels of this colour beside the panel; none: nothing.
inline std::optional<std::pair<double, double>> middle_of(const std::vector<png_byte>& shot, int red, int green,
                                                          int blue) {
  double x_sum = 0, y_sum = 0, count = 0;
  for (int y = 0; y < kWindowHeight; ++y) {
    for (int x = kPanelPixels; x < kWindowWidth; ++x) {
      const png_byte* const p = &shot[static_cast<std::size_t>(3 * (y * kWindowWidth + x))];
      if (p[0] != red || p[1] != green || p[2] != blue) continue;
      x_sum += x;
      y_sum += y;
      count += 1;
    }
  }
  if (count == 0) return std::nullopt;
  return std::pair(x_sum / count, y_sum / count);
}

inline std::string coordinates(double x, double y) {
  return std::to_string(std::lround(x)) + " " + std::to_string(std::lround(y));
}

// Share of the pixels in these columns that differ by more than a rounding.
inline double difference(const std::vector<png_byte>& a, const std::vector<png_byte>& b, int first, int end,
                         int rounding = 2) {
  int different = 0;
  for (int y = 0; y < kWindowHeight; ++y) {
    for (int x = first; x < end; ++x) {
      const auto at = static_cast<std::size_t>(3 * (y * kWindowWidth + x));
      for (std::size_t c = at; c < at + 3; ++c) {
        if (std::abs(a[c] - b[c]) <= rounding) continue;
        ++different;
        break;
      }
    }
  }
  return static_cast<double>(different) / ((end - first) * kWindowHeight);
}

}  // namespace marrow::test
