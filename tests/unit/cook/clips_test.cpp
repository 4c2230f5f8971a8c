// Compression of clips that models rarely have: very many joints, one key, full turns, keys out of step. What is
// decoded is held against slerp and lerp in double precision, joint by joint.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cook/clip/compress/compress_clip.h"
#include "cook/clip/compress/pack_tracks.h"
#include "marrow/sample.h"
#include "support/double_math.h"

namespace marrow::cook {
namespace {

using test::Quat;
using test::Vec3;

constexpr double kError = 1e-4, kShell = 0.03, kLength = 0.1;
// The promise is about six points on the axes of a joint; about any axis, one of them goes at least √(2/3) of the
// shell's radius round. So a joint that stays in place turns by no more than this.
const double kAngle = kError / (kShell * std::sqrt(2.0 / 3));

// A tree in which every joint has up to three children, one after the other along y.
BuiltSkeleton tree(std::size_t joints) {
  BuiltSkeleton s;
  s.scene_from_root.push_back({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  s.rest.resize(soa_count(joints));
  for (SoaTransform& four : s.rest)
    for (int lane = 0; lane < 4; ++lane) {
      four.rotation[3][lane] = 1;
      for (int i = 0; i < 3; ++i) four.scale[i][lane] = 1;
    }
  for (std::size_t j = 0; j < joints; ++j) {
    s.parents.push_back(j == 0 ? kNoParent : static_cast<std::uint16_t>((j - 1) / 3));
    s.joint_names.push_back("j" + std::to_string(j));
    if (j > 0) s.rest[j / 4].translation[1][j % 4] = static_cast<float>(kLength);
  }
  return s;
}

void add_rotation(BuiltClip& clip, std::size_t joint, const std::vector<float>& times_s,
                  const std::vector<Quat>& keys) {
  if (clip.times_s.size() < times_s.size()) clip.times_s = times_s;
  clip.duration_s = std::max(clip.duration_s, times_s.back());
  clip.tracks.push_back({static_cast<std::uint16_t>(joint), TrackPath::rotation, Interpolation::linear,
                         static_cast<std::uint32_t>(times_s.size()), 0,
                         static_cast<std::uint32_t>(clip.values.size())});
  for (const Quat& q : keys)
    for (const double x : q) clip.values.push_back(static_cast<float>(x));
}

Promise promise_for(std::size_t joints) {
  Promise out;
  out.error.assign(joints, kError);
  out.shell = kShell;
  out.points.resize(joints);
  out.reach.assign(joints, kShell);
  return out;
}

// The largest angle between the decoded rotation of a joint and slerp between its keys, in radians.
double worst_angle(const BuiltSkeleton& skeleton, const BuiltClip& clip, std::size_t joint,
                   const std::vector<float>& times_s, const std::vector<Quat>& keys) {
  const Skeleton view_of = view(skeleton);
  std::vector<SoaTransform> local(view_of.soa_size());
  double worst = 0;
  std::size_t compared = 0;
  for (std::size_t k = 0; k + 1 < times_s.size(); ++k)
    for (const float u : {0.0f, 0.3f, 0.5f, 0.9f, 1.0f}) {
      const float time_s = times_s[k] + u * (times_s[k + 1] - times_s[k]);
      EXPECT_EQ(sample(view_of, view(clip, view_of), time_s, local), Status::ok);
      Quat got;
      for (std::size_t i = 0; i < 4; ++i) got[i] = static_cast<double>(local[joint / 4].rotation[i][joint % 4]);
      const double exact = static_cast<double>(time_s - times_s[k]) / static_cast<double>(times_s[k + 1] - times_s[k]);
      const Quat want = test::slerp(keys[k], keys[k + 1], exact);
      const double side = got[0] * want[0] + got[1] * want[1] + got[2] * want[2] + got[3] * want[3] < 0 ? -1 : 1;
      double apart = 0;
      for (std::size_t i = 0; i < 4; ++i) apart += (got[i] - side * want[i]) * (got[i] - side * want[i]);
      worst = std::max(worst, 2 * std::sqrt(apart));
      ++compared;
    }
  EXPECT_EQ(compared, 5 * (times_s.size() - 1));
  return worst;
}

TEST(CompressClip, AThousandJoints) {
  constexpr std::size_t kJoints = 1000;
  const BuiltSkeleton skeleton = tree(kJoints);
  const std::vector<float> times_s = {0, 0.125f, 0.25f, 0.375f};
  std::vector<std::vector<Quat>> keys;
  BuiltClip clip;
  for (std::size_t j = 0; j < kJoints; ++j) {
    keys.emplace_back();
    for (std::size_t k = 0; k < times_s.size(); ++k) {
      const double a = 0.3 * std::sin(static_cast<double>(7 * j + 3 * k));
      keys.back().push_back(test::axis_angle({1, static_cast<double>(j % 3), 0.5}, a));
    }
    add_rotation(clip, j, times_s, keys.back());
  }
  const Rig rig(skeleton);
  compress_clip(clip, skeleton, rig, promise_for(kJoints), {}, Effort::normal);
  ASSERT_EQ(clip.coded.header.track_count, kJoints);
  EXPECT_LE(clip.error.error_m, kError);
  EXPECT_LE(worst_angle(skeleton, clip, kJoints - 1, times_s, keys.back()), 2 * kAngle)
      << "a leaf: its own error and those above it";
  const Skeleton view_of = view(skeleton);
  std::vector<SoaTransform> local(view_of.soa_size());
  const std::vector<std::uint32_t> joints(32);
  SampleOptions some;
  some.joints = {joints.data(), 31};
  EXPECT_EQ(sample(view_of, view(clip, view_of), 0, local, some), Status::bad_argument) << "992 bits";
  some.joints = {joints.data(), 32};
  EXPECT_EQ(sample(view_of, view(clip, view_of), 0, local, some), Status::ok);
  // Below the root hangs everything, 0.6 m deep.
  EXPECT_LE(worst_angle(skeleton, clip, 0, times_s, keys.front()), kError / 0.3) << "the root";
}

TEST(CompressClip, APoseIsConstants) {
  const BuiltSkeleton skeleton = tree(9);
  const std::vector<Quat> key = {test::axis_angle({1, 2, 3}, 0.7)};
  BuiltClip clip;
  for (std::size_t j = 1; j < 9; ++j) add_rotation(clip, j, {0.5f}, key);
  compress_clip(clip, skeleton, Rig(skeleton), promise_for(9), {}, Effort::normal);
  EXPECT_TRUE(clip.tracks.empty());
  EXPECT_EQ(clip.coded.header.track_count, 0u);
  EXPECT_EQ(clip.coded.header.constant_count, 8u);
  EXPECT_EQ(clip.duration_s, 0.5f);
  EXPECT_LE(clip.error.error_m, kError);
  for (const float time_s : {-1.0f, 0.0f, 0.5f, 3.0f}) {
    const Skeleton view_of = view(skeleton);
    std::vector<SoaTransform> local(view_of.soa_size());
    ASSERT_EQ(sample(view_of, view(clip, view_of), time_s, local), Status::ok);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(static_cast<double>(local[2].rotation[i][0]), key[0][i], kError / kShell / 2) << time_s;
  }
}

TEST(CompressClip, WhatRestsCostsNothing) {
  const BuiltSkeleton skeleton = tree(9);
  BuiltClip clip;
  for (std::size_t j = 0; j < 9; ++j) add_rotation(clip, j, {0, 1}, {{0, 0, 0, 1}, {0, 0, 1e-7, 1}});
  compress_clip(clip, skeleton, Rig(skeleton), promise_for(9), {}, Effort::normal);
  EXPECT_TRUE(clip.tracks.empty());
  EXPECT_EQ(clip.coded.header.frame_count, 0u);
  EXPECT_EQ(clip.duration_s, 1.0f);
}

// Three whole turns, whose quaternions change sign on the way, and which no modified Rodrigues parameters span.
TEST(CompressClip, SpinsTurnOnAndOn) {
  const BuiltSkeleton skeleton = tree(3);
  std::vector<float> times_s;
  std::vector<Quat> keys;
  for (int k = 0; k <= 36; ++k) {
    times_s.push_back(static_cast<float>(k) / 32);
    keys.push_back(test::axis_angle({0, 1, 0.2}, k * 0.5235987755982988));
  }
  BuiltClip clip;
  add_rotation(clip, 1, times_s, keys);
  compress_clip(clip, skeleton, Rig(skeleton), promise_for(3), {}, Effort::normal);
  ASSERT_EQ(clip.coded.header.frame_count, 37u);
  EXPECT_LE(clip.error.error_m, kError);
  EXPECT_LE(worst_angle(skeleton, clip, 1, times_s, keys), kAngle);
}

// Keys at multiples of a third of the shortest distance between two of them.
TEST(CompressClip, KeysOutOfStep) {
  const BuiltSkeleton skeleton = tree(3);
  const std::vector<float> times_s = {0, 0.25f, 0.5f, 0.75f, 1.0833333f, 1.3333333f, 1.5833333f};
  std::vector<Quat> keys;
  for (std::size_t k = 0; k < times_s.size(); ++k)
    keys.push_back(test::axis_angle({1, 0, 0}, std::sin(2.0 * static_cast<double>(k))));
  BuiltClip clip;
  for (std::size_t j = 0; j < 3; ++j) add_rotation(clip, j, times_s, keys);
  compress_clip(clip, skeleton, Rig(skeleton), promise_for(3), {}, Effort::normal);
  EXPECT_EQ(clip.coded.times_s, times_s) << "rather than 20 frames, twelfths of a second";
  EXPECT_EQ(clip.coded.header.frame_count, 7u);
  EXPECT_EQ(clip.coded.header.time_count, 7u);
  EXPECT_LE(clip.error.error_m, kError);
  EXPECT_LE(worst_angle(skeleton, clip, 2, times_s, keys), 2 * kAngle) << "its own error and its parent's";
}

// A long thin mesh on the last joint: a shell of 3 cm would let its end stray by metres.
TEST(CompressClip, WhatHangsOnAJointCounts) {
  const BuiltSkeleton skeleton = tree(2);
  const std::vector<float> times_s = {0, 0.25f, 0.5f, 0.75f, 1};
  std::vector<Quat> keys;
  for (std::size_t k = 0; k < times_s.size(); ++k)
    keys.push_back(test::axis_angle({1, 0, 0}, 0.4 * std::sin(2.0 * static_cast<double>(k))));
  BuiltClip clip;
  add_rotation(clip, 1, times_s, keys);
  const Rig rig(skeleton);
  Promise promise = promise_for(2);
  constexpr double kReach = 5;
  promise.watch(1, {0, kReach, 0, 1}, rig);
  promise.watch(1, {0, 0, 0.5 * kShell, 1}, rig);
  ASSERT_EQ(promise.points[1].size(), 1u) << "nearer than the shell";
  EXPECT_EQ(promise.reach[1], kReach);
  compress_clip(clip, skeleton, rig, promise, {}, Effort::normal);
  ASSERT_GT(clip.coded.header.frame_count, 0u);
  EXPECT_EQ(clip.raw_because, "");
  EXPECT_LE(worst_angle(skeleton, clip, 1, times_s, keys), kError / kReach);
}

TEST(CompressClip, SaysWhyKeysStayAsTheyWere) {
  BuiltClip still;
  compress_clip(still, tree(1), Rig(tree(1)), promise_for(1), {}, Effort::normal);
  EXPECT_EQ(still.raw_because, "") << "nothing moves";
  // Two keys of noise take less room than a segment with all that belongs to it.
  const BuiltSkeleton skeleton = tree(1);
  BuiltClip two;
  add_rotation(two, 0, {0, 1}, {test::axis_angle({1, 2, 3}, 1), test::axis_angle({3, 2, 1}, -1)});
  compress_clip(two, skeleton, Rig(skeleton), promise_for(1), {}, Effort::normal);
  EXPECT_EQ(two.coded.header.frame_count, 0u);
  EXPECT_NE(two.raw_because.find("in segments its curves would be "), std::string::npos) << two.raw_because;
}

}  // namespace
}  // namespace marrow::cook
