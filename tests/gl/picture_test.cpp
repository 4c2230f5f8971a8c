// `marrow render` as a program: pictures that show something, and the same bytes however many threads the driver uses.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include "disk/cook_on_disk.h"
#include "gl/support/feedback.h"
#include "gl/support/models.h"
#include "gles3/palettes.h"
#include "marrow/gles3.h"
#include "support/millipede.h"
#include "support/places.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

class Picture : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("marrow_picture_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
               std::to_string(std::hash<std::string>{}(std::to_string(::getpid()))));
    fs::create_directories(folder_);
    fs::copy_file(cooked_newt(), path("newt.mrw"));
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  // Exit code of the program.
  static int run(const std::string& arguments, const std::string& environment = "") {
    const int status = std::system((environment + " " + program() + " " + arguments + " >/dev/null").c_str());
    return status < 0 ? -1 : status / 256;
  }
  int render(const std::string& options, const std::string& name, const std::string& environment = "") const {
    return run("render " + path("newt.mrw") + " --clip 0 --time 0.5 --size 200x160 " + options + " -o " + path(name),
               environment);
  }
  std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::vector<png_byte> pixels(const std::string& name) const {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path(name).c_str()), 0);
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> out(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, out.data(), 0, nullptr), 0);
    return out;
  }

 private:
  // Cooked once for all tests; its folder goes with the process.
  static fs::path cooked_newt() {
    struct Once {
      Once() : folder(fs::temp_directory_path() / ("marrow_newt_" + std::to_string(::getpid()))) {
        fs::create_directories(folder);
        EXPECT_EQ(run("cook " + newt_glb() + " -o " + (folder / "newt.mrw").string() + " 2>/dev/null"), 0);
      }
      ~Once() { fs::remove_all(folder); }
      fs::path folder;
    };
    static const Once once;
    return once.folder / "newt.mrw";
  }

  fs::path folder_;
};

// Share of pixels that differ by more than eight levels.
double difference(const std::vector<png_byte>& a, const std::vector<png_byte>& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    for (std::size_t c = i; c < i + 3; ++c) {
      if (std::abs(a[c] - b[c]) > 8) {
        ++different;
        break;
      }
    }
  }
  return static_cast<double>(different) * 3 / static_cast<double>(a.size());
}

TEST_F(Picture, ShowsTheCharacterTheSameOnEveryPath) {
  ASSERT_EQ(render("--deformer ssd --path ubo", "ubo.png"), 0);
  ASSERT_EQ(render("--deformer ssd --path cpu", "cpu.png"), 0);
  ASSERT_EQ(render("--deformer as --path ubo", "as.png"), 0);
  ASSERT_EQ(render("--deformer rigid --path ubo", "rigid.png"), 0);
  const std::vector<png_byte> ubo = pixels("ubo.png");
  ASSERT_EQ(ubo.size(), 200u * 160 * 3);
  std::set<int> reds, greens;
  for (std::size_t i = 0; i < ubo.size(); i += 3) {
    reds.insert(ubo[i]);
    greens.insert(ubo[i + 1]);
  }
  EXPECT_GT(reds.size(), 100u) << "blank";
  EXPECT_GT(greens.size(), 100u) << "blank";
  EXPECT_LE(difference(ubo, pixels("cpu.png")), 0.01);
  EXPECT_LE(difference(ubo, pixels("as.png")), 0.01);
  EXPECT_GT(difference(ubo, pixels("rigid.png")), 0.002) << "rigid must look otherwise";
  for (const std::string way : {"texture", "feedback", "compute"}) {
    const int code = render("--deformer ssd --path " + way, way + ".png");
    if (way == "compute" && !gl().caps().compute) {
      EXPECT_NE(code, 0);
      continue;
    }
    ASSERT_EQ(code, 0) << way;
    EXPECT_LE(difference(ubo, pixels(way + ".png")), 0.001) << way;
  }
}

