// `marrow demo`: which joint its contact sheet says to be the worst, by how much, and that it shows it.
#ifdef MARROW_HAS_GLES
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

// A sleeve round the joints "upper", at its end, and "lower", in its middle, which bends in the clip "bend", 2.75 s.
class DemoTest : public ::testing::Test {
 protected:
  static constexpr int kMoments = 6;
  static constexpr double kBendSeconds = 2.75;

  // The lines of the table on stdout, a source each.
  std::vector<std::string> shown(const std::vector<std::string>& sources) const {
    std::vector<std::string> arguments = {"demo", "-o", folder_ / "out"}, out(sources.size());
    arguments.insert(arguments.end(), sources.begin(), sources.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::istringstream lines(ran.out);
    std::string heading;
    std::getline(lines, heading);
    EXPECT_NE(heading.find("worst joint"), std::string::npos) << heading;
    for (std::string& line : out) std::getline(lines, line);
    return out;
  }
  std::vector<std::array<double, 3>> posed(double time_s, const std::string& deformer) const {
    const Ran ran = run_marrow({"pose", folder_ / "out/elbow.mrw", "--clip", "bend", "--time", std::to_string(time_s),
                                "--deformer", deformer, "-o", folder_ / "p.obj"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::vector<std::array<double, 3>> out;
    std::istringstream lines(read_text(folder_ / "p.obj"));
    for (std::string line; std::getline(lines, line);) {
      std::array<double, 3> p{};
      if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p[0], &p[1], &p[2]) == 3) out.push_back(p);
    }
    return out;
  }
  struct Picture {
    std::size_t width, height;
    std::vector<png_byte> rgb;
    const png_byte* pixel(std::size_t x, std::size_t y) const { return rgb.data() + 3 * (y * width + x); }
  };
  Picture sheet(const char* name) const {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, (folder_ / "out/" + name).c_str()), 0);
    image.format = PNG_FORMAT_RGB;
    Picture out{image.width, image.height, std::vector<png_byte>(PNG_IMAGE_SIZE(image))};
    EXPECT_NE(png_image_finish_read(&image, nullptr, out.rgb.data(), 0, nullptr), 0);
    return out;
  }

  TemporaryFolder folder_;
};

// What moves as a whole is the same by any deformer: there is no worst joint, and no row for it.
TEST_F(DemoTest, NamesAndShowsTheWorstJoint) {
  std::string whole = read_text(in_golden("elbow.gltf"));
  const std::string bends = R"("target": {"node": 1,)";
  ASSERT_NE(whole.find(bends), std::string::npos);
  whole.replace(whole.find(bends), bends.size(), R"("target": {"node": 0,)");
  write_text(folder_ / "whole.gltf", whole);
  const std::vector<std::string> lines = shown({in_golden("elbow.gltf"), folder_ / "whole.gltf"});
  EXPECT_EQ(lines[1].find(" lower "), std::string::npos) << lines[1];
  EXPECT_EQ(lines[1].find(" upper "), std::string::npos) << lines[1];
  const std::string& line = lines[0];
  EXPECT_NE(line.find(" lower "), std::string::npos) << line;
  double largest_m = 0, when_s = 0;
  for (int i = 0; i < kMoments; ++i) {
    const double time_s = kBendSeconds * i / kMoments;
    const auto ssd = posed(time_s, "ssd"), as = posed(time_s, "as");
    ASSERT_EQ(ssd.size(), as.size());
    ASSERT_GT(ssd.size(), 8u);
    for (std::size_t v = 0; v < ssd.size(); ++v) {
      const double d = std::hypot(ssd[v][0] - as[v][0], ssd[v][1] - as[v][1], ssd[v][2] - as[v][2]);
      if (d > largest_m) when_s = time_s;
      largest_m = std::max(largest_m, d);
    }
  }
  EXPECT_GT(when_s, 0);
  EXPECT_NE(line.find(" " + std::to_string(std::lround(1000 * largest_m)) + " mm "), std::string::npos) << line << "\n"
                                                                                                        << largest_m;

  // The last row: three cells of 604 by 440, of which the last one glows in its middle, and the others differ.
  const Picture picture = sheet("elbow.png");
  EXPECT_GT(picture.height, sheet("whole.png").height + 400);
  constexpr std::size_t kEdge = 28, kGap = 4, kBelow = 44, kCell = 604, kTall = 440;
  ASSERT_EQ(picture.width, 2 * kEdge + 3 * kCell + 2 * kGap);
  const std::size_t top = picture.height - kBelow - kTall;
  double count = 0, x_sum = 0, y_sum = 0, differ = 0;
  for (std::size_t y = 0; y < kTall; ++y) {
    for (std::size_t x = 0; x < kCell; ++x) {
      const png_byte* const heat = picture.pixel(kEdge + 2 * (kCell + kGap) + x, top + y);
      const png_byte* const ssd = picture.pixel(kEdge + x, top + y);
      const png_byte* const as = picture.pixel(kEdge + kCell + kGap + x, top + y);
      differ += std::equal(ssd, ssd + 3, as) ? 0 : 1;
      if (heat[0] - heat[2] < 100) continue;
      ++count;
      x_sum += double(x);
      y_sum += double(y);
    }
  }
  EXPECT_GT(count, 0.01 * kCell * kTall);
  EXPECT_NEAR(x_sum / count, kCell / 2.0, kCell / 6.0);
  EXPECT_NEAR(y_sum / count, kTall / 2.0, kTall / 6.0);
  EXPECT_GT(differ, 0.01 * kCell * kTall);
}

}  // namespace
}  // namespace marrow::test
#endif
