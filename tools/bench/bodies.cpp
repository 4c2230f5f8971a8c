// The row ik/full_body: a whole body follows its hands, feet and head. One iteration is one solve, from the same pose
// each time, of one target of a fixed set of 1024.
#include "bench/workload.h"
#include "marrow/ik_solve.h"
#include "marrow/local_to_model.h"
#include "marrow/roles.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kTargets = 1024, kEnds = 5;
constexpr Role kEndRoles[kEnds] = {Role::left_hand, Role::right_hand, Role::left_foot, Role::right_foot, Role::head};

// Hands within 0.2 m of where the animation has them, feet and head within 0.05 m, along each axis. All joints turn,
// and the hips travel.
class FollowingBody : public Workload {
 public:
  FollowingBody(const ClipOfModel& source, const File& file)
      : skeleton_(source.skeleton), pose_(skeleton_.soa_size()), joints_(skeleton_.joint_count) {
    check(sample(skeleton_, source.clip, source.clip.duration_s / 2, pose_));
    check(local_to_model(skeleton_, pose_, joints_));
    for (std::uint32_t j = 0; j < skeleton_.joint_count; ++j) turning_.push_back(static_cast<std::uint16_t>(j));
    const Roles roles = file.roles(source.clip.skeleton);
    Noise noise;
    for (std::size_t i = 0; i < kTargets * kEnds; ++i) {
      IkGoal goal;
      goal.joint = joint_of(roles, kEndRoles[i % kEnds]);
      check(goal.joint == kNoJoint ? Status::mismatch : Status::ok);
      const float range = i % kEnds < 2 ? 0.2f : 0.05f;
      for (int r = 0; r < 3; ++r) goal.position[r] = joints_[goal.joint].rows[r][3] + noise.between(-range, range);
      goals_.push_back(goal);
    }
    problem_.goals = {goals_.data(), kEnds};
    problem_.joints = turning_;
    problem_.root_travel_m = 0.5f;
    options_.max_iterations = 8;
    options_.tolerance_m = 1e-3f;
    scratch_.resize(ik_scratch_bytes(skeleton_, problem_, options_));
    local_ = pose_;
    scene_ = joints_;
  }
  std::uint32_t items() const override { return 1; }
  std::uint32_t period() const override { return kTargets; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(scene_, hash_of(local_, state)); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      local_ = pose_;
      scene_ = joints_;
      problem_.goals = {goals_.data() + next_ * kEnds, kEnds};
      next_ = (next_ + 1) % kTargets;
      check(solve_ik({skeleton_, local_, scene_}, problem_, options_, scratch_));
    }
  }

 private:
  Skeleton skeleton_;
  std::vector<SoaTransform> pose_, local_;
  std::vector<Affine> joints_, scene_;
  std::vector<std::uint16_t> turning_;
  std::vector<IkGoal> goals_;
  std::vector<std::byte> scratch_;
  IkProblem problem_;
  IkOptions options_;
  std::size_t next_ = 0;
};

}  // namespace

RowGroup body_rows() {
  RowGroup group{"ik/full_body\n", {}};
  group.rows.push_back({"ik/full_body", &kPab, {"pab_walk_raw"}, [](Models& from) {
                          const File& file = from.get(kPab);
                          return std::make_unique<FollowingBody>(find_clip(kPab, file, "pab_walk_raw"), file);
                        }});
  return group;
}

}  // namespace marrow::tools
