// sample_channels: the three interpolations of glTF 2.0 on numbers, by hand.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/rig.h"

namespace marrow {
namespace {

// Channels beside a track, lists of times shared and not.
struct Rig {
  Rig() {
    clip.add(0, TrackPath::translation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 1, 1});
    add(Interpolation::linear, {0, 1}, {2, 6});
    share(Interpolation::step, {5, 7});
    add(Interpolation::linear, {1, 2, 4}, {0, 10, -10});
    share(Interpolation::step, {1, 2, 3});
    // The interval is 2 s: at its middle the weights are ½, ¼, ½ and -¼ (glTF 2.0, appendix C).
    add(Interpolation::cubic_spline, {1, 3}, {99, 1, 4, 8, 5, 99});
    add(Interpolation::linear, {2}, {0.75f});
    add(Interpolation::cubic_spline, {2}, {99, -0.5f, 99});
  }
  void add(Interpolation interpolation, const std::vector<float>& times, const std::vector<float>& values) {
    channels.push_back({0,
                        0,
                        static_cast<std::uint32_t>(times.size()),
                        static_cast<std::uint32_t>(clip.times.size()),
                        static_cast<std::uint32_t>(clip.values.size()),
                        interpolation,
                        {}});
    clip.times.insert(clip.times.end(), times.begin(), times.end());
    clip.values.insert(clip.values.end(), values.begin(), values.end());
  }
  // With the times of the channel before.
  void share(Interpolation interpolation, const std::vector<float>& values) {
    Channel channel = channels.back();
    channel.interpolation = interpolation;
    channel.first_value = static_cast<std::uint32_t>(clip.values.size());
    channels.push_back(channel);
    clip.values.insert(clip.values.end(), values.begin(), values.end());
  }
  std::vector<float> at(float time_s) const {
    Clip view = clip.view();
    view.channels = channels;
    std::vector<float> out(channels.size(), -77);
    EXPECT_EQ(sample_channels(view, time_s, out), Status::ok);
    return out;
  }
  test::TestClip clip;
  std::vector<Channel> channels;
};

TEST(Channels, ByHand) {
  const Rig rig;
  const float after = std::nextafter(2.0f, 0.0f);
  const struct {
    float time_s;
    std::vector<float> want;
  } cases[] = {
      {-1, {2, 5, 0, 1, 1, 0.75f, -0.5f}},
      {0, {2, 5, 0, 1, 1, 0.75f, -0.5f}},
      {0.5f, {4, 5, 0, 1, 1, 0.75f, -0.5f}},
      {1, {6, 7, 0, 1, 1, 0.75f, -0.5f}},
      {1.5f, {6, 7, 5, 1, (54 * 1 + 18 * 4 + 10 * 5 - 6 * 8) / 64.0f, 0.75f, -0.5f}},
      {after, {6, 7, 10, 1, 2, 0.75f, -0.5f}},
      {2, {6, 7, 10, 2, (1 + 5) / 2.0f + (4 - 8) / 4.0f, 0.75f, -0.5f}},
      {3, {6, 7, 0, 2, 5, 0.75f, -0.5f}},
      {4, {6, 7, -10, 3, 5, 0.75f, -0.5f}},
      {9, {6, 7, -10, 3, 5, 0.75f, -0.5f}},
      {std::numeric_limits<float>::infinity(), {6, 7, -10, 3, 5, 0.75f, -0.5f}},
  };
  int compared = 0;
  for (const auto& c : cases) {
    const std::vector<float> got = rig.at(c.time_s);
    ASSERT_EQ(got.size(), c.want.size());
    for (std::size_t i = 0; i < got.size(); ++i, ++compared)
      EXPECT_NEAR(got[i], c.want[i], 2e-6) << "channel " << i << " at " << c.time_s;
  }
  EXPECT_EQ(compared, 11 * 7);
}

TEST(Channels, BadCalls) {
  const Rig rig;
  Clip clip = rig.clip.view();
  clip.channels = rig.channels;
  std::vector<float> out(rig.channels.size(), -77);
  EXPECT_EQ(sample_channels(clip, 0.5f, {out.data(), out.size() - 1}), Status::bad_argument);
  EXPECT_EQ(sample_channels(clip, std::nanf(""), out), Status::bad_argument);
  for (const float f : out) EXPECT_EQ(f, -77);
  EXPECT_EQ(sample_channels(rig.clip.view(), 0.5f, {}), Status::ok) << "a clip without channels needs no memory";
}

// Poses do not see channels.
TEST(Channels, LeaveThePoseAlone) {
  const Rig rig;
  Clip with = rig.clip.view();
  with.channels = rig.channels;
  const test::TestSkeleton skeleton(std::vector<test::TestJoint>(1));
  std::vector<SoaTransform> pose(1);
  ASSERT_EQ(sample(skeleton.view(), with, 0.25f, pose), Status::ok);
  EXPECT_EQ(pose[0].translation[0][0], 0.25f);
}

}  // namespace
}  // namespace marrow
