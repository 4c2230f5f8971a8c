// sample: the three interpolations of glTF 2.0, their ends, and what a clip leaves alone.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/rig.h"

namespace marrow {
namespace {

using test::joint_of;
using test::Quat;
using test::TestClip;
using test::TestJoint;
using test::TestSkeleton;
using test::Vec3;

constexpr double kFloat = 1e-6;

std::vector<TestJoint> six_joints() {
  std::vector<TestJoint> joints(6);
  for (std::size_t i = 0; i < 6; ++i) {
    joints[i].parent = static_cast<int>(i) - 1;
    joints[i].translation = {1.0 + static_cast<double>(i), 0.5, -0.25};
    joints[i].scale = {1, 2, 3};
  }
  return joints;
}

struct Sampled {
  explicit Sampled(const TestClip& clip, float time_s) : skeleton(six_joints()), out(skeleton.view().soa_size()) {
    status = sample(skeleton.view(), clip.view(), time_s, out);
  }
  Vec3 translation(std::size_t j) const { return joint_of(out.data(), j).translation; }
  Quat rotation(std::size_t j) const { return joint_of(out.data(), j).rotation; }
  TestSkeleton skeleton;
  std::vector<SoaTransform> out;
  Status status;
};

void expect_vec(const Vec3& got, const Vec3& want) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], want[i], kFloat * std::max(1.0, std::fabs(want[i]))) << i;
}

// The same rotation, with the same sign or the other.
void expect_rotation(const Quat& got, const Quat& want, double tolerance_rad = 2e-6) {
  double d = 0, length = 0;
  for (std::size_t i = 0; i < 4; ++i) d += got[i] * want[i], length += got[i] * got[i];
  double off = 0;
  for (std::size_t i = 0; i < 4; ++i) off += std::pow(got[i] - (d < 0 ? -want[i] : want[i]), 2);
  EXPECT_NEAR(length, 1, 2e-6);
  EXPECT_LT(2 * std::sqrt(off), tolerance_rad);
}

std::vector<float> floats(std::initializer_list<Quat> quats) {
  std::vector<float> out;
  for (const Quat& q : quats)
    for (const double c : q) out.push_back(static_cast<float>(c));
  return out;
}

TEST(Sample, JointsWithoutTracksKeepTheirRestPose) {
  TestClip clip;
  clip.add(4, TrackPath::translation, Interpolation::linear, {0, 1}, {7, 8, 9, 7, 8, 9});
  const Sampled s(clip, 0.5f);
  ASSERT_EQ(s.status, Status::ok);
  for (std::size_t j = 0; j < 6; ++j) {
    expect_vec(s.translation(j), j == 4 ? Vec3{7, 8, 9} : six_joints()[j].translation);
    expect_vec(joint_of(s.out.data(), j).scale, {1, 2, 3});
  }
  for (std::size_t lane = 6; lane < 8; ++lane) {  // past the last joint: the identity
    expect_vec(s.translation(lane), {0, 0, 0});
    expect_vec(joint_of(s.out.data(), lane).scale, {1, 1, 1});
    expect_rotation(s.rotation(lane), {0, 0, 0, 1}, 1e-9);
  }
}

TEST(Sample, AClipWithoutTracksIsTheRestPose) {
  const Sampled s(TestClip{}, 3.0f);
  ASSERT_EQ(s.status, Status::ok);
  for (std::size_t j = 0; j < 6; ++j) expect_vec(s.translation(j), six_joints()[j].translation);
}

TEST(Sample, LinearTranslation) {
  TestClip clip;
  clip.add(1, TrackPath::translation, Interpolation::linear, {1, 2, 4}, {0, 0, 0, 10, -20, 30, 20, -20, 30});
  const struct {
    float time_s;
    Vec3 want;
  } cases[] = {{-5, {0, 0, 0}},    {0, {0, 0, 0}},     {1, {0, 0, 0}},     {1.25f, {2.5, -5, 7.5}},
               {2, {10, -20, 30}}, {3, {15, -20, 30}}, {4, {20, -20, 30}}, {100, {20, -20, 30}}};
  int count = 0;
  for (const auto& c : cases) {
    expect_vec(Sampled(clip, c.time_s).translation(1), c.want);
    ++count;
  }
  EXPECT_EQ(count, 8);
}

