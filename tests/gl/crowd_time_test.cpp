// Where an instance of a crowd is at a time: frames, clocks and blends against the clips themselves, in double.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "gl/support/troop.h"
#include "gles3/crowd/crowd.h"
#include "support/allocations.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

using gles3::CrowdInstance;
using gles3::CrowdPlay;

constexpr double kTickS = 1.0 / 16384;

// Two clips of a hand that turns about z, one round in `seconds`: what its joint does at any time is known.
struct Clock {
  explicit Clock(float seconds) : skeleton(std::vector<TestJoint>{{}}) {
    const float half = 0.70710678f;
    const std::vector<float> times = {0, seconds / 4, seconds / 2, 3 * seconds / 4, seconds};
    clip.add(0, TrackPath::rotation, Interpolation::linear, times,
             {0, 0, 0, 1, 0, 0, half, half, 0, 0, 1, 0, 0, 0, half, -half, 0, 0, 0, -1});
    slide.add(0, TrackPath::translation, Interpolation::linear, {0, seconds}, {0, 0, 0, seconds, 0, 0});
  }
  TestSkeleton skeleton;
  TestClip clip, slide;
};

double turn_of(const Affine& m) {
  return std::atan2(static_cast<double>(m.rows[1][0]), static_cast<double>(m.rows[0][0])) / (2 * M_PI);
}

double apart(double a, double b) {
  const double d = a - b;
  return std::fabs(d - std::round(d));
}

TEST(CrowdTime, APlanHasWholeStepsAndAFrameMore) {
  const Clock clock(2.01f);
  const gles3::CrowdSource sources[] = {{clock.clip.view(), true}, {clock.slide.view(), false}};
  gles3::CrowdClip clips[2];
  std::uint32_t count = 0;
  ASSERT_EQ(gles3::plan_crowd({sources, 2}, 10, {clips, 2}, count), Status::ok);
  EXPECT_EQ(clips[0].steps, 21u);  // 20.1, at 10 a second or more
  EXPECT_EQ(clips[1].first_frame, 22u);
  EXPECT_FALSE(clips[1].loops);
  EXPECT_EQ(count, 44u);
}

TEST(CrowdTime, FramesAreTheClipsOwnAndLoopsClose) {
  const Clock clock(2);
  const Reel reel(clock.skeleton.view(),
                  {{clock.clip.view(), true}, {clock.slide.view(), true}, {clock.slide.view(), false}}, 10);
  ASSERT_EQ(reel.frames.frame_count, 63u);
  for (std::size_t i = 0; i <= 20; ++i) {
    const auto x = [&](std::size_t clip) { return reel.matrices[21 * clip + i].rows[0][3]; };
    EXPECT_LT(apart(turn_of(reel.matrices[i]), static_cast<double>(i) / 20), 1e-6);
    EXPECT_NEAR(x(1), i == 20 ? 0 : 0.1f * static_cast<float>(i), 1e-6f) << "then its first frame";
    EXPECT_NEAR(x(2), 0.1f * static_cast<float>(i), 1e-6f) << "then nothing";
  }
}

// Frames 1/100 of a round apart: between them a chord is off by 1e-5 rounds at most in angle.
TEST(CrowdTime, ALoopGoesRoundForADayAndAHalf) {
  const float seconds = 2;
  const Clock clock(seconds);
  const Reel reel(clock.skeleton.view(), {{clock.clip.view(), true}}, 50);
  for (const double start_s : {0.0, -0.3, 7.25, 1e9 + 0.1}) {
    for (const float speed : {1.0f, -1.0f, 0.37f, 2.9f, 0.0f}) {
      CrowdInstance instance;
      instance.a = {0, 0.7f, speed, start_s};
      for (const double after_s : {0.0, 0.013, 1.987, 59.5, 3600.01, 86400.123, 36 * 3600.0, -100.0, -36 * 3600.0}) {
        Affine got;
        ASSERT_EQ(gles3::crowd_joint(reel.frames, instance, start_s + after_s, 0, got), Status::ok);
        const double want = (0.7 + static_cast<double>(speed) * after_s) / static_cast<double>(seconds);
        // Two roundings to ticks, the rate's 2⁻⁴⁹ a tick, 2⁻¹⁶ of a frame, and the chord.
        const double most = (std::fabs(static_cast<double>(speed)) * kTickS) / static_cast<double>(seconds) +
                            std::fabs(after_s) * 16384 * 0x1p-49 + 0x1p-16 / 100 + 1.1e-5;
        EXPECT_LT(apart(turn_of(got), want), most) << start_s << " " << speed << " " << after_s;
      }
    }
  }
}

