// What is reported of a clip where its curves jump: both sides are looked at, however short.
#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cook/clip/measure/clip_measure.h"

namespace marrow::cook {
namespace {

BuiltSkeleton one_joint() {
  BuiltSkeleton out;
  out.model_from_root.push_back({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  out.rest.resize(1);
  for (int lane = 0; lane < 4; ++lane) {
    out.rest[0].rotation[3][lane] = 1;
    for (int i = 0; i < 3; ++i) out.rest[0].scale[i][lane] = 1;
  }
  out.parents.push_back(kNoJoint);
  out.joint_names.push_back("j");
  return out;
}

// It stands at 0, from a moment on at 1, along x.
BuiltClip jump_at(float time_s, Interpolation interpolation) {
  BuiltClip out;
  out.duration_s = 1;
  out.times_s = {0, time_s, 1};
  out.values = {0, 0, 0, 1, 0, 0, 1, 0, 0};
  if (interpolation == Interpolation::linear) {
    out.times_s.insert(out.times_s.begin() + 1, time_s);
    out.values.insert(out.values.begin(), {0, 0, 0});
  }
  out.tracks.push_back(
      {0, TrackPath::translation, interpolation, static_cast<std::uint32_t>(out.times_s.size()), 0, 0});
  return out;
}

// For a tenth of a millisecond, between the moments of any rate, the joint is a metre from where the source has it:
// before the source jumps or behind.
TEST(ClipMeasureAtJumps, LooksAtBothSides) {
  const BuiltSkeleton skeleton = one_joint();
  const Rig rig(skeleton);
  const Hung nothing;
  const BuiltClip no_channels;
  Promise promise;
  promise.error = {2};
  std::size_t checked = 0;
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear}) {
    const BuiltClip source = jump_at(0.513f, interpolation);
    const ClipMeasure measure(source, no_channels, skeleton, rig, nothing);
    const std::vector<float> moments = measure.moments({0, 0.25f, 0.5f, 0.75f, 1});
    using Case = std::pair<float, double>;
    for (const auto& [jump_s, error_m] : {Case{0.5129f, 1}, Case{0.513f, 0}, Case{0.5131f, 1}}) {
      const ClipError got = measure.measure(jump_at(jump_s, interpolation), moments, promise);
      EXPECT_NEAR(got.error_m, error_m, 1e-9) << jump_s << ' ' << static_cast<int>(interpolation);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 6u);
}

}  // namespace
}  // namespace marrow::cook
