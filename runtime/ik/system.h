// The Jacobian of an IkTree's goals and the equations that it makes: how errors change as joints turn.
//
// Everything is in units that make the joints alike: the step of a node is its rotation vector, in its own axes,
// divided by the square root of its ease, and rows of goals are multiplied by their weights.
#pragma once

#include "ik/tree.h"

namespace marrow {

// What turning one node does to one task: a column for each axis of the node, a lane for each row.
struct IkEntry {
  f32x4 column[3];
  std::uint16_t node;
};

// Of the columns, one of that direction.
f32x4 times(const IkEntry& entry, f32x4 v);

// Three rows of the Jacobian: where a tip is, or how it is turned.
struct IkTask {
  const IkNode* tip;
  IkEntry* path;  // from the top down, so that what tasks have in common is the front of their paths
  std::uint32_t length;
  bool turn;
  float weight;
  float longest;  // the most of the error that one step is to mend, weighted
  float size;     // |error| · the length of its bones: what damping is measured by
  float cut;      // how many times longer the error is: 1 or more
};

// The step of a node is fixed + answer.
struct IkMove {
  f32x4 fixed;        // what does not answer the goals: the pull back, and what limits leave of the step
  f32x4 answer;       // Jᵀ x
  WideRotation next;  // where it leads
  f32x4 beyond;       // the direction in which a limit stopped it
  float most;         // how far it still went that way
  bool stopped;
};

struct IkSystem {
  IkTree* tree;
  Span<IkTask> tasks;  // most urgent first
  IkEntry* entries;
  Span<IkMove> moves;  // one a node, and one for the travel; to a multiple of four
  std::size_t rows;
  float travel_ease;
  float* error;  // of each row, to be mended by one step
  float* rest;   // of that, what fixed parts of the step leave to be answered
  float* a;      // J Jᵀ: see dense_stride()
  float* work;
  float* x;
  float* sum;  // of solutions, level by level
};

// The room for it. Without memory it only counts, and the pointers mean nothing.
IkSystem place_system(const Skeleton& skeleton, const IkProblem& problem, Memory& scratch);

// Tasks and their paths.
void set_tasks(IkTree& tree, const IkProblem& problem, IkSystem& system);

// Errors as they are now. Returns the total: see IkReport.
float set_errors(IkSystem& system);

// The Jacobian as it is now.
void set_entries(IkSystem& system);

// J Jᵀ, of whatever is left of the Jacobian.
void set_products(IkSystem& system);

// sum: x of the answer Jᵀ x. Level by level of priority, each in the null space of those before it. `error_share` and
// `size_share` make the damping: of the level's Σ IkTask::size, and of the mean of J Jᵀ's diagonal.
void solve_rows(IkSystem& system, float error_share, float size_share);

// The moves' answers, from `sum`.
void set_answers(IkSystem& system);

// By how much a part of the step changes the rows of a task.
f32x4 effect(const IkTask& task, Span<const IkMove> moves, f32x4 IkMove::*part);

}  // namespace marrow