TEST(Sample, StepHoldsUntilTheVeryKey) {
  TestClip clip;
  clip.add(2, TrackPath::scale, Interpolation::step, {0.1f, 0.7f, 1.3f}, {1, 1, 1, 2, 2, 2, 3, 3, 3});
  const auto scale = [&](float time_s) { return joint_of(Sampled(clip, time_s).out.data(), 2).scale[0]; };
  EXPECT_EQ(scale(0.0f), 1);
  EXPECT_EQ(scale(0.1f), 1);
  EXPECT_EQ(scale(std::nextafter(0.7f, 0.0f)), 1);
  EXPECT_EQ(scale(0.7f), 2);
  EXPECT_EQ(scale(std::nextafter(0.7f, 1.0f)), 2);
  EXPECT_EQ(scale(std::nextafter(1.3f, 0.0f)), 2);
  EXPECT_EQ(scale(1.3f), 3);
  EXPECT_EQ(scale(9.0f), 3);
}

TEST(Sample, LinearRotationIsSpherical) {
  const Quat a = test::axis_angle({1, 2, 3}, 0.3), b = test::axis_angle({-1, 0.5, 2}, 2.6);
  TestClip clip;
  clip.add(5, TrackPath::rotation, Interpolation::linear, {0, 2}, floats({a, b}));
  ASSERT_GT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3], 0) << "the file's keys are on the shorter arc";
  int cases = 0;
  for (int i = 0; i <= 32; ++i, ++cases) {
    expect_rotation(Sampled(clip, static_cast<float>(i) / 16).rotation(5), test::slerp(a, b, i / 32.0));
  }
  EXPECT_EQ(cases, 33);
}

// A quarter turn about z at its middle is an eighth turn: sin and cos of π/8, by hand.
TEST(Sample, HalfOfAQuarterTurn) {
  const float h = 0.70710678f;
  TestClip clip;
  clip.add(0, TrackPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, h, h});
  const Quat q = Sampled(clip, 0.5f).rotation(0);
  EXPECT_NEAR(q[2], 0.38268343, 1e-6);
  EXPECT_NEAR(q[3], 0.92387953, 1e-6);
}

// glTF 2.0 appendix C by hand: at t = ½ the weights are ½, ⅛ of the interval, ½ and -⅛ of the interval.
TEST(Sample, CubicSplineTranslation) {
  TestClip clip;
  clip.add(3, TrackPath::translation, Interpolation::cubic_spline, {1, 3},
           {99, 99, 99, 1, 2, 3, 4, 0, -4, 8, -8, 0, 5, 6, 7, 99, 99, 99});
  expect_vec(Sampled(clip, 2).translation(3), {3 + 2 * (4 - 8) / 8.0, 4 + 2 * (0 + 8) / 8.0, 5 + 2 * -4 / 8.0});
  expect_vec(Sampled(clip, 1).translation(3), {1, 2, 3});
  expect_vec(Sampled(clip, 0).translation(3), {1, 2, 3});
  expect_vec(Sampled(clip, 3).translation(3), {5, 6, 7});
  expect_vec(Sampled(clip, 4).translation(3), {5, 6, 7});
  // t = ¼: (54, 18, 10, -6) / 64 with the interval of 2 s in the tangents.
  expect_vec(Sampled(clip, 1.5f).translation(3),
             {(54 * 1 + 18 * 4 + 10 * 5 - 6 * 8) / 64.0, (54 * 2 + 18 * 0 + 10 * 6 + 6 * 8) / 64.0,
              (54 * 3 - 18 * 4 + 10 * 7) / 64.0});
}

