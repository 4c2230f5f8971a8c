// blend and overlay against weighted means in double precision.
#include "marrow/blend.h"

#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "support/bad_numbers.h"
#include "support/expect_joint.h"
#include "support/poses.h"

namespace marrow {
namespace {

using test::kInfinity;
using test::kNan;
using test::Poses;

double factor(const BlendLayer& layer, std::size_t joint) {
  if (layer.mask.empty()) return 1;
  const double m = static_cast<double>(layer.mask[joint]);
  return m > 0 ? std::fmin(m, 1.0) : 0;  // NaN is not above 0
}

// The definition in blend.h, joint by joint.
test::TestJoint mean(const Poses& p, Span<const BlendLayer> layers, double threshold, std::size_t joint) {
  test::TestJoint sum{-1, {0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}};
  double total = 0;
  const auto take = [&](const SoaTransform* pose, double w) {
    const test::TestJoint j = test::joint_of(pose, joint);
    double cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += j.rotation[i] * sum.rotation[i];
    for (std::size_t i = 0; i < 4; ++i) sum.rotation[i] += (cosine < 0 ? -w : w) * j.rotation[i];
    for (std::size_t i = 0; i < 3; ++i) sum.translation[i] += w * j.translation[i], sum.scale[i] += w * j.scale[i];
    total += w;
  };
  for (const BlendLayer& layer : layers)
    take(layer.pose.data, static_cast<double>(layer.weight) * factor(layer, joint));
  if (total < threshold) take(p.skeleton.rest, threshold - total);
  for (std::size_t i = 0; i < 3; ++i) sum.translation[i] /= total, sum.scale[i] /= total;
  sum.rotation = test::normalised(sum.rotation);
  return sum;
}

void expect_mean(Poses& p, Span<const BlendLayer> layers, float threshold = kRestThreshold) {
  ASSERT_EQ(blend(p.skeleton, layers, p.out, threshold), Status::ok);
  for (std::size_t j = 0; j < p.skeleton.joint_count; ++j)
    test::expect_joint(test::joint_of(p.out.data(), j), mean(p, layers, static_cast<double>(threshold), j), 3e-6);
}

TEST(Blend, AnyNumberOfLayersWithAndWithoutMasks) {
  int cases = 0;
  for (std::size_t joints = 3; joints <= 12; ++joints) {
    for (std::size_t count = 0; count <= 7; ++count) {
      for (int masks = 0; masks < 3; ++masks, ++cases) {  // none, some, all
        Poses p(joints * 100 + count, joints, count);
        std::vector<BlendLayer> layers;
        for (std::size_t l = 0; l < count; ++l) {
          const bool masked = masks == 2 || (masks == 1 && l % 2 == 1);
          layers.push_back(
              {p.pose[l], 0.05f + 0.2f * static_cast<float>(l), masked ? p.masks(l) : Span<const float>()});
        }
        expect_mean(p, layers);
      }
    }
  }
  EXPECT_EQ(cases, 10 * 8 * 3);
}

TEST(Blend, TwoLayersByHand) {
  const test::TestSkeleton skeleton({{-1, {0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}}});
  const double h = 0.7071067811865476;
  const test::TestSkeleton other({{-1, {1, 2, 4}, {0, 0, -h, -h}, {3, 1, 1}}});  // a quarter about z, in the far half
  std::vector<SoaTransform> out(1);
  const BlendLayer layers[] = {{skeleton.rest, 1, {}}, {other.rest, 1, {}}};
  ASSERT_EQ(blend(skeleton.view(), {layers, 2}, out), Status::ok);
  const test::TestJoint want = {-1, {0.5, 1, 2}, test::axis_angle({0, 0, 1}, M_PI / 4), {2, 1, 1}};
  test::expect_joint(test::joint_of(out.data(), 0), want, 1e-6);
}

TEST(Blend, OnlyRatiosOfWeightsCount) {
  Poses p(7, 21, 4);
  for (const float factor : {1.0f, 0.5f, 256.0f}) {
    const BlendLayer layers[] = {{p.pose[0], 1 * factor, {}},
                                 {p.pose[1], 3 * factor, {}},
                                 {p.pose[2], 2 * factor, {}},
                                 {p.pose[3], 7 * factor, {}}};
    std::vector<SoaTransform> first = p.out;
    ASSERT_EQ(blend(p.skeleton, {layers, 4}, p.out), Status::ok);
    EXPECT_TRUE(factor == 1.0f || p.same(first, p.out)) << factor;
  }
}

TEST(Blend, OneLayerIsCopiedAndLayersWithoutWeightAreNotRead) {
  Poses p(8, 21, 3);
  for (SoaTransform& t : p.pose[1]) t.translation[0][0] = t.rotation[2][1] = kNan;
  for (int where = 0; where < 3; ++where) {
    std::vector<BlendLayer> layers(2, {p.pose[1], 0.0f, {}});
    layers.insert(layers.begin() + where, {p.pose[0], 0.7f, {}});
    ASSERT_EQ(blend(p.skeleton, layers, p.out), Status::ok);
    EXPECT_TRUE(p.same(p.out, p.pose[0]));
  }
  for (int where = 0; where < 2; ++where) {
    std::vector<BlendLayer> layers(1, {p.pose[0], 0.7f, p.masks(0)});
    ASSERT_EQ(blend(p.skeleton, layers, p.out), Status::ok);
    const std::vector<SoaTransform> without = p.out;
    layers.insert(layers.begin() + where, {p.pose[1], 0.0f, p.masks(1)});
    ASSERT_EQ(blend(p.skeleton, layers, p.out), Status::ok);
    EXPECT_TRUE(p.same(p.out, without));
  }
  // Five that count take the way for many.
  std::vector<BlendLayer> layers(5, {p.pose[2], 1.0f, {}});
  layers.insert(layers.begin(), {p.pose[1], 0.0f, {}});
  expect_mean(p, {layers.data() + 1, 5});
  const std::vector<SoaTransform> without = p.out;
  ASSERT_EQ(blend(p.skeleton, layers, p.out), Status::ok);
  EXPECT_TRUE(p.same(p.out, without));
}

TEST(Blend, WhatIsMissingIsFilledWithTheRestPose) {
  Poses p(9, 21, 2);
  ASSERT_EQ(blend(p.skeleton, {}, p.out), Status::ok);
  EXPECT_TRUE(p.same(p.out, p.c.skeleton.rest)) << "no layers";
  const BlendLayer none[] = {{p.pose[0], 0, {}}, {p.pose[1], 0, {}}};
  ASSERT_EQ(blend(p.skeleton, {none, 2}, p.out), Status::ok);
  EXPECT_TRUE(p.same(p.out, p.c.skeleton.rest)) << "a sum of 0";
  const BlendLayer little[] = {{p.pose[0], 0.03f, {}}, {p.pose[1], 0.01f, {}}};
  expect_mean(p, {little, 1});
  expect_mean(p, {little, 2});
  expect_mean(p, {little, 2}, 1.0f);
  const std::vector<float> zero(p.groups() * 4, 0.0f);
  const BlendLayer hidden[] = {{p.pose[0], 1, zero}, {p.pose[1], 1, zero}};
  expect_mean(p, {hidden, 2});
  const BlendLayer nearly[] = {{p.pose[0], 1e-30f, {}}, {p.pose[1], 1e6f, {}}};
  ASSERT_EQ(blend(p.skeleton, {nearly, 2}, p.out), Status::ok);
  EXPECT_TRUE(p.same(p.out, p.pose[1])) << "what no float would show";
}

TEST(Blend, MasksOfAnyValueAreDefined) {
  Poses p(10, 21, 2);
  std::vector<float> odd(p.groups() * 4), sane(odd.size());
  const float values[] = {kNan, -kNan, -1, 0, -0.0f, 0.25f, 1, 2, kInfinity, -kInfinity, 1e-40f};
  const float means[] = {0, 0, 0, 0, 0, 0.25f, 1, 1, 1, 0, 1e-40f};
  for (std::size_t i = 0; i < odd.size(); ++i) odd[i] = values[i % 11], sane[i] = means[i % 11];
  std::vector<SoaTransform> want(p.groups());
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}}) {
    const BlendLayer layers[] = {{p.pose[0], 1, odd}, {p.pose[1], 1, odd}};
    const BlendLayer clean[] = {{p.pose[0], 1, sane}, {p.pose[1], 1, sane}};
    ASSERT_EQ(blend(p.skeleton, {clean, count}, want), Status::ok);
    ASSERT_EQ(blend(p.skeleton, {layers, count}, p.out), Status::ok);
    EXPECT_TRUE(p.same(p.out, want)) << count;
  }
}

