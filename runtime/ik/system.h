// The Jacobian of an IkTree's goals, how errors change as joints turn, and the equations made of it.
//
// Units make the joints alike: a node's step is its rotation vector, in its own axes, divided by the square root of its
// ease. Rows of goals are multiplied by the goals' weights.
#pragma once

#include "ik/tree.h"

namespace marrow {

// How turning one node changes one task: a column for each axis of the node, a lane for each row.
struct IkEntry {
  f32x4 column[3];
  std::uint16_t node;
};

// The sum of the columns by the lanes of v.
f32x4 times(const IkEntry& entry, f32x4 v);

// Three rows of the Jacobian: a tip's position, or its rotation.
struct IkTask {
  const IkNode* tip;
  IkEntry* path;  // from the top down: what two tasks share is the front of their paths
  std::uint32_t length;
  bool turn;
  float weight;
  float longest;  // of the weighted error, the most that one step is to mend
  float size;     // |error| · length of the bones, which damping is proportional to
  float cut;      // the error divided by what is to be mended of it: 1 or more
};

// The step of a node is fixed + answer.
struct IkMove {
  f32x4 fixed;        // what is not solved for: the pull back, and the way to a limit
  f32x4 answer;       // what is: Jᵀ x
  WideRotation next;  // the rotation after the step
  f32x4 beyond;       // the direction in which a limit stopped it
  float most;         // how far the step went that way
  bool stopped;
};

struct IkSystem {
  IkTree* tree;
  Span<IkTask> tasks;  // most urgent first
  IkEntry* entries;
  Span<IkMove> moves;  // one a node, then one for the travel, then up to a multiple of four
  std::size_t rows;
  float travel_ease;
  float* error;  // for each row, what one step is to mend
  float* rest;   // the same less what the fixed parts of the step do
  float* a;      // J Jᵀ: see dense_stride()
  float* work;
  float* x;
  float* sum;  // solutions, summed over the levels of priority
};

// A system with its memory. Without memory this only counts, and the pointers mean nothing.
IkSystem place_system(const Skeleton& skeleton, const IkProblem& problem, Memory& scratch);

// Sets the tasks and their paths.
void set_tasks(IkTree& tree, const IkProblem& problem, IkSystem& system);

// Sets the errors to the tree's. Returns the total, see IkReport.
float set_errors(IkSystem& system);

// Sets the Jacobian to the tree's.
void set_entries(IkSystem& system);

// Sets J Jᵀ from the Jacobian, or from what is left of it.
void set_products(IkSystem& system);

// Solves for x of the answer Jᵀ x, into `sum`: one level of priority after another, each in the null space of those
// before it. Damping is error_share · the level's Σ IkTask::size + size_share · the mean of J Jᵀ's diagonal.
void solve_rows(IkSystem& system, float error_share, float size_share);

// Sets the moves' answers from `sum`.
void set_answers(IkSystem& system);

// How a part of the step changes the rows of a task.
f32x4 effect(const IkTask& task, Span<const IkMove> moves, f32x4 IkMove::*part);

}  // namespace marrow
