// Chains of noise for inverse kinematics to solve: skeletons in memory, targets that they can reach, and forward
// kinematics in double precision that says whether they did.
#pragma once

#include <cmath>
#include <vector>

#include "support/rig.h"

namespace marrow::test {

// model_from_joint of every joint of a pose, in double precision.
inline std::vector<Map> scene_maps(const TestSkeleton& skeleton, const SoaTransform* local) {
  std::vector<Map> out;
  std::size_t root = 0;
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
    const TestJoint t = joint_of(local, j);
    const Map parent_from_joint = from_trs(t.translation, normalised(t.rotation), t.scale);
    const int parent = skeleton.joints[j].parent;
    out.push_back((parent < 0 ? skeleton.above[root++] : out[static_cast<std::size_t>(parent)]) * parent_from_joint);
  }
  return out;
}

inline Vec3 origin_of(const Map& m) {
  return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
}

// First b, then a.
inline Quat product(const Quat& a, const Quat& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
          a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

// A unit vector, evenly over the sphere.
inline Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (dot(v, v) > 1e-2 && dot(v, v) <= 1) return normalised(v);
  }
}

// Of at most most_rad, about any axis. No library's trigonometry: the same bits everywhere.
inline Quat random_turn(Random& random, double most_rad) {
  const Vec3 axis = random_direction(random);
  const double half = random.between(0, most_rad) / 2, y = half * half;
  double sine = 0, cosine = 0, term = 1;
  for (int k = 0; k < 24; k += 2) {
    cosine += term;
    sine += term / (k + 1);
    term *= -y / ((k + 1) * (k + 2));
  }
  sine *= half;
  return {axis[0] * sine, axis[1] * sine, axis[2] * sine, cosine};
}

// A joint at the base, turned anyhow, then the chain, a leaf beside some of its joints, and two joints that hang from
// its tip. Bones are 0.5 to 1.5 m long, in any direction of their joint.
struct RandomChain {
  // bend_rad: how far each joint of the rest pose is turned at most.
  RandomChain(Random& random, int bones, double bend_rad = 1.0) : skeleton(make(random, bones, bend_rad)) {}

  TestSkeleton make(Random& random, int bones, double bend_rad) {
    std::vector<TestJoint> all = {{-1, {random.between(-2, 2), random.between(-2, 2), 0}, random.rotation()}};
    int parent = 0;
    for (int i = 0; i <= bones; ++i) {
      TestJoint j{parent, {0, 0, 0}, random_turn(random, bend_rad)};
      if (i > 0) {
        const Vec3 along = random_direction(random);
        const double bone_m = random.between(0.5, 1.5);
        for (std::size_t c = 0; c < 3; ++c) j.translation[c] = along[c] * bone_m;
        length_m += bone_m;
      }
      const int leaf_of = random.below(3) == 0 ? parent : -1;
      parent = static_cast<int>(all.size());
      if (i < bones) joints.push_back(static_cast<std::uint16_t>(parent));
      tip = static_cast<std::uint16_t>(parent);
      all.push_back(j);
      if (leaf_of >= 0) all.push_back({leaf_of, {0.1, 0.2, 0.3}, random.rotation()});
    }
    all.push_back({parent, {0.2, 0, 0}, random.rotation()});
    all.push_back({static_cast<int>(all.size()) - 1, {0, 0.2, 0}, random.rotation()});
    return TestSkeleton(all);
  }

  // Where the tip is when every joint of the chain is turned by up to most_rad from its rest pose.
  Vec3 reachable(Random& random, double most_rad = 3.14159) const {
    std::vector<TestJoint> posed = skeleton.joints;
    for (const std::uint16_t j : joints) posed[j].rotation = product(posed[j].rotation, random_turn(random, most_rad));
    return origin_of(scene_maps(skeleton, TestSkeleton(posed).rest.data())[tip]);
  }

  std::vector<std::uint16_t> joints;  // that turn, root first
  std::uint16_t tip = 0;
  double length_m = 0;
  TestSkeleton skeleton;  // the last member: made from the others
};

}  // namespace marrow::test
