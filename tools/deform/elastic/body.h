// A lattice as an elastic body that joints carry: all that is the same in every pose.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "deform/elastic/elastic_options.h"
#include "deform/elastic/factor.h"
#include "deform/elastic/lattice.h"

namespace marrow::deform {

// As smooth as they can be while between corners they are what vertices have: of each joint the least of
// 4 Σ (interpolated - vertex's)² + Σ |gradient|². Of each corner the six largest, none below 0.01; they sum to 1.
// On all cores, the same on every run.
std::vector<std::vector<Influence>> node_weights(const Lattice& lattice, const SkinnedMesh& mesh);

// A cell as it is reckoned with. Four are at a time: `Body::free` has them so that none is beside another of its
// four, nor of its half, and fills up with cells of no weight.
struct ElasticCell {
  std::array<std::uint32_t, 8> nodes{};
  std::array<std::uint32_t, 6> beside{};  // Body::cells.size() for none
  float filled = 0;
};

struct Body {
  Lattice lattice;
  std::vector<std::vector<Influence>> weights;  // of a node; none: nothing is known of it
  std::vector<ElasticCell> cells;               // those that are free first
  std::size_t half = 0, free = 0;               // ends of the free cells' halves: multiples of 4
  std::vector<std::uint32_t> row;               // of a node in the equations, or kNone: it goes with its joint
  std::vector<float> keep;                      // of a node: what its way from the joints' pose costs
  std::size_t rows = 0;
  std::unique_ptr<Factor> factor;
  float volume = 0;
};

// Of what a mode of a cell, Σ ± of its corners, costs: the three that bend it, and the one that twists those.
inline constexpr float kBending = 2.0f / 24, kTwisting = 2.0f / 48;

// Of Lattice::filled_around: up to there a body is thin, from there on it is not.
inline constexpr double kThin = 0.10, kThick = 0.30;

// 0 up to `from`, 1 beyond `to`, and smooth between.
double smooth_step(double x, double from, double to);

Body make_body(const SkinnedMesh& mesh, const ElasticOptions& options, std::size_t cells);

}  // namespace marrow::deform
