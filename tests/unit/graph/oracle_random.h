// Random graphs as texts, and random inputs for them.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "unit/graph/oracle.h"

namespace marrow::test::oracle {

// The same numbers everywhere; std's distributions are not.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  double number(double least = 0, double most = 1) {
    return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  bool is(double share) { return number() < share; }

 private:
  std::mt19937_64 engine_;
};

// A valid graph of all kinds of nodes, at most `height` above each other. calm: it leaves a state only when the fade to
// it is over, and machines stand at the top.
std::string random_graph(std::uint64_t seed, int height, bool calm = false);

struct Input {
  std::size_t parameter;
  double value;  // of a trigger: fired
};
// What a game sets before a step of dt seconds.
std::vector<Input> random_inputs(const Graph& graph, Chance& chance, double dt_s);

}  // namespace marrow::test::oracle
