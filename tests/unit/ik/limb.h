// A limb of two bones of noise, and where its joints are.
#pragma once

#include <vector>

#include "marrow/ik.h"
#include "unit/ik/reach.h"

namespace marrow::test {

// Joint 0 is above the limb, joint 4 hangs below it.
inline constexpr TwoBoneLimb kLimb = {1, 2, 3};

inline Chain random_limb(Random& random, bool mirrored = false) {
  Map above;
  for (int i = 0; i < 3; ++i) above.rows[i][i] = mirrored ? -0.5 : 2;
  std::vector<TestJoint> joints;
  for (int i = 0; i < 5; ++i) {
    const double scale = random.between(0.5, 2);
    joints.push_back(random_joint(random, i - 1, {scale, scale, scale}));
  }
  return Chain(joints, above);
}

struct Places {
  explicit Places(const Chain& c) {
    const std::vector<Map> maps = c.maps();
    start = origin_of(maps[1]), mid = origin_of(maps[2]), end = origin_of(maps[3]);
    upper = length(minus(mid, start)), lower = length(minus(end, mid)), limb = upper + lower;
  }
  Vec3 start, mid, end;
  double upper, lower, limb;
};

}  // namespace marrow::test