TEST(CrowdTime, AClipThatDoesNotLoopStaysAtItsEnds) {
  const float seconds = 2;
  const Clock clock(seconds);
  const Reel reel(clock.skeleton.view(), {{clock.slide.view(), false}}, 10);
  for (const float speed : {1.0f, 0.25f, 30.0f, -1.0f, -30.0f, 0.0f}) {
    for (const float phase : {0.0f, 0.5f, 2.0f, 5.0f, -5.0f}) {
      CrowdInstance instance;
      instance.a = {0, phase, speed, 10};
      const double from = std::fmin(2, std::fmax(0, static_cast<double>(phase)));
      for (const double time_s : {10.0, 10.3, 9.9, 12.0, 8.0, 1000.0, -1000.0, 10 + 36 * 3600.0, 10 - 36 * 3600.0}) {
        Affine got;
        ASSERT_EQ(gles3::crowd_joint(reel.frames, instance, time_s, 0, got), Status::ok);
        const double want = std::fmin(2, std::fmax(0, from + static_cast<double>(speed) * (time_s - 10)));
        EXPECT_NEAR(static_cast<double>(got.rows[0][3]), want,
                    1e-5 + 2 * std::fabs(static_cast<double>(speed)) * kTickS)
            << speed << " " << phase << " " << time_s;
      }
    }
  }
}

TEST(CrowdTime, ABlendIsLinear) {
  const Clock clock(2);
  const Reel reel(clock.skeleton.view(), {{clock.slide.view(), true}, {clock.slide.view(), false}}, 10);
  CrowdInstance instance;
  instance.world_from_model = {{{0, -2, 0, 5}, {2, 0, 0, 6}, {0, 0, 2, 7}}};
  instance.a = {0, 0, 1, 0};
  instance.b = {1, 0, -1, 0};
  instance.b.phase_s = 1.5f;
  instance.blend_start_s = 0.5;
  instance.blend_s = 0.5f;
  const auto at = [&](double time_s) {
    Affine got;
    EXPECT_EQ(gles3::crowd_joint(reel.frames, instance, time_s, 0, got), Status::ok);
    EXPECT_NEAR(got.rows[0][1], -2, 1e-6f);
    EXPECT_NEAR(got.rows[0][3], 5, 1e-6f) << "x of the character is y of the scene";
    EXPECT_NEAR(got.rows[2][3], 7, 1e-6f);
    return static_cast<double>(got.rows[1][3] - 6) / 2;
  };
  EXPECT_NEAR(at(0.25), 0.25, 2e-4);  // a alone
  EXPECT_NEAR(at(0.5), 0.5, 2e-4);
  EXPECT_NEAR(at(0.625), 0.75 * 0.625 + 0.25 * 0.875, 2e-4);
  EXPECT_NEAR(at(0.75), 0.5 * 0.75 + 0.5 * 0.75, 2e-4);
  EXPECT_NEAR(at(0.875), 0.25 * 0.875 + 0.75 * 0.625, 2e-4);
  EXPECT_NEAR(at(1.0), 0.5, 2e-4);  // b alone
  EXPECT_NEAR(at(4.0), 0, 2e-4);
  instance.blend_s = 0;
  EXPECT_NEAR(at(0.4375), 0.4375, 2e-4);
  EXPECT_NEAR(at(0.5), 1.0, 2e-4) << "at once";
}

TEST(CrowdTime, BadNumbersAreRefused) {
  const Clock clock(2);
  const Reel reel(clock.skeleton.view(), {{clock.clip.view(), true}}, 10);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  Affine got;
  CrowdInstance good;
  EXPECT_EQ(gles3::crowd_joint(reel.frames, good, 0, 0, got), Status::bad_argument) << "nothing to play";
  good.a = good.b = {0, 0, 1, 0};
  EXPECT_EQ(gles3::crowd_joint(reel.frames, good, 0, 0, got), Status::ok);
  EXPECT_EQ(gles3::crowd_joint(reel.frames, good, 0, 1, got), Status::bad_argument);
  EXPECT_EQ(gles3::crowd_pose(reel.frames, good, 0, {&got, 0}), Status::bad_argument);
  for (const double time_s : {static_cast<double>(inf), static_cast<double>(nan), 1e300, -2e12})
    EXPECT_EQ(gles3::crowd_joint(reel.frames, good, time_s, 0, got), Status::bad_argument);
  int refused = 0;
  const auto refuse = [&](auto&& spoil) {
    CrowdInstance bad = good;
    spoil(bad);
    EXPECT_EQ(gles3::crowd_joint(reel.frames, bad, 0, 0, got), Status::bad_argument) << refused;
    ++refused;
  };
  for (CrowdPlay CrowdInstance::*play : {&CrowdInstance::a, &CrowdInstance::b}) {
    refuse([&](CrowdInstance& i) { (i.*play).clip = 1; });
    for (const float bad : {inf, -inf, nan}) {
      refuse([&](CrowdInstance& i) { (i.*play).speed = bad; });
      refuse([&](CrowdInstance& i) { (i.*play).phase_s = bad; });
      refuse([&](CrowdInstance& i) { (i.*play).start_s = static_cast<double>(bad); });
    }
  }
  for (const float bad : {inf, nan}) {
    refuse([&](CrowdInstance& i) { i.blend_s = bad; });
    refuse([&](CrowdInstance& i) { i.blend_start_s = static_cast<double>(bad); });
    refuse([&](CrowdInstance& i) { i.colour[3] = bad; });
    refuse([&](CrowdInstance& i) { i.world_from_model.rows[2][3] = bad; });
  }
  refuse([&](CrowdInstance& i) { i.blend_s = -1; });
  EXPECT_EQ(refused, 2 * 10 + 2 * 4 + 1);
  // Finite is not refused, however far.
  for (const float large : {1e38f, -1e38f, 1e-40f}) {
    CrowdInstance far = good;
    far.a.speed = far.a.phase_s = far.b.speed = far.b.phase_s = large;
    far.blend_s = std::fabs(large);
    for (const double time_s : {0.0, 1e12, -1e12, 1e-300}) {
      ASSERT_EQ(gles3::crowd_joint(reel.frames, far, time_s, 0, got), Status::ok);
      for (const auto& row : got.rows)
        for (const float x : row) EXPECT_LE(std::fabs(x), 1.001f);
    }
  }
}

