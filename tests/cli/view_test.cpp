// `marrow view` in a window of a screen that nobody sees.
#ifdef MARROW_HAS_VIEW
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "cli/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

constexpr int kWindowWidth = 480, kWindowHeight = 360;
constexpr int kPanelPixels = 316;

// Rows from the top, 3 bytes a pixel; empty unless of this size.
std::vector<png_byte> picture(const std::string& path, int width, int height) {
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

class ViewTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "SKIPPED: there is no xvfb-run (Debian: xvfb and xauth)";
    ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", mrw()}).code, 0);
  }
  std::string mrw() const { return folder_ / "t.mrw"; }
  Ran view(const std::vector<std::string>& options) const {
    std::vector<std::string> all = {"xvfb-run", "-a", "-s", "-screen 0 800x600x24", program(), "view", mrw()};
    all.insert(all.end(), options.begin(), options.end());
    // On a busy machine its server may write into the folder that xvfb-run deletes, whose complaint replaces the exit
    // code.
    for (int tries = 0;; ++tries) {
      Ran ran = run_program(all);
      if (tries == 4 || ran.err.find("xvfb-run: error: problem while cleaning up") == std::string::npos) return ran;
    }
  }
  std::vector<png_byte> shot(std::vector<std::string> options) const {
    options.insert(options.end(), {"--size", "480x360", "--screenshot", folder_ / "w.png", "--frames", "3"});
    const Ran ran = view(options);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return picture(folder_ / "w.png", kWindowWidth, kWindowHeight);
  }

  TemporaryFolder folder_;
};

// Share of the pixels in these columns that differ by more than a rounding.
double difference(const std::vector<png_byte>& a, const std::vector<png_byte>& b, int first, int end) {
  int different = 0;
  for (int y = 0; y < kWindowHeight; ++y) {
    for (int x = first; x < end; ++x) {
      const auto at = static_cast<std::size_t>(3 * (y * kWindowWidth + x));
      for (std::size_t c = at; c < at + 3; ++c) {
        if (std::abs(a[c] - b[c]) <= 2) continue;
        ++different;
        break;
      }
    }
  }
  return static_cast<double>(different) / ((end - first) * kWindowHeight);
}

TEST_F(ViewTest, ShowsThePictureBesideThePanel) {
  const std::vector<png_byte> window = shot({"--clip", "point"});
  std::set<std::vector<png_byte>> panel, beside;
  for (std::size_t i = 0; i < window.size(); i += 3) {
    const bool is_panel = static_cast<int>(i / 3) % kWindowWidth < kPanelPixels;
    (is_panel ? panel : beside).insert({window[i], window[i + 1], window[i + 2]});
  }
  EXPECT_GT(panel.size(), 10u) << "text and widgets";
  EXPECT_GT(beside.size(), 100u) << "light and shadow";
  EXPECT_EQ(panel.contains({20, 25, 31}), true) << "the panel's ground";

  // What `marrow render` draws of the size and in the place of the picture.
  ASSERT_EQ(run_marrow({"render", mrw(), "--clip", "point", "--size", "164x360", "-o", folder_ / "r.png"}).code, 0);
  const std::vector<png_byte> render = picture(folder_ / "r.png", kWindowWidth - kPanelPixels, kWindowHeight);
  std::vector<png_byte> placed(window.size());
  for (std::size_t i = 0; i < render.size(); ++i) {
    const std::size_t row = i / (3 * (kWindowWidth - kPanelPixels)), column = i % (3 * (kWindowWidth - kPanelPixels));
    placed[3 * (row * kWindowWidth + kPanelPixels) + column] = render[i];
  }
  EXPECT_GT(difference(window, placed, 0, kPanelPixels), 0.99);
  EXPECT_LT(difference(window, placed, kPanelPixels, kWindowWidth), 0.01);
}

TEST_F(ViewTest, OptionsAreWhereThePanelBegins) {
  const std::vector<std::string> at = {"--clip", "wave", "--time", "0.5"};
  const std::vector<png_byte> plain = shot(at);
  for (const std::vector<std::string>& option :
       {std::vector<std::string>{"--bones"}, {"--heatmap", "rigid:ssd"}, {"--weights", "elbow"}, {"--time", "1"}}) {
    std::vector<std::string> options = at;
    if (option[0] == "--time") options.resize(2);
    options.insert(options.end(), option.begin(), option.end());
    EXPECT_GT(difference(plain, shot(options), kPanelPixels, kWindowWidth), 0.002) << option[0];
  }
  // On the processor and in the vertex shader, it looks alike.
  std::vector<std::string> cpu = at;
  cpu.insert(cpu.end(), {"--path", "cpu"});
  EXPECT_LT(difference(plain, shot(cpu), kPanelPixels, kWindowWidth), 0.01);
}

// With a driver that is reset as a frame ends, `at` of them in the process: the window comes back with what it showed.
TEST_F(ViewTest, OutlivesAResetOfTheDriver) {
  const std::vector<std::string> options = {"--clip", "wave", "--time", "0.5"};
  const std::vector<png_byte> plain = shot(options);
  const auto spoilt = [&](const char* at) {
    std::vector<std::string> all = {"xvfb-run",
                                    "-a",
                                    "-s",
                                    "-screen 0 800x600x24",
                                    "env",
                                    "LD_PRELOAD=" + reset_shim(),
                                    std::string("MARROW_RESET_AT=") + at,
                                    program(),
                                    "view",
                                    mrw(),
                                    "--size",
                                    "480x360",
                                    "--screenshot",
                                    folder_ / "s.png",
                                    "--frames",
                                    "3"};
    all.insert(all.end(), options.begin(), options.end());
    return run_program(all);
  };
  const std::string message = "OpenGL ES: the graphics processor was reset: ";
  const Ran twice = spoilt("9 18");
  EXPECT_EQ(twice.code, 0) << twice.err;
  const std::size_t first = twice.err.find(message + "the window is opened anew");
  ASSERT_NE(first, std::string::npos) << twice.err;
  EXPECT_NE(twice.err.find(message, first + 1), std::string::npos) << twice.err;
  EXPECT_LT(difference(plain, picture(folder_ / "s.png", kWindowWidth, kWindowHeight), kPanelPixels, kWindowWidth),
            0.001);
  // Before there is a frame there is no use in another try.
  const Ran always = spoilt("1");
  EXPECT_EQ(always.code, 5) << always.err;
  EXPECT_NE(always.err.find(message + "try again"), std::string::npos) << always.err;
}

TEST_F(ViewTest, SaysWhatIsWrong) {
  const Ran joint = view({"--weights", "nose", "--screenshot", folder_ / "w.png"});
  EXPECT_EQ(joint.code, 1);
  EXPECT_NE(joint.err.find("no joint \"nose\""), std::string::npos) << joint.err;
  EXPECT_EQ(run_marrow({"view", mrw(), "--frames", "3"}).code, 1);
  EXPECT_EQ(run_marrow({"view", mrw(), "--weights", "a", "--heatmap", "ssd:as"}).code, 1);
  const Ran blind = run_program({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", program(), "view", mrw()});
  EXPECT_EQ(blind.code, 4);
  ASSERT_EQ(blind.complaints().size(), 1u) << blind.err;
  EXPECT_EQ(blind.err.find("window: "), 0u) << blind.err;
}

}  // namespace
}  // namespace marrow::test
#endif
