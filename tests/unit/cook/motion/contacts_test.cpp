// Contacts that the cooker finds, against frames that were marked by eye in pictures of each frame, and speeds against
// what makes the marked feet stand still.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/aligned_bytes.h"
#include "disk/cook_on_disk.h"
#include "marrow/owned.h"
#include "support/places.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

constexpr double kMarkedHz = 30;

// From the first to the last frame in which any of the sole is on the ground; in a loop beyond its end.
struct Mark {
  const char* foot;
  int from, to;
};
struct MarkedClip {
  const char *file, *clip;
  int uncertain;  // frames
  std::vector<Mark> marks;
  bool drags_its_feet;  // while they stand, so that no speed makes them stand still
};

// Ten clips of six rigs, at 30 frames a second. In the crossed arms a foot steps aside twice, lifted by a centimetre.
const std::vector<MarkedClip> kMarked = {
    {"pab.glb", "pab_walk_raw", 1, {{"left_foot", 28, 53}, {"right_foot", 10, 34}}, false},
    {"pab.glb", "pab_crossarms", 2, {{"left_foot", 0, 258}, {"right_foot", 128, 218}, {"right_foot", 228, 374}}, false},
    {"pab.glb",
     "pab_atlas_raw",
     2,
     {{"left_foot", 252, 273},
      {"left_foot", 281, 305},
      {"left_foot", 311, 697},
      {"right_foot", 237, 259},
      {"right_foot", 265, 286},
      {"right_foot", 291, 683}},
     false},
    {"pab.glb", "pab_run_raw", 1, {{"left_foot", 19, 23}, {"right_foot", 9, 13}}, false},
    {"KayKit_Knight.glb", "Walking_Backwards", 2, {{"left_foot", 12, 32}, {"right_foot", 28, 48}}, true},
    {"mannequiny.glb", "air_land_root.001", 1, {{"left_foot", 6, 36}, {"right_foot", 15, 36}}, true},
    {"godot_robot.glb", "run", 1, {{"left_foot", 13, 20}, {"right_foot", 1, 7}}, true},
    {"CesiumMan.glb", "", 3, {{"left_foot", 23, 50}, {"right_foot", 53, 78}}, true},
    {"Fox.glb",
     "Walk",
     1,
     {{"left_foot", 18, 22}, {"right_foot", 3, 10}, {"left_hand", 3, 10}, {"right_hand", 15, 23}},
     true},
    {"Fox.glb",
     "Run",
     2,
     {{"left_foot", 34, 40}, {"right_foot", 4, 9}, {"left_hand", 22, 27}, {"right_hand", 14, 19}},
     true}};

class Contacts : public ::testing::TestWithParam<MarkedClip> {
 protected:
  void SetUp() override {
    const std::filesystem::path path = std::filesystem::path(test::assets_folder()) / GetParam().file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "not there: " << path;
    const CookOptions options = options_of("--mesh-codec none --images none --clip-codec raw");
    const std::vector<std::byte> bytes = cook_file(path.string(), options).file;
    ASSERT_EQ(make_owned(Span<const std::byte>(bytes.data(), bytes.size()), file_), Status::ok);
    for (std::uint32_t c = 0; c < file_.clip_count(); ++c)
      if (std::string(file_.clip(c).name) == GetParam().clip) clip_ = c;
    motion_ = file_.motion(clip_);
  }
  // By how many frames a contact begins and ends late; of several the nearest one.
  std::pair<double, double> off(const Mark& mark) const {
    std::pair<double, double> best{1e9, 1e9};
    const double round = static_cast<double>(motion_.duration_s) * kMarkedHz;
    for (const ClipEvent& e : motion_.events)
      for (int r = -1; r <= 1 && std::string(file_.text(e.name)) == mark.foot; ++r) {
        const std::pair<double, double> now{static_cast<double>(e.time_s) * kMarkedHz + r * round - mark.from,
                                            static_cast<double>(e.until_s) * kMarkedHz + r * round - mark.to};
        if (std::abs(now.first) + std::abs(now.second) < std::abs(best.first) + std::abs(best.second)) best = now;
      }
    return best;
  }

  OwnedFile file_;
  std::uint32_t clip_ = 0;
  ClipMotion motion_;
};

// None is missed and none invented. Of 58 begins and ends 43 are within what the marks are sure of, and 51 within a
// frame more. The others are of feet that are dragged: the Knight's toes skim the ground before they stand, and the fox
// folds its paws.
TEST_P(Contacts, AreWhereTheyWereMarked) {
  EXPECT_EQ(motion_.events.size, GetParam().marks.size());
  for (const Mark& mark : GetParam().marks) {
    const auto [from, to] = off(mark);
    std::printf("%s %s: %s %+.1f %+.1f frames\n", GetParam().file, GetParam().clip, mark.foot, from, to);
    EXPECT_LT(std::abs(from), GetParam().uncertain + 5.2) << mark.foot;
    EXPECT_LT(std::abs(to), GetParam().uncertain + 3.9) << mark.foot;
  }
}

INSTANTIATE_TEST_SUITE_P(OfMarkedClips, Contacts, ::testing::ValuesIn(kMarked));

}  // namespace
}  // namespace marrow::cook
