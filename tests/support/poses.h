// Poses of noise of one skeleton, and whether they are the same bits.
#pragma once

#include <cstring>
#include <vector>

#include "support/rig.h"

namespace marrow::test {

// Any rotations, in both hemispheres; translations and scales of a few units.
inline std::vector<SoaTransform> noise_pose(std::uint64_t seed, std::size_t joint_count) {
  Random random(seed);
  std::vector<TestJoint> joints(joint_count);
  for (TestJoint& j : joints) {
    for (double& x : j.translation) x = random.between(-2, 2);
    for (double& x : j.scale) x = random.between(0.5, 2);
    j.rotation = random.rotation();
  }
  return TestSkeleton(joints).rest;
}

struct Poses {
  Poses(std::uint64_t seed, std::size_t joints, std::size_t count)
      : c(make_character(seed, joints, 1, false)), skeleton(c.skeleton.view()), out(skeleton.soa_size()) {
    for (std::size_t i = 0; i < count; ++i) {
      pose.push_back(noise_pose(seed + 1000 * (i + 1), joints));
      Random random(seed + i);
      mask.emplace_back(groups() * 4);
      for (float& m : mask.back()) m = random.below(4) == 0 ? 0.0f : static_cast<float>(random.between(0, 1));
    }
  }
  std::size_t groups() const { return skeleton.soa_size(); }
  Span<const float> masks(std::size_t i) const { return mask[i]; }
  bool same(const std::vector<SoaTransform>& a, const std::vector<SoaTransform>& b) const {
    return std::memcmp(a.data(), b.data(), groups() * sizeof(SoaTransform)) == 0;
  }

  TestCharacter c;
  Skeleton skeleton;
  std::vector<std::vector<SoaTransform>> pose;
  std::vector<std::vector<float>> mask;
  std::vector<SoaTransform> out;
};

// The lanes of one joint, bit for bit.
inline bool same_bits(const std::vector<SoaTransform>& a, const std::vector<SoaTransform>& b, std::size_t joint) {
  const auto* const fa = reinterpret_cast<const float*>(&a[joint / 4]);
  const auto* const fb = reinterpret_cast<const float*>(&b[joint / 4]);
  for (std::size_t i = joint % 4; i < 40; i += 4)
    if (std::memcmp(fa + i, fb + i, sizeof(float)) != 0) return false;
  return true;
}

}  // namespace marrow::test
