// Damped least squares and Gauss-Newton: steps by the Jacobian, solved in the space of the goals.
//
// Damped least squares (Nakamura and Hanafusa 1986; Wampler 1986) takes the step Jᵀ (J Jᵀ + λ²)⁻¹ e. λ² is proportional
// to the error (Levenberg-Marquardt by Fan and Yuan 2005): close to the goal that is Newton's method, and for a goal
// out of reach it is as stiff as a stretched chain. λ² also has a factor that follows how well the last step did what
// its linear model promised (Nielsen 1999). No step is taken back, so the result moves continuously with the goals.
//
// Gauss-Newton minimises Σ |x|² / ease under the constraint e = 0, with x the rotation vectors from the pose at the
// start. Linearised, with μ the Lagrange multipliers, the Karush-Kuhn-Tucker system is step + x = Jᵀ μ, J step = e, so
// J Jᵀ μ = e + J x. The same damping keeps it safe for goals out of reach. The pull back by x fades near the goals.
#include "core/zone.h"
#include "ik/dense.h"
#include "ik/system.h"
#include "limits/joint_limit.h"

namespace marrow {
namespace {

// Damping as a share of Σ IkTask::size: above 0.21, the stiffness against bending of two stretched bones.
constexpr float kErrorDamping = 0.25f;
constexpr float kSizeDamping = 1e-4f;  // damping as a share of the mean of J Jᵀ's diagonal
constexpr float kLeastTrust = 0.1f;    // the least factor on damping, where steps keep their promise
constexpr float kLongestStep_rad = 0.5f;
constexpr float kStill_rad = 1e-5f;  // a step of less counts as none
constexpr float kPull = 0.4f;        // the share of the way back to the start that a step takes
constexpr float kPullEnds = 10;      // at an error of so many tolerances the pull is half as strong
constexpr float kStuck = 1e-3f;  // a chain is straight if J Jᵀ has less than this share of its trace along the error
constexpr float kBend_rad = 0.5f;
constexpr int kPasses = 2;  // solutions a step, where joints meet their limits

struct Progress {
  float damping = 1;
  float error = 0;     // Σ error² before the step
  float promised = 0;  // how much of that the step would have taken, were the goals linear
  float mended = 1;    // the share of the error that the step was to take
  int still = 0;       // steps in a row without movement
};

// How the step changes the rows of task t, were the goals linear.
f32x4 linear_effect(const IkSystem& s, std::size_t t) {
  return load(s.error + 3 * t) - load(s.rest + 3 * t) + effect(s.tasks[t], s.moves, &IkMove::answer);
}

// Takes what a fixed part of the step does off what task t still wants.
void take_off(IkSystem& s, std::size_t t, f32x4 done) {
  float* const rest = s.rest + 3 * t;
  const float next = rest[3];  // the next task's, or padding
  store(rest, load(rest) - done);
  rest[3] = next;
}

// Gauss-Newton's pull back to the pose at the start.
void pull_back(IkSystem& s, float share) {
  const IkTree& tree = *s.tree;
  for (std::size_t i = 0; i < tree.nodes.size; ++i) {
    const IkNode& node = tree.nodes[i];
    if (!(node.ease_root > 0)) continue;
    s.moves[i].fixed = turn_of(conjugate(node.start) * node.rotation) * splat(-share / node.ease_root);
  }
  if (s.travel_ease > 0) s.moves[tree.nodes.size].fixed = tree.travel * splat(-share / s.travel_ease);
  for (std::size_t t = 0; t < s.tasks.size; ++t) take_off(s, t, effect(s.tasks[t], s.moves, &IkMove::fixed));
}

// Bends a straight chain a little, about `axis` of model space, if its goal is on the chain's line and nearer: no turn
// of a joint brings the tip nearer there, and the task's block of J Jᵀ is 0 in that direction.
void leave_singularity(IkSystem& s, f32x4 axis) {
  const IkTree& tree = *s.tree;
  const std::size_t stride = dense_stride(s.rows);
  for (std::size_t t = 0; t < s.tasks.size; ++t) {
    const IkTask& task = s.tasks[t];
    const float *const e3 = s.error + 3 * t, *const block = s.a + 3 * t * (stride + 1);
    const f32x4 e = load(e3);
    float felt = 0, all = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      felt += e3[r] * dot3(load(block + r * stride), e);
      all += kStuck * block[r * stride + r];
    }
    const float squared = squared3(e);
    if (task.turn || !(felt < all * squared)) continue;
    const float l = sqrt(squared), stuck = 1.0f - (felt > 0 ? felt / (all * squared) : 0.0f);
    const float bend = kBend_rad * stuck * sqrt(l / (l + task.longest));
    const f32x4 end = task.tip->frame.origin;
    for (std::uint16_t n = task.tip->parent; n != kNoJoint; n = tree.nodes[n].parent) {
      const IkNode& node = tree.nodes[n];
      const f32x4 arm = end - node.frame.origin, about = products(node.frame.axis, axis);
      const float inward = -dot3(arm, e), size = l * sqrt(squared3(arm) * squared3(about));
      if (!(inward > 0 && size > 0)) continue;
      s.moves[n].answer = s.moves[n].answer + about * splat(bend * node.ease_root * (inward / size));
    }
  }
}

// The largest turn of the step; not finite if some turn is not.
float longest_turn(const IkSystem& s) {
  float most = 0;
  for (std::size_t i = 0; i < s.tree->nodes.size; ++i) {
    const f32x4 v = (s.moves[i].fixed + s.moves[i].answer) * splat(s.tree->nodes[i].ease_root);
    const float squared = squared3(v);
    if (!(squared <= most)) most = squared;
  }
  return sqrt(most);
}

// Sets the rotations after `factor` of the step. Joints go no further than their limits; returns whether some limit
// stopped one.
bool set_next(IkSystem& s, float factor) {
  const IkTree& tree = *s.tree;
  bool any = false;
  for (std::size_t i = 0; i < tree.nodes.size; ++i) {
    const IkNode& node = tree.nodes[i];
    IkMove& move = s.moves[i];
    const f32x4 step = move.fixed + move.answer;
    const WideRotation next = normalised(node.rotation * exp_rotation(step * splat(factor * node.ease_root)));
    move.next = next;
    move.stopped = false;
    if (node.limit == nullptr || !(node.ease_root > 0)) continue;
    move.next = clamped(*node.limit, next);
    if (same(move.next, next)) continue;
    const f32x4 turn = turn_of(conjugate(node.rotation) * move.next) * splat(1.0f / node.ease_root), over = step - turn;
    const float squared = squared3(over);
    move.beyond = over * splat(squared > 1e-30f ? 1.0f / sqrt(squared) : 0.0f);
    move.most = dot3(move.beyond, turn - move.fixed);
    move.fixed = move.fixed + move.beyond * splat(move.most);
    move.answer = turn - move.fixed;
    move.stopped = any = true;
  }
  return any;
}

// Takes the directions in which limits stopped joints out of the equations: other joints then do the rest.
void leave_out_stopped(IkSystem& s) {
  for (std::size_t t = 0; t < s.tasks.size; ++t) {
    const IkTask& task = s.tasks[t];
    f32x4 done = splat(0.0f);
    for (std::uint32_t k = 0; k < task.length; ++k) {
      IkEntry& entry = task.path[k];
      const IkMove& move = s.moves[entry.node];
      if (!move.stopped) continue;
      const f32x4 along = times(entry, move.beyond);
      done = done + along * splat(move.most);
      entry.column[0] = entry.column[0] - along * splat_lane<0>(move.beyond);
      entry.column[1] = entry.column[1] - along * splat_lane<1>(move.beyond);
      entry.column[2] = entry.column[2] - along * splat_lane<2>(move.beyond);
    }
    take_off(s, t, done);
  }
}

// Nielsen's rule: less damping if the last step kept its promise, more if it did not.
void update_damping(float error, Progress& p) {
  if (p.promised > 1e-4f * p.error) {  // of less, rounding decides
    const float x = 2 * (p.error - error) / p.promised - 1, change = 1 - x * x * x;
    p.damping *= change > 2 ? 2.0f : change > 1.0f / 3 ? change : 1.0f / 3;
    p.damping = p.damping > 1 ? 1.0f : p.damping > kLeastTrust ? p.damping : kLeastTrust;
  }
  p.error = error;
}

void set_promise(const IkSystem& s, float factor, Progress& p) {
  float mended = 0, all = 1e-30f;
  p.promised = 0;
  for (std::size_t t = 0; t < s.tasks.size; ++t) {
    const f32x4 e = load(s.error + 3 * t), step = linear_effect(s, t) * splat(factor);
    const float along = dot3(step, e);
    p.promised += 2 * s.tasks[t].cut * along - squared3(step);
    mended += along;
    all += squared3(e);
  }
  p.mended = mended > 0 ? (mended < all ? mended / all : 1.0f) : 0.0f;
}

// Takes one step. False, and nothing is changed, if the step is not finite.
bool take_step(IkSystem& s, const IkOptions& options, float pull, f32x4 bend_axis, Progress& p) {
  IkTree& tree = *s.tree;
  set_entries(s);
  for (std::size_t i = 0; i < s.rows; ++i) s.rest[i] = s.error[i];
  for (IkMove& move : s.moves) move.fixed = splat(0.0f);
  if (pull > 0) pull_back(s, pull);
  const float damping = options.damping * p.damping;
  float factor = 1;
  for (int pass = 0; pass < kPasses; ++pass) {
    if (pass > 0) leave_out_stopped(s);
    set_products(s);
    solve_rows(s, damping * kErrorDamping, options.damping * kSizeDamping);
    set_answers(s);
    if (pass == 0) leave_singularity(s, bend_axis);
    const float longest = longest_turn(s);
    if (!(longest < 1e15f)) return false;
    factor = longest > kLongestStep_rad ? kLongestStep_rad / longest : 1.0f;
    if (!set_next(s, factor)) break;
  }
  set_promise(s, factor, p);
  p.still = longest_turn(s) < kStill_rad ? p.still + 1 : 0;
  for (std::size_t i = 0; i < tree.nodes.size; ++i) {
    if (tree.nodes[i].ease_root > 0) tree.nodes[i].rotation = s.moves[i].next;
  }
  const IkMove& travel = s.moves[tree.nodes.size];
  tree.travel = tree.travel + (travel.fixed + travel.answer) * splat(factor * s.travel_ease);
  update_frames(tree);
  return true;
}

}  // namespace

