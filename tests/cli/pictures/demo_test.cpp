// `marrow demo`: where its contact sheet says that plain skinning is worst, by how much, and that it shows it.
#ifdef MARROW_HAS_GLES
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
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
  static constexpr int kMoments = 4;
  static constexpr double kBendSeconds = 2.75;

  // The table on stdout, a source each: by heading what stands below it.
  std::vector<std::map<std::string, std::string>> shown(const std::vector<std::string>& sources) const {
    std::vector<std::string> arguments = {"demo", "-o", folder_ / "out"};
    arguments.insert(arguments.end(), sources.begin(), sources.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::vector<std::vector<std::string>> lines;
    std::istringstream text(ran.out);
    for (std::string line; lines.size() <= sources.size() && std::getline(text, line);) {
      std::vector<std::string>& cells = lines.emplace_back();
      for (std::size_t at = 0, end = 0; end != std::string::npos; at = line.find_first_not_of(' ', end)) {
        end = line.find("  ", at);
        cells.push_back(line.substr(at, end == std::string::npos ? end : end - at));
      }
    }
    std::vector<std::map<std::string, std::string>> out(sources.size());
    for (std::size_t row = 0; row < out.size(); ++row) {
      EXPECT_EQ(lines.at(row + 1).size(), lines[0].size());
      for (std::size_t c = 0; c < lines[0].size(); ++c) out[row][lines[0][c]] = lines[row + 1].at(c);
    }
    return out;
  }
  // The sleeve's vertices in the source's order, cooked with these options.
  std::vector<std::array<double, 3>> posed(double time_s, const std::vector<std::string>& options,
                                           const std::string& deformer) const {
    std::vector<std::string> cook = {"cook", in_golden("elbow.gltf"), "--keep-vertex-order", "-o", folder_ / "p.mrw"};
    cook.insert(cook.end(), options.begin(), options.end());
    EXPECT_EQ(run_marrow(cook).code, 0);
    const Ran ran = run_marrow({"pose", folder_ / "p.mrw", "--clip", "bend", "--time", std::to_string(time_s),
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
TEST_F(DemoTest, ShowsWherePlainSkinningIsWorst) {
  std::string whole = read_text(in_golden("elbow.gltf"));
  const std::string bends = R"("target": {"node": 1,)";
  ASSERT_NE(whole.find(bends), std::string::npos);
  whole.replace(whole.find(bends), bends.size(), R"("target": {"node": 0,)");
  write_text(folder_ / "whole.gltf", whole);
  const auto rows = shown({in_golden("elbow.gltf"), folder_ / "whole.gltf"});
  EXPECT_EQ(rows[1].at("worst joint"), "-");
  EXPECT_EQ(rows[1].at("apart"), "0 mm");
  EXPECT_EQ(rows[0].at("worst joint"), "lower");
  EXPECT_EQ(rows[0].at("clip"), "bend");
  const double worst_s = std::atof(rows[0].at("at s").c_str());
  EXPECT_GT(worst_s, 0);
  // Plain skinning is that of the source's own weights, cooked without helpers, at four moments, the worst among them.
  double largest_m = 0;
  for (int i = 0; i < kMoments; ++i) {
    const double time_s = std::fmod(worst_s, kBendSeconds / kMoments) + kBendSeconds * i / kMoments;
    const auto plain = posed(time_s, {}, "ssd"), as = posed(time_s, {"--as", "fit", "--helpers", "auto"}, "as");
    ASSERT_EQ(plain.size(), as.size());
    ASSERT_GT(plain.size(), 8u);
    for (std::size_t v = 0; v < plain.size(); ++v)
      largest_m =
          std::max(largest_m, std::hypot(plain[v][0] - as[v][0], plain[v][1] - as[v][1], plain[v][2] - as[v][2]));
  }
  EXPECT_NEAR(std::atof(rows[0].at("apart").c_str()), 1000 * largest_m, 0.02 * 1000 * largest_m);

  // The first row: three cells of 408 by 360, of which the last one glows in its middle, and the others differ.
  const Picture picture = sheet("elbow.png");
  EXPECT_GT(picture.height, sheet("whole.png").height + 300);
  constexpr std::size_t kEdge = 24, kGap = 4, kTop = 104, kCell = 408, kTall = 360;
  ASSERT_EQ(picture.width, 2 * kEdge + 3 * kCell + 2 * kGap);
  EXPECT_EQ(picture.width, 1280u);
  double count = 0, x_sum = 0, y_sum = 0, differ = 0;
  for (std::size_t y = 0; y < kTall; ++y) {
    for (std::size_t x = 0; x < kCell; ++x) {
      const png_byte* const heat = picture.pixel(kEdge + 2 * (kCell + kGap) + x, kTop + y);
      const png_byte* const plain = picture.pixel(kEdge + x, kTop + y);
      const png_byte* const as = picture.pixel(kEdge + kCell + kGap + x, kTop + y);
      differ += std::equal(plain, plain + 3, as) ? 0 : 1;
      if (heat[0] - heat[2] < 60) continue;
      ++count;
      x_sum += double(x);
      y_sum += double(y);
    }
  }
  EXPECT_GT(count, 0.01 * kCell * kTall);
  EXPECT_NEAR(x_sum / count, kCell / 2.0, kCell / 5.0);
  EXPECT_NEAR(y_sum / count, kTall / 2.0, kTall / 5.0);
  EXPECT_GT(differ, 0.01 * kCell * kTall);
}

}  // namespace
}  // namespace marrow::test
#endif