// Many joints, and ten influences.
TEST_F(Picture, ShowsModelsTheSameOnEveryPath) {
  if (!have_assets()) GTEST_SKIP() << "SKIPPED: no models; set MARROW_ASSETS";
  const fs::path folder = fs::path(model_paths().back()).parent_path();
  std::size_t compared = 0;
  double worst = 0;
  for (const std::string name : {in_long_form() ? "ruby" : "Fox", "assimp_quad_skin_10inf"}) {
    const std::string cooked = path(name + ".mrw");
    ASSERT_EQ(run("cook " + (folder / (name + ".glb")).string() + " -o " + cooked + " --clip-codec raw 2>/dev/null"),
              0);
    for (const std::string deformer : {"ssd", "as"}) {
      std::vector<png_byte> first;
      for (const std::string way : {"ubo", "texture", "feedback", "compute", "crowd", "cpu"}) {
        if (way == "compute" && !gl().caps().compute) continue;
        const std::string picture = name + deformer + way + ".png";
        const std::string clip = name == "assimp_quad_skin_10inf" ? "" : " --clip 0 --time 0.5";
        const int code = run("render " + cooked + clip + " --size 200x160 --deformer " + deformer + " --path " + way +
                             " -o " + path(picture) + " 2>/dev/null");
        ASSERT_EQ(code, 0) << picture;
        if (first.empty()) {
          first = pixels(picture);
          continue;
        }
        const double share = difference(first, pixels(picture));
        EXPECT_LE(share, 0.001) << picture;
        worst = std::max(worst, share);
        ++compared;
      }
    }
  }
  std::printf("pictures that were compared: %zu, at most %.5f of the pixels differ\n", compared, worst);
  EXPECT_GE(compared, 4u * 4);
}

TEST_F(Picture, ShowsAJointBroughtToAPoint) {
  const std::string goal = "--ik hand.L=0.45,0.9,0.25 ";
  ASSERT_EQ(render("", "plain.png"), 0);
  ASSERT_EQ(render(goal, "reach.png"), 0);
  ASSERT_EQ(render(goal + "--ik hand.R=-0.3,0.7,0.35 --ik-solver dls --ik-joints 4", "both.png"), 0);
  EXPECT_GT(difference(pixels("plain.png"), pixels("reach.png")), 0.005);
  EXPECT_GT(difference(pixels("reach.png"), pixels("both.png")), 0.005);
  const std::string genetic = goal + "--ik-solver genetic --ik-joints 4 ";
  ASSERT_EQ(render(genetic + "--ik-seed 7", "seven.png"), 0);
  ASSERT_EQ(render(genetic + "--ik-seed 7", "seven_again.png"), 0);
  ASSERT_EQ(render(genetic + "--ik-seed 8", "eight.png"), 0);
  EXPECT_TRUE(bytes("seven.png") == bytes("seven_again.png"));
  EXPECT_GT(difference(pixels("seven.png"), pixels("eight.png")), 0.0) << "another seed, another elbow";
  EXPECT_EQ(render("--ik tentacle=1,2,3 2>/dev/null", "none.png"), 1);
  EXPECT_EQ(render("--path crowd 2>/dev/null " + goal, "none.png"), 1);
  EXPECT_EQ(render("--ik-solver dls 2>/dev/null", "none.png"), 1) << "without a goal";
  EXPECT_FALSE(fs::exists(path("none.png")));
}

TEST_F(Picture, IsTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(render("--deformer as", "one.png", "LP_NUM_THREADS=1"), 0);
  ASSERT_EQ(render("--deformer as", "again.png", "LP_NUM_THREADS=1"), 0);
  ASSERT_EQ(render("--deformer as", "four.png", "LP_NUM_THREADS=4"), 0);
  EXPECT_FALSE(bytes("one.png").empty());
  EXPECT_TRUE(bytes("one.png") == bytes("again.png"));
  EXPECT_TRUE(bytes("one.png") == bytes("four.png"));
}

