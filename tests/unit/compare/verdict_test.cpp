// What `marrow compare` recommends, of figures made by hand.
#include "compare/verdict.h"

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

struct Case {
  Study study;
  DeformerComparison comparison;
  MotionStudy motion;

  Case() {
    study.joint_names = {"hips", "knee"};
    comparison.diagonal_m = 2;
    comparison.held = 40;
    comparison.truth = {10, 5, 0.01, 1.0};
    for (const auto& [name, rms] : {std::pair("ssd", 0.010), std::pair("as_smooth", 0.012), std::pair("as_fit", 0.009),
                                    std::pair("as_helpers", 0.006), std::pair("as_helpers_fit5", 0.001)}) {
      DeformerRow& row = comparison.rows.emplace_back();
      row.deformer = name;
      row.held_rms = rms;
      row.bytes_per_vertex = 10;
      row.look = comparison.truth;
      MotionRow& of = motion.of.emplace_back();
      of.ring_over_bind = 0.9;
    }
  }
  DeformerRow& row(const std::string& name) {
    return *std::ranges::find(comparison.rows, name, &DeformerRow::deformer);
  }
  MotionRow& motion_of(const std::string& name) {
    return motion.of[static_cast<std::size_t>(&row(name) - comparison.rows.data())];
  }
  Verdict judged(const std::string& truth = "cor") const { return verdict(study, truth, comparison, motion); }
};

bool says(const Verdict& v, const std::string& words) {
  return std::ranges::any_of(v.why, [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST(Verdict, TakesTheNearestThatLooksNoWorse) {
  const Case c;
  const Verdict v = c.judged();
  EXPECT_EQ(v.deformer, "as_helpers_fit5");
  EXPECT_EQ(v.use.find("Use animation space (cook with --as fit --helpers auto): 10 % of"), 0u) << v.use;
  EXPECT_TRUE(v.why.empty());
}

// Each of the four measures alone is enough, and what a table does not show is not.
TEST(Verdict, RefusesWhatIsUglier) {
  const SurfaceLook worse[] = {{10.1, 5, 0.01, 1.0}, {10, 5.01, 0.01, 1.0}, {10, 5, 0.0101, 1.0}, {10, 5, 0.01, 1.11}};
  const char* const why[] = {"10.1 flipped triangles a pose for 10.0", "it bends by 5.01° for 5.00°",
                             "it creases 1.01 % of its edges for 1.00 %", "it jumps 1.11 times"};
  for (std::size_t i = 0; i < 4; ++i) {
    Case c;
    c.row("as_helpers_fit5").look = worse[i];
    const Verdict v = c.judged();
    EXPECT_EQ(v.deformer, "as_helpers") << i;
    EXPECT_TRUE(says(v, "as_helpers_fit5 is nearer, 10 % of the error, but looks worse than plain skinning: ")) << i;
    EXPECT_TRUE(says(v, why[i])) << why[i];
    c.row("as_helpers").look = worse[i];
    EXPECT_EQ(c.judged().deformer, "ssd") << i;
  }
  Case c;
  c.row("as_helpers_fit5").look = {10.04, 5.004, 0.01004, 1.1};
  EXPECT_EQ(c.judged().deformer, "as_helpers_fit5");
  c.row("as_helpers_fit5").look = {0, 0, 0, std::nullopt};
  EXPECT_EQ(c.judged().deformer, "as_helpers_fit5");
}

TEST(Verdict, SaysWhyPlainSkinningIsLeft) {
  Case c;
  for (const char* const name : {"as_helpers", "as_helpers_fit5"}) c.row(name).look.flipped = 20;
  EXPECT_EQ(c.judged().use,
            "Use linear blend skinning, or learn from another truth: what is nearer to the truth cor "
            "looks worse.");
  EXPECT_EQ(c.judged("elastic").use, "Use linear blend skinning: what is nearer to the truth elastic looks worse.");
}

// Whatever is recommended.
TEST(Verdict, SaysWhatIsWrung) {
  Case c;
  c.motion.truth_ring = 0.9;
  EXPECT_FALSE(says(c.judged(), "wrings"));
  c.motion_of("as_helpers_fit5").ring_over_bind = 0.09;
  EXPECT_TRUE(says(c.judged(),
                   "But as_helpers_fit5 wrings joints: twisted to 170° they keep 0.09 of their thickness, "
                   "by the truth 0.90."));
  c.motion.truth_ring = 0.28;
  EXPECT_FALSE(says(c.judged(), "wrings")) << "the truth does, too";
  c.motion.truth_ring = {};
  EXPECT_FALSE(says(c.judged(), "wrings"));
}

TEST(Verdict, SaysWhereTheTruthFolds) {
  Case c;
  c.comparison.folding = 7;
  c.comparison.truth_folds = {{"jump", 4.03, 1, 182, 115}, {"walk", 1, 0, 20, 30}};
  EXPECT_TRUE(says(c.judged(),
                   "folds in 7 of 40 poses, most at joint knee in \"jump\" at 4.03 s: 182 triangles, plain "
                   "skinning 115."));
  EXPECT_TRUE(says(c.judged(), "--truth elastic"));
  EXPECT_FALSE(says(c.judged("elastic"), "--truth elastic"));
  EXPECT_FALSE(says(c.judged(), "looks worse"));
  c.comparison.truth.bend_deg = 6;
  EXPECT_TRUE(says(c.judged(), "The truth looks worse than plain skinning: it bends by 6.00° for 5.00°."));
}

TEST(Verdict, WarnsOfWhatClipsDoNotShow) {
  Case c;
  c.motion_of("ssd").mean_flipped = 3;
  c.motion_of("as_helpers_fit5").mean_flipped = 3.04;
  EXPECT_TRUE(c.judged().why.empty());
  c.motion_of("as_helpers_fit5").mean_flipped = 4;
  EXPECT_TRUE(says(c.judged(), "flips 4.0 triangles a pose for plain skinning's 3.0"));
}

}  // namespace
}  // namespace marrow::tools
