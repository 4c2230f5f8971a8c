// Clips of one real model on others: how far feet slide, how high soles are, and how far hands are apart.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "unit/cook/retarget/measured_body.h"

namespace marrow::cook {
namespace {

CookOptions plain() {
  CookOptions options;
  options.mesh_codec = MeshCodec::none;
  options.images = Images::none;
  options.raw_clips = true;
  return options;
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
    CookOptions options = plain();
    options.retarget = {{source_path, "", {}}};
    const MeasuredBody target(path, options);
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

}  // namespace
}  // namespace marrow::cook
