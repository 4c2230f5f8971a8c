// What a clip pack alone knows of a skeleton: names and parents of its joints, but not where they rest.
#pragma once

#include <algorithm>
#include <vector>

#include "common/check_status.h"
#include "marrow/sample.h"

namespace marrow::tools {

class BareSkeleton {
 public:
  explicit BareSkeleton(const SkeletonReference& reference) : rest_(soa_count(reference.joint_count)) {
    for (SoaTransform& four : rest_) {
      std::fill_n(&four.translation[0][0], 12, 0.0f);
      std::fill_n(&four.rotation[0][0], 12, 0.0f);
      std::fill_n(four.rotation[3], 4, 1.0f);
      std::fill_n(&four.scale[0][0], 12, 1.0f);
    }
    skeleton_.name = reference.name;
    skeleton_.joint_count = reference.joint_count;
    skeleton_.rest = rest_.data();
    skeleton_.parents = reference.parents;
    skeleton_.names = reference.names;
  }
  BareSkeleton(const BareSkeleton&) = delete;
  BareSkeleton& operator=(const BareSkeleton&) = delete;

  // With all joints at rest where their parents are, and of an additive clip the poses: how two moments differ is as
  // with the skeleton that it was made for.
  std::vector<SoaTransform> pose(Clip clip, float time_s) const {
    clip.additive = false;
    std::vector<SoaTransform> out(rest_.size());
    check(sample(skeleton_, clip, time_s, out));
    return out;
  }

 private:
  std::vector<SoaTransform> rest_;
  Skeleton skeleton_;
};

}  // namespace marrow::tools