TEST(Blend, OutMayBeALayer) {
  Poses p(11, 21, 3);
  for (const bool masked : {false, true}) {
    const Span<const float> mask = masked ? p.masks(1) : Span<const float>();
    for (std::size_t at = 0; at < 3; ++at) {
      const BlendLayer layers[] = {{p.pose[0], 1, {}}, {p.pose[1], 1, mask}, {p.pose[2], 2, {}}};
      ASSERT_EQ(blend(p.skeleton, {layers, 3}, p.out), Status::ok);
      std::vector<SoaTransform> kept = p.pose[at];
      ASSERT_EQ(blend(p.skeleton, {layers, 3}, p.pose[at]), Status::ok);
      EXPECT_TRUE(p.same(p.out, p.pose[at]));
      p.pose[at] = kept;
    }
  }
}

TEST(Blend, BadCallsWriteNothing) {
  Poses p(12, 21, 2);
  const std::vector<SoaTransform> before = p.out;
  const std::vector<float> mask(p.groups() * 4, 0.5f);
  const auto refused = [&](BlendLayer layer, float threshold = 0.1f) {
    const BlendLayer layers[] = {{p.pose[0], 1, {}}, layer};
    EXPECT_EQ(blend(p.skeleton, {layers, 2}, p.out, threshold), Status::bad_argument);
  };
  for (const float weight : {-0.1f, -1e-40f, kNan, kInfinity, -kInfinity, 1.1e6f}) refused({p.pose[1], weight, {}});
  for (const float threshold : {0.0f, -1.0f, 1e-7f, kNan, kInfinity}) refused({p.pose[1], 1, {}}, threshold);
  refused({{p.pose[1].data(), p.groups() - 1}, 1, {}});
  refused({p.pose[1], 1, {mask.data(), mask.size() - 1}});
  refused({p.pose[1], 1, {mask.data(), p.skeleton.joint_count}});
  refused({p.pose[1], 0, {mask.data(), 1}});
  EXPECT_EQ(blend(p.skeleton, {}, {p.out.data(), p.groups() - 1}), Status::bad_argument);
  EXPECT_EQ(overlay(p.skeleton, {p.pose[1], 1.1f, {}}, p.out), Status::bad_argument);
  EXPECT_EQ(overlay(p.skeleton, {p.pose[1], kNan, {}}, p.out), Status::bad_argument);
  EXPECT_EQ(overlay(p.skeleton, {p.pose[1], 1, {mask.data(), 23}}, p.out), Status::bad_argument);
  EXPECT_EQ(overlay(p.skeleton, {{}, 1, {}}, p.out), Status::bad_argument);
  EXPECT_EQ(overlay(p.skeleton, {p.pose[1], 1, {}}, {p.out.data(), 1}), Status::bad_argument);
  EXPECT_TRUE(p.same(p.out, before));
}

