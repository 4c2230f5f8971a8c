// Additive clips as they are cooked: what cannot be a change is refused, and what is reported holds as a game plays.
#include <vector>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

struct Popup {
  explicit Popup(const std::vector<float>& scales) {
    const std::vector<int> joints = d.character("Ada", 0);
    d.clip("popup");
    d.keys(joints[3], "scale", {0, 0.5F, 1}, scales);
    d.turn(joints[1], {0, 0.25F, 0.5F, 0.75F, 1});
  }
  LoadedCook cook(const std::string& reference) {
    return LoadedCook(cook_scene(d.read(), options_of("--additive popup=" + reference)));
  }
  SceneDocument d;
};

// A factor changes scale, and there is none from 0 to 1.2.
TEST(AdditiveClips, WhatGrowsFromNoScaleIsRefusedByName) {
  Popup popup({0, 1, 1, 1.2F, 1, 1, 1, 1, 1});
  try {
    popup.cook("first");
    FAIL();
  } catch (const tools::Failure& e) {
    EXPECT_EQ(e.code(), tools::Exit::usage);
    const std::string what = e.what();
    EXPECT_NE(what.find("\"popup\""), std::string::npos) << what;
    EXPECT_NE(what.find("\"arm\""), std::string::npos) << what;
  }
  EXPECT_EQ(popup.cook("rest").file.clip_count(), 1u) << "whose scale is 1";
  Popup hidden({0, 0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(hidden.cook("first").file.clip_count(), 1u) << "0 times anything is 0";
}

// Over its reference an additive clip is the source's pose.
TEST(AdditiveClips, OverTheReferenceIsTheSourcesPose) {
  Popup popup({0.01F, 0.01F, 0.01F, 1.2F, 1.2F, 1.2F, 1, 1, 1});
  const LoadedCook cooked = popup.cook("first");
  const Skeleton skeleton = cooked.file.skeleton(0);
  const Clip clip = cooked.file.clip(0);
  ASSERT_TRUE(clip.additive);
  std::vector<SoaTransform> pose(clip.reference, clip.reference + skeleton.soa_size());
  std::vector<AdditiveTransform> change(skeleton.soa_size());
  ASSERT_EQ(sample_additive(skeleton, clip, 0.5f, change), Status::ok);
  ASSERT_EQ(add(skeleton, {change}, pose), Status::ok);
  const double promised = cooked.report["clips"][0]["max_error_m"].get<double>();
  EXPECT_LE(promised, 1e-4);
  const std::uint32_t arm = cooked.file.find_joint(skeleton, "arm");
  ASSERT_LT(arm, skeleton.joint_count);
  EXPECT_NEAR(pose[arm / 4].scale[0][arm % 4], 1.2f, 4e-3f) << "the shell of 3 cm strays by a tenth of a millimetre";
}

}  // namespace
}  // namespace marrow::cook
