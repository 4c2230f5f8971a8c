#include "marrow/ik_solve.h"

#include "core/check.h"
#include "ik/tree.h"
#include "math/finite.h"

namespace marrow {
namespace {

constexpr float kMost = 1e15f;         // of numbers that are squared
constexpr float kMostWeight = 100.0f;  // of what positions are multiplied by: still so

bool all_good(const float* v, std::size_t count) {
  return all_within(v, count, -kMost, kMost);
}

Status check_goal(const Skeleton& skeleton, const IkGoal& goal) {
  MARROW_REQUIRE(goal.joint < skeleton.joint_count);
  MARROW_REQUIRE(within(goal.position_weight, 0, kMostWeight) && within(goal.rotation_weight, 0, kMost));
  MARROW_REQUIRE(all_good(goal.offset, 3) && all_good(goal.position, 3) && all_good(goal.rotation, 4));
  return Status::ok;
}

Status check_problem(const Skeleton& skeleton, const IkProblem& problem) {
  MARROW_REQUIRE(problem.goals.size > 0 && problem.joints.size > 0 && problem.joints.size < kNoParent);
  MARROW_REQUIRE(problem.goals.size <= kMaxJoints);  // with joints, what 16 bits number
  MARROW_REQUIRE(problem.stiffness.empty() || problem.stiffness.size == problem.joints.size);
  MARROW_REQUIRE(within(problem.root_travel_m, 0, kMost));
  for (const IkGoal& goal : problem.goals) {
    const Status status = check_goal(skeleton, goal);
    if (status != Status::ok) return status;
  }
  for (std::size_t i = 0; i < problem.joints.size; ++i) {
    MARROW_REQUIRE(problem.joints[i] < skeleton.joint_count);
    MARROW_REQUIRE(i == 0 || problem.joints[i - 1] < problem.joints[i]);
  }
  for (const float s : problem.stiffness) MARROW_REQUIRE(within(s, 0, 1));
  for (std::size_t i = 0; i < problem.limits.size; ++i) {
    MARROW_REQUIRE(is_valid(problem.limits[i]));
    MARROW_REQUIRE(i == 0 || problem.limits[i - 1].joint < problem.limits[i].joint);
  }
  MARROW_REQUIRE(all_good(problem.pole, 3) && within(problem.pole_weight, 0, 1));
  return Status::ok;
}

Status check_options(const IkOptions& options) {
  MARROW_REQUIRE(options.method <= IkMethod::gauss_newton);
  MARROW_REQUIRE(within(options.tolerance_m, 0, kMost) && within(options.damping, 0, kMost));
  MARROW_REQUIRE(within(options.weight, 0, 1) && within(options.stretch, 1, kMost));
  return Status::ok;
}

bool is_jacobian(IkMethod method) {
  return method == IkMethod::damped_least_squares || method == IkMethod::gauss_newton;
}

std::size_t tree_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem) {
  IkScratch count;
  place_tree(skeleton, problem, count);
  return count.used + 15;
}

}  // namespace

std::size_t ik_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem, const IkOptions& options) {
  if (problem.goals.empty() || problem.joints.empty()) return 0;
  return tree_scratch_bytes(skeleton, problem) +
         (is_jacobian(options.method) ? jacobian_scratch_bytes(skeleton, problem) : heuristic_scratch_bytes(problem));
}

Status solve_ik(const Skeleton& skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch, IkReport* report) {
  const IkSolver solver = is_jacobian(options.method) ? solve_jacobian : solve_heuristic;
  return solve_ik_by(solver, skeleton, local, scene_from_joint, problem, options, scratch,
                     ik_scratch_bytes(skeleton, problem, options), report);
}

Status solve_ik_by(IkSolver solver, const Skeleton& skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint,
                   const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                   std::size_t scratch_bytes, IkReport* report) {
  MARROW_REQUIRE(local.size >= skeleton.soa_size());
  MARROW_REQUIRE(scene_from_joint.size >= skeleton.joint_count);
  Status status = check_problem(skeleton, problem);
  if (status == Status::ok) status = check_options(options);
  if (status != Status::ok) return status;
  MARROW_REQUIRE(scratch.size >= scratch_bytes);
  const std::size_t past = reinterpret_cast<std::uintptr_t>(scratch.data) % 16;
  IkScratch memory{scratch.data + (16 - past) % 16};
  IkTree tree;
  const IkTreeMemory placed = place_tree(skeleton, problem, memory);
  status = build_tree(skeleton, local, scene_from_joint, problem, placed, tree);
  if (status != Status::ok) return status;
  const IkReport done = solver(skeleton, tree, problem, options, memory);
  if (report != nullptr) *report = done;
  if (options.weight == 0) return Status::ok;
  return store_tree(skeleton, tree, options.weight, local, scene_from_joint);
}

}  // namespace marrow