TEST(Overlay, BitsOutsideTheMaskAndInsideItAreKept) {
  int outside = 0, inside = 0, between = 0;
  for (std::size_t joints = 3; joints <= 24; ++joints) {
    Poses p(joints, joints, 2);
    std::vector<float> mask(p.groups() * 4);
    test::Random random(joints);
    for (float& m : mask) m = random.below(3) < 2 ? static_cast<float>(random.below(2)) : 0.25f;
    p.out = p.pose[0];
    ASSERT_EQ(overlay(p.skeleton, {p.pose[1], 1.0f, mask}, p.out), Status::ok);
    for (std::size_t j = 0; j < joints; ++j) {
      if (mask[j] == 0.0f) {
        ++outside;
        EXPECT_TRUE(test::same_bits(p.out, p.pose[0], j));
      } else if (mask[j] == 1.0f) {
        ++inside;
        EXPECT_TRUE(test::same_bits(p.out, p.pose[1], j));
      } else {
        const BlendLayer layers[] = {{p.pose[0], 0.75f, {}}, {p.pose[1], 0.25f, {}}};
        ++between;
        test::expect_joint(test::joint_of(p.out.data(), j), mean(p, {layers, 2}, 0.1, j), 2e-6);
      }
    }
    p.out = p.pose[0];
    ASSERT_EQ(overlay(p.skeleton, {p.pose[1], 0.0f, mask}, p.out), Status::ok);
    EXPECT_TRUE(p.same(p.out, p.pose[0]));
    ASSERT_EQ(overlay(p.skeleton, {p.pose[1], 1.0f, {}}, p.out), Status::ok);
    EXPECT_TRUE(p.same(p.out, p.pose[1]));
  }
  EXPECT_GT(outside, 60);
  EXPECT_GT(inside, 60);
  EXPECT_GT(between, 60);
}