TEST(Sample, CubicSplineRotationIsNormalisedAndKeepsItsSigns) {
  const Quat a = {0, 0, 0, 1}, b = {0, 0, -0.6, -0.8};  // opposite hemispheres: the curve goes the long way, as drawn
  TestClip clip;
  clip.add(0, TrackPath::rotation, Interpolation::cubic_spline, {0, 1},
           floats({{0, 0, 0, 0}, a, {0, 1, 0, 0}, {0.5, 0, 0, 0}, b, {0, 0, 0, 0}}));
  // t = ¼: (54 a + 9 out + 10 b - 3 in) / 64.
  Quat want = {-3 * 0.5, 9, 10 * -0.6, 54 - 8};
  want = test::normalised(want);
  expect_rotation(Sampled(clip, 0.25f).rotation(0), want);
}

// A curve through nothing, and one beyond numbers: neither turns, and both can be blended.
TEST(Sample, CubicSplineRotationAlwaysHasALength) {
  const std::vector<float> through_nothing = floats({{0, 0, 0, 0},
                                                     {0, 0, 0, 1},
                                                     {0, 0, 0, 0},  //
                                                     {0, 0, 0, 0},
                                                     {0, 0, 0, -1},
                                                     {0, 0, 0, 0}}),
                           beyond = floats({{0, 0, 0, 0},
                                            {1e30, 0, 0, 1},
                                            {1e30, 0, 0, 0},  //
                                            {0, 0, 0, 0},
                                            {1e30, 0, 0, -1},
                                            {0, 0, 0, 0}});
  for (const std::vector<float>& values : {through_nothing, beyond}) {
    TestClip clip;
    clip.add(0, TrackPath::rotation, Interpolation::cubic_spline, {0, 1}, values);
    expect_rotation(Sampled(clip, 0.5f).rotation(0), {0, 0, 0, 1});
  }
}

TEST(Sample, OneKeyHoldsForEver) {
  for (const Interpolation i : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
    TestClip clip;
    std::vector<float> values = {4, 5, 6};
    if (i == Interpolation::cubic_spline) values = {9, 9, 9, 4, 5, 6, 9, 9, 9};
    clip.add(1, TrackPath::translation, i, {2}, values);
    for (const float time_s : {0.0f, 2.0f, 3.0f}) expect_vec(Sampled(clip, time_s).translation(1), {4, 5, 6});
  }
}

TEST(Sample, TracksMayShareTimes) {
  TestClip clip;
  clip.add(0, TrackPath::translation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 1, 1});
  clip.add(1, TrackPath::translation, Interpolation::linear, {0, 2}, {0, 0, 0, 1, 1, 1});
  clip.tracks.push_back(clip.tracks.back());
  clip.tracks.back().joint = 2;
  const Sampled s(clip, 0.5f);
  expect_vec(s.translation(0), {0.5, 0.5, 0.5});
  expect_vec(s.translation(1), {0.25, 0.25, 0.25});
  expect_vec(s.translation(2), {0.25, 0.25, 0.25});
}

TEST(Sample, InfiniteTimesAreTheEnds) {
  TestClip clip;
  clip.add(1, TrackPath::translation, Interpolation::linear, {1, 2}, {0, 0, 0, 10, 10, 10});
  expect_vec(Sampled(clip, std::numeric_limits<float>::infinity()).translation(1), {10, 10, 10});
  expect_vec(Sampled(clip, -std::numeric_limits<float>::infinity()).translation(1), {0, 0, 0});
}

TEST(Sample, ManyKeysFindTheirInterval) {
  std::vector<float> times, values;
  for (int i = 0; i < 301; ++i) {
    times.push_back(static_cast<float>(i * i) / 256);  // uneven and exact
    values.insert(values.end(), {static_cast<float>(i), 0, 0});
  }
  TestClip clip;
  clip.add(0, TrackPath::translation, Interpolation::linear, times, values);
  int cases = 0;
  for (int i = 0; i < 300; ++i, ++cases) {
    const float middle = (times[static_cast<std::size_t>(i)] + times[static_cast<std::size_t>(i) + 1]) / 2;
    EXPECT_NEAR(Sampled(clip, middle).translation(0)[0], i + 0.5, 1e-4);
    EXPECT_EQ(Sampled(clip, times[static_cast<std::size_t>(i)]).translation(0)[0], i);
  }
  EXPECT_EQ(cases, 300);
}

}  // namespace
}  // namespace marrow
