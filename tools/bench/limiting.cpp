// The rows ik/limit_pose and ik/limit_pose_inside: limits of joints, on rotations of which most are outside, and none.
#include <algorithm>
#include <cmath>

#include "bench/workload.h"
#include "marrow/limits.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kLimitedJoints = 64, kLimitedPoses = 1024;

// A third of the joints each hinges, cones and euler boxes, up to 60° to each side.
std::vector<JointLimit> mixed_limits() {
  std::vector<JointLimit> limits(kLimitedJoints);
  for (std::size_t j = 0; j < kLimitedJoints; ++j) {
    LimitDescription d;
    d.kind = static_cast<LimitKind>(1 + j % 3);
    d.axis[j / 3 % 3] += 0.5f;
    for (int i = 0; i < 3; ++i) {
      d.most_rad[i] = 0.3f + 0.2f * static_cast<float>((j + static_cast<std::size_t>(i)) % 4);
      d.least_rad[i] = -d.most_rad[i];
    }
    check(make_limit(d, static_cast<std::uint16_t>(j), limits[j]));
  }
  return limits;
}

// Turns of up to about 140°, unit within rounding.
std::vector<SoaTransform> noise_poses(std::size_t count) {
  Noise noise;
  std::vector<SoaTransform> poses(count);
  for (SoaTransform& four : poses)
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const float q[4] = {noise.between(-1, 1), noise.between(-1, 1), noise.between(-1, 1), noise.between(0.6f, 1)};
      float squared = 0;
      for (const float x : q) squared += x * x;
      for (std::size_t i = 0; i < 4; ++i) four.rotation[i][lane] = q[i] / std::sqrt(squared);
    }
  return poses;
}

class LimitPose : public Workload {
 public:
  explicit LimitPose(bool inside)
      : limits_(mixed_limits()), poses_(noise_poses(kLimitedPoses * kGroups)), out_(kGroups) {
    for (std::size_t i = 0; inside && i < kLimitedPoses; ++i)
      check(limit_pose(limits_, {&poses_[i * kGroups], kGroups}));
  }
  std::uint32_t items() const override { return kLimitedJoints; }
  std::uint32_t period() const override { return kLimitedPoses; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(out_, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      const SoaTransform* const from = poses_.data() + next_ * kGroups;
      std::copy(from, from + kGroups, out_.begin());
      next_ = (next_ + 1) % kLimitedPoses;
      check(limit_pose(limits_, out_));
    }
  }

 private:
  static constexpr std::size_t kGroups = kLimitedJoints / 4;
  std::vector<JointLimit> limits_;
  std::vector<SoaTransform> poses_, out_;
  std::size_t next_ = 0;
};

}  // namespace

RowGroup limit_rows() {
  RowGroup group;
  const auto add = [&](const char* name, bool inside) {
    group.rows.push_back({name, nullptr, {}, [inside](Models&) { return std::make_unique<LimitPose>(inside); }, false});
  };
  add("ik/limit_pose", false);
  add("ik/limit_pose_inside", true);
  group.names = "ik/{limit_pose,limit_pose_inside}\n";
  return group;
}

}  // namespace marrow::tools
