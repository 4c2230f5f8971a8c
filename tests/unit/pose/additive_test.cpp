// make_additive and add against quaternion products in double precision.
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/blend.h"
#include "marrow/sample.h"
#include "support/expect_joint.h"
#include "support/poses.h"

namespace marrow {
namespace {

using test::Poses;
using test::Quat;

// A pose is not a change, and a change is not a pose.
static_assert(!std::is_constructible_v<Span<const AdditiveTransform>, std::vector<SoaTransform>&>);
static_assert(!std::is_constructible_v<Span<const AdditiveTransform>, Span<const SoaTransform>>);
static_assert(!std::is_constructible_v<Span<const SoaTransform>, std::vector<AdditiveTransform>&>);
static_assert(!std::is_convertible_v<SoaTransform, AdditiveTransform>);

Quat multiply(const Quat& a, const Quat& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

test::TestJoint added(const test::TestJoint& base, const test::TestJoint& pose, const test::TestJoint& reference,
                      double w) {
  const Quat& r = reference.rotation;
  Quat change = multiply(pose.rotation, {-r[0], -r[1], -r[2], r[3]});
  const double sign = change[3] < 0 ? -1 : 1;
  for (double& x : change) x *= w * sign;
  change[3] += 1 - w;
  test::TestJoint out{-1, {}, test::normalised(multiply(change, base.rotation)), {}};
  for (std::size_t i = 0; i < 3; ++i) {
    out.translation[i] = base.translation[i] + w * (pose.translation[i] - reference.translation[i]);
    out.scale[i] = base.scale[i] * (1 + w * (pose.scale[i] / reference.scale[i] - 1));
  }
  return out;
}

TEST(Additive, AnyWeightAndMask) {
  int cases = 0;
  for (std::size_t joints = 3; joints <= 24; ++joints) {
    Poses p(joints, joints, 3);
    std::vector<AdditiveTransform> change(p.groups());
    ASSERT_EQ(make_additive(p.skeleton, p.pose[1], p.pose[2], change), Status::ok);
    for (const float weight : {0.125f, 0.6f, 1.0f}) {
      for (const bool masked : {false, true}) {
        p.out = p.pose[0];
        const AdditiveLayer layer{change, weight, masked ? p.masks(0) : Span<const float>()};
        ASSERT_EQ(add(p.skeleton, layer, p.out), Status::ok);
        for (std::size_t j = 0; j < joints; ++j, ++cases) {
          const double w = static_cast<double>(weight * (masked ? p.mask[0][j] : 1.0f));
          const auto joint = [j](const std::vector<SoaTransform>& pose) { return test::joint_of(pose.data(), j); };
          test::expect_joint(joint(p.out), added(joint(p.pose[0]), joint(p.pose[1]), joint(p.pose[2]), w), 1e-5);
          EXPECT_TRUE(w != 0 || test::same_bits(p.out, p.pose[0], j));
        }
      }
    }
  }
  EXPECT_EQ(cases, 22 * 27 / 2 * 6);
}

TEST(Additive, OfTheReferenceIsTheIdentity) {
  Poses p(31, 21, 2);
  std::vector<AdditiveTransform> change(p.groups());
  ASSERT_EQ(make_additive(p.skeleton, p.pose[1], p.pose[1], change), Status::ok);
  for (std::size_t j = 0; j < 21; ++j) {
    const test::TestJoint c = test::joint_of(&change[j / 4].change - j / 4, j);
    EXPECT_EQ(c.translation, (test::Vec3{0, 0, 0}));
    EXPECT_EQ(c.rotation, (Quat{0, 0, 0, 1}));
    EXPECT_EQ(c.scale, (test::Vec3{1, 1, 1}));
  }
  p.out = p.pose[0];
  ASSERT_EQ(add(p.skeleton, {change, 1, {}}, p.out), Status::ok);
  for (std::size_t j = 0; j < 21; ++j)
    test::expect_joint(test::joint_of(p.out.data(), j), test::joint_of(p.pose[0].data(), j), 2e-7);
}

TEST(Additive, TheWholeChangeOnTheReferenceIsThePose) {
  Poses p(32, 21, 2);
  std::vector<AdditiveTransform> change(p.groups());
  ASSERT_EQ(make_additive(p.skeleton, p.pose[0], p.pose[1], change), Status::ok);
  p.out = p.pose[1];
  ASSERT_EQ(add(p.skeleton, {change, 1, {}}, p.out), Status::ok);
  for (std::size_t j = 0; j < 21; ++j)
    test::expect_joint(test::joint_of(p.out.data(), j), test::joint_of(p.pose[0].data(), j), 2e-6);
}

// A clip that holds a pose still, marked as the cooker marks it.
struct AdditiveClip {
  AdditiveClip(const Poses& p, const std::vector<SoaTransform>& pose, const std::vector<SoaTransform>* reference) {
    for (std::uint16_t j = 0; j < p.skeleton.joint_count; ++j) {
      const test::TestJoint joint = test::joint_of(pose.data(), j);
      const auto add = [&](TrackPath path, const auto& v) {
        keys.add(j, path, Interpolation::step, {0}, {v.begin(), v.end()});
      };
      add(TrackPath::translation, floats(joint.translation));
      add(TrackPath::rotation, floats(joint.rotation));
      add(TrackPath::scale, floats(joint.scale));
    }
    clip = keys.view();
    clip.joint_count = p.skeleton.joint_count;
    clip.additive = true;
    clip.reference = reference != nullptr ? reference->data() : nullptr;
  }
  template <class Vector>
  static std::vector<float> floats(const Vector& v) {
    std::vector<float> out;
    for (const double x : v) out.push_back(static_cast<float>(x));
    return out;
  }
  test::TestClip keys;
  Clip clip;
};

TEST(Additive, ClipsGiveChangesFromTheirReference) {
  int cases = 0;
  for (const bool own : {false, true}) {
    Poses p(35, 21, 3);
    const AdditiveClip a(p, p.pose[1], own ? &p.pose[2] : nullptr);
    std::vector<AdditiveTransform> change(p.groups());
    ASSERT_EQ(sample_additive(p.skeleton, a.clip, 0.5f, change), Status::ok);
    p.out = p.pose[0];
    ASSERT_EQ(add(p.skeleton, {change, 1, {}}, p.out), Status::ok);
    for (std::size_t j = 0; j < 21; ++j, ++cases) {
      const test::TestJoint reference = test::joint_of(own ? p.pose[2].data() : p.skeleton.rest, j);
      const test::TestJoint want =
          added(test::joint_of(p.pose[0].data(), j), test::joint_of(p.pose[1].data(), j), reference, 1);
      test::expect_joint(test::joint_of(p.out.data(), j), want, 1e-5);
    }
  }
  EXPECT_EQ(cases, 42);
}

TEST(Additive, ClipsOfOneKindAreNotTakenForTheOther) {
  Poses p(36, 21, 2);
  AdditiveClip a(p, p.pose[0], &p.pose[1]);
  p.out = p.pose[1];
  EXPECT_EQ(sample(p.skeleton, a.clip, 0.5f, p.out), Status::bad_argument);
  EXPECT_TRUE(p.same(p.out, p.pose[1]));
  std::vector<AdditiveTransform> change(p.groups());
  EXPECT_EQ(sample_additive(p.skeleton, a.clip, 0.5f, {change.data(), change.size() - 1}), Status::bad_argument);
  EXPECT_EQ(sample_additive(p.skeleton, a.clip, std::nanf(""), change), Status::bad_argument);
  Clip of_others = a.clip;
  of_others.joint_count = 17;
  EXPECT_EQ(sample_additive(p.skeleton, of_others, 0.5f, change), Status::bad_argument);
  a.clip.additive = false;
  EXPECT_EQ(sample_additive(p.skeleton, a.clip, 0.5f, change), Status::bad_argument);
  EXPECT_EQ(change[0].change.rotation[3][0], 0) << "nothing was written";
  EXPECT_EQ(sample(p.skeleton, a.clip, 0.5f, p.out), Status::ok);
}

TEST(Additive, AScaleOfZeroDividesNothing) {
  Poses p(33, 4, 2);
  p.pose[1][0].scale[0][0] = 0;
  p.pose[1][0].scale[1][1] = -0.0f;
  std::vector<AdditiveTransform> change(1);
  ASSERT_EQ(make_additive(p.skeleton, p.pose[0], p.pose[1], change), Status::ok);
  EXPECT_EQ(change[0].change.scale[0][0], 1.0f);
  EXPECT_EQ(change[0].change.scale[1][1], 1.0f);
}

TEST(Additive, BadCallsWriteNothing) {
  Poses p(34, 21, 2);
  p.out = p.pose[0];
  std::vector<AdditiveTransform> change(p.groups());
  const std::size_t few = p.groups() - 1;
  EXPECT_EQ(make_additive(p.skeleton, {p.pose[0].data(), few}, p.pose[1], change), Status::bad_argument);
  EXPECT_EQ(make_additive(p.skeleton, p.pose[0], {p.pose[1].data(), few}, change), Status::bad_argument);
  EXPECT_EQ(make_additive(p.skeleton, p.pose[0], p.pose[1], {change.data(), few}), Status::bad_argument);
  ASSERT_EQ(make_additive(p.skeleton, p.pose[0], p.pose[1], change), Status::ok);
  for (const float weight : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(add(p.skeleton, {change, weight, {}}, p.out), Status::bad_argument);
  EXPECT_EQ(add(p.skeleton, {{change.data(), few}, 1, {}}, p.out), Status::bad_argument);
  EXPECT_EQ(add(p.skeleton, {change, 1, {p.mask[0].data(), 4 * few}}, p.out), Status::bad_argument);
  EXPECT_EQ(add(p.skeleton, {change, 1, {}}, {p.out.data(), few}), Status::bad_argument);
  EXPECT_TRUE(p.same(p.out, p.pose[0]));
}

// The ratio to a scale that is next to nothing would be infinite.
TEST(Additive, RatiosOfTinyScalesAreFinite) {
  test::Poses p(3, 4, 2);
  for (auto& axis : p.pose[0][0].scale) axis[1] = 1e15f;
  for (const float tiny : {0.0f, 1e-45f, -1e-38f, 1e-25f}) {
    for (auto& axis : p.pose[1][0].scale) axis[1] = tiny;
    std::vector<AdditiveTransform> change(1);
    ASSERT_EQ(make_additive(p.skeleton, p.pose[0], p.pose[1], change), Status::ok);
    for (const auto& axis : change[0].change.scale) EXPECT_EQ(axis[1], 1.0f) << tiny;
  }
}

}  // namespace
}  // namespace marrow
