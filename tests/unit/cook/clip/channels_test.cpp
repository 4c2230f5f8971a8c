// What channels cost: constants a key, lists of times shared, keys on straight lines left out within the stated error.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cook/clip/build_tracks.h"
#include "marrow/sample.h"
#include "support/rig.h"

namespace marrow::cook {
namespace {

constexpr double kSlack = 0x1p-17;  // of the largest value, as stated

RawScalar scalar(RawInterpolation interpolation, std::vector<float> times, std::vector<float> values) {
  RawScalar out;
  out.name = "n";
  out.interpolation = interpolation;
  out.times_s = std::move(times);
  out.values = std::move(values);
  return out;
}

BuiltClip build(std::vector<RawScalar> scalars, bool all_keys = false) {
  RawClip raw;
  raw.scalars = std::move(scalars);
  BuiltClip out = build_tracks(raw, {});
  add_channels(raw, all_keys, out);
  return out;
}

std::vector<float> times_of(const BuiltClip& clip, std::size_t i) {
  const auto first = clip.times_s.begin() + clip.channels[i].first_time;
  return {first, first + clip.channels[i].key_count};
}

const std::vector<float> kFour = {0, 0.5f, 1, 2};

TEST(Channels, ConstantsHaveOneKeyAndOneListOfTimes) {
  const BuiltClip clip =
      build({scalar(RawInterpolation::linear, kFour, {3, 3, 3, 3}), scalar(RawInterpolation::step, {1, 5}, {4, 4}),
             scalar(RawInterpolation::cubic_spline, {1, 2}, {0, 5, 0, 0, 5, 0})});
  ASSERT_EQ(clip.channels.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(times_of(clip, i), std::vector<float>{0});
    EXPECT_EQ(clip.channels[i].interpolation, Interpolation::step);
  }
  EXPECT_EQ(clip.times_s.size(), 1u);
  EXPECT_EQ(clip.values, (std::vector<float>{3, 4, 5}));
  EXPECT_EQ(clip.duration_s, 5) << "the source's";
}

TEST(Channels, ASplineWithTangentsIsNoConstant) {
  const BuiltClip clip = build({scalar(RawInterpolation::cubic_spline, {1, 2}, {0, 5, 1, 0, 5, 0})});
  EXPECT_EQ(times_of(clip, 0), (std::vector<float>{1, 2}));
  EXPECT_EQ(clip.values.size(), 6u);
}

TEST(Channels, StepsThatRepeatAreLeftOut) {
  const BuiltClip clip = build({scalar(RawInterpolation::step, kFour, {1, 1, 2, 2})});
  EXPECT_EQ(times_of(clip, 0), (std::vector<float>{0, 1}));
  EXPECT_EQ(clip.values, (std::vector<float>{1, 2}));
}

TEST(Channels, KeysOnALineAreLeftOut) {
  const BuiltClip clip = build({scalar(RawInterpolation::linear, kFour, {0, 1, 2, 4})});
  EXPECT_EQ(times_of(clip, 0), (std::vector<float>{0, 2}));
  const BuiltClip bent = build({scalar(RawInterpolation::linear, kFour, {0, 1, 2, 5})});
  EXPECT_EQ(times_of(bent, 0), (std::vector<float>{0, 1, 2}));
}

// Numbers may stand for something; and a spline of zeros has nothing but its tangents to be rounded by.
TEST(Channels, WhatIsNotRounded) {
  const std::vector<float> numbers = {7, 1000001, 3, 123457};
  EXPECT_EQ(build({scalar(RawInterpolation::step, {0, 1, 2, 3}, numbers)}).values, numbers);
  const std::vector<float> tangents = {0, 0, 0.1f, -0.3f, 0, 0};
  EXPECT_EQ(build({scalar(RawInterpolation::cubic_spline, {0, 1}, tangents)}).values, tangents);
}

TEST(Channels, RawKeepsEveryKey) {
  const BuiltClip clip = build(
      {scalar(RawInterpolation::linear, kFour, {0, 1, 2, 4}), scalar(RawInterpolation::linear, kFour, {3, 3, 3, 3})},
      true);
  EXPECT_EQ(times_of(clip, 0), kFour);
  EXPECT_EQ(times_of(clip, 1), kFour);
  EXPECT_EQ(clip.times_s.size(), 4u) << "the list is shared all the same";
}

TEST(Channels, AListOfItsOwnMustBeWorthIt) {
  const std::vector<float> curve = {0, 1, 4, 9, 16, 25}, nearly = {0, 1, 2, 4, 8, 16}, times = {0, 1, 2, 3, 4, 5};
  const BuiltClip clip = build({scalar(RawInterpolation::linear, times, curve),
                                scalar(RawInterpolation::linear, times, nearly)});  // one key of six could go
  EXPECT_EQ(clip.times_s, times);
  EXPECT_EQ(clip.channels[0].first_time, clip.channels[1].first_time);
}

TEST(Channels, ShareTheListOfTheLastTrack) {
  RawClip raw;
  raw.scalars = {scalar(RawInterpolation::linear, {0, 2}, {0, 1}), scalar(RawInterpolation::linear, {0, 1}, {0, 1})};
  raw.channels.push_back({0, RawPath::translation, RawInterpolation::linear, {0, 1}, {{}, {}}});
  BuiltClip clip = build_tracks(raw, {0});
  add_channels(raw, true, clip);
  EXPECT_EQ(clip.times_s, (std::vector<float>{0, 1, 0, 2}));
  EXPECT_EQ(clip.channels[0].first_time, clip.tracks[0].first_time);
  EXPECT_EQ(clip.channels[1].first_time, 2u);
  EXPECT_EQ(clip.duration_s, 2);
}

double line(const RawScalar& s, double time_s) {
  std::size_t k = 0;
  while (k + 2 < s.times_s.size() && static_cast<double>(s.times_s[k + 1]) <= time_s) ++k;
  const auto t = [&](std::size_t i) { return static_cast<double>(s.times_s[i]); };
  const auto v = [&](std::size_t i) { return static_cast<double>(s.values[i]); };
  return v(k) + (v(k + 1) - v(k)) * (time_s - t(k)) / (t(k + 1) - t(k));
}

// Polygons of noise, most of whose keys lie on lines but for float's rounding.
TEST(Channels, LeavingKeysOutKeepsTheStatedError) {
  test::Random random(81);
  std::size_t before = 0, after = 0, compared = 0;
  for (int run = 0; run < 200; ++run) {
    RawScalar s = scalar(RawInterpolation::linear, {}, {});
    double value = 0, slope = 0, largest = 0;
    for (int key = 0; key < 300; ++key) {
      if (random.below(20) == 0) slope = random.between(-3, 3);
      s.times_s.push_back(static_cast<float>(key) / 30.0f);
      value += slope / 30;
      s.values.push_back(static_cast<float>(value));
      largest = std::max(largest, std::fabs(value));
    }
    const BuiltClip clip = build({s});
    const Channel& channel = clip.channels[0];
    const std::vector<float> times = times_of(clip, 0);
    const RawScalar kept =
        scalar(RawInterpolation::linear, times, {clip.values.begin(), clip.values.begin() + channel.key_count});
    before += s.times_s.size();
    after += channel.key_count;
    for (std::size_t k = 0; k < s.times_s.size(); ++k, ++compared) {
      const double time_s = static_cast<double>(s.times_s[k]);
      const double got = channel.key_count > 1 ? line(kept, time_s) : static_cast<double>(kept.values[0]);
      ASSERT_NEAR(got, static_cast<double>(s.values[k]), kSlack * largest * (1 + 1e-9));
    }
  }
  EXPECT_EQ(compared, 60000u);
  EXPECT_LT(after, before / 4);
}

}  // namespace
}  // namespace marrow::cook
