// Clips of one real model on others: how far feet slide, how high soles are, and how far hands are apart.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "unit/cook/options_text.h"
#include "unit/cook/retarget/measured_body.h"

namespace marrow::cook {
namespace {

CookOptions plain(const std::string& more = "") {
  return options_of("--mesh-codec none --images none --clip-codec raw" + more);
}

struct Bar {
  const char* file;
  double slide, height, hands;
};

TEST(RetargetModels, FeetStandAndHandsMeet) {
  const std::string source_path = test::assets_folder() + "/pab.glb";
  if (!std::filesystem::exists(source_path)) GTEST_SKIP() << "no models; name their folder in MARROW_ASSETS";
  const MeasuredBody source(source_path, plain());
  const char* const clips[] = {"pab_walk_raw", "pab_crossarms", "pab_run_raw"};
  for (const Bar& bar : {Bar{"mannequiny", 10, 10, 15}, Bar{"m2m_sintel", 10, 10, 15}, Bar{"RiggedFigure", 10, 10, 15},
                         Bar{"KayKit_Knight", 20, 10, 15}, Bar{"ruby", 10, 10, 15}}) {
    const std::string path = test::assets_folder() + "/" + bar.file + ".glb";
    const MeasuredBody target(path, plain(" --retarget " + source_path));
    for (const char* const clip : clips) {
      const HowCarried how = compare_bodies(source, source.clip(clip), target, target.clip(clip));
      std::printf("%-14s %-14s slide %6.1f mm, soles %6.1f mm, hands %6.1f mm, knees straighter by %4.1f deg\n",
                  bar.file, clip, how.slide, how.height, how.hands, how.knees_deg);
      EXPECT_LE(how.slide, bar.slide) << bar.file << ' ' << clip;
      EXPECT_LE(how.height, bar.height) << bar.file << ' ' << clip;
      EXPECT_LE(how.hands, bar.hands) << bar.file << ' ' << clip;
    }
  }
}

// The Knight has short legs and large boots. While one swings, its toes point down, and farther: at keys it is no
// deeper in the ground than the source's soles ever are. Between keys joints turn evenly, and it may be.
TEST(RetargetModels, FeetThatSwingStayOutOfTheGround) {
  const std::string source_path = test::assets_folder() + "/pab.glb";
  if (!std::filesystem::exists(source_path)) GTEST_SKIP() << "no models; name their folder in MARROW_ASSETS";
  const MeasuredBody source(source_path, plain());
  const MeasuredBody target(test::assets_folder() + "/KayKit_Knight.glb", plain(" --retarget " + source_path));
  const auto lowest = [](const MeasuredBody& body, const char* clip, float step_s) {
    const std::uint32_t at = body.clip(clip);
    const auto steps = static_cast<int>(body.duration_s(at) / double{step_s} + 0.5);
    double out = 1e9;
    for (int i = 0; i <= steps; ++i)
      out = std::min(out, body.heights(body.pose(at, static_cast<float>(i) * step_s), true).first);
    return 1000 * body.to_size() * (out - body.ground());
  };
  for (const char* const clip : {"pab_walk_raw", "pab_jog_raw", "pab_run_raw"}) {
    const double keys = lowest(target, clip, 2 * kStepS), between = lowest(target, clip, kStepS / 4);
    std::printf("%-14s lowest of the source %5.1f mm, of the Knight %5.1f mm, between keys %5.1f mm\n", clip,
                lowest(source, clip, 2 * kStepS), keys, between);
    EXPECT_GT(keys, -2.0) << clip;
    EXPECT_GT(between, -13.0) << clip;
  }
}

}  // namespace
}  // namespace marrow::cook