TEST(CrowdTime, BadPlansAreRefused) {
  const Clock clock(2), endless(1e30f);
  const gles3::CrowdSource source{clock.clip.view(), true}, long_one{endless.clip.view(), true};
  gles3::CrowdClip clip;
  std::uint32_t count = 7;
  EXPECT_EQ(gles3::plan_crowd({&source, 0}, 30, {&clip, 1}, count), Status::bad_argument);
  EXPECT_EQ(gles3::plan_crowd({&source, 1}, 30, {&clip, 0}, count), Status::bad_argument);
  for (const float rate :
       {0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(gles3::plan_crowd({&source, 1}, rate, {&clip, 1}, count), Status::bad_argument);
  EXPECT_EQ(gles3::plan_crowd({&source, 1}, 40000, {&clip, 1}, count), Status::unsupported) << "80 000 steps";
  EXPECT_EQ(gles3::plan_crowd({&long_one, 1}, 30, {&clip, 1}, count), Status::unsupported);
  const std::vector<gles3::CrowdSource> many(20, source);
  std::vector<gles3::CrowdClip> clips(20);
  EXPECT_EQ(gles3::plan_crowd(many, 30000, clips, count), Status::unsupported) << "1.2 million frames";
  gles3::CrowdSource additive = source;
  additive.clip.additive = true;
  EXPECT_EQ(gles3::plan_crowd({&additive, 1}, 30, {&clip, 1}, count), Status::bad_argument);
  EXPECT_EQ(count, 7u) << "written on failure";

  ASSERT_EQ(gles3::plan_crowd({&source, 1}, 30, {&clip, 1}, count), Status::ok);
  const Skeleton skeleton = clock.skeleton.view();
  std::vector<SoaTransform> scratch(1);
  std::vector<Affine> matrices(count);
  gles3::CrowdFrames frames;
  const auto bake = [&](const gles3::CrowdClip& with, std::size_t rooms, std::size_t room) {
    return gles3::bake_crowd(skeleton, {&source, 1}, {&with, 1}, {scratch.data(), rooms}, {matrices.data(), room},
                             frames);
  };
  EXPECT_EQ(bake(clip, 0, count), Status::bad_argument);
  EXPECT_EQ(bake(clip, 1, count - 1), Status::bad_argument);
  gles3::CrowdClip other = clip;
  other.steps = 0;
  EXPECT_EQ(bake(other, 1, count), Status::bad_argument);
  other = clip;
  other.first_frame = 1;
  EXPECT_EQ(bake(other, 1, count), Status::bad_argument);
  EXPECT_EQ(frames.frame_count, 0u);
  EXPECT_EQ(bake(clip, 1, count), Status::ok);
}

TEST(CrowdTime, AllocatesNothing) {
  const TestCharacter c = make_character(9, 12, 4, false);
  const gles3::CrowdSource source{c.clip.view(), true};
  const Reel reel(c.skeleton.view(), {source}, 30);
  std::vector<SoaTransform> scratch(reel.skeleton.soa_size());
  std::vector<Affine> pose(reel.skeleton.joint_count), matrices(reel.matrices.size());
  gles3::CrowdClip clip;
  gles3::CrowdFrames frames;
  std::uint32_t count = 0;
  CrowdInstance instance;
  instance.a = {0, 0, 1, 0};
  std::vector<std::byte> room(gles3::kCrowdInstanceBytes);
  gles3::Crowd crowd;
  crowd.capacity = 1;
  crowd.records = room;
  gles3::Api api;
  api.BindTexture = [](unsigned, unsigned) {};
  api.TexSubImage2D = [](unsigned, int, int, int, int, int, unsigned, unsigned, const void*) {};
  int failures = 0;
  const std::size_t before = allocation_count();
  failures += gles3::plan_crowd({&source, 1}, 30, {&clip, 1}, count) != Status::ok;
  failures += gles3::bake_crowd(reel.skeleton, {&source, 1}, {&clip, 1}, scratch, matrices, frames) != Status::ok;
  failures += gles3::crowd_pose(frames, instance, 0.5, pose) != Status::ok;
  failures += gles3::crowd_joint(frames, instance, 0.5, 3, pose[0]) != Status::ok;
  failures += gles3::set_instances(api, crowd, frames, 0, {&instance, 1}) != Status::ok;
  EXPECT_EQ(allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
}

}  // namespace
}  // namespace marrow::test