// The cooker splits what a uniform block cannot hold; what is cooked whole all the same is left to a texture and the
// CPU.
TEST_F(Picture, ShowsMoreJointsThanAPaletteTakes) {
  for (const std::size_t entries : {std::size_t{gles3::kPaletteJoints}, std::size_t{kMaxJoints}}) {
    cook::CookOptions options;
    options.mesh.most_entries = entries;
    options.mesh.codec = cook::MeshCodec::none;
    const std::vector<std::byte> file = cook::cook_scene(Millipede(150).scene, options).file;
    std::ofstream(path("millipede.mrw"), std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    const auto shoot = [&](const std::string& way) {
      return run("render " + path("millipede.mrw") + " --clip 0 --time 0.8 --size 400x160 --path " + way + " -o " +
                     path(way + ".png"),
                 "exec 2>/dev/null;");
    };
    EXPECT_EQ(shoot("cpu"), 0);
    const bool fits = entries == gles3::kPaletteJoints;
    EXPECT_EQ(shoot("texture"), 0);
    EXPECT_LE(difference(pixels("cpu.png"), pixels("texture.png")), 0.01);
    EXPECT_EQ(shoot("ubo"), fits ? 0 : 4);
    EXPECT_EQ(shoot("feedback"), fits ? 0 : 4);
    if (fits) {
      EXPECT_LE(difference(pixels("cpu.png"), pixels("ubo.png")), 0.01);
    }
  }
}

// The walk is 36 steps of 1/30 s: in its frames a crowd has the clip's own pose, between them the line from one to the
// next. Beyond its end it stays there, and without a clip it rests.
TEST_F(Picture, ShowsWhatACrowdShows) {
  const auto shoot = [&](const std::string& options, const std::string& name) {
    const std::string to = " --size 200x160 -o " + path(name);
    EXPECT_EQ(run("render " + path("newt.mrw") + " " + options + to), 0) << options;
    return pixels(name);
  };
  const auto against_ubo = [&](const std::string& options) {
    return difference(shoot(options + " --path ubo", "ubo.png"), shoot(options + " --path crowd", "crowd.png"));
  };
  for (const std::string deformer : {"ssd", "as", "rigid"}) {
    const std::string moment = "--deformer " + deformer + " --clip walk --time ";
    EXPECT_LE(against_ubo(moment + "0.4"), 0.001) << deformer;
    const double between = against_ubo(moment + "0.41666667");
    EXPECT_LE(between, 0.01) << deformer;
    EXPECT_GT(between, 0) << deformer << ": not baked";
  }
  EXPECT_LE(against_ubo("--clip walk --time 9"), 0.001);
  EXPECT_LE(against_ubo(""), 0.001);
  EXPECT_GT(difference(pixels("crowd.png"), shoot("--clip walk --time 0.4 --path crowd", "walk.png")), 0.01)
      << "nothing moves";
  EXPECT_EQ(difference(shoot("--heatmap rigid:ssd --path ubo", "ubo.png"),
                       shoot("--heatmap rigid:ssd --path crowd", "crowd.png")),
            0);
}

// The elbow has learnt from dual quaternions, by enough to be seen.
TEST_F(Picture, ShowsAPoseSpaceOnEveryPath) {
  ASSERT_EQ(run("cook " + in_golden("elbow.gltf") + " -o " + path("posed.mrw") + " --psd 4 --mwe --truth dqs",
                "exec 2>/dev/null;"),
            0);
  const auto shoot = [&](const std::string& deformer, const std::string& way) {
    return run("render " + path("posed.mrw") + " --clip bend --time 1 --size 400x320 --deformer " + deformer +
                   " --path " + way + " -o " + path(deformer + way + ".png"),
               "exec 2>/dev/null;");
  };
  ASSERT_EQ(shoot("psd", "cpu"), 0);
  ASSERT_EQ(shoot("ssd", "cpu"), 0);
  const double moved = difference(pixels("ssdcpu.png"), pixels("psdcpu.png"));
  EXPECT_GT(moved, 0.005);
  std::vector<std::string> ways = {"ubo", "texture", "feedback"};
  if (gl().caps().compute) ways.emplace_back("compute");
  for (const std::string& way : ways) {
    ASSERT_EQ(shoot("psd", way), 0) << way;
    EXPECT_LE(difference(pixels("psdcpu.png"), pixels("psd" + way + ".png")), std::min(0.002, moved / 4)) << way;
  }
  EXPECT_EQ(shoot("psd", "crowd"), 4);
  for (const char* const way : {"ubo", "crowd"}) EXPECT_EQ(shoot("mwe", way), 4);
  EXPECT_FALSE(fs::exists(path("mweubo.png")));
}

TEST_F(Picture, OfACrowdIsRefusedWhereCrowdsCannot) {
  const auto shoot = [&](const std::string& cook, const std::string& options) {
    EXPECT_EQ(run("cook " + cook + " -o " + path("other.mrw"), "exec 2>/dev/null;"), 0) << cook;
    return run("render " + path("other.mrw") + " --size 40x40 --path crowd " + options + " -o " + path("other.png"),
               "exec 2>/dev/null;");
  };
  const std::string face = in_golden("face.gltf"), tiny = in_golden("tiny.gltf");
  EXPECT_EQ(shoot(face, "--clip 0"), 4);
  EXPECT_FALSE(fs::exists(path("other.png")));
  EXPECT_EQ(shoot(tiny + " --additive wave=rest", "--clip wave"), 4);
  EXPECT_FALSE(fs::exists(path("other.png")));
  EXPECT_EQ(shoot(tiny, "--clip wave"), 0);
}

// Targets whose weights are 0 are no hindrance in the rest pose; under the clip, which has channels for them, they are.
TEST_F(Picture, OfACrowdShowsTargetsAtRest) {
  std::ifstream in(in_golden("face.gltf"));
  std::string face{std::istreambuf_iterator<char>(in), {}};
  for (const std::string weights : {"\"weights\": [0.5, 0]", "\"weights\": [0.25, 0.75]"}) {
    const std::size_t at = face.find(weights);
    ASSERT_NE(at, std::string::npos);
    face.replace(at, weights.size(), "\"weights\": [0, 0]");
  }
  std::ofstream(path("still.gltf")) << face;
  ASSERT_EQ(run("cook " + path("still.gltf") + " -o " + path("still.mrw"), "exec 2>/dev/null;"), 0);
  const auto shoot = [&](const std::string& way, const std::string& options = "") {
    return run("render " + path("still.mrw") + " --size 200x160 --path " + way + options + " -o " + path(way + ".png"),
               "exec 2>/dev/null;");
  };
  ASSERT_EQ(shoot("ubo"), 0);
  ASSERT_EQ(shoot("crowd"), 0);
  EXPECT_LE(difference(pixels("ubo.png"), pixels("crowd.png")), 0.001);
  EXPECT_EQ(shoot("crowd", " --clip 0"), 4);
}

TEST_F(Picture, BadArgumentsLeaveNoFile) {
  EXPECT_EQ(render("--size 0x10", "bad.png", "exec 2>/dev/null;"), 1);
  EXPECT_EQ(render("--heatmap ssd", "bad.png", "exec 2>/dev/null;"), 1);
  EXPECT_EQ(render("--clip no-such-clip", "bad.png", "exec 2>/dev/null;"), 1);
  EXPECT_EQ(render("", "no/such/folder/bad.png", "exec 2>/dev/null;"), 2);
  EXPECT_FALSE(fs::exists(path("bad.png")));
}

TEST_F(Picture, HeatMapsSayTheLargestDistance) {
  EXPECT_EQ(render("--heatmap rigid:ssd", "heat.png"), 0);
  EXPECT_GT(difference(pixels("heat.png"), (render("", "plain.png"), pixels("plain.png"))), 0.02);
}

}  // namespace
}  // namespace marrow::test