// A layer so light that the rest pose is all there is; its weight's inverse and the square of that are no floats.
TEST(Blend, NextToNoWeightGivesTheRestPose) {
  int cases = 0;
  for (const float weight : {1e-45f, 1e-40f, 1e-30f, 1e-20f, 1e-14f}) {
    for (const std::size_t count : {1u, 2u, 4u, 5u}) {
      for (const float threshold : {0.1f, 1e6f}) {
        Poses p(7, 10, count);
        std::vector<BlendLayer> layers;
        for (std::size_t l = 0; l < count; ++l) layers.push_back({p.pose[l], weight, {}});
        ASSERT_EQ(blend(p.skeleton, layers, p.out, threshold), Status::ok);
        for (std::size_t j = 0; j < p.skeleton.joint_count; ++j, ++cases)
          test::expect_joint(test::joint_of(p.out.data(), j), test::joint_of(p.skeleton.rest, j), 1e-6);
      }
    }
  }
  EXPECT_EQ(cases, 5 * 4 * 2 * 10);
}

TEST(Masks, OfAJointAndWhatHangsOnIt) {
  // 0 → 2 → {3 → 5, 4}; 1 is alone.
  const std::uint16_t parents[] = {kNoJoint, kNoJoint, 0, 2, 2, 3};
  Skeleton skeleton;
  skeleton.joint_count = 6;
  skeleton.root_count = 2;
  skeleton.parents = parents;
  std::vector<float> mask(8, 0.0f);
  ASSERT_EQ(mask_below(skeleton, 2, 0, mask), Status::ok);
  EXPECT_EQ(mask, (std::vector<float>{0, 0, 1, 1, 1, 1, 0, 0}));
  mask.assign(8, 0.0f);
  ASSERT_EQ(mask_below(skeleton, 0, 3, mask), Status::ok);
  EXPECT_EQ(mask, (std::vector<float>{0.25f, 0, 0.5f, 0.75f, 0.75f, 1, 0, 0}));
  ASSERT_EQ(mask_below(skeleton, 3, 1, mask), Status::ok);  // has less than it had
  EXPECT_EQ(mask, (std::vector<float>{0.25f, 0, 0.5f, 0.75f, 0.75f, 1, 0, 0}));
  ASSERT_EQ(mask_below(skeleton, 4, 0, mask), Status::ok);
  EXPECT_EQ(mask[4], 1);
  EXPECT_EQ(mask_below(skeleton, 6, 0, mask), Status::bad_argument);
  EXPECT_EQ(mask_below(skeleton, 0, 0, {mask.data(), 7}), Status::bad_argument);
}

}  // namespace
}  // namespace marrow
