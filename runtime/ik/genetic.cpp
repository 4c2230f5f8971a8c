// Inverse kinematics by evolution: poses compete, are crossed and learn.
//
// After the memetic scheme of Starke, Hendrich and Zhang 2019 (Memetic Evolution for Generic Full-Body Inverse
// Kinematics in Robotics and Animation), with cyclic coordinate descent in place of its gradient steps.
#include <algorithm>

#include "core/zone.h"
#include "ik/heuristic.h"

namespace marrow {
namespace {

constexpr std::size_t kPoses = 24;  // of a generation
constexpr std::size_t kElites = 6;  // the best of them, which learn and live on
constexpr int kLessons = 4;         // CCD steps of an elite in a generation, at most
constexpr float kProgress = 0.9f;   // an elite that keeps more of its error than this share makes room

struct Candidate {
  WideRotation* rotations;  // one a node
  float error;
};

// A generation, and room for the next.
struct Population {
  IkHeuristic h;
  Chance chance;
  Candidate poses[kPoses], next[kPoses];
};

void put(IkTree& tree, const Candidate& pose) {
  for (std::size_t i = 0; i < tree.nodes.size; ++i) tree.nodes[i].rotation = pose.rotations[i];
  update_frames(tree);
}

void take(const IkTree& tree, Candidate& pose) {
  for (std::size_t i = 0; i < tree.nodes.size; ++i) pose.rotations[i] = tree.nodes[i].rotation;
  pose.error = total_error(tree);
}

// Makes a pose from the start by random turns of its joints, which are small or large.
void be_born(Population& p, Candidate& pose) {
  const float wide = p.chance.unit();
  begin_anew(*p.h.tree, p.chance, 4.0f * wide * wide);
  take(*p.h.tree, pose);
}

// The better of two poses chosen at random.
const Candidate& parent(Population& p) {
  const Candidate &a = p.poses[p.chance.below(kPoses)], &b = p.poses[p.chance.below(kPoses)];
  return a.error < b.error ? a : b;
}

void cross(Population& p, Candidate& child) {
  IkTree& tree = *p.h.tree;
  const Candidate &a = parent(p), &b = parent(p);
  const float wide = p.chance.unit(), size = wide * wide * wide, share = p.chance.unit();
  for (std::size_t i = 0; i < tree.nodes.size; ++i) {
    const WideRotation between =
        part_of(conjugate(a.rotations[i]) * b.rotations[i], p.chance.bits() % 2 == 0 ? 0.0f : share);
    const bool changes = p.chance.bits() % 2 == 0;
    set_turned(tree.nodes[i], a.rotations[i] * between * p.chance.turn(changes ? size : 0.0f));
  }
  update_frames(tree);
  take(tree, child);
}

// Improves a pose by cyclic coordinate descent, as long as that helps.
void learn(Population& p, Candidate& pose, float tolerance) {
  IkTree& tree = *p.h.tree;
  put(tree, pose);
  update_parts(p.h);
  for (int i = 0; i < kLessons && pose.error > tolerance; ++i) {
    descend_once(p.h);
    if (!(total_error(tree) < pose.error)) return;
    take(tree, pose);
  }
}

void sort(Candidate (&poses)[kPoses]) {
  for (std::size_t i = 1; i < kPoses; ++i)
    for (std::size_t k = i; k > 0 && poses[k].error < poses[k - 1].error; --k) std::swap(poses[k], poses[k - 1]);
}

void next_generation(Population& p, float tolerance) {
  for (std::size_t i = 0; i < kElites; ++i) {
    Candidate& elite = p.poses[i];
    const float before = elite.error;
    learn(p, elite, tolerance);
    // Stuck in a corner of its limits: all but the best begin anew.
    if (i > 0 && elite.error > tolerance && elite.error > kProgress * before) be_born(p, elite);
  }
  for (std::size_t i = kElites; i < kPoses; ++i) cross(p, p.next[i]);
  for (std::size_t i = kElites; i < kPoses; ++i) std::swap(p.poses[i], p.next[i]);
  sort(p.poses);
}

void solve_genetic(const IkCall& call, IkTree& tree, Memory& scratch, IkReport& report) {
  const IkOptions& options = call.options;
  Population p{set_up(tree, scratch), Chance(options.seed), {}, {}};
  for (std::size_t i = 0; i < kPoses; ++i) {
    p.poses[i].rotations = scratch.take<WideRotation>(tree.nodes.size).data;
    p.next[i].rotations = scratch.take<WideRotation>(tree.nodes.size).data;
  }
  take(tree, p.poses[0]);
  if (p.poses[0].error > options.tolerance_m) {
    for (std::size_t i = 1; i < kPoses; ++i) be_born(p, p.poses[i]);
    sort(p.poses);
  }
  for (; p.poses[0].error > options.tolerance_m && report.iterations < options.max_iterations; ++report.iterations)
    next_generation(p, options.tolerance_m);
  put(tree, p.poses[0]);
  report.error_m = p.poses[0].error;
  report.why = report.error_m <= options.tolerance_m ? IkStop::reached : IkStop::iterations;
}

void count_genetic(const Skeleton& skeleton, const IkProblem& problem, Memory& count) {
  count_heuristic(skeleton, problem, count);
  for (std::size_t i = 0; i < 2 * kPoses; ++i) count.take<WideRotation>(problem.joints.size);
}

}  // namespace

std::size_t ik_genetic_scratch_bytes(const Skeleton& skeleton, const IkProblem& problem) {
  return scratch_bytes(count_genetic, skeleton, problem);
}

Status solve_ik_genetic(const Pose& pose, const IkProblem& problem, const IkOptions& options, Span<std::byte> scratch,
                        IkReport* report) {
  MARROW_ZONE;
  IkOptions once = options;
  once.starts = 1;
  MARROW_REQUIRE_GOOD(solve_ik_by(solve_genetic, count_genetic, {pose, problem, once}, scratch, report));
  return Status::ok;
}

}  // namespace marrow
