// Compression of clips that models rarely have: very many joints, one key, full turns, keys out of step. What is
// decoded is held against slerp and lerp in double precision, joint by joint.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cook/clip/compress/compress_clip.h"
#include "cook/clip/compress/pack_tracks.h"
#include "cook/clip/compress/strays.h"
#include "marrow/sample.h"
#include "support/double_math.h"
#include "support/rig.h"

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
  s.model_from_root.push_back({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  s.rest.resize(soa_count(joints));
  for (SoaTransform& four : s.rest)
    for (int lane = 0; lane < 4; ++lane) {
      four.rotation[3][lane] = 1;
      for (int i = 0; i < 3; ++i) four.scale[i][lane] = 1;
    }
  for (std::size_t j = 0; j < joints; ++j) {
    s.parents.push_back(j == 0 ? kNoJoint : static_cast<std::uint16_t>((j - 1) / 3));
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
  // Leaves may turn by 0.05 · kError / kShell = 1.7e-4. Numbers of which the largest is m turn by no more than 2 / m,
  // as each of four is off by a half at most: with 12000 they are near enough, and no more bits than for that are
  // taken.
  for (std::size_t leaf = 2; leaf < 8; ++leaf)
    for (int i = 0; i < 4; ++i) {
      EXPECT_LE(std::abs(clip.coded.constants[leaf].v[i]), 16383) << leaf;
      EXPECT_EQ(clip.coded.constants[leaf].v[i], clip.coded.constants[2].v[i]) << leaf;
    }
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

// Float times are not even to the last bit: ten minutes on half a last place is a thousandth of a frame, after an hour
// seven. Swift joints feel that, so what is measured are the source's own times.
TEST(CompressClip, LateAndLongClipsAtAnEvenRateAreCoded) {
  const BuiltSkeleton skeleton = tree(2);
  std::size_t cases = 0, early = 0;
  for (const bool swift : {false, true})
    for (const auto& [start_s, count] :
         {std::pair(0, 301), std::pair(600, 301), std::pair(3600, 301), std::pair(0, 9001)}) {
      std::vector<float> times_s;
      for (int k = 0; k < count; ++k) times_s.push_back(static_cast<float>(start_s + k / 30.0));
      BuiltClip clip;
      std::vector<std::vector<Quat>> keys(2);
      for (std::size_t j = 0; j < 2; ++j) {
        for (int k = 0; k < count; ++k) {
          const double angle = std::sin((swift ? 0.6 : 0.1) * k + static_cast<double>(j));
          keys[j].push_back(test::axis_angle({1, 0, static_cast<double>(j)}, angle));
        }
        add_rotation(clip, j, times_s, keys[j]);
      }
      compress_clip(clip, skeleton, Rig(skeleton), promise_for(2), {}, Effort::fast);
      EXPECT_EQ(clip.raw_because, "") << start_s << " " << count;
      ASSERT_EQ(clip.coded.header.frame_count, static_cast<std::uint32_t>(count)) << start_s;
      EXPECT_LE(clip.error.share, 1);
      EXPECT_LE(worst_angle(skeleton, clip, 1, times_s, keys[1]), 2 * kAngle) << "its own and its parent's";
      if (start_s == 0 && count == 301) early = clip.coded.payload.size();
      const double frames = static_cast<double>(count - 1) / 300;
      EXPECT_LE(static_cast<double>(clip.coded.payload.size()), 1.15 * frames * static_cast<double>(early)) << start_s;
      ++cases;
    }
  EXPECT_EQ(cases, 8u);
}

// The two keys of a jump stay as they are; what does not jump is coded, with the same list of times.
TEST(CompressClip, WhatJumpsStaysRawBesideWhatDoesNot) {
  const BuiltSkeleton skeleton = tree(3);
  std::vector<float> times_s;
  for (int k = 0; k <= 60; ++k) {
    if (k == 15) times_s.push_back(std::nextafter(0.5f, 0.0f));
    times_s.push_back(static_cast<float>(k) / 30);
  }
  const Quat before = test::axis_angle({0, 0, 1}, 0.5), behind = test::axis_angle({0, 0, 1}, -2);
  std::vector<Quat> cut, even;
  for (const float t : times_s) {
    cut.push_back(t < 0.5f ? before : behind);
    even.push_back(test::axis_angle({1, 0, 0}, std::sin(3 * static_cast<double>(t))));
  }
  even[15] = even[16];
  BuiltClip clip;
  add_rotation(clip, 0, times_s, even);
  add_rotation(clip, 1, times_s, cut);
  add_rotation(clip, 2, times_s, even);
  compress_clip(clip, skeleton, Rig(skeleton), promise_for(3), {}, Effort::normal);
  ASSERT_EQ(clip.tracks.size(), 1u);
  EXPECT_EQ(clip.tracks[0].joint, 1u);
  EXPECT_EQ(clip.coded.header.frame_count, 61u) << "on even steps";
  EXPECT_EQ(clip.coded.header.time_count, 0u);
  EXPECT_LE(clip.error.error_m, kError);
  const Skeleton view_of = view(skeleton);
  std::vector<SoaTransform> local(view_of.soa_size());
  for (const float time_s : {0.1f, std::nextafter(0.5f, 0.0f), 0.5f, 1.9f}) {
    ASSERT_EQ(sample(view_of, view(clip, view_of), time_s, local), Status::ok);
    const Quat& want = time_s < 0.5f ? before : behind;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(static_cast<double>(local[0].rotation[i][1]), want[i], 1e-6) << time_s;
  }
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

// Moments of a frame and one more, of a tree whose joints are turned, moved and stretched a little beside the source.
struct Strayed {
  std::vector<std::vector<Transform>> source, decoded;  // a joint and moment
};
Strayed stray(std::size_t joints, test::Random& random) {
  const auto three = [&](double most) {
    return glm::dvec3(random.between(-most, most), random.between(-most, most), random.between(-most, most));
  };
  Strayed out{std::vector<std::vector<Transform>>(joints), std::vector<std::vector<Transform>>(joints)};
  for (std::size_t j = 0; j < joints; ++j)
    for (std::size_t e = 0; e < kMoments + 1; ++e) {
      const Quat q = random.rotation();
      Transform t{three(1), glm::dquat(q[3], q[0], q[1], q[2]), glm::dvec3(1) + three(0.5)};
      out.source[j].push_back(t);
      t.translation += three(1e-4);
      t.rotation = glm::normalize(t.rotation * glm::dquat(1, three(1e-4)));
      t.scale += three(1e-4);
      out.decoded[j].push_back(t);
    }
  return out;
}

test::Map world_of(const BuiltSkeleton& skeleton, const std::vector<std::vector<Transform>>& local, std::size_t joint,
                   std::size_t moment) {
  const Transform& t = local[joint][moment];
  const test::Map own =
      test::from_trs({t.translation.x, t.translation.y, t.translation.z},
                     {t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w}, {t.scale.x, t.scale.y, t.scale.z});
  return skeleton.parents[joint] == kNoJoint ? own : world_of(skeleton, local, skeleton.parents[joint], moment) * own;
}

// Squared, of the six points of the shell and of one that hangs on the joint.
double squared_share(const test::Map& source, const test::Map& other, const Promise& promise, std::size_t joint) {
  double worst = 0;
  const auto look = [&](const Vec3& at, double weight) {
    const double far = weight * test::length(test::minus(test::point(other, at), test::point(source, at)));
    worst = std::max(worst, far / promise.error[joint]);
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Vec3 unit{}, at{};
      unit[axis] = 1;
      at[axis] = sign * promise.shell / test::length(test::direction(source, unit));
      look(at, 1);
    }
  for (const glm::dvec4& p : promise.points[joint]) look({p.x / p.w, p.y / p.w, p.z / p.w}, p.w);
  return worst * worst;
}

TEST(Strays, AreThoseOfPosesInDoublePrecision) {
  constexpr std::size_t kJoints = 13;
  test::Random random(5);
  const BuiltSkeleton skeleton = tree(kJoints);
  const Rig rig(skeleton);
  Promise promise = promise_for(kJoints);
  for (std::size_t j = 0; j < kJoints; ++j) {
    promise.error[j] = 0.02 * static_cast<double>(1 + j % 3);
    promise.points[j].push_back({0.1, 0.3, -0.2, 0.5});
  }
  Strayed poses = stray(kJoints, random);
  Strays strays(rig, promise, {poses.source.begin(), poses.source.end()});
  ASSERT_TRUE(strays.place(poses.decoded));
  const auto share_of = [&](std::size_t j, std::size_t e) {
    return squared_share(world_of(skeleton, poses.source, j, e), world_of(skeleton, poses.decoded, j, e), promise, j);
  };
  for (const std::size_t joint : {std::size_t{0}, std::size_t{2}, std::size_t{12}}) {
    double before = 0, after = 0, worst = 0, change = 0;
    for (const std::size_t j : rig.subtree(joint))
      for (std::size_t e = 0; e < kMoments; ++e) before += std::pow(share_of(j, e), 4);
    poses.decoded[joint] = stray(1, random).decoded[0];
    for (std::size_t e = 0; e <= kMoments; ++e) {  // near the source again, but elsewhere
      poses.decoded[joint][e] = poses.source[joint][e];
      poses.decoded[joint][e].translation.x += 1e-3 * static_cast<double>(e + 1);
    }
    for (const std::size_t j : rig.subtree(joint))
      for (std::size_t e = 0; e < kMoments; ++e) {
        after += std::pow(share_of(j, e), 4);
        worst = std::max(worst, share_of(j, e));
      }
    EXPECT_NEAR(strays.worst(joint, 0, &poses.decoded[joint][0], false, 1e9f), worst, 1e-4 * worst) << joint;
    ASSERT_TRUE(strays.attempt(joint, 0, &poses.decoded[joint][0], change));
    EXPECT_NEAR(change, after - before, 1e-4 * (after + before)) << joint;
    ASSERT_TRUE(strays.attempt(joint, 1, &poses.decoded[joint][kMoments], change));
    strays.commit(joint);
    const test::Map want = world_of(skeleton, poses.decoded, kJoints - 1, 1);
    const World got = strays.decoded(kJoints - 1, 1);
    for (int r = 0; r < 3; ++r)
      EXPECT_NEAR(got.origin[r], test::point(want, {0, 0, 0})[static_cast<std::size_t>(r)], 1e-6) << joint;
  }
}

// More effort is never more bytes here, and every effort keeps the promise.
TEST(Clips, EffortsKeepThePromise) {
  constexpr std::size_t kJoints = 9;
  const BuiltSkeleton skeleton = tree(kJoints);
  std::vector<float> times_s;
  for (int i = 0; i <= 60; ++i) times_s.push_back(static_cast<float>(i) / 30);
  std::size_t last = SIZE_MAX;
  for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
    BuiltClip clip;
    for (std::size_t j = 0; j < kJoints; ++j) {
      std::vector<Quat> keys;
      for (const float t : times_s)
        keys.push_back(test::axis_angle({0.6, 0, 0.8},
                                        0.7 * std::sin(static_cast<double>(t) * (2 + 0.3 * static_cast<double>(j)))));
      add_rotation(clip, j, times_s, keys);
      clip.tracks.back().first_value = static_cast<std::uint32_t>(clip.values.size() - 4 * keys.size());
    }
    compress_clip(clip, skeleton, Rig(skeleton), promise_for(kJoints), {}, effort);
    ASSERT_GT(clip.coded.payload.size(), 0u);
    EXPECT_LE(clip.error.share, 1);
    EXPECT_LE(clip.coded.payload.size(), last);
    last = clip.coded.payload.size();
  }
}

}  // namespace
}  // namespace marrow::cook