void solve_jacobian(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report) {
  const IkOptions& options = call.options;
  IkSystem s = place_system(call.pose.skeleton, call.problem, scratch);
  set_tasks(tree, call.problem, s);
  const bool newton = options.method == IkMethod::gauss_newton;
  const float ends = kPullEnds * options.tolerance_m;
  // Every other step bends to the other side, in case limits forbid the first or the chain lies along the axis.
  constexpr float kBendAxes[2][4] = {{0.48f, 0.36f, 0.8f, 0}, {-0.36f, -0.8f, -0.48f, 0}};
  for (Progress p;; ++report.iterations) {
    report.error_m = set_errors(s);
    report.why = IkStop::reached;
    if (report.error_m <= options.tolerance_m) return;
    report.why = IkStop::stalled;
    if (p.still > 1) return;  // both sides were tried, see leave_singularity()
    report.why = IkStop::iterations;
    if (report.iterations == options.max_iterations) return;
    update_damping(report.error_m * report.error_m, p);
    const float pull = newton ? kPull * p.mended * report.error_m / (report.error_m + ends) : 0.0f;
    report.why = IkStop::stalled;
    if (!take_step(s, options, pull, load(kBendAxes[report.iterations % 2]), p)) return;
  }
}

Status solve_ik_body(const Pose& pose, const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                     IkReport* report) {
  MARROW_ZONE;
  MARROW_REQUIRE(options.method > IkMethod::ccd);
  MARROW_REQUIRE_GOOD(solve_ik_by(solve_jacobian, count_jacobian, {pose, problem, options}, scratch, report));
  return Status::ok;
}

}  // namespace marrow
