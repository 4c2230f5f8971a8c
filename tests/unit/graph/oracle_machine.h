// Machines of the oracle: one stretch of a step.
#pragma once

#include <set>

#include "unit/graph/oracle.h"

namespace marrow::test::oracle {

class Machine {
 public:
  Machine(Animator& animator, int node, Run& run)
      : animator_(animator),
        index_(node),
        node_(animator.graph_.nodes[static_cast<std::size_t>(node)]),
        state_(animator.nodes_[static_cast<std::size_t>(node)]),
        run_(run) {}
  void go();

 private:
  struct Due {
    const Transition* transition = nullptr;
    double at_s = 0;
  };
  void start();
  Due due() const;
  bool is_due(const Transition& t, double& at_s) const;
  bool holds(const Condition& c, double at_s) const;
  double left_s() const;
  void show_until(double end_s);
  void take(const Transition& t);
  Place phase() const;

  Animator& animator_;
  int index_;
  const Node& node_;
  NodeState& state_;
  Run& run_;
  double now_s_ = 0;
  std::set<int> played_;  // states that had a part of the step
  // What the current state begins with at its next stretch.
  Run fresh_ = {};
};

}  // namespace marrow::test::oracle
