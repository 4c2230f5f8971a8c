// Machines of the oracle: one step.
#pragma once

#include "unit/graph/oracle.h"

namespace marrow::test::oracle {

class Machine {
 public:
  Machine(Animator& animator, int node, Run& run)
      : animator_(animator),
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
  void decide();
  Due due() const;
  bool is_due(const Transition& t, double& at_s) const;
  bool holds(const Condition& c, double at_s) const;
  double left_s() const;
  void show();
  void take(const Transition& t);
  Place phase() const;
  NodeState current() const;
  int child(int state) const { return node_.states[static_cast<std::size_t>(state)].node; }

  Animator& animator_;
  const Node& node_;
  NodeState& state_;
  Run& run_;
  Run fresh_ = {};  // how the current state is entered in this step, if it is
};

}  // namespace marrow::test::oracle
