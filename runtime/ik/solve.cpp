#include "marrow/ik_solve.h"

#include "core/check.h"
#include "core/zone.h"
#include "ik/tree.h"
#include "marrow/block.h"
#include "math/finite.h"

namespace marrow {
namespace {

constexpr float kMost = 1e15f;         // numbers up to here can be squared
constexpr float kMostWeight = 100.0f;  // positions times this can still be squared

bool all_good(const float* v, std::size_t count) {
  return all_within(v, count, -kMost, kMost);
}

BadCall check_goal(const Pose& pose, const IkGoal& goal) {
  MARROW_CHECK(goal.joint < pose.skeleton.joint_count);
  MARROW_CHECK(within(goal.position_weight, 0, kMostWeight) && within(goal.rotation_weight, 0, kMost));
  MARROW_CHECK(all_good(goal.offset, 3) && all_good(goal.position, 3) && all_good(goal.rotation, 4));
  return {};
}

BadCall check_problem(const Pose& pose, const IkProblem& problem) {
  MARROW_CHECK(problem.goals.size > 0 && problem.joints.size > 0 && problem.joints.size < kNoJoint);
  MARROW_CHECK(holds(problem.goals) && holds(problem.joints) && holds(problem.stiffness) && holds(problem.limits));
  MARROW_CHECK(problem.goals.size <= kMaxJoints);  // 16 bits number tips behind the nodes
  MARROW_CHECK(problem.stiffness.empty() || problem.stiffness.size == problem.joints.size);
  MARROW_CHECK(within(problem.root_travel_m, 0, kMost));
  for (const IkGoal& goal : problem.goals)
    if (const BadCall bad = check_goal(pose, goal)) return bad;
  for (std::size_t i = 0; i < problem.joints.size; ++i) {
    MARROW_CHECK(problem.joints[i] < pose.skeleton.joint_count);
    MARROW_CHECK(i == 0 || problem.joints[i - 1] < problem.joints[i]);
  }
  for (const float s : problem.stiffness) MARROW_CHECK(within(s, 0, 1));
  for (std::size_t i = 0; i < problem.limits.size; ++i) {
    MARROW_CHECK(is_valid(problem.limits[i]));
    MARROW_CHECK(i == 0 || problem.limits[i - 1].joint < problem.limits[i].joint);
  }
  MARROW_CHECK(all_good(problem.pole, 3) && within(problem.pole_weight, 0, 1));
  return {};
}

BadCall check_options(const IkOptions& options) {
  MARROW_CHECK(options.method <= IkMethod::gauss_newton && options.starts > 0 && "not zeros: mrw_ik_options_init");
  MARROW_CHECK(within(options.tolerance_m, 0, kMost) && within(options.damping, 0, kMost));
  MARROW_CHECK(within(options.weight, 0, 1) && within(options.stretch, 1, kMost));
  return {};
}

// Solves from the pose, then from other poses, as many as there may be, until the goals are reached. The tree keeps the
// best result.
IkReport solve_from_starts(IkSolver solve, const IkCall& call, IkTree& tree, const Memory& memory) {
  IkReport best;
  Chance chance(call.options.seed);
  for (int start = 0; start == 0 || (start < call.options.starts && best.why != IkStop::reached); ++start) {
    const f32x4 travel = tree.travel;
    if (start > 0) {
      for (IkNode& node : tree.nodes) node.best = node.rotation;
      tree.travel = splat(0.0f);
      begin_anew(tree, chance, 1.0f);
    }
    Memory rest = memory;
    IkReport next;
    solve(call, tree, rest, next);
    next.iterations += best.iterations;
    if (start == 0 || next.error_m < best.error_m) {
      best = next;
      continue;
    }
    best.iterations = next.iterations;
    for (IkNode& node : tree.nodes) node.rotation = node.best;
    tree.travel = travel;
  }
  return best;
}

}  // namespace

std::size_t scratch_bytes(IkCounter method, const Skeleton& skeleton, const IkProblem& problem) {
  if (!holds(problem.goals, 1) || !holds(problem.joints, 1)) return 0;
  Memory count;
  place_tree(skeleton, problem, count);
  method(skeleton, problem, count);
  return block_bytes(count.whole());
}

std::size_t ik_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem, const IkOptions& options) {
  return scratch_bytes(options.method <= IkMethod::ccd ? count_heuristic : count_jacobian, skeleton, problem);
}

Status solve_ik(const Pose& pose, const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                IkReport* report) {
  MARROW_ZONE;
  const bool heuristic = options.method <= IkMethod::ccd;
  MARROW_REQUIRE_GOOD(solve_ik_by(heuristic ? solve_heuristic : solve_jacobian,
                                  heuristic ? count_heuristic : count_jacobian, {pose, problem, options}, scratch,
                                  report));
  return Status::ok;
}

BadCall solve_ik_by(IkSolver solver, IkCounter counter, const IkCall& call, Span<std::byte> scratch, IkReport* report) {
  const Skeleton& skeleton = call.pose.skeleton;
  if (const BadCall bad = check_pose(call.pose)) return bad;
  if (const BadCall bad = check_problem(call.pose, call.problem)) return bad;
  if (const BadCall bad = check_options(call.options)) return bad;
  MARROW_CHECK(holds(scratch, scratch_bytes(counter, skeleton, call.problem)));
  Memory memory{block_in(scratch).data};
  IkTree tree = place_tree(skeleton, call.problem, memory);
  if (const BadCall bad = build_tree(call, tree)) return bad;
  const IkReport done = solve_from_starts(solver, call, tree, memory);
  if (report != nullptr) *report = done;
  if (call.options.weight != 0) store_tree(tree, call.options.weight, call.pose);
  return {};
}

}  // namespace marrow
