// The rows ik/…8: a chain of eight bones reaches for targets, from its rest pose each time.
#include <array>
#include <cmath>

#include "bench/workload.h"
#include "marrow/ik_solve.h"
#include "marrow/local_to_model.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr std::uint16_t kBones = 8;
constexpr std::uint16_t kJoints = kBones + 2;  // one above them, and the tip
constexpr std::size_t kTargets = 1024;
constexpr float kBone_m = 0.1f;

void set_turn(SoaTransform* pose, std::size_t joint, float x, float y, float z, float w) {
  const float k = 1.0f / std::sqrt(x * x + y * y + z * z + w * w);
  const std::array<float, 4> q = {x * k, y * k, z * k, w * k};
  for (std::size_t c = 0; c < 4; ++c) pose[joint / 4].rotation[c][joint % 4] = q[c];
}

class ReachingChain : public Workload {
 public:
  explicit ReachingChain(IkMethod method) : rest_(soa_count(kJoints)), rest_joints_(kJoints) {
    options_.method = method;
    options_.max_iterations = 64;
    options_.tolerance_m = 1e-3f * kBones * kBone_m;
    make_rest();
    for (std::uint16_t j = 1; j <= kBones; ++j) turning_.push_back(j);
    for (IkGoal& goal : goals_) make_goal(goal);
    problem_.joints = turning_;
    problem_.goals = {goals_.data(), 1};
    scratch_.resize(ik_scratch_bytes(skeleton_, problem_, options_));
    pose_ = rest_;
    joints_ = rest_joints_;
  }
  std::uint32_t items() const override { return 1; }
  std::uint32_t period() const override { return kTargets; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(joints_, hash_of(pose_, state)); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      pose_ = rest_;
      joints_ = rest_joints_;
      problem_.goals = {&goals_[next_], 1};
      next_ = (next_ + 1) % kTargets;
      check(solve_ik({skeleton_, pose_, joints_}, problem_, options_, scratch_));
    }
  }

 private:
  // Nearly straight: each joint is bent by up to 0.15 radians or so.
  void make_rest() {
    for (std::uint16_t j = 0; j < kJoints; ++j)
      parents_.push_back(j == 0 ? kNoJoint : static_cast<std::uint16_t>(j - 1));
    names_.resize(kJoints);
    skeleton_.joint_count = kJoints;
    skeleton_.root_count = 1;
    skeleton_.model_from_root = &root_;
    skeleton_.parents = parents_.data();
    skeleton_.names = names_.data();
    for (std::size_t j = 0; j < rest_.size() * 4; ++j) {
      for (auto& s : rest_[j / 4].scale) s[j % 4] = 1;
      const bool bends = j > 0 && j <= kBones;
      const float most = bends ? 0.075f : 0.0f;
      const float x = noise_.between(-most, most), y = noise_.between(-most, most), z = noise_.between(-most, most);
      set_turn(rest_.data(), j, x, y, z, 1);
      if (j > 0 && j < kJoints) rest_[j / 4].translation[1][j % 4] = j == 1 ? 1.0f : kBone_m;
    }
    skeleton_.rest = rest_.data();
    check(local_to_model(skeleton_, rest_, rest_joints_));
  }
  // Where the tip is when joints are turned anyhow.
  void make_goal(IkGoal& goal) {
    std::vector<SoaTransform> pose = rest_;
    for (std::size_t j = 1; j <= kBones; ++j) {
      float q[4];
      for (float& c : q) c = noise_.between(-1, 1);
      set_turn(pose.data(), j, q[0], q[1], q[2], q[3]);
    }
    std::vector<Affine> joints(kJoints);
    check(local_to_model(skeleton_, pose, joints));
    goal.joint = kJoints - 1;
    for (int c = 0; c < 3; ++c) goal.position[c] = joints[goal.joint].rows[c][3];
  }

  Noise noise_;
  Skeleton skeleton_;
  Affine root_ = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  std::vector<std::uint16_t> parents_, turning_;
  std::vector<std::uint32_t> names_;
  std::vector<SoaTransform> rest_, pose_;
  std::vector<Affine> rest_joints_, joints_;
  std::array<IkGoal, kTargets> goals_;
  std::vector<std::byte> scratch_;
  IkProblem problem_;
  IkOptions options_;
  std::size_t next_ = 0;
};

}  // namespace

RowGroup chain_rows() {
  RowGroup group{"ik/{fabrik8,ccd8,dls8,gauss_newton8}\n", {}};
  const auto add = [&](const char* name, IkMethod method) {
    group.rows.push_back({name, nullptr, {}, [method](Models&) { return std::make_unique<ReachingChain>(method); }});
  };
  add("ik/fabrik8", IkMethod::fabrik);
  add("ik/ccd8", IkMethod::ccd);
  add("ik/dls8", IkMethod::damped_least_squares);
  add("ik/gauss_newton8", IkMethod::gauss_newton);
  return group;
}

}  // namespace marrow::tools
